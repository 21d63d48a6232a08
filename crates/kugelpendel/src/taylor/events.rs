//! When something happens within a step: the zeros of a function of its series, to the last bit.

use crate::numbers::arithmetic::Arithmetic;
use crate::numbers::lanes::Lanes;
use crate::numbers::roots::{ScalarFunction, zero_between};
use crate::taylor::layout::{Alone, Layout, Several, Vector};
use crate::taylor::series::{ORDER, Point, Series};

/// Something that happens to the bob at one time, and that can be asked for.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Event {
    /// The bob is farthest from the axis.
    Outer,
    /// The bob is closest to the axis: at the lowest point of its path or, above the support, at the highest.
    Inner,
    /// The bob is at the lowest point of its path, below the support.
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

/// A function of the time since the start of a step.
pub(crate) trait StepFunction<L: Layout> {
    fn value_at(&self, since: L::Scalar) -> L::Scalar;
}

/// ½ d(ρ²)/dt: from below zero upwards at the closest approach to the axis.
pub(crate) struct Outward<'a, S = f64, V = Vector>(pub(crate) &'a Series<S, V>);

impl<L: Layout> StepFunction<L> for Outward<'_, L::Scalar, L::Vector> {
    #[inline(always)]
    fn value_at(&self, since: L::Scalar) -> L::Scalar {
        let Point { position, velocity } = self.0.at::<L>(since);
        let ([x, y, _], [vx, vy, _]) = (L::parts(&position), L::parts(&velocity));
        x * vx + y * vy
    }
}

/// ρ² less that of a radius.
pub(crate) struct Beyond<'a, S = f64, V = Vector>(pub(crate) &'a Series<S, V>, pub(crate) S);

impl<L: Layout> StepFunction<L> for Beyond<'_, L::Scalar, L::Vector> {
    #[inline(always)]
    fn value_at(&self, since: L::Scalar) -> L::Scalar {
        let [x, y, _] = L::parts(&self.0.position_at::<L>(since));
        x * x + y * y - self.1 * self.1
    }
}

/// How far to the left of the direction (cos, sin).
pub(crate) struct Beside<'a>(pub(crate) &'a Series, pub(crate) [f64; 2]);

impl<A: Arithmetic> StepFunction<Alone<A>> for Beside<'_> {
    #[inline(always)]
    fn value_at(&self, since: f64) -> f64 {
        let [x, y, _, _] = self.0.position_at::<Alone<A>>(since);
        y * self.1[0] - x * self.1[1]
    }
}

/// r·r − 1.
pub(crate) struct Outside<'a>(pub(crate) &'a Series);

impl<A: Arithmetic> StepFunction<Alone<A>> for Outside<'_> {
    #[inline(always)]
    fn value_at(&self, since: f64) -> f64 {
        let [x, y, z, _] = self.0.position_at::<Alone<A>>(since);
        x * x + y * y + (z - 1.0) * (z + 1.0)
    }
}

/// The law's guard.
pub(crate) struct Guard<'a>(pub(crate) &'a Series);

impl<A: Arithmetic> StepFunction<Alone<A>> for Guard<'_> {
    #[inline(always)]
    fn value_at(&self, since: f64) -> f64 {
        self.0.guard_at::<Alone<A>>(since)
    }
}

/// d(v²)/dt in the sense of the walk: from below zero upwards where the bob is slowest.
pub(crate) struct SpeedSquaredRate<'a, S = f64, V = Vector>(pub(crate) &'a Series<S, V>, pub(crate) S);

impl<L: Layout> StepFunction<L> for SpeedSquaredRate<'_, L::Scalar, L::Vector> {
    #[inline(always)]
    fn value_at(&self, since: L::Scalar) -> L::Scalar {
        let squared = &self.0.speed_squared;
        let mut sum = L::same(0.0);
        for k in (1..ORDER).rev() {
            sum = L::mul_add(sum, since, L::same(k as f64) * squared[k]);
        }
        self.1 * sum
    }
}

/// A function of one case, where its zeros are looked for.
struct OfOneCase<'a, F>(&'a F);

impl<A: Arithmetic, F: StepFunction<Alone<A>>> ScalarFunction<A> for OfOneCase<'_, F> {
    #[inline(always)]
    fn value(&self, since: f64) -> f64 {
        self.0.value_at(since)
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
pub(crate) fn first<A: Arithmetic>(function: &impl StepFunction<Alone<A>>, end: f64, upwards: bool) -> Option<f64> {
    at_most::<A>(function, end, upwards, 1).times().first().copied()
}

/// Upwards or downwards in the sense of the walk, which may go backwards in time; at most one in each piece of the step.
/// A function that starts at zero passes through it there.
#[inline(always)]
pub(crate) fn crossings<A: Arithmetic>(function: &impl StepFunction<Alone<A>>, end: f64, upwards: bool) -> Crossings {
    at_most::<A>(function, end, upwards, PIECES)
}

#[inline(always)]
fn at_most<A: Arithmetic>(function: &impl StepFunction<Alone<A>>, end: f64, upwards: bool, most: usize) -> Crossings {
    let function = &OfOneCase(function);
    let sign = if upwards { 1.0 } else { -1.0 };
    let mut found = Crossings::default();
    let (mut before, mut below) = (0.0, sign * ScalarFunction::<A>::value(function, 0.0));
    for piece in 1..=PIECES {
        let after = end * share(piece);
        let above = sign * ScalarFunction::<A>::value(function, after);
        if passes(below, above) {
            found.times[found.count] =
                if below == 0.0 { before } else { zero_between::<A>(function, sign, [before, after], [below, above]) };
            found.count += 1;
            if found.count == most {
                break;
            }
        }
        (before, below) = (after, above);
    }
    found
}

/// Of the step, where a piece ends.
#[inline(always)]
fn share(piece: usize) -> f64 {
    piece as f64 / PIECES as f64
}

#[inline(always)]
fn passes(below: f64, above: f64) -> bool {
    below <= 0.0 && above > 0.0
}

/// Marks the lanes, 1 << lane, in which [`first`] finds a time.
#[inline(always)]
pub(crate) fn lanes_that_pass<L: Lanes>(function: &impl StepFunction<Several<L>>, end: L, upwards: bool) -> u32 {
    let sign = L::same(if upwards { 1.0 } else { -1.0 });
    let mut found = 0;
    let mut below = sign * function.value_at(L::same(0.0));
    for piece in 1..=PIECES {
        let above = sign * function.value_at(end * L::same(share(piece)));
        for (lane, (below, above)) in below.numbers().iter().zip(above.numbers()).enumerate() {
            found |= u32::from(passes(*below, *above)) << lane;
        }
        below = above;
    }
    found
}
