//! The real motion step by step, with what happens between the steps: the thread goes slack, or taut; the drive pushes.

use crate::given::drive::Drive;
use crate::given::forces::Thread;
use crate::numbers::arithmetic::{Arithmetic, dispatch};
use crate::numbers::double_double::{Dd, Pair};
use crate::real::motion::RealMotion;
use crate::real::sphere::{Kind, turning_point};
use crate::taylor::events::{Beyond, Guard, Outside, Outward, first};
use crate::taylor::series::{Law, Point, Series};

/// In 1/ω0. Longer ones are never worth their last terms, and an event could come and go within.
const LONGEST: f64 = 1.5;

/// Where the motion has come to: the step under way and what follows it.
#[derive(Clone, Debug)]
pub(crate) struct Walk {
    pub(crate) direction: f64,
    /// Of the step's start, in 1/ω0.
    pub(crate) start: Pair,
    pub(crate) size: f64,
    pub(crate) series: Series,
    /// The thread is slack during the step.
    pub(crate) free: bool,
    /// The step's end is the last of the motion.
    pub(crate) last: bool,
    next: Point,
    next_free: bool,
    /// An outer turning point has passed since the last push.
    armed: bool,
    /// Until a push that is due, in 1/ω0 from the step's start.
    push_in: Option<f64>,
}

impl Walk {
    pub(crate) fn new(motion: &RealMotion, direction: f64) -> Self {
        let mut walk = Self {
            direction,
            start: Pair { hi: 0.0, lo: 0.0 },
            size: 0.0,
            series: Series::ZERO,
            free: false,
            last: false,
            next: motion.start,
            next_free: false,
            armed: true,
            push_in: None,
        };
        walk.advance(motion);
        walk
    }

    /// Time since the start of the step.
    pub(crate) fn since(&self, time: Pair) -> f64 {
        (time.hi - self.start.hi) + (time.lo - self.start.lo)
    }

    /// Whether the step has not come so far yet.
    pub(crate) fn is_before(&self, since: f64) -> bool {
        since * self.direction > self.size * self.direction
    }

    /// Whether the thread goes slack at the step's end.
    pub(crate) fn slackens(&self) -> bool {
        self.last || (self.next_free && !self.free)
    }

    /// Whether the thread is taut again from the step's end on.
    pub(crate) fn tautens(&self) -> bool {
        self.free && !self.next_free
    }

    /// The next step.
    pub(crate) fn advance(&mut self, motion: &RealMotion) {
        advance(motion, self);
    }
}

dispatch! {
    fn advance(motion: &RealMotion, walk: &mut Walk) = advance_with
}

#[inline(always)]
fn advance_with<A: Arithmetic>(_: A, motion: &RealMotion, walk: &mut Walk) {
    walk.start = (Dd::<A>::of(walk.start) + Dd::from(walk.size)).pair();
    walk.push_in = walk.push_in.map(|time| time - walk.size);
    walk.free = walk.next_free;
    let law = &motion.law;
    walk.series.start(&walk.next);
    let series = &mut walk.series;
    match (law.forced, law.quadratic != 0.0, !walk.free) {
        (false, false, true) => Law::<A>::continue_series(&Kind::<false, false, true>(law), series),
        (true, false, true) => Law::<A>::continue_series(&Kind::<true, false, true>(law), series),
        (_, true, true) => Law::<A>::continue_series(&Kind::<true, true, true>(law), series),
        (_, false, false) => Law::<A>::continue_series(&Kind::<true, false, false>(law), series),
        (_, true, false) => Law::<A>::continue_series(&Kind::<true, true, false>(law), series),
    };
    walk.size = walk.direction * walk.series.reach(motion.tolerance).min(LONGEST);
    if law.quadratic != 0.0 {
        walk.size = turning_point::<A>(&walk.series, walk.size).unwrap_or(walk.size);
    }
    if walk.free {
        walk.becomes_taut::<A>();
    } else {
        walk.may_slacken::<A>(motion);
    }
    let pushed = walk.is_pushed::<A>(motion);
    walk.next = walk.series.at::<A>(walk.size);
    if !walk.next_free {
        onto_sphere(&mut walk.next);
    }
    if pushed {
        walk.push(motion);
    }
}

impl Walk {
    /// In flight: cuts the step where the bob comes back to the sphere.
    #[inline(always)]
    fn becomes_taut<A: Arithmetic>(&mut self) {
        // It starts on the sphere, which is no return.
        let back = first::<A>(&Outside(&self.series), self.size, true).filter(|back| *back != 0.0);
        if let Some(size) = back {
            self.size = size;
            self.next_free = false;
        }
    }

    /// On the sphere: cuts the step where the thread's pull reaches zero.
    #[inline(always)]
    fn may_slacken<A: Arithmetic>(&mut self, motion: &RealMotion) {
        if motion.thread == Thread::Rod || self.series.guard_holds(self.size) {
            return;
        }
        let already = self.series.guard[0] <= 0.0;
        let root = if already { Some(0.0) } else { first::<A>(&Guard(&self.series), self.size, false) };
        let Some(size) = root else { return };
        self.size = size;
        match motion.thread {
            Thread::Flies => self.next_free = true,
            _ => self.last = true,
        }
    }

    /// Cuts the step where the drive pushes.
    #[inline(always)]
    fn is_pushed<A: Arithmetic>(&mut self, motion: &RealMotion) -> bool {
        let (phase, radius) = match motion.drive {
            Drive::Absent => return false,
            Drive::Phase { phase, .. } => (phase, None),
            Drive::Radius { radius, .. } => (0.0, Some(radius / motion.pendulum.length)),
        };
        let series = &self.series;
        if self.armed && self.push_in.is_none() {
            self.push_in = match radius {
                None => first::<A>(&Outward(series), self.size, true).map(|closest| closest + phase),
                Some(radius) => first::<A>(&Beyond(series, radius), self.size, true),
            };
            self.armed = self.push_in.is_none();
        }
        let pushed = match self.push_in {
            Some(time) if time <= self.size => {
                // What the thread would have done later it may not do now.
                if time < self.size {
                    (self.next_free, self.last) = (self.free, false);
                }
                self.size = time.max(0.0);
                self.push_in = None;
                true
            }
            _ => false,
        };
        self.armed |= first::<A>(&Outward(&self.series), self.size, false).is_some();
        pushed
    }

    fn push(&mut self, motion: &RealMotion) {
        let (Drive::Phase { push, .. } | Drive::Radius { push, .. }) = motion.drive else { return };
        let push = push / motion.speed();
        let Point { place: [x, y, _, _], rate } = &mut self.next;
        let distance = x.hypot(*y);
        // On the axis itself away from it is where the bob is going.
        let [ux, uy] = if distance > 0.0 {
            [*x / distance, *y / distance]
        } else {
            let speed = rate[0].hypot(rate[1]);
            if speed == 0.0 { return } else { [rate[0] / speed, rate[1] / speed] }
        };
        rate[0] += push * ux;
        rate[1] += push * uy;
        if !self.next_free {
            onto_sphere(&mut self.next);
        }
    }
}

/// Takes away what rounding, or the thread's jerk, has left of r·r − 1 and r·v.
#[inline(always)]
fn onto_sphere(point: &mut Point) {
    let Point { place, rate } = point;
    let [x, y, z, _] = *place;
    let excess = 0.5 * (x * x + y * y + (z - 1.0) * (z + 1.0));
    let along = x * rate[0] + y * rate[1] + z * rate[2];
    for lane in 0..3 {
        rate[lane] -= along * place[lane];
        place[lane] -= excess * place[lane];
    }
}
