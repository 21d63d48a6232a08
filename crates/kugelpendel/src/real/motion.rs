//! The motion of a real pendulum: the full equations, integrated.

use crate::exact::motion::ExactMotion;
use crate::given::forces::{Drive, Forces, Thread};
use crate::given::invalid::Invalid;
use crate::given::launch::Launch;
use crate::given::pendulum::Pendulum;
use crate::given::times::{Quantity, Times, both_ways};
use crate::numbers::arithmetic::{Arithmetic, Portable, dispatch};
use crate::numbers::double_double::{Dd, Pair};
use crate::real::sphere::Sphere;
use crate::real::walk::Walk;
use crate::taylor::events::{Beside, Beyond, Crossings, Event, Guard, Outward, Sinking, crossings};
use crate::taylor::series::{FINEST, Point};

/// From where, and under which forces.
#[derive(Clone, Debug)]
pub struct RealMotion {
    pub(crate) pendulum: Pendulum,
    pub(crate) drive: Drive,
    pub(crate) thread: Thread,
    pub(crate) tolerance: f64,
    pub(crate) law: Sphere,
    pub(crate) start: Point,
    omega0: Pair,
}

/// Why an integration has not come to the end of what was asked.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Halt {
    /// The thread has gone slack, at this time in s.
    Ended(f64),
    /// Whoever asked does not want it any more.
    Interrupted,
}

/// Asked now and then during long work; `true` ends it.
pub type Stop<'a> = &'a (dyn Fn() -> bool + Sync);

/// Steps between two such questions.
const PATIENCE: usize = 4096;

/// The walks of a motion, forwards and backwards, as far as they have come. A request that begins no earlier goes on
/// from there, with the same steps as from the launch.
#[derive(Clone, Debug, Default)]
pub struct Walks([Option<Box<Walk>>; 2]);

impl RealMotion {
    /// The pendulum's gravity is what moves the bob, buoyancy and all taken into account.
    ///
    /// # Errors
    /// A pendulum or launch that makes no sense.
    pub fn new(
        pendulum: Pendulum,
        launch: Launch,
        forces: Forces,
        drive: Drive,
        thread: Thread,
        tolerance: f64,
    ) -> Result<Self, Invalid> {
        let exact = ExactMotion::new(pendulum, launch)?;
        let (mut place, mut rate) = ([0.0; 3], [0.0; 3]);
        exact.fill(Quantity::Position, Times::Scattered(&[0.0]), &mut place);
        exact.fill(Quantity::Velocity, Times::Scattered(&[0.0]), &mut rate);
        let omega0 = exact.omega0;
        let speed = pendulum.length * omega0.hi;
        let [x, y, z] = place.map(|value| value / pendulum.length);
        let [vx, vy, vz] = rate.map(|value| value / speed);
        let start = Point { place: [x, y, z, 0.0], rate: [vx, vy, vz, 0.0] };
        let law = Sphere::new(&forces, pendulum.length, omega0.hi);
        Ok(Self { pendulum, drive, thread, tolerance: tolerance.max(FINEST), law, start, omega0 })
    }

    /// lω0.
    pub(crate) fn speed(&self) -> f64 {
        self.pendulum.length * self.omega0.hi
    }

    /// Fills `out`, three numbers to a time; beyond an end it is left as it was.
    ///
    /// # Errors
    /// What halted it.
    ///
    /// # Panics
    /// If times and `out` do not have the same count.
    pub fn fill(
        &self,
        quantity: Quantity,
        times: &[f64],
        out: &mut [f64],
        walks: &mut Walks,
        stop: Stop<'_>,
    ) -> Result<(), Halt> {
        assert_eq!(3 * times.len(), out.len(), "three numbers to a time");
        self.visit(times, walks, stop, |walk, since, index| {
            let triple = &mut out[3 * index..3 * index + 3];
            triple.copy_from_slice(&at(walk, since, self, quantity));
        })
    }

    /// Fills `out` with the pull of the thread in N, 0 where it is slack.
    ///
    /// # Errors
    /// What halted it.
    ///
    /// # Panics
    /// If times and `out` do not have the same count.
    pub fn fill_tension(&self, times: &[f64], out: &mut [f64], walks: &mut Walks, stop: Stop<'_>) -> Result<(), Halt> {
        assert_eq!(times.len(), out.len(), "one number to a time");
        let weight = self.pendulum.mass * self.pendulum.gravity;
        self.visit(times, walks, stop, |walk, since, index| {
            out[index] = if walk.free { 0.0 } else { weight * guard_at(walk, since) };
        })
    }

    /// The times in s of an event, from `start` to `end`, at most `most` of them; fewer where the motion ends before.
    ///
    /// # Errors
    /// Only an interruption.
    pub fn events(
        &self,
        event: Event,
        [start, end]: [f64; 2],
        most: usize,
        walks: &mut Walks,
        stop: Stop<'_>,
    ) -> Result<Vec<f64>, Halt> {
        let mut found = Vec::new();
        let event = match event {
            Event::Radius(radius) => Event::Radius(radius / self.pendulum.length),
            other => other,
        };
        let walk = self.walk(walks, 0, self.dimensionless(start));
        let mut steps = 0;
        loop {
            // What ends before the start is passed over without a look.
            if !walk.is_before(walk.since(self.dimensionless(start))) || walk.last {
                let times = happen(walk, event).into_iter().map(|since| self.seconds(walk, since));
                found.extend(times.filter(|time| (start..=end).contains(time)));
                found.truncate(most);
            }
            let done = walk.last || !walk.is_before(walk.since(self.dimensionless(end)));
            if done || found.len() == most {
                return Ok(found);
            }
            walk.advance(self);
            steps += 1;
            if steps % PATIENCE == 0 && stop() {
                return Err(Halt::Interrupted);
            }
        }
    }

    fn visit(
        &self,
        times: &[f64],
        walks: &mut Walks,
        stop: Stop<'_>,
        mut take: impl FnMut(&Walk, f64, usize),
    ) -> Result<(), Halt> {
        both_ways(times, |side, order| self.sweep(side, order, times, walks, stop, &mut take))
    }

    fn sweep(
        &self,
        side: usize,
        order: &mut dyn Iterator<Item = usize>,
        times: &[f64],
        walks: &mut Walks,
        stop: Stop<'_>,
        take: &mut impl FnMut(&Walk, f64, usize),
    ) -> Result<(), Halt> {
        let Some(mut index) = order.next() else { return Ok(()) };
        let walk = self.walk(walks, side, self.dimensionless(times[index]));
        let mut steps = 0;
        loop {
            let since = walk.since(self.dimensionless(times[index]));
            if !walk.is_before(since) {
                take(walk, since, index);
                index = match order.next() {
                    Some(index) => index,
                    None => return Ok(()),
                };
            } else if walk.last {
                return Err(Halt::Ended(self.seconds(walk, walk.size)));
            } else {
                walk.advance(self);
                steps += 1;
                if steps % PATIENCE == 0 && stop() {
                    return Err(Halt::Interrupted);
                }
            }
        }
    }

    /// The walk of one side, where it has not passed this time yet, or from the launch.
    fn walk<'a>(&self, walks: &'a mut Walks, side: usize, time: Pair) -> &'a mut Walk {
        let direction = [1.0, -1.0][side];
        let slot = &mut walks.0[side];
        if slot.as_ref().is_some_and(|walk| walk.since(time) * direction < 0.0) {
            *slot = None;
        }
        slot.get_or_insert_with(|| Box::new(Walk::new(self, direction)))
    }

    fn dimensionless(&self, time: f64) -> Pair {
        dimensionless(time, self.omega0)
    }

    fn seconds(&self, walk: &Walk, since: f64) -> f64 {
        (walk.start.hi + (walk.start.lo + since)) / self.omega0.hi
    }
}

dispatch! {
    fn dimensionless(time: f64, omega0: Pair) -> Pair = dimensionless_with
}

#[inline(always)]
fn dimensionless_with<A: Arithmetic>(_: A, time: f64, omega0: Pair) -> Pair {
    (Dd::<A>::of(omega0) * time).pair()
}

dispatch! {
    fn at(walk: &Walk, since: f64, motion: &RealMotion, quantity: Quantity) -> [f64; 3] = at_with
}

#[inline(always)]
fn at_with<A: Arithmetic>(_: A, walk: &Walk, since: f64, motion: &RealMotion, quantity: Quantity) -> [f64; 3] {
    let Point { place: [x, y, z, _], rate: [vx, vy, vz, _] } = walk.series.at::<A>(since);
    match quantity {
        Quantity::Position => [x, y, z].map(|value| value * motion.pendulum.length),
        Quantity::Velocity => [vx, vy, vz].map(|value| value * motion.speed()),
    }
}

dispatch! {
    fn guard_at(walk: &Walk, since: f64) -> f64 = guard_at_with
}

#[inline(always)]
fn guard_at_with<A: Arithmetic>(_: A, walk: &Walk, since: f64) -> f64 {
    walk.series.guard_at::<A>(since)
}

dispatch! {
    /// The times of an event since the start of the step, in order.
    fn happen(walk: &Walk, event: Event) -> Vec<f64> = happen_with
}

#[inline(always)]
fn happen_with<A: Arithmetic>(_: A, walk: &Walk, event: Event) -> Vec<f64> {
    let Walk { series, size, .. } = walk;
    match event {
        Event::Outer => crossings::<A>(&Outward(series), *size, false).times().to_vec(),
        Event::Inner => crossings::<A>(&Outward(series), *size, true).times().to_vec(),
        Event::Azimuth(azimuth) => {
            let (sin, cos) = azimuth.sin_cos();
            let beside = Beside(series, [cos, sin]);
            let mut times = either_way([true, false].map(|upwards| crossings::<A>(&beside, *size, upwards)));
            times.retain(|time| {
                let [x, y, _, _] = series.place_at::<Portable>(*time);
                x * cos + y * sin > 0.0
            });
            times
        }
        Event::Bottom => crossings::<A>(&Sinking(series), *size, false).times().to_vec(),
        Event::Radius(radius) => {
            let beyond = Beyond(series, radius);
            either_way([true, false].map(|upwards| crossings::<A>(&beyond, *size, upwards)))
        }
        Event::Slack if walk.slackens() => vec![*size],
        Event::Slack if !walk.free && !series.guard_holds(*size) => {
            crossings::<A>(&Guard(series), *size, false).times().to_vec()
        }
        Event::Taut if walk.tautens() => vec![*size],
        Event::Slack | Event::Taut => Vec::new(),
    }
}

/// Passages in either direction, in order.
fn either_way(passages: [Crossings; 2]) -> Vec<f64> {
    let mut times: Vec<f64> = passages.iter().flat_map(|crossings| crossings.times().iter().copied()).collect();
    times.sort_by(f64::total_cmp);
    times
}
