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

/// The zero between two places, by the secant, whose end that stays is halved (the Illinois rule: Dowell & Jarratt,
/// BIT 11, 168 (1971)).
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
    let ([mut below, mut above], [mut low, mut high]) = (places, values);
    let mut side = 0;
    for _ in 0..100 {
        let place = (below * high - above * low) / (high - low);
        let inside = place > below.min(above) && place < below.max(above);
        if !inside {
            break;
        }
        let found = sign * function.value(place);
        if found == 0.0 {
            return place;
        }
        if found < 0.0 {
            (below, low) = (place, found);
            if side == -1 {
                high *= 0.5;
            }
            side = -1;
        } else {
            (above, high) = (place, found);
            if side == 1 {
                low *= 0.5;
            }
            side = 1;
        }
    }
    if low.abs() < high.abs() { below } else { above }
}

#[cfg(test)]
mod tests {
    use super::zero_between;
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
}
