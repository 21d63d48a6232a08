//! What a motion keeps for ever: energy, angular momentum, turning heights, frequency, precession.
//!
//! Dimensionless (lengths in l, time in 1/ω0), computed in double-double, since frequency and precession are later
//! multiplied by the time. With ε the energy above the bottom and λ the angular momentum about the vertical, the height
//! s obeys ṡ² = 2(s − s_b)(s_a − s)(s_c − s), 0 ≤ s_b ≤ s_a ≤ 2 ≤ s_c.
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

use crate::arithmetic::Arithmetic;
use crate::double_double::{Dd, Pair};
use crate::launch::State;

/// Heights of the turning points with everything that would cancel if it were subtracted later.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Turning {
    /// s_a, s_b: highest and lowest.
    pub(crate) high: f64,
    pub(crate) low: f64,
    /// 2 − s_a, 2 − s_b.
    pub(crate) high_depth: f64,
    pub(crate) low_depth: f64,
    /// s_c − 2.
    pub(crate) excess: f64,
    /// (s_a − s_b)/2.
    pub(crate) half_range: f64,
}

#[derive(Clone, Copy, Debug)]
pub(crate) struct Invariants {
    pub(crate) energy: f64,
    /// |λ| and its sign: everything between is computed for the counter-clockwise mirror image.
    pub(crate) angular_momentum: f64,
    pub(crate) sense: f64,
    pub(crate) turning: Turning,
    /// π/T in units of ω0, T the time from one highest point to the next; 0 on the separatrix.
    pub(crate) frequency: Pair,
    /// Rate of the frame in which the motion has only odd harmonics; ≥ 0 in the mirror image.
    pub(crate) precession: Pair,
    /// Where the path comes so near the top that the upper pole is better seen from above (theta_2 for theta_3 in the
    /// chart), the rate of the frame for that: the precession less the frequency.
    pub(crate) precession_from_above: Option<Pair>,
    /// Launch, as a point on the circle (cos, sin)·half_range: s = mean + cos, rate of s ∝ sin.
    pub(crate) circle: [f64; 2],
}

impl Invariants {
    #[inline(always)]
    pub(crate) fn of<A: Arithmetic>(state: &State<A>) -> Self {
        let two = Dd::<A>::from(2.0);
        let half_speed_squared = state.speed_squared.scale(0.5);
        let energy = state.height + half_speed_squared;
        // 2 − ε, with all its digits near the separatrix; what is only the rounding of a cancellation is zero.
        let deficit = state.depth - half_speed_squared;
        let deficit = if deficit.hi.abs() < 1e-30 * state.depth.hi { Dd::ZERO } else { deficit };
        let lambda = state.angular_momentum.abs();
        let lambda_squared = lambda.square();

        // σ = s_c − 2 ≥ 0 and κ = s_c − ε ≥ 0 differ by 2 − ε; solve for the smaller: 2ν(ν + A)(ν + B) = λ².
        let (excess, kappa) = if deficit.hi >= 0.0 {
            let sigma = smaller_root(two, deficit, lambda_squared);
            (sigma, sigma + deficit)
        } else {
            let kappa = smaller_root(-deficit, two - deficit, lambda_squared);
            (kappa - deficit, kappa)
        };
        let third = two + excess;
        let product = lambda_squared / third.scale(2.0); // s_a s_b
        let depths_product = kappa.scale(2.0) + product; // (2 − s_a)(2 − s_b)
        let half_sum = (if deficit.hi >= 0.0 { energy - excess } else { two - kappa }).scale(0.5);

        // (s0 − mean)² + ṡ0²/(2(s_c − s0)) = half_range²: a sum of squares, exact on cones as well.
        let cos = state.height - half_sum;
        let above = (excess + state.depth).scale(2.0).sqrt(); // 0 only at rest upright
        let sin = if above.hi > 0.0 { state.climb / above } else { Dd::ZERO };
        let half_range = cos.hypot(sin);
        let high = half_sum + half_range;
        let low = if high.hi > 0.0 { product / high } else { Dd::ZERO };
        let low_depth = two - half_sum + half_range;
        let high_depth = depths_product / low_depth;

        let (frequency, [lower, upper], from_above) = {
            let root_eighth = Dd::<A>::SQRT_HALF.scale(0.5);
            let lower = lambda * root_eighth / third;
            // The upper pole from below while y2 ≤ K'/2, that is (s_c−2)/(2−s_a) ≤ √((s_c−s_b)/(s_a−s_b)).
            let ratio = excess.hi / high_depth.hi;
            let range = 2.0 * half_range.hi;
            let from_above =
                excess.hi > 0.0 && (high_depth.hi <= 0.0 || ratio * ratio * range > excess.hi + low_depth.hi);
            let upper = if from_above {
                lambda * root_eighth / excess
            } else if depths_product.hi > 0.0 {
                half_range * (lambda * Dd::SQRT_HALF / depths_product)
            } else {
                Dd::ZERO
            };
            let (mean, sums) =
                mean_and_sums(excess + low_depth, excess + high_depth, half_range, [lower, upper]);
            let leading = if from_above {
                -upper // −H + W_1 = −W_1
            } else if depths_product.hi > 0.0 {
                // H − W_1 = Λ(2 + κ)/2 with Λ = λ/(√2 (2 − s_a)(2 − s_b))
                lambda * root_eighth / depths_product * (two + kappa)
            } else {
                Dd::ZERO
            };
            let upper = if from_above { leading + sums[1] } else { leading - sums[1] };
            (mean * Dd::SQRT_HALF, [lower + sums[0], upper], from_above)
        };
        let frame = (lower + upper) * Dd::SQRT_HALF;
        Self {
            energy: energy.hi,
            angular_momentum: lambda.hi,
            sense: if state.angular_momentum.hi < 0.0 { -1.0 } else { 1.0 },
            turning: Turning {
                high: high.hi,
                low: low.hi,
                high_depth: high_depth.hi,
                low_depth: low_depth.hi,
                excess: excess.hi,
                half_range: half_range.hi,
            },
            frequency: frequency.pair(),
            precession: if from_above { frequency + frame } else { frame }.pair(),
            precession_from_above: from_above.then(|| frame.pair()),
            circle: [cos.hi, sin.hi],
        }
    }

    /// W_1 of the two zeta sums, for the lower and the upper pole.
    pub(crate) fn first_zeta_terms(&self) -> [f64; 2] {
        const ROOT_EIGHTH: f64 = 0.5 * std::f64::consts::FRAC_1_SQRT_2;
        let (lambda, turning) = (self.angular_momentum, &self.turning);
        let upper = if self.precession_from_above.is_some() {
            ROOT_EIGHTH * lambda / turning.excess
        } else if lambda > 0.0 {
            2.0 * ROOT_EIGHTH * lambda * turning.half_range / (turning.high_depth * turning.low_depth)
        } else {
            0.0
        };
        [ROOT_EIGHTH * lambda / (2.0 + turning.excess), upper]
    }

    /// In a vertical plane, round and round: one revolution per T, and nothing precesses.
    pub(crate) fn revolves(&self) -> bool {
        self.angular_momentum == 0.0 && self.energy > 2.0
    }
}

/// The positive root of 2ν(ν + A)(ν + B) = λ² for A, B ≥ 0.
#[inline(always)]
fn smaller_root<A: Arithmetic>(first: Dd<A>, second: Dd<A>, lambda_squared: Dd<A>) -> Dd<A> {
    let (a, b, l) = (first.hi, second.hi, lambda_squared.hi);
    if l == 0.0 {
        return Dd::ZERO;
    }
    // Two upper bounds; from above, Newton's method on a convex increasing function cannot miss.
    let g = l / (2.0 * a.max(b));
    let small = a.min(b);
    let mut root = (2.0 * g / (small + (small * small + 4.0 * g).sqrt())).min((0.5 * l).cbrt());
    for _ in 0..60 {
        let value = 2.0 * root * (root + a) * (root + b) - l;
        let slope = 2.0 * (root * (2.0 * root + a + b) + (root + a) * (root + b));
        let step = value / slope;
        root -= step;
        if step.abs() <= 1e-15 * root {
            break;
        }
    }
    let mut precise = Dd::from(root);
    for _ in 0..2 {
        let (with_first, with_second) = (precise + first, precise + second);
        let value = (precise * with_first * with_second).scale(2.0) - lambda_squared;
        let slope = 2.0 * (precise.hi * (with_first.hi + with_second.hi) + with_first.hi * with_second.hi);
        precise = precise - Dd::from(value.hi / slope);
    }
    precise
}

/// M(√larger, √smaller), and for each first term W_1 the sum of the W_n with n ≥ 2.
#[inline(always)]
fn mean_and_sums<A: Arithmetic>(
    larger: Dd<A>,
    smaller: Dd<A>,
    half_range: Dd<A>,
    first: [Dd<A>; 2],
) -> (Dd<A>, [Dd<A>; 2]) {
    let (mut a, mut b) = (larger.sqrt(), smaller.sqrt());
    let mut sums = [Dd::ZERO; 2];
    if b.hi == 0.0 {
        return (Dd::ZERO, sums); // the separatrix: infinite period
    }
    let mut terms = first;
    let mut c = half_range; // c_1 = (a_0² − b_0²)/(4 a_1) with a_0² − b_0² = 2·half_range; the division follows
    for step in 0..64 {
        let mean = (a + b).scale(0.5);
        b = (a * b).sqrt();
        a = mean;
        c = if step == 0 { c.scale(0.5) / a } else { c.square() / a.scale(4.0) };
        let negligible = c.hi <= 1e-17 * a.hi;
        let mut finished = negligible;
        let (a_squared, c_squared) = (a.square(), c.square());
        for (term, (sum, first)) in terms.iter_mut().zip(sums.iter_mut().zip(first)) {
            let square = term.square();
            *term = term.scale(0.5) * ((c_squared + square) / (a_squared + square)).sqrt();
            *sum = *sum + *term;
            finished &= term.hi <= 1e-33 * first.hi;
        }
        if finished {
            // a_{n+1} = a_n − c_{n+1}, and c_{n+1} = c_n²/4a_{n+1} is below the last bit.
            break;
        }
    }
    (a, sums)
}
