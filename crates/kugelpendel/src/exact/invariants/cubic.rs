//! The one root of the height's cubic that has to be found by iteration; the others follow.

use crate::numbers::arithmetic::Arithmetic;
use crate::numbers::double_double::Dd;

/// The positive root of 2ν(ν + A)(ν + B) = λ² for A, B ≥ 0, and whether it was reached.
#[inline(always)]
pub(crate) fn smaller_root<A: Arithmetic, const QUICK: bool>(
    first: Dd<A>,
    second: Dd<A>,
    lambda_squared: Dd<A>,
) -> (Dd<A>, bool) {
    let (a, b, l) = (first.hi, second.hi, lambda_squared.hi);
    // An upper bound: from above, Newton's method on a convex increasing function cannot miss.
    let large = a.max(b);
    let g = l / (2.0 * large);
    let small = a.min(b);
    let mut root = 2.0 * g / (small + (small * small + 4.0 * g).sqrt());
    // Convergence is quadratic: after a relative step of 1e-8, what is left is below the last bit.
    let step;
    if QUICK {
        for _ in 0..4 {
            root = newton(a, b, l, root).0;
        }
        (root, step) = newton(a, b, l, root);
    } else {
        let mut latest = newton(a, b, l, root.min((0.5 * l).cbrt()));
        for _ in 0..60 {
            if latest.1.abs() <= 1e-8 * latest.0 {
                break;
            }
            latest = newton(a, b, l, latest.0);
        }
        (root, step) = latest;
    }
    let precise = Dd::from(root);
    let (with_first, with_second) = (precise.plus(first), precise.plus(second));
    let value = (with_first * with_second * root).scale(2.0) - lambda_squared;
    let slope = 2.0 * (root * (with_first.hi + with_second.hi) + with_first.hi * with_second.hi);
    let precise = precise - Dd::from(value.hi / slope);
    let vanishes = l == 0.0;
    (Dd::select(vanishes, Dd::ZERO, precise), vanishes | (step.abs() <= 1e-8 * root))
}

#[inline(always)]
fn newton(a: f64, b: f64, l: f64, root: f64) -> (f64, f64) {
    let (with_a, with_b) = (root + a, root + b);
    let value = 2.0 * root * with_a * with_b - l;
    let slope = 2.0 * (root * (with_a + with_b) + with_a * with_b);
    let step = value / slope;
    (root - step, step)
}
