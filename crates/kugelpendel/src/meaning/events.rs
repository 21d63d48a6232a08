//! When something happens to a motion: between the extremes of its closed form, or on a grid of any motion's states.

use crate::exact::motion::ExactMotion;
use crate::exact::phase::Phase;
use crate::exact::plan::Plan;
use crate::given::pendulum::Pendulum;
use crate::given::times::{Quantity, Times};
use crate::numbers::arithmetic::Portable;
use crate::numbers::double_double::{Dd, Pair};
use crate::numbers::roots::{Bracket, zero_between};
use crate::taylor::events::Event;
use crate::taylor::walk::{Halt, StateVector, Stop};
use std::cell::{Cell, RefCell};

/// Pieces between two extremes of the distance from the axis, at the ends of which the azimuth is looked at.
const PIECES: usize = 8;

/// Times whose states are asked for together.
const TOGETHER: usize = 4096;

/// Rounds of closing in on zeros; the digits double in most, and the interval is halved at worst.
const ROUNDS: usize = 60;

/// The relative change of ρ² in a stretch below which a path is a circle and its turning points are rounding.
const ROUND_ENOUGH: f64 = 1e-13;

/// An extreme of the distance from the axis, at a share of the way from one lowest point to the next.
#[derive(Clone, Copy, Debug)]
struct Extreme {
    share: f64,
    outer: bool,
    lowest: bool,
}

/// Extremes between two questions whether the work is to end.
const PATIENCE: u32 = 64;

/// The extremes of a path, as they come one after the other.
enum Timetable {
    /// Those of each swing from a lowest point on, the swings per second, and the swing's share at t = 0.
    Periodic { extremes: Vec<Extreme>, swings: Pair, start: Pair },
    /// Once and for all, each at the time in its share.
    Once(Vec<Extreme>),
}

impl Timetable {
    fn of(motion: &ExactMotion) -> Self {
        let turning = &motion.invariants.turning;
        let above = turning.high > 1.0;
        let bottom = Extreme { share: 0.0, outer: false, lowest: true };
        match motion.phase() {
            Phase::Still => Self::Once(Vec::new()),
            Phase::Once { rate, start } => {
                // On the separatrix the support's level is where tan φ = √(s/(2 − s)) = sinh h is 1.
                let level = 1.0_f64.asinh();
                let at = |h: f64, outer| Extreme { share: (h - start) / rate, outer, lowest: !outer };
                Self::Once(vec![at(-level, true), at(0.0, false), at(level, true)])
            }
            Phase::Periodic { swings, start, .. } => {
                let mut extremes = vec![bottom];
                if above {
                    let level = motion.share_at_height(1.0);
                    extremes.push(Extreme { share: level, outer: true, lowest: false });
                    extremes.push(Extreme { share: 0.5, outer: false, lowest: false });
                    extremes.push(Extreme { share: 1.0 - level, outer: true, lowest: false });
                } else {
                    extremes.push(Extreme { share: 0.5, outer: true, lowest: false });
                }
                Self::Periodic { extremes, swings, start }
            }
        }
    }

    /// The extremes from a swing or two before a time on, each with its own time in s.
    fn around(&self, time: f64) -> Box<dyn Iterator<Item = (f64, Extreme)> + '_> {
        match self {
            Self::Once(extremes) => Box::new(extremes.iter().map(|extreme| (extreme.share, *extreme))),
            Self::Periodic { extremes, swings, start } => {
                let first = (time * swings.hi + start.hi).floor() - 1.0;
                let count = extremes.len();
                let at = move |number: usize| {
                    let extreme = extremes[number % count];
                    let swing = first + (number / count) as f64;
                    let passed = Dd::<Portable>::from(swing) + Dd::from(extreme.share) - Dd::of(*start);
                    ((passed / Dd::of(*swings)).pair().hi, extreme)
                };
                Box::new((0..).map(at))
            }
        }
    }
}

impl Timetable {
    /// The times of the extremes from one before the interval to the first after it, or its ends where there are none: so
    /// that a zero between them has the same bits whatever the interval.
    fn breaks(&self, [start, end]: [f64; 2]) -> Box<dyn Iterator<Item = f64> + '_> {
        let times = self.around(start).map(|(time, _)| time);
        if let Self::Once(_) = self {
            let inner = times.filter(move |time| *time > start && *time < end);
            return Box::new([start].into_iter().chain(inner).chain([end]));
        }
        let mut passed = false;
        Box::new(times.take_while(move |time| !std::mem::replace(&mut passed, *time > end)))
    }
}

impl ExactMotion {
    /// The share of a swing after its lowest point at which the bob comes to a height above the lowest point, in lengths,
    /// that lies between those of the turning points.
    pub(crate) fn share_at_height(&self, height: f64) -> f64 {
        let turning = &self.invariants.turning;
        let cos = height - 0.5 * (turning.high + turning.low);
        let sin = ((turning.half_range - cos) * (turning.half_range + cos)).max(0.0).sqrt();
        let share = self.invariants.fraction([cos, sin]);
        share.hi + share.lo
    }

    /// The times of an event from `start` to `end`, in s, to the last bits, at most `most` of them.
    ///
    /// Outer and inner turning points on a cone are those of a slight wobble about it. In a vertical plane no azimuth is
    /// passed, since it changes on the axis only, and by a jump.
    ///
    /// # Errors
    /// An interruption.
    pub fn events(&self, event: Event, between: [f64; 2], most: usize, stop: Stop<'_>) -> Result<Vec<f64>, Halt> {
        let (stopped, mut asked) = (Cell::new(false), 0_u32);
        let goes_on = || {
            asked = asked.wrapping_add(1);
            stopped.set(stopped.get() || (asked.is_multiple_of(PATIENCE) && stop()));
            !stopped.get()
        };
        let found = self.events_while(event, between, most, goes_on);
        if stopped.get() { Err(Halt::Interrupted) } else { Ok(found) }
    }

    fn events_while(
        &self,
        event: Event,
        [start, end]: [f64; 2],
        most: usize,
        goes_on: impl FnMut() -> bool,
    ) -> Vec<f64> {
        let goes_on = RefCell::new(goes_on);
        let timetable = Timetable::of(self);
        let extremes = timetable.around(start).take_while(|_| goes_on.borrow_mut()());
        let breaks = timetable.breaks([start, end]).take_while(|_| goes_on.borrow_mut()());
        let inside = |time: &f64| (start..=end).contains(time);
        let plan = Plan::new(self, &Times::Scattered(&[]));
        let position = |time: f64| {
            let mut position = [0.0; 3];
            plan.fill(Quantity::Position, Times::Scattered(&[time]), &mut position);
            position
        };
        let happens = |extreme: &Extreme| match event {
            Event::Outer => extreme.outer,
            Event::Inner => !extreme.outer,
            _ => extreme.lowest,
        };
        match event {
            Event::Outer | Event::Inner | Event::Bottom => {
                let times = extremes.filter(|(_, extreme)| happens(extreme)).map(|(time, _)| time);
                times.take_while(|time| *time <= end).filter(inside).take(most).collect()
            }
            Event::Azimuth(_) if self.angular_momentum() == 0.0 => Vec::new(),
            Event::Azimuth(azimuth) => {
                let (sin, cos) = azimuth.sin_cos();
                let beside = |time: f64| {
                    let [x, y, _] = position(time);
                    y * cos - x * sin
                };
                let ahead = |time: &f64| {
                    let [x, y, _] = position(*time);
                    x * cos + y * sin > 0.0
                };
                let times = passages(breaks, PIECES, beside).map(|(time, _)| time);
                times.filter(inside).filter(ahead).take(most).collect()
            }
            Event::Radius(radius) => {
                let beyond = |time: f64| {
                    let [x, y, _] = position(time);
                    x.hypot(y) - radius
                };
                passages(breaks, 1, beyond).map(|(time, _)| time).filter(inside).take(most).collect()
            }
            Event::Slack | Event::Taut => {
                let pull = |time: f64| self.tension_at(1.0 - position(time)[2] / self.pendulum.length);
                let tautens = event == Event::Taut;
                let times = passages(breaks, 1, pull).filter(|(_, rises)| *rises == tautens);
                times.map(|(time, _)| time).filter(inside).take(most).collect()
            }
        }
    }
}

/// The zeros of a function between breaks, and whether it rises through them; in each of so many pieces between two
/// breaks it has one at most.
fn passages(
    mut breaks: impl Iterator<Item = f64>,
    pieces: usize,
    function: impl Fn(f64) -> f64,
) -> impl Iterator<Item = (f64, bool)> {
    let start = breaks.next().unwrap_or(f64::NAN);
    let mut before = start;
    let ends = breaks.flat_map(move |next| {
        let (from, share) = (before, (next - before) / pieces as f64);
        before = next;
        (1..=pieces).map(move |piece| if piece == pieces { next } else { from + share * piece as f64 })
    });
    let (mut before, mut below) = (start, function(start));
    ends.filter_map(move |after| {
        let above = function(after);
        let (points, values) = ([before, after], [below, above]);
        (before, below) = (after, above);
        let rises = values[0] < 0.0 || (values[0] == 0.0 && above > 0.0);
        let passes = values[0] * above < 0.0 || (above == 0.0) != (values[0] == 0.0);
        // What ends at zero begins the next piece there, where it is not to be counted again.
        let counted = values[0] == 0.0 && points[0] != start;
        let sign = if rises { 1.0 } else { -1.0 };
        (passes && !counted)
            .then(|| (zero_between::<Portable>(&function, sign, points, values.map(|value| sign * value)), rises))
    })
}

/// The times of an event of any motion from `start` to `end`, in s, at most `most` of them.
///
/// `states` gives positions and velocities at ascending times within `span`; `step` is a time in s in which nothing
/// happens twice, such as a 24th of a half swing. Times are good to the motion's own error over the rate of what passes
/// through zero, and have the same bits whatever the interval: the grid is one of whole steps from t = 0.
///
/// # Errors
/// The first that `states` returns.
pub fn events_on_a_grid<E>(
    event: Event,
    [start, end]: [f64; 2],
    span: [f64; 2],
    step: f64,
    most: usize,
    pendulum: &Pendulum,
    mut states: impl FnMut(&[f64]) -> Result<Vec<StateVector>, E>,
) -> Result<Vec<f64>, E> {
    let (mut first, count) = ((start / step).floor(), (end / step).floor() + 1.0);
    let at = |k: f64| (step * k).clamp(span[0], span[1]);
    let mut found = Vec::new();
    while first < count && found.len() < most {
        // At first a few: who asks for one event need not wait for many.
        let together = if most == 1 { TOGETHER / 32 } else { TOGETHER };
        let last = (first + together as f64).min(count);
        let times: Vec<f64> = (0..=(last - first) as usize).map(|k| at(first + k as f64)).collect();
        let seen = states(&times)?;
        let times = passages_on_a_grid(event, &times, &seen, pendulum, &mut states)?;
        found.extend(times.into_iter().filter(|time| (start..=end).contains(time)));
        found.dedup(); // one at the very end of a stretch begins the next one too
        first = last;
    }
    found.truncate(most);
    Ok(found)
}

fn passages_on_a_grid<E>(
    event: Event,
    times: &[f64],
    seen: &[StateVector],
    pendulum: &Pendulum,
    states: &mut impl FnMut(&[f64]) -> Result<Vec<StateVector>, E>,
) -> Result<Vec<f64>, E> {
    let values: Vec<f64> = seen.iter().map(|state| watched(event, state, pendulum)).collect();
    if matches!(event, Event::Outer | Event::Inner) {
        let squares = seen.iter().map(|state| state.position[0].powi(2) + state.position[1].powi(2));
        let (least, most) = squares.fold((f64::INFINITY, 0.0), |(l, m), r| (f64::min(l, r), f64::max(m, r)));
        if most - least <= ROUND_ENOUGH * most {
            return Ok(Vec::new());
        }
    }
    let both = matches!(event, Event::Azimuth(_) | Event::Radius(_));
    let mut brackets = Vec::new();
    for k in 0..times.len() - 1 {
        let (below, above) = (values[k], values[k + 1]);
        let rises = below <= 0.0 && above > 0.0;
        let falls = below >= 0.0 && above < 0.0;
        if rises || (falls && both) {
            let sign = if rises { 1.0 } else { -1.0 };
            brackets.push((sign, Bracket::new([times[k], times[k + 1]], [sign * below, sign * above])));
        }
    }
    for _ in 0..ROUNDS {
        let open: Vec<_> = (0..brackets.len()).filter_map(|k| Some((k, brackets[k].1.next()?))).collect();
        if open.is_empty() {
            break;
        }
        let asked: Vec<f64> = open.iter().map(|(_, time)| *time).collect();
        for ((k, time), state) in open.into_iter().zip(states(&asked)?) {
            let (sign, bracket) = &mut brackets[k];
            bracket.tell(time, *sign * watched(event, &state, pendulum));
        }
    }
    let mut found: Vec<f64> = brackets.iter().map(|(_, bracket)| bracket.best()).collect();
    if let Event::Azimuth(azimuth) = event {
        let (sin, cos) = azimuth.sin_cos();
        let seen = states(&found)?;
        let mut ahead = seen.iter().map(|state| state.position[0] * cos + state.position[1] * sin > 0.0);
        found.retain(|_| ahead.next().unwrap_or(false));
    }
    Ok(found)
}

/// What passes through zero where the event happens: upwards, unless it is a radius or an azimuth, which is passed both
/// ways.
fn watched(event: Event, state: &StateVector, pendulum: &Pendulum) -> f64 {
    let StateVector { position: [x, y, _], velocity: [vx, vy, vz] } = *state;
    match event {
        Event::Outer => -(x * vx + y * vy),
        Event::Inner => x * vx + y * vy,
        Event::Bottom => -vz,
        Event::Azimuth(azimuth) => {
            let (sin, cos) = azimuth.sin_cos();
            y * cos - x * sin
        }
        Event::Radius(radius) => x.hypot(y) - radius,
        Event::Slack => -pendulum.pull(state.position, state.velocity),
        Event::Taut => pendulum.pull(state.position, state.velocity),
    }
}
