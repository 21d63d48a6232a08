//! What a motion keeps for ever: energy, angular momentum, turning heights, frequency, precession.
//!
//! Dimensionless (lengths in l, time in 1/ω0), computed in double-double, since frequency and precession are later
//! multiplied by the time. With ε the energy above the bottom and λ the angular momentum about the vertical, the height
//! s obeys ṡ² = 2(s − s_b)(s_a − s)(s_c − s), 0 ≤ s_b ≤ s_a ≤ 2 ≤ s_c.
//! Frequency and precession are one arithmetic-geometric mean and two sums beside it: `zeta`.

use crate::exact::invariants::cubic::smaller_root;
use crate::exact::invariants::zeta::mean_and_sums;
use crate::given::launch::LaunchState;
use crate::numbers::arithmetic::Arithmetic;
use crate::numbers::double_double::{Dd, Pair};

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
    /// Whether the path comes so near the top that the upper pole is better seen from above: theta_2 for theta_3 in the
    /// chart, in a frame that turns with the precession less the frequency.
    pub(crate) from_above: bool,
    /// The rate of that frame, or the precession.
    pub(crate) frame: Pair,
    /// Launch, as a point on the circle (cos, sin)·half_range: s = mean + cos, rate of s ∝ sin.
    pub(crate) circle: [f64; 2],
    /// Whether the iterations have converged.
    pub(crate) settled: bool,
}

impl Invariants {
    pub(crate) const ZERO: Self = Self {
        energy: 0.0,
        angular_momentum: 0.0,
        sense: 1.0,
        turning: Turning { high: 0.0, low: 0.0, high_depth: 2.0, low_depth: 2.0, excess: 0.0, half_range: 0.0 },
        frequency: Pair { hi: 0.0, lo: 0.0 },
        precession: Pair { hi: 0.0, lo: 0.0 },
        from_above: false,
        frame: Pair { hi: 0.0, lo: 0.0 },
        circle: [0.0; 2],
        settled: true,
    };

    /// With QUICK, a fixed number of steps and no branch, and whether they were enough.
    #[inline(always)]
    pub(crate) fn of<A: Arithmetic, const QUICK: bool>(state: &LaunchState<A>) -> Self {
        let (zero, two) = (Dd::<A>::ZERO, Dd::<A>::from(2.0));
        let half_speed_squared = state.speed_squared.scale(0.5);
        let energy = state.height.plus(half_speed_squared);
        // 2 − ε, with all its digits near the separatrix; what is only the rounding of a cancellation is zero.
        let deficit = state.depth - half_speed_squared;
        let deficit = Dd::select(deficit.hi.abs() < 1e-30 * state.depth.hi, zero, deficit);
        let bound = deficit.hi >= 0.0;
        let distance = deficit.abs();
        let lambda = state.angular_momentum.abs();
        let lambda_squared = lambda.square();

        // σ = s_c − 2 ≥ 0 and κ = s_c − ε ≥ 0 differ by 2 − ε; solve for the smaller: 2ν(ν + A)(ν + B) = λ².
        let other = Dd::select(bound, two, two.plus(distance));
        let (smaller, root_settled) = smaller_root::<A, QUICK>(distance, other, lambda_squared);
        let larger = smaller.plus(distance);
        let (excess, kappa) = (Dd::select(bound, smaller, larger), Dd::select(bound, larger, smaller));
        let third = two.plus(excess);
        let product = lambda_squared / third.scale(2.0); // s_a s_b
        let depths_product = kappa.scale(2.0).plus(product); // (2 − s_a)(2 − s_b)
        let half_sum = (Dd::select(bound, energy, two) - Dd::select(bound, excess, kappa)).scale(0.5);

        // (s0 − mean)² + ṡ0²/(2(s_c − s0)) = half_range²: a sum of squares, exact on cones as well.
        let cos = state.height - half_sum;
        let above = excess.plus(state.depth).scale(2.0).sqrt(); // 0 only at rest upright
        let sin = Dd::select(above.hi > 0.0, state.climb / above, zero);
        let half_range = cos.hypot(sin);
        let high = half_sum.plus(half_range);
        let low = Dd::select(high.hi > 0.0, product / high, zero);
        let low_depth = two - half_sum + half_range;
        let high_depth = depths_product / low_depth;

        // The upper pole from below while y2 ≤ K'/2, that is (s_c−2)/(2−s_a) ≤ √((s_c−s_b)/(s_a−s_b)).
        let ratio = excess.hi / high_depth.hi;
        let high_enough = ratio * ratio * 2.0 * half_range.hi > excess.hi + low_depth.hi;
        let from_above = (excess.hi > 0.0) & ((high_depth.hi <= 0.0) | high_enough);
        // First terms, and what they are taken from: Λ(2 + κ)/2 = H − W_1 with Λ = λ/(√2 (2 − s_a)(2 − s_b)), or −W_1.
        let eighth = lambda * Dd::SQRT_HALF.scale(0.5);
        let lower = eighth / third;
        let pole = Dd::select(from_above, excess, depths_product);
        let share = Dd::select(pole.hi > 0.0, eighth / pole, zero);
        let upper = Dd::select(from_above, share, share.scale(2.0) * half_range);
        let leading = Dd::select(from_above, -share, share * two.plus(kappa));
        let (mean, [lower_sum, upper_sum], mean_settled) =
            mean_and_sums::<A, QUICK>(excess.plus(low_depth), excess.plus(high_depth), half_range, [lower, upper]);
        let frequency = mean * Dd::SQRT_HALF;
        let upper = leading + Dd::select(from_above, upper_sum, -upper_sum);
        let frame = (lower.plus(lower_sum) + upper) * Dd::SQRT_HALF;
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
            precession: Dd::select(from_above, frequency + frame, frame).pair(),
            from_above,
            frame: frame.pair(),
            circle: [cos.hi, sin.hi],
            settled: root_settled & mean_settled,
        }
    }

    /// W_1 of the two zeta sums, for the lower and the upper pole.
    pub(crate) fn first_zeta_terms(&self) -> [f64; 2] {
        const ROOT_EIGHTH: f64 = 0.5 * std::f64::consts::FRAC_1_SQRT_2;
        let (lambda, turning) = (self.angular_momentum, &self.turning);
        let upper = if self.from_above {
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
        self.angular_momentum == 0.0 && self.turning.excess > 0.0
    }
}
