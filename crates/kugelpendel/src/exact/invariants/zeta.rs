//! Frequency and precession by one arithmetic-geometric mean.
//!
//! Both rates come out of one arithmetic-geometric mean. The frequency is Gauss's,
//! ω = M(√(s_c − s_b), √(s_c − s_a))/√2. The precession is a sum of Jacobi zeta functions of imaginary argument,
//! and the descending Landen transformation turns each into
//!
//! ```text
//! Σ W_n,   W_{n+1} = (W_n/2) √((c_n² + W_n²)/(a_n² + W_n²)),
//! ```
//!
//! with a_n, c_n of the same mean: all terms positive, quadratically convergent, and finite on cones, where both the
//! elliptic modulus and the argument are degenerate. First terms: λ/(2√2 s_c) for the lower pole, and for the upper
//! one δΛ, already taken off the leading term Λ(2 + κ)/2 (symbols below). For small ellipses they are ab/8 and ab/4,
//! the 1/8 + 1/4 = 3/8 of Olsson's (25).

use crate::numbers::arithmetic::Arithmetic;
use crate::numbers::double_double::Dd;
use crate::numbers::landen::Landen;

/// M(√larger, √smaller), for each first term W_1 the sum of the W_n with n ≥ 2, and whether all have converged.
#[inline(always)]
pub(crate) fn mean_and_sums<A: Arithmetic, const QUICK: bool>(
    larger: Dd<A>,
    smaller: Dd<A>,
    half_range: Dd<A>,
    first: [Dd<A>; 2],
) -> (Dd<A>, [Dd<A>; 2], bool) {
    let mut mean = Landen { a: larger.sqrt(), b: smaller.sqrt(), c: Dd::ZERO }.next();
    // c_1 = (a_0² − b_0²)/(4 a_1) with a_0² − b_0² = 2·half_range
    mean.c = half_range.scale(0.5) / mean.a;
    let mut rung = ZetaStep { mean, terms: first, sums: [Dd::ZERO; 2] };
    if QUICK {
        rung = rung.next().next().next();
    } else {
        if mean.b.hi == 0.0 {
            return (Dd::ZERO, rung.sums, true); // the separatrix: infinite period
        }
        for _ in 0..40 {
            if rung.is_nearly_there() {
                break;
            }
            rung = rung.next();
        }
    }
    let settled = rung.is_nearly_there();
    let (mean, sums) = rung.finish();
    (mean, sums, settled)
}

/// One step of the mean and of the two sums.
#[derive(Clone, Copy)]
struct ZetaStep<A> {
    mean: Landen<Dd<A>>,
    terms: [Dd<A>; 2],
    sums: [Dd<A>; 2],
}

impl<A: Arithmetic> ZetaStep<A> {
    #[inline(always)]
    fn next(self) -> Self {
        let Self { mean, terms: [lower, upper], sums: [lower_sum, upper_sum] } = self;
        let (a_squared, c_squared) = (mean.a.square(), mean.c.square());
        let lower = next_term(a_squared, c_squared, lower);
        let upper = next_term(a_squared, c_squared, upper);
        Self { mean: mean.next(), terms: [lower, upper], sums: [lower_sum.plus(lower), upper_sum.plus(upper)] }
    }

    /// What the next steps add is below 1e-12, so that binary64 is enough for it.
    #[inline(always)]
    fn is_nearly_there(&self) -> bool {
        let limit = 1e-6 * self.mean.a.hi;
        (self.mean.c.hi <= limit) & (self.terms[0].hi <= limit) & (self.terms[1].hi <= limit)
    }

    #[inline(always)]
    fn finish(self) -> (Dd<A>, [Dd<A>; 2]) {
        let (a, c, [lower, upper]) = (self.mean.a.hi, self.mean.c.hi, [self.terms[0].hi, self.terms[1].hi]);
        let next = |a: f64, c: f64, w: f64| 0.5 * w * ((c * c + w * w) / (a * a + w * w)).sqrt();
        let (lower_1, upper_1) = (next(a, c, lower), next(a, c, upper));
        // a_{n+1} = a_n − c_{n+1}
        let c_1 = 0.25 * c * c / a;
        let (lower_2, upper_2) = (next(a, c_1, lower_1), next(a, c_1, upper_1));
        (
            self.mean.a - Dd::from(c_1 + 0.25 * c_1 * c_1 / a),
            [self.sums[0].plus(Dd::from(lower_1 + lower_2)), self.sums[1].plus(Dd::from(upper_1 + upper_2))],
        )
    }
}

/// W_{n+1} from W_n.
#[inline(always)]
fn next_term<A: Arithmetic>(a_squared: Dd<A>, c_squared: Dd<A>, term: Dd<A>) -> Dd<A> {
    let square = term.square();
    term.scale(0.5) * Dd::sqrt_ratio(c_squared.plus(square), a_squared.plus(square))
}
