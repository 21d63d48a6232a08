//! When something happens within a step: the zeros of a function of its series, to the last bit.

use crate::numbers::arithmetic::Arithmetic;
use crate::numbers::lanes::{Lanes, Number};
use crate::numbers::roots::{ScalarFunction, zero_between};
use crate::taylor::layout::{Alone, Layout, Several, Vector};
use crate::taylor::series::{Coefficients, ORDER, Point, Series, SeriesOf};

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

    /// At several times at once, which need not wait for one another.
    #[inline(always)]
    fn values_at(&self, [t0, t1, t2, t3]: [L::Scalar; 4]) -> [L::Scalar; 4] {
        [self.value_at(t0), self.value_at(t1), self.value_at(t2), self.value_at(t3)]
    }
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
pub(crate) struct SpeedSquaredRate<S = f64>(Coefficients<S>);

impl<S: Number> SpeedSquaredRate<S> {
    #[inline(always)]
    pub(crate) fn of<L: Layout<Scalar = S>>(series: &SeriesOf<L>, direction: S) -> Self {
        let mut rate = [L::same(0.0); ORDER + 1];
        for k in 1..ORDER {
            rate[k - 1] = direction * L::same(k as f64) * series.speed_squared[k];
        }
        Self(rate)
    }
}

impl<L: Layout> StepFunction<L> for SpeedSquaredRate<L::Scalar> {
    #[inline(always)]
    fn value_at(&self, since: L::Scalar) -> L::Scalar {
        let mut sum = L::same(0.0);
        for k in (0..ORDER - 1).rev() {
            sum = L::mul_add(sum, since, self.0[k]);
        }
        sum
    }

    #[inline(always)]
    fn values_at(&self, times: [L::Scalar; 4]) -> [L::Scalar; 4] {
        let [mut s0, mut s1, mut s2, mut s3] = [L::same(0.0); 4];
        for k in (0..ORDER - 1).rev() {
            s0 = L::mul_add(s0, times[0], self.0[k]);
            s1 = L::mul_add(s1, times[1], self.0[k]);
            s2 = L::mul_add(s2, times[2], self.0[k]);
            s3 = L::mul_add(s3, times[3], self.0[k]);
        }
        [s0, s1, s2, s3]
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

/// Pieces of a step that are looked at one by one, four at once where cases go side by side; a step is at most a quarter of
/// a swing.
pub(crate) const PIECES: usize = 8;

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
    let mut found = Crossings::default();
    let mut piece = Piece::start::<A>(function, end, upwards);
    while found.count < most && piece.next::<A>(function) {
        found.times[found.count] = piece.time::<A>(function);
        found.count += 1;
    }
    found
}

/// A piece of a step, in which a function passes through zero.
pub(crate) struct Piece {
    number: usize,
    end_of_step: f64,
    sign: f64,
    pub(crate) ends: [f64; 2],
    /// Of the function at the ends, with the sign that makes it pass upwards.
    pub(crate) values: [f64; 2],
}

impl Piece {
    /// Before the first one.
    #[inline(always)]
    pub(crate) fn start<A: Arithmetic>(function: &impl StepFunction<Alone<A>>, end: f64, upwards: bool) -> Self {
        let sign = if upwards { 1.0 } else { -1.0 };
        let value = sign * function.value_at(0.0);
        Self { number: 0, end_of_step: end, sign, ends: [0.0; 2], values: [value; 2] }
    }

    /// Goes on to the next, if there is one.
    #[inline(always)]
    pub(crate) fn next<A: Arithmetic>(&mut self, function: &impl StepFunction<Alone<A>>) -> bool {
        while self.number < PIECES {
            self.number += 1;
            let after = self.end_of_step * share(self.number);
            self.ends = [self.ends[1], after];
            self.values = [self.values[1], self.sign * function.value_at(after)];
            if passes(self.values[0], self.values[1]) {
                return true;
            }
        }
        false
    }

    /// When the function passes through zero.
    #[inline(always)]
    pub(crate) fn time<A: Arithmetic>(&self, function: &impl StepFunction<Alone<A>>) -> f64 {
        if self.values[0] == 0.0 {
            return self.ends[0];
        }
        zero_between::<A>(&OfOneCase(function), self.sign, self.ends, self.values)
    }
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

/// The first pieces in which a function passes through zero, as [`Piece`] finds them.
pub(crate) struct Passages<L> {
    /// Those that there are, as 1 << lane.
    pub(crate) lanes: u32,
    /// Where they begin.
    pub(crate) before: L,
    /// The function there, with the sign that makes it pass upwards.
    pub(crate) below: L,
}

#[inline(always)]
pub(crate) fn first_passages<L: Lanes>(function: &impl StepFunction<Several<L>>, end: L, upwards: bool) -> Passages<L> {
    let sign = L::same(if upwards { 1.0 } else { -1.0 });
    let mut found = Passages { lanes: 0, before: L::default(), below: L::default() };
    let (mut before, mut below) = (L::default(), sign * function.value_at(L::default()));
    for passed in (0..PIECES).step_by(4) {
        let [t0, t1, t2, t3] = [share(passed + 1), share(passed + 2), share(passed + 3), share(passed + 4)];
        let ends = [end * L::same(t0), end * L::same(t1), end * L::same(t2), end * L::same(t3)];
        let values = function.values_at(ends);
        for (after, value) in ends.into_iter().zip(values) {
            let above = sign * value;
            let mut lanes = 0;
            for (lane, (below, above)) in below.numbers().iter().zip(above.numbers()).enumerate() {
                lanes |= u32::from(passes(*below, *above)) << lane;
            }
            for lane in (0..L::COUNT).filter(|lane| lanes & !found.lanes & (1 << lane) != 0) {
                found.before.numbers_mut()[lane] = before.numbers()[lane];
                found.below.numbers_mut()[lane] = below.numbers()[lane];
            }
            found.lanes |= lanes;
            (before, below) = (after, above);
        }
    }
    found
}

/// Marks the lanes, 1 << lane, in which [`crossings`] finds a time, upwards or downwards.
#[inline(always)]
pub(crate) fn lanes_that_turn<L: Lanes>(function: &impl StepFunction<Several<L>>, end: L) -> u32 {
    let mut found = 0;
    let mut before = function.value_at(L::default());
    for piece in 1..=PIECES {
        let after = function.value_at(end * L::same(share(piece)));
        for (lane, (before, after)) in before.numbers().iter().zip(after.numbers()).enumerate() {
            found |= u32::from(passes(*before, *after) | passes(-*before, -*after)) << lane;
        }
        before = after;
    }
    found
}

/// Marks the lanes, 1 << lane, in which [`first`] finds a time.
#[inline(always)]
pub(crate) fn lanes_that_pass<L: Lanes>(function: &impl StepFunction<Several<L>>, end: L, upwards: bool) -> u32 {
    first_passages(function, end, upwards).lanes
}
