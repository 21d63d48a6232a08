//! When something happens within a step: the zeros of a function, to the last bit.

use crate::numbers::arithmetic::Arithmetic;
use crate::taylor::series::{ORDER, Point, Series};

/// What can be asked for.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Event {
    /// Farthest from the axis.
    Outer,
    /// Closest approach to the axis.
    Inner,
    /// Lowest.
    Bottom,
    /// The bob passes this azimuth, rad, either way.
    Azimuth(f64),
    /// The bob passes this distance from the axis, m, either way.
    Radius(f64),
    /// The thread goes slack.
    Slack,
    /// The thread is taut again.
    Taut,
}

/// A function of the time since the step's start.
///
/// A trait and not a closure: what is not inlined into the dispatched function is not compiled for its processor.
pub(crate) trait Watched<A: Arithmetic> {
    fn value(&self, since: f64) -> f64;
}

/// ½ d(ρ²)/dt: from below zero upwards at the closest approach to the axis.
pub(crate) struct Outward<'a>(pub(crate) &'a Series);

impl<A: Arithmetic> Watched<A> for Outward<'_> {
    #[inline(always)]
    fn value(&self, since: f64) -> f64 {
        let Point { place: [x, y, _, _], rate: [vx, vy, _, _] } = self.0.at::<A>(since);
        x * vx + y * vy
    }
}

/// ρ² less that of a radius.
pub(crate) struct Beyond<'a>(pub(crate) &'a Series, pub(crate) f64);

impl<A: Arithmetic> Watched<A> for Beyond<'_> {
    #[inline(always)]
    fn value(&self, since: f64) -> f64 {
        let [x, y, _, _] = self.0.place_at::<A>(since);
        x * x + y * y - self.1 * self.1
    }
}

/// How far to the left of the direction (cos, sin).
pub(crate) struct Beside<'a>(pub(crate) &'a Series, pub(crate) [f64; 2]);

impl<A: Arithmetic> Watched<A> for Beside<'_> {
    #[inline(always)]
    fn value(&self, since: f64) -> f64 {
        let [x, y, _, _] = self.0.place_at::<A>(since);
        y * self.1[0] - x * self.1[1]
    }
}

/// Rate of z: from above zero downwards at the lowest point.
pub(crate) struct Sinking<'a>(pub(crate) &'a Series);

impl<A: Arithmetic> Watched<A> for Sinking<'_> {
    #[inline(always)]
    fn value(&self, since: f64) -> f64 {
        self.0.at::<A>(since).rate[2]
    }
}

/// r·r − 1.
pub(crate) struct Outside<'a>(pub(crate) &'a Series);

impl<A: Arithmetic> Watched<A> for Outside<'_> {
    #[inline(always)]
    fn value(&self, since: f64) -> f64 {
        let [x, y, z, _] = self.0.place_at::<A>(since);
        x * x + y * y + (z - 1.0) * (z + 1.0)
    }
}

/// The law's guard.
pub(crate) struct Guard<'a>(pub(crate) &'a Series);

impl<A: Arithmetic> Watched<A> for Guard<'_> {
    #[inline(always)]
    fn value(&self, since: f64) -> f64 {
        self.0.guard_at::<A>(since)
    }
}

/// d(v²)/dt in the sense of the walk: from below zero upwards where the bob is slowest.
pub(crate) struct Quickening<'a>(pub(crate) &'a Series, pub(crate) f64);

impl<A: Arithmetic> Watched<A> for Quickening<'_> {
    #[inline(always)]
    fn value(&self, since: f64) -> f64 {
        let squared = &self.0.speed_squared;
        self.1 * (1..ORDER).rev().fold(0.0, |sum, k| A::mul_add(sum, since, k as f64 * squared[k]))
    }
}

/// Pieces of a step that are looked at one by one; a step is at most a quarter of a swing.
const PIECES: usize = 8;

/// The times, in order, at which a function passes through zero between 0 and `end`.
#[derive(Clone, Copy, Default)]
pub(crate) struct Crossings {
    times: [f64; PIECES],
    count: usize,
}

impl Crossings {
    pub(crate) fn times(&self) -> &[f64] {
        &self.times[..self.count]
    }
}

/// The first time at which a function passes through zero; as [`crossings`].
#[inline(always)]
pub(crate) fn first<A: Arithmetic>(function: &impl Watched<A>, end: f64, upwards: bool) -> Option<f64> {
    at_most::<A>(function, end, upwards, 1).times().first().copied()
}

/// Upwards or downwards in the sense of the walk, which may go backwards in time; at most one in each piece of the step.
/// A function that starts at zero passes through it there.
#[inline(always)]
pub(crate) fn crossings<A: Arithmetic>(function: &impl Watched<A>, end: f64, upwards: bool) -> Crossings {
    at_most::<A>(function, end, upwards, PIECES)
}

#[inline(always)]
fn at_most<A: Arithmetic>(function: &impl Watched<A>, end: f64, upwards: bool, most: usize) -> Crossings {
    let sign = if upwards { 1.0 } else { -1.0 };
    let mut found = Crossings::default();
    let (mut before, mut below) = (0.0, sign * function.value(0.0));
    for piece in 1..=PIECES {
        let after = end * (piece as f64 / PIECES as f64);
        let above = sign * function.value(after);
        if below <= 0.0 && above > 0.0 {
            found.times[found.count] =
                if below == 0.0 { before } else { between::<A>(function, sign, [before, after], [below, above]) };
            found.count += 1;
            if found.count == most {
                break;
            }
        }
        (before, below) = (after, above);
    }
    found
}

/// The zero between two times, by the secant, halved where an end stays (the Illinois rule).
#[inline(always)]
fn between<A: Arithmetic>(function: &impl Watched<A>, sign: f64, times: [f64; 2], values: [f64; 2]) -> f64 {
    let ([mut below, mut above], [mut low, mut high]) = (times, values);
    let mut side = 0;
    for _ in 0..100 {
        let time = (below * high - above * low) / (high - low);
        let inside = time > below.min(above) && time < below.max(above);
        if !inside {
            break;
        }
        let found = sign * function.value(time);
        if found == 0.0 {
            return time;
        }
        if found < 0.0 {
            (below, low) = (time, found);
            if side == -1 {
                high *= 0.5;
            }
            side = -1;
        } else {
            (above, high) = (time, found);
            if side == 1 {
                low *= 0.5;
            }
            side = 1;
        }
    }
    if low.abs() < high.abs() { below } else { above }
}
