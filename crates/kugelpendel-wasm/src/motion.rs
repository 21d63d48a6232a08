//! A motion by one of the laws, from its launch on, asked at many times.

use crate::exchange::{refuse, tell};
use crate::given::Given;
use crate::memory::{numbers, room};
use kugelpendel::{
    Ellipse, Ending, Envelope, EnvelopeMotion, EnvelopeWalks, Equation, Event, ExactMotion, Halt, HarmonicLaw,
    HarmonicMotion, IntegratedMotion, Invalid, Pendulum, Quantity, Readings, RealMotion, Thread, Times, Walk,
    distances, unwrap,
};
use std::f64::consts::PI;
use std::sync::atomic::{AtomicU32, Ordering};

/// Checkpoints that a walk keeps.
const KEPT: usize = 1024;

/// The tolerance of the integration, that of the Python package.
const TOLERANCE: f64 = 1e-17;

/// Points that are computed together.
pub(crate) const TOGETHER: usize = 256;

/// Questions whether to go on, some hundred microseconds apart, before a call that may be asked again comes back.
const PATIENCE: u32 = 24;

/// A motion, and where it ended if that has been seen.
#[derive(Debug)]
pub struct Motion {
    course: Course,
    pub(crate) pendulum: Pendulum,
    /// Of the ground about the vertical, rad/s.
    rotation: f64,
    ended: Option<(f64, Ending)>,
}

#[derive(Debug)]
enum Course {
    Exact(Box<ExactMotion>),
    Harmonic(Box<HarmonicMotion>),
    Integrated(Box<IntegratedMotion>, Walk),
    Averaged(Box<EnvelopeMotion>, EnvelopeWalks),
    Real(Box<RealMotion>, Walk),
}

/// How a request has gone.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[repr(u32)]
pub enum Outcome {
    /// All has been written.
    Done = 0,
    /// The motion ends before the last time.
    Ended = 1,
    /// It would take longer; what has been done is kept, and the same request goes on from there.
    Unfinished = 2,
}

impl Motion {
    pub(crate) fn new(law: u32) -> Result<Self, Invalid> {
        let given = Given::receive()?;
        let Given { pendulum, effective, launch, ref acting } = given;
        let integrated = |equation| IntegratedMotion::new(effective, equation, launch);
        let real = |thread| RealMotion::under(acting, pendulum, launch, thread, TOLERANCE);
        let course = match law {
            0 => Course::Exact(Box::new(given.ideal()?)),
            1 => Course::Harmonic(Box::new(HarmonicMotion::new(effective, launch, HarmonicLaw::Linear)?)),
            2 => Course::Harmonic(Box::new(HarmonicMotion::new(effective, launch, HarmonicLaw::Olsson)?)),
            3 => Course::Integrated(Box::new(integrated(Equation::Cubic)?), Walk::new(KEPT)),
            4 => {
                let averaged = EnvelopeMotion::under(acting, pendulum, launch, true, 1.0)?;
                Course::Averaged(Box::new(averaged), EnvelopeWalks::default())
            }
            5 => Course::Real(Box::new(real(Thread::Ends)?), Walk::new(KEPT)),
            _ => Course::Real(Box::new(real(Thread::Rod)?), Walk::new(KEPT)),
        };
        let rotation = match course {
            Course::Averaged(..) | Course::Real(..) => acting.forces().rotation[1],
            _ => 0.0,
        };
        Ok(Self { course, pendulum: effective, rotation, ended: None })
    }

    /// Positions and velocities at ascending times; slices that are empty are not asked for.
    pub(crate) fn fill(
        &mut self,
        times: &[f64],
        position: &mut [f64],
        velocity: &mut [f64],
        stop: &(dyn Fn() -> bool + Sync),
    ) -> Outcome {
        let mut quantities = [(Quantity::Position, &mut *position), (Quantity::Velocity, &mut *velocity)];
        let wanted = quantities.iter_mut().filter(|(_, out)| !out.is_empty());
        let halted = match &mut self.course {
            Course::Exact(motion) => {
                wanted.for_each(|(quantity, out)| motion.fill(*quantity, Times::Scattered(times), out));
                Ok(())
            }
            Course::Harmonic(motion) => {
                wanted.for_each(|(quantity, out)| motion.fill(*quantity, Times::Scattered(times), out));
                Ok(())
            }
            Course::Averaged(motion, walks) => wanted
                .map(|(quantity, out)| motion.fill(Envelope::Point(*quantity), times, out, walks, stop))
                .fold(Ok(()), Result::and),
            Course::Integrated(motion, walk) => {
                let mut readings = Readings { times, position, velocity, ..Readings::default() };
                motion.read(&mut readings, walk, stop)
            }
            Course::Real(motion, walk) => {
                let mut readings = Readings { times, position, velocity, ..Readings::default() };
                motion.read(&mut readings, walk, stop)
            }
        };
        self.noted(halted)
    }

    fn noted(&mut self, halted: Result<(), Halt>) -> Outcome {
        match halted {
            Ok(()) => Outcome::Done,
            Err(Halt::Interrupted) => Outcome::Unfinished,
            Err(Halt::Ended(time, why)) => {
                self.ended = Some((time, why));
                Outcome::Ended
            }
        }
    }

    /// All positions and velocities; NaN beyond an end.
    pub(crate) fn states(&mut self, times: &[f64]) -> [Vec<f64>; 2] {
        let [mut position, mut velocity] = [(); 2].map(|()| vec![f64::NAN; 3 * times.len()]);
        self.fill(times, &mut position, &mut velocity, &|| false);
        [position, velocity]
    }

    /// All positions at start + step·k; NaN beyond an end.
    fn on_a_grid(&mut self, start: f64, step: f64, count: usize) -> Vec<f64> {
        let mut positions = vec![f64::NAN; 3 * count];
        let grid = Times::Grid { start, step, first: 0 };
        match &self.course {
            Course::Exact(motion) => motion.fill(Quantity::Position, grid, &mut positions),
            Course::Harmonic(motion) => motion.fill(Quantity::Position, grid, &mut positions),
            _ => {
                let times: Vec<f64> = (0..count).map(|k| start + step * k as f64).collect();
                self.fill(&times, &mut positions, &mut [], &|| false);
            }
        }
        positions
    }

    /// A position as it is drawn: in lengths, the third number 1 − cos θ.
    pub(crate) fn drawn(&self, position: [f64; 3]) -> [f32; 3] {
        let [x, y, _] = position;
        let length = self.pendulum.length;
        [x / length, y / length, self.pendulum.height(position)].map(|value| value as f32)
    }

    /// Of the major axis, rad.
    fn azimuths(&mut self, times: &[f64], out: &mut [f64]) {
        let evenly = |time: f64, azimuth: f64, rate: f64, out: &mut [f64]| {
            out.iter_mut().zip(times).for_each(|(out, t)| *out = azimuth + rate * (t - time));
        };
        match &mut self.course {
            Course::Exact(motion) => {
                let (rate, _) = motion.turning_rate();
                evenly(motion.apsis_time(), motion.apsis_azimuth(), rate, out);
            }
            Course::Harmonic(motion) => evenly(motion.apsis_time, motion.apsis_azimuth, motion.precession, out),
            Course::Averaged(motion, walks) => {
                let halted = motion.fill(Envelope::Azimuth, times, out, walks, &|| false);
                self.noted(halted);
            }
            Course::Integrated(..) | Course::Real(..) => {
                let ellipses = self.osculating(times);
                out.iter_mut().zip(ellipses).for_each(|(out, ellipse)| *out = ellipse.azimuth);
                unwrap(out, PI, None);
            }
        }
    }

    fn osculating(&mut self, times: &[f64]) -> Vec<Ellipse> {
        let [positions, velocities] = self.states(times);
        let triple = |numbers: &[f64], index: usize| std::array::from_fn(|k| numbers[3 * index + k]);
        Ellipse::osculating(times.len(), |index| {
            (self.pendulum, triple(&positions, index), triple(&velocities, index), self.rotation)
        })
    }

    /// a, b and azimuth at ascending times, the azimuth continuous; those of the averaged motion are its own.
    pub(crate) fn ellipses(&mut self, times: &[f64], out: &mut [f64]) {
        if let Course::Averaged(motion, walks) = &mut self.course {
            let halted = motion.fill(Envelope::Ellipse, times, out, walks, &|| false);
            self.noted(halted);
            return;
        }
        let ellipses = self.osculating(times);
        let mut azimuths: Vec<f64> = ellipses.iter().map(|ellipse| ellipse.azimuth).collect();
        unwrap(&mut azimuths, PI, None);
        for ((out, Ellipse { a, b, .. }), azimuth) in out.chunks_exact_mut(3).zip(ellipses).zip(azimuths) {
            out.copy_from_slice(&[a, b, azimuth]);
        }
    }

    fn turning_times(&mut self, between: [f64; 2], most: usize) -> Vec<f64> {
        let mut readings = Readings { events: &[Event::Outer], between, most, ..Readings::default() };
        let halted = match &mut self.course {
            Course::Exact(motion) => return motion.events(Event::Outer, between, most, &|| false).unwrap_or_default(),
            Course::Harmonic(motion) => {
                return motion.events(Event::Outer, between, most, &|| false).unwrap_or_default();
            }
            Course::Averaged(..) => return Vec::new(),
            Course::Integrated(motion, walk) => motion.read(&mut readings, walk, &|| false),
            Course::Real(motion, walk) => motion.read(&mut readings, walk, &|| false),
        };
        let times = readings.found.iter().flatten().map(|passage| passage.time).collect();
        self.noted(halted);
        times
    }

    /// The pull of the thread, N.
    fn tension(&mut self, time: f64, [position, velocity]: [[f64; 3]; 2]) -> f64 {
        let mut tension = [f64::NAN];
        let times = &[time];
        let mut readings = Readings { times, tension: &mut tension, ..Readings::default() };
        // A motion that has been read at this time does not end before it.
        let _ = match &mut self.course {
            Course::Integrated(motion, walk) => motion.read(&mut readings, walk, &|| false),
            Course::Real(motion, walk) => motion.read(&mut readings, walk, &|| false),
            _ => return self.pendulum.pull(position, velocity),
        };
        tension[0]
    }

    /// The rate of the plane by its causes, rad/s, then those of a and b, m/s.
    pub(crate) fn rates(&mut self, time: f64) -> Option<[f64; 7]> {
        let Course::Averaged(motion, walks) = &mut self.course else { return None };
        let mut rates = [f64::NAN; 7];
        let halted = motion.fill(Envelope::Rates, &[time], &mut rates, walks, &|| false);
        (self.noted(halted) == Outcome::Done).then_some(rates)
    }

    pub(crate) fn averaged(&self) -> Option<&EnvelopeMotion> {
        if let Course::Averaged(motion, _) = &self.course { Some(motion) } else { None }
    }
}

/// Says stop after so many questions.
pub(crate) fn patience() -> impl Fn() -> bool + Sync {
    let asked = AtomicU32::new(0);
    move || asked.fetch_add(1, Ordering::Relaxed) >= PATIENCE
}

/// The motion of what is given, by a law: 0 exact, 1 linear, 2 turning ellipse, 3 cubic, 4 averaged, 5 real, 6 real on a
/// rod. Null where it is refused, which is told.
#[unsafe(no_mangle)]
pub extern "C" fn motion_new(law: u32) -> Option<Box<Motion>> {
    Motion::new(law).map(Box::new).inspect_err(refuse).ok()
}

/// Gives its memory back.
#[unsafe(no_mangle)]
pub extern "C" fn motion_free(motion: Box<Motion>) {
    drop(motion);
}

/// Position, velocity, height, tension at a time; a call may come back unfinished.
#[unsafe(no_mangle)]
pub extern "C" fn motion_state(motion: &mut Motion, time: f64) -> Outcome {
    let [mut position, mut velocity] = [[f64::NAN; 3]; 2];
    let outcome = motion.fill(&[time], &mut position, &mut velocity, &patience());
    if outcome == Outcome::Done {
        let (height, tension) = (motion.pendulum.height(position), motion.tension(time, [position, velocity]));
        let ([x, y, z], [vx, vy, vz]) = (position, velocity);
        tell(&[x, y, z, vx, vy, vz, height, tension]);
    }
    outcome
}

/// Whether an end has been seen; it is told: the time and 0 for slack, 1 for level, 2 for running away.
#[unsafe(no_mangle)]
pub extern "C" fn motion_ended(motion: &Motion) -> u32 {
    let Some((time, why)) = motion.ended else { return 0 };
    let why = match why {
        Ending::Slack => 0.0,
        Ending::Level => 1.0,
        Ending::Runaway => 2.0,
    };
    tell(&[time, why]);
    1
}

/// x, y, z at ascending times; NaN beyond an end.
///
/// # Safety
/// `count` times lie at `times`, and `out` has room for thrice as many.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn motion_positions(motion: &mut Motion, times: *const f64, count: usize, out: *mut f64) {
    // SAFETY: the caller's promise.
    let (times, out) = unsafe { (numbers(times, count), room(out, 3 * count)) };
    out.fill(f64::NAN);
    motion.fill(times, out, &mut [], &|| false);
}

/// Azimuths of the major axis at ascending times; NaN beyond an end.
///
/// # Safety
/// `count` times lie at `times`, and `out` has room for as many.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn motion_azimuths(motion: &mut Motion, times: *const f64, count: usize, out: *mut f64) {
    // SAFETY: the caller's promise.
    let (times, out) = unsafe { (numbers(times, count), room(out, count)) };
    out.fill(f64::NAN);
    motion.azimuths(times, out);
}

/// How far two motions are apart, m, at ascending times; NaN beyond an end of either.
///
/// # Safety
/// As for [`motion_azimuths`]; the motions are two.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn motion_distances(
    motion: &mut Motion,
    other: &mut Motion,
    times: *const f64,
    count: usize,
    out: *mut f64,
) {
    // SAFETY: the caller's promise.
    let (times, out) = unsafe { (numbers(times, count), room(out, count)) };
    let [[first, _], [second, _]] = [motion.states(times), other.states(times)];
    out.copy_from_slice(&distances(&first, &second));
}

/// a, b and azimuth of the ellipse at ascending times; NaN beyond an end.
///
/// # Safety
/// `count` times lie at `times`, and `out` has room for thrice as many.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn motion_ellipses(motion: &mut Motion, times: *const f64, count: usize, out: *mut f64) {
    // SAFETY: the caller's promise.
    let (times, out) = unsafe { (numbers(times, count), room(out, 3 * count)) };
    out.fill(f64::NAN);
    motion.ellipses(times, out);
}

/// Points as they are drawn, three 32-bit numbers each, at start + step·k; NaN beyond an end.
///
/// # Safety
/// `out` has room for `count` points.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn motion_drawn(motion: &mut Motion, start: f64, step: f64, count: usize, out: *mut [f32; 3]) {
    // SAFETY: the caller's promise.
    let out = unsafe { std::slice::from_raw_parts_mut(out, count) };
    let positions = motion.on_a_grid(start, step, count);
    for (out, place) in out.iter_mut().zip(positions.as_chunks::<3>().0) {
        *out = motion.drawn(*place);
    }
}

/// Outer turning points from one time to another, `most` at most: for each the time, x, y, z, a, b, azimuth. How many.
///
/// # Safety
/// `out` has room for seven numbers to each of the most.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn motion_turning_points(
    motion: &mut Motion,
    from: f64,
    to: f64,
    most: usize,
    out: *mut f64,
) -> usize {
    let times = motion.turning_times([from, to], most);
    let [positions, _] = motion.states(&times);
    let mut ellipses = vec![f64::NAN; 3 * times.len()];
    motion.ellipses(&times, &mut ellipses);
    // SAFETY: the caller's promise; no more than the most are found.
    let out = unsafe { room(out, 7 * times.len()) };
    let rows = positions.as_chunks::<3>().0.iter().zip(ellipses.as_chunks::<3>().0);
    for ((out, time), ([x, y, z], [a, b, azimuth])) in out.chunks_exact_mut(7).zip(&times).zip(rows) {
        out.copy_from_slice(&[*time, *x, *y, *z, *a, *b, *azimuth]);
    }
    times.len()
}

/// x, y and their rates at ascending times.
pub(crate) fn plan_states(motion: &mut Motion, times: &[f64]) -> Vec<[f64; 4]> {
    let [positions, velocities] = motion.states(times);
    let rows = positions.chunks_exact(3).zip(velocities.chunks_exact(3));
    rows.map(|(r, v)| [r[0], r[1], v[0], v[1]]).collect()
}
