//! Zeros of a function that has different signs at two points.

/// An interval with a zero in it, closed in on by the secant, halved where an end stays (the Illinois rule).
///
/// The caller evaluates the function, so that many zeros can be looked for with one evaluation of many points.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Bracket {
    /// Where the function is below zero and where it is not; in whatever order.
    below: f64,
    above: f64,
    low: f64,
    high: f64,
    /// Which end stayed last.
    side: i8,
    best: (f64, f64),
}

impl Bracket {
    /// From two points and the values there, the first of them negative or zero and the second positive or zero.
    pub(crate) fn new([below, above]: [f64; 2], [low, high]: [f64; 2]) -> Self {
        let best = if low.abs() < high.abs() { (below, low.abs()) } else { (above, high.abs()) };
        Self { below, above, low, high, side: 0, best }
    }

    /// Where to evaluate next; none where binary64 has no number left between the ends.
    pub(crate) fn next(&self) -> Option<f64> {
        let middle = 0.5 * (self.below + self.above);
        self.secant().or(Some(middle).filter(|middle| self.holds(*middle))).filter(|_| self.best.1 > 0.0)
    }

    /// Where the secant meets zero, if that lies between the ends.
    #[inline(always)]
    fn secant(&self) -> Option<f64> {
        let secant = (self.below * self.high - self.above * self.low) / (self.high - self.low);
        Some(secant).filter(|secant| self.holds(*secant))
    }

    #[inline(always)]
    fn holds(&self, point: f64) -> bool {
        point > self.below.min(self.above) && point < self.below.max(self.above)
    }

    /// The value at the point that was asked for.
    #[inline(always)]
    pub(crate) fn tell(&mut self, point: f64, value: f64) {
        if value.abs() < self.best.1 {
            self.best = (point, value.abs());
        }
        if value < 0.0 {
            (self.below, self.low) = (point, value);
            if self.side == -1 {
                self.high *= 0.5;
            }
            self.side = -1;
        } else {
            (self.above, self.high) = (point, value);
            if self.side == 1 {
                self.low *= 0.5;
            }
            self.side = 1;
        }
    }

    /// The point with the smallest value so far.
    pub(crate) fn best(&self) -> f64 {
        self.best.0
    }
}

/// The zero of a function between two points at which it has these values, the first not above zero, the second not below.
pub(crate) fn zero(points: [f64; 2], values: [f64; 2], mut function: impl FnMut(f64) -> f64) -> f64 {
    let mut bracket = Bracket::new(points, values);
    for _ in 0..100 {
        let Some(point) = bracket.next() else { break };
        bracket.tell(point, function(point));
    }
    bracket.best()
}

/// As [`zero`] for a function that is smooth between the points, by secants alone: it asks for the function less often,
/// and for a series of an integration, where it is good to rounding, it is as good.
#[inline(always)]
pub(crate) fn zero_of_smooth(points: [f64; 2], values: [f64; 2], function: impl Fn(f64) -> f64) -> f64 {
    let mut bracket = Bracket::new(points, values);
    for _ in 0..100 {
        let Some(point) = bracket.secant() else { break };
        let value = function(point);
        if value == 0.0 {
            return point;
        }
        bracket.tell(point, value);
    }
    if bracket.low.abs() < bracket.high.abs() { bracket.below } else { bracket.above }
}

#[cfg(test)]
mod tests {
    use super::{zero, zero_of_smooth};

    type Case = (fn(f64) -> f64, [f64; 2], f64);

    #[test]
    fn zeros_are_found_to_the_last_bits() {
        let cases: [Case; 4] = [
            (|x| x * x - 2.0, [0.0, 2.0], std::f64::consts::SQRT_2),
            (|x| x.powi(9), [-1.0, 3.0], 0.0),
            (|x| x.exp() - 1.0, [-40.0, 1.0], 0.0),
            (|x| 1.0 - 1.0 / x, [1e-3, 1e3], 1.0),
        ];
        for (function, points, expected) in cases {
            let found = zero(points, points.map(function), function);
            let slope = function(found).abs();
            assert!((found - expected).abs() <= 4e-16 || slope <= 1e-30, "{found} for {expected}");
        }
    }

    #[test]
    fn zeros_of_smooth_functions_are_found_by_secants() {
        let found = zero_of_smooth([1.0, 2.0], [-1.0, 2.0], |x| x * x - 2.0);
        assert!((found - std::f64::consts::SQRT_2).abs() <= f64::EPSILON, "{found}");
        assert_eq!(zero_of_smooth([1.0, 0.0], [-0.75, 0.25], |x| 0.25 - x), 0.25);
    }

    #[test]
    fn a_zero_at_an_end_is_that_end() {
        assert_eq!(zero([0.0, 1.0], [0.0, 1.0], |x| x), 0.0);
        assert_eq!(zero([3.0, 1.0], [-2.0, 0.0], |x| 1.0 - x), 1.0);
    }
}
