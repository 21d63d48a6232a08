//! The trace of a bob as it is drawn: a ring of points that lives in memory and goes on with the time.

use crate::exchange::tell;
use crate::motion::{Motion, Outcome, TOGETHER, patience};

/// Points at whole multiples of a spacing in time, the newest of them followed by the bob itself; in lengths, the third
/// number 1 − cos θ, so that 32 bits keep a narrow ellipse on a long wire.
#[derive(Debug)]
pub struct Trace {
    /// s.
    spacing: f64,
    /// One point more than the ring has: the last is a copy of the first, so that a segment joins each point to the next.
    points: Vec<[f32; 3]>,
    /// Points on the ring that are filled, the bob among them.
    count: usize,
    /// Of the newest multiple of the spacing; its place on the ring is its remainder.
    newest: u64,
    changed: usize,
    times: [f64; TOGETHER],
    positions: [f64; 3 * TOGETHER],
}

impl Trace {
    fn capacity(&self) -> usize {
        self.points.len() - 1
    }

    fn place(&self, index: u64) -> usize {
        (index % self.capacity() as u64) as usize
    }

    fn set(&mut self, index: u64, point: [f32; 3]) {
        let place = self.place(index);
        self.points[place] = point;
        if place == 0 {
            let last = self.capacity();
            self.points[last] = point;
        }
    }

    fn follow(&mut self, motion: &mut Motion, time: f64) -> Outcome {
        let most = self.capacity() as u64 - 1;
        let last = (time / self.spacing).floor().max(0.0) as u64;
        if self.count == 0 || last < self.newest || last - self.newest > most {
            let first = (last + 1).saturating_sub(most);
            (self.count, self.newest, self.changed) = (0, first, self.place(first));
        } else {
            // What was the bob becomes the next point or the bob again.
            self.changed = self.place(self.newest + 1);
        }
        let stop = patience();
        let mut next = if self.count == 0 { self.newest } else { self.newest + 1 };
        while next <= last {
            let together = ((last + 1 - next) as usize).min(TOGETHER);
            for (k, time) in self.times[..together].iter_mut().enumerate() {
                *time = (next + k as u64) as f64 * self.spacing;
            }
            let positions = &mut self.positions[..3 * together];
            let outcome = motion.fill(&self.times[..together], positions, &mut [], &stop);
            if outcome != Outcome::Done {
                return outcome;
            }
            for k in 0..together {
                let position = std::array::from_fn(|i| self.positions[3 * k + i]);
                self.set(next + k as u64, motion.drawn(position));
            }
            next += together as u64;
            self.newest = next - 1;
            self.count = (self.count.max(1) + together).min(self.capacity());
        }
        let [mut position, mut velocity] = [[0.0; 3]; 2];
        let outcome = motion.fill(&[time], &mut position, &mut velocity, &stop);
        if outcome == Outcome::Done {
            self.set(self.newest + 1, motion.drawn(position));
            let ([x, y, z], [vx, vy, vz]) = (position, velocity);
            tell(&[x, y, z, vx, vy, vz, motion.pendulum.height(position)]);
        }
        outcome
    }
}

/// A trace with this spacing, s, and so many points, at least 3; null for anything else.
#[unsafe(no_mangle)]
pub extern "C" fn trace_new(spacing: f64, capacity: usize) -> Option<Box<Trace>> {
    let sound = spacing > 0.0 && spacing.is_finite() && capacity >= 3;
    sound.then(|| {
        Box::new(Trace {
            spacing,
            points: vec![[0.0; 3]; capacity + 1],
            count: 0,
            newest: 0,
            changed: 0,
            times: [0.0; TOGETHER],
            positions: [0.0; 3 * TOGETHER],
        })
    })
}

/// Gives its memory back.
#[unsafe(no_mangle)]
pub extern "C" fn trace_free(trace: Box<Trace>) {
    drop(trace);
}

/// Where its points lie; they do not move.
#[unsafe(no_mangle)]
pub extern "C" fn trace_points(trace: &Trace) -> *const f32 {
    trace.points.as_ptr().cast()
}

/// Forgets all points.
#[unsafe(no_mangle)]
pub extern "C" fn trace_restart(trace: &mut Trace) {
    trace.count = 0;
}

/// Goes on to a time, s, and tells position, velocity and height of the bob; where the time lies before the newest point or
/// too far ahead, the ring is filled anew with what leads up to it.
#[unsafe(no_mangle)]
pub extern "C" fn trace_follow(trace: &mut Trace, motion: &mut Motion, time: f64) -> Outcome {
    trace.follow(motion, time)
}

/// The bob's place on the ring.
#[unsafe(no_mangle)]
pub extern "C" fn trace_head(trace: &Trace) -> usize {
    trace.place(trace.newest + 1)
}

/// Points on the ring that are filled, the bob among them.
#[unsafe(no_mangle)]
pub extern "C" fn trace_count(trace: &Trace) -> usize {
    trace.count
}

/// The first place, going round to the head, that the latest call may have changed.
#[unsafe(no_mangle)]
pub extern "C" fn trace_changed(trace: &Trace) -> usize {
    trace.changed
}
