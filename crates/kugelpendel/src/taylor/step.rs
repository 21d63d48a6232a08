//! One step of an integration, and what the next one starts from.

use crate::numbers::arithmetic::{Arithmetic, Portable, dispatch};
use crate::numbers::double_double::{Dd, Pair};
use crate::taylor::events::{Beside, Beyond, Event, Guard, Outward, crossings};
use crate::taylor::layout::Alone;
use crate::taylor::series::{Point, Series};

/// Everything that the motion from here on depends on: whoever keeps one can go on from it, with the same bits.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Checkpoint {
    /// Steps since the launch.
    pub(crate) count: u64,
    /// In 1/ω0.
    pub(crate) time: Pair,
    pub(crate) point: Point,
    /// The thread is slack.
    pub(crate) free: bool,
    /// An outer turning point has passed since the last push.
    pub(crate) armed: bool,
    /// Until a push that is due, in 1/ω0.
    pub(crate) push_in: Option<f64>,
}

impl Checkpoint {
    pub(crate) fn launch(point: Point) -> Self {
        Self { count: 0, time: Pair { hi: 0.0, lo: 0.0 }, point, free: false, armed: true, push_in: None }
    }

    /// How much later than this a time is, in 1/ω0.
    pub(crate) fn since(&self, time: Pair) -> f64 {
        (time.hi - self.time.hi) + (time.lo - self.time.lo)
    }

    /// What comes after a step of this size that ends at `point`, with the thread and the drive as they were.
    #[inline(always)]
    pub(crate) fn after<A: Arithmetic>(&self, size: f64, point: Point) -> Self {
        let time = (Dd::<A>::of(self.time) + Dd::from(size)).pair();
        Self { count: self.count + 1, time, point, ..*self }
    }
}

/// What the thread does at the end of a step.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) enum ThreadChange {
    #[default]
    None,
    Slackens,
    Tautens,
}

/// Why a motion cannot be followed any further.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Ending {
    /// The thread has gone slack.
    Slack,
    /// The bob has come to the height of the support, where the paper's equations in the plan view end.
    Level,
    /// The speed has grown beyond all bounds, as it does backwards in time under quadratic drag.
    Runaway,
}

/// A step: the motion as a series from `start` on, as far as `size`, with the sign of the direction.
#[derive(Clone, Debug)]
pub(crate) struct Step {
    pub(crate) start: Checkpoint,
    pub(crate) size: f64,
    pub(crate) series: Series,
    pub(crate) thread: ThreadChange,
    /// Why the step's end is that of the motion.
    pub(crate) ending: Option<Ending>,
    pub(crate) next: Checkpoint,
}

impl Step {
    /// Before the first step.
    pub(crate) fn before(next: Checkpoint) -> Self {
        Self { start: next, size: 0.0, series: Series::ZERO, thread: ThreadChange::None, ending: None, next }
    }

    /// Whether the step does not come so far, in 1/ω0 since its start.
    pub(crate) fn is_before(&self, since: f64, direction: f64) -> bool {
        let beyond = (since - self.size) * direction;
        // The end of a motion, after its conversion to seconds and back, still belongs to it.
        let rounding = if self.ending.is_some() { 1e-15 * (self.start.time.hi + self.size).abs() } else { 0.0 };
        beyond > rounding
    }

    /// A time since the step's start, in s since the launch.
    pub(crate) fn seconds(&self, since: f64, omega0: f64) -> f64 {
        let Pair { hi, lo } = self.start.time;
        (hi + (lo + since)) / omega0
    }
}

dispatch! {
    /// Position and velocity so long after the step's start.
    pub(crate) fn point_at(step: &Step, since: f64) -> Point = point_at_with
}

#[inline(always)]
fn point_at_with<A: Arithmetic>(_: A, step: &Step, since: f64) -> Point {
    step.series.at::<Alone<A>>(since)
}

dispatch! {
    pub(crate) fn guard_at(step: &Step, since: f64) -> f64 = guard_at_with
}

#[inline(always)]
fn guard_at_with<A: Arithmetic>(_: A, step: &Step, since: f64) -> f64 {
    step.series.guard_at::<Alone<A>>(since)
}

dispatch! {
    /// The times of an event since the start of the step, in order; the event's radius in lengths.
    pub(crate) fn happens(step: &Step, event: Event) -> Vec<f64> = happens_with
}

#[inline(always)]
fn happens_with<A: Arithmetic>(_: A, step: &Step, event: Event) -> Vec<f64> {
    let Step { series, size, .. } = step;
    let position = |time: f64| series.position_at::<Alone<Portable>>(time);
    match event {
        Event::Outer => crossings::<A>(&Outward(series), *size, false).times().to_vec(),
        Event::Inner => crossings::<A>(&Outward(series), *size, true).times().to_vec(),
        Event::Bottom => {
            let mut times = crossings::<A>(&Outward(series), *size, true).times().to_vec();
            times.retain(|time| position(*time)[2] >= 0.0);
            times
        }
        Event::Azimuth(azimuth) => {
            let (sin, cos) = azimuth.sin_cos();
            let beside = Beside(series, [cos, sin]);
            let [up, down] = [true, false].map(|upwards| crossings::<A>(&beside, *size, upwards));
            let mut times = [up.times(), down.times()].concat();
            times.retain(|time| {
                let [x, y, _, _] = position(*time);
                x * cos + y * sin > 0.0
            });
            times.sort_by(f64::total_cmp);
            times
        }
        Event::Radius(radius) => {
            let beyond = Beyond(series, radius);
            let [out, back] = [true, false].map(|upwards| crossings::<A>(&beyond, *size, upwards));
            let mut times = [out.times(), back.times()].concat();
            times.sort_by(f64::total_cmp);
            times
        }
        Event::Slack if step.thread == ThreadChange::Slackens => vec![*size],
        Event::Slack if !step.start.free && !series.guard_holds::<A>(*size) => {
            crossings::<A>(&Guard(series), *size, false).times().to_vec()
        }
        Event::Taut if step.thread == ThreadChange::Tautens => vec![*size],
        Event::Slack | Event::Taut => Vec::new(),
    }
}

dispatch! {
    pub(crate) fn dimensionless(time: f64, omega0: Pair) -> Pair = dimensionless_with
}

#[inline(always)]
fn dimensionless_with<A: Arithmetic>(_: A, time: f64, omega0: Pair) -> Pair {
    (Dd::<A>::of(omega0) * time).pair()
}
