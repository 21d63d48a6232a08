//! The zero of a function between two places where its sign differs.

use crate::numbers::arithmetic::Arithmetic;

/// A function of one variable.
///
/// It is a trait and not a closure, since what is not inlined into a dispatched function is not compiled for its
/// processor; where speed is no concern, a closure will do.
pub(crate) trait ScalarFunction<A: Arithmetic> {
    fn value(&self, at: f64) -> f64;
}

impl<A: Arithmetic, F: Fn(f64) -> f64> ScalarFunction<A> for F {
    #[inline(always)]
    fn value(&self, at: f64) -> f64 {
        self(at)
    }
}

/// An interval with a zero in it, closed in on by the secant, whose end that stays is halved (the Illinois rule: Dowell &
/// Jarratt, BIT 11, 168 (1971)).
///
/// The caller evaluates the function, so that many zeros can be looked for with one evaluation at many places.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Bracket {
    /// Where the function is below zero and where it is not, in any order.
    below: f64,
    above: f64,
    low: f64,
    high: f64,
    /// Which end was moved last.
    side: i8,
    /// The place with the smallest value so far, and its size.
    best: (f64, f64),
}

impl Bracket {
    /// From two places and the values there, the first of them negative or zero and the second positive or zero.
    #[inline(always)]
    pub(crate) fn new([below, above]: [f64; 2], [low, high]: [f64; 2]) -> Self {
        let best = if low.abs() < high.abs() { (below, low.abs()) } else { (above, high.abs()) };
        Self { below, above, low, high, side: 0, best }
    }

    #[inline(always)]
    fn contains(&self, place: f64) -> bool {
        place > self.below.min(self.above) && place < self.below.max(self.above)
    }

    /// Where the secant passes through zero, if that is inside.
    #[inline(always)]
    fn secant(&self) -> Option<f64> {
        let place = (self.below * self.high - self.above * self.low) / (self.high - self.low);
        self.contains(place).then_some(place)
    }

    /// Where to evaluate next; none where binary64 has no number left between the ends, or the zero is met.
    pub(crate) fn next(&self) -> Option<f64> {
        let middle = 0.5 * (self.below + self.above);
        let place = self.secant().or_else(|| self.contains(middle).then_some(middle));
        place.filter(|_| self.best.1 > 0.0)
    }

    /// The value at the place that was asked for.
    #[inline(always)]
    pub(crate) fn tell(&mut self, place: f64, value: f64) {
        if value.abs() < self.best.1 {
            self.best = (place, value.abs());
        }
        if value < 0.0 {
            (self.below, self.low) = (place, value);
            if self.side == -1 {
                self.high *= 0.5;
            }
            self.side = -1;
        } else {
            (self.above, self.high) = (place, value);
            if self.side == 1 {
                self.low *= 0.5;
            }
            self.side = 1;
        }
    }

    /// The place with the smallest value so far.
    pub(crate) fn best(&self) -> f64 {
        self.best.0
    }
}

/// The zero between two places.
///
/// `sign` times the function is negative (or zero) at the first of the places and positive at the second, which are in any
/// order; `values` are those of `sign` times the function there. The answer is one of the places at which the function
/// was asked: where it is zero, or else the better one of the last two.
#[inline(always)]
pub(crate) fn zero_between<A: Arithmetic>(
    function: &impl ScalarFunction<A>,
    sign: f64,
    places: [f64; 2],
    values: [f64; 2],
) -> f64 {
    let mut bracket = Bracket::new(places, values);
    for _ in 0..100 {
        let Some(place) = bracket.secant() else { break };
        let value = sign * function.value(place);
        if value == 0.0 {
            return place;
        }
        bracket.tell(place, value);
    }
    if bracket.low.abs() < bracket.high.abs() { bracket.below } else { bracket.above }
}

#[cfg(test)]
mod tests {
    use super::{Bracket, zero_between};
    use crate::numbers::arithmetic::Portable;

    #[test]
    fn a_zero_to_the_last_bit_whichever_way_the_function_goes() {
        let fall = |x: f64| 2.0 - x * x;
        let [low, high] = [1.0, 3.0];
        let root = zero_between::<Portable>(&fall, -1.0, [low, high], [-fall(low), -fall(high)]);
        assert!((root - 2f64.sqrt()).abs() <= f64::EPSILON, "{root}");
        let rise = |x: f64| x.powi(3) - 1e-30;
        let root = zero_between::<Portable>(&rise, 1.0, [-1.0, 1.0], [rise(-1.0), rise(1.0)]);
        assert!((root / 1e-10 - 1.0).abs() < 1e-12, "{root}");
    }

    #[test]
    fn two_places_in_descending_order() {
        let function = |x: f64| x - 0.25;
        let root = zero_between::<Portable>(&function, -1.0, [1.0, 0.0], [-0.75, 0.25]);
        assert_eq!(root, 0.25);
    }

    #[test]
    fn a_bracket_closes_in_step_by_step() {
        type Case = (fn(f64) -> f64, [f64; 2], f64);
        let cases: [Case; 3] = [
            (|x| x * x - 2.0, [0.0, 2.0], std::f64::consts::SQRT_2),
            (|x| x.exp() - 1.0, [-40.0, 1.0], 0.0),
            (|x| 1.0 - 1.0 / x, [1e-3, 1e3], 1.0),
        ];
        for (function, places, expected) in cases {
            let mut bracket = Bracket::new(places, places.map(function));
            for _ in 0..100 {
                let Some(place) = bracket.next() else { break };
                bracket.tell(place, function(place));
            }
            assert!((bracket.best() - expected).abs() <= 4e-16, "{} for {expected}", bracket.best());
        }
        assert_eq!(Bracket::new([0.0, 1.0], [0.0, 1.0]).best(), 0.0);
        assert_eq!(Bracket::new([3.0, 1.0], [-2.0, 0.0]).next(), None);
    }
}
