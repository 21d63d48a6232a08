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
use crate::launch::{STATE_NUMBERS, State};

/// Launches solved together.
pub(crate) const BLOCK: usize = 64;

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
    settled: bool,
}

impl Invariants {
    pub(crate) const ZERO: Self = Self {
        energy: 0.0,
        angular_momentum: 0.0,
        sense: 1.0,
        turning: Turning {
            high: 0.0,
            low: 0.0,
            high_depth: 2.0,
            low_depth: 2.0,
            excess: 0.0,
            half_range: 0.0,
        },
        frequency: Pair { hi: 0.0, lo: 0.0 },
        precession: Pair { hi: 0.0, lo: 0.0 },
        from_above: false,
        frame: Pair { hi: 0.0, lo: 0.0 },
        circle: [0.0; 2],
        settled: true,
    };

    /// All of them for many launches: a straight line that the compiler vectorises, and the few that need more steps of
    /// an iteration once more. One launch takes the same way, so that it has the same result in any ensemble.
    #[inline(always)]
    pub(crate) fn fill<A: Arithmetic>(states: &[State<A>], out: &mut [Self]) {
        // In columns, since records of numbers are what the compiler does not vectorise.
        let mut given = [[0.0; BLOCK]; STATE_NUMBERS];
        let mut found = [[0.0; BLOCK]; Self::NUMBERS];
        let count = states.len().min(BLOCK);
        for (k, state) in states.iter().enumerate() {
            for (column, number) in given.iter_mut().zip(state.numbers()) {
                column[k] = number;
            }
        }
        for k in 0..count {
            let mut row = [0.0; STATE_NUMBERS];
            for n in 0..STATE_NUMBERS {
                row[n] = given[n][k];
            }
            let row = Self::of::<A, true>(&State::from_numbers(row)).numbers();
            for n in 0..Self::NUMBERS {
                found[n][k] = row[n];
            }
        }
        for (k, (state, out)) in states.iter().zip(out).enumerate() {
            *out = Self::from_numbers(std::array::from_fn(|n| found[n][k]));
            if !out.settled {
                *out = Self::of::<A, false>(state);
            }
        }
    }

    const NUMBERS: usize = 19;

    #[inline(always)]
    fn numbers(&self) -> [f64; Self::NUMBERS] {
        let t = &self.turning;
        let flag = |flag: bool| if flag { 1.0 } else { 0.0 };
        [
            self.energy,
            self.angular_momentum,
            self.sense,
            t.high,
            t.low,
            t.high_depth,
            t.low_depth,
            t.excess,
            t.half_range,
            self.frequency.hi,
            self.frequency.lo,
            self.precession.hi,
            self.precession.lo,
            self.frame.hi,
            self.frame.lo,
            self.circle[0],
            self.circle[1],
            flag(self.from_above),
            flag(self.settled),
        ]
    }

    fn from_numbers(numbers: [f64; Self::NUMBERS]) -> Self {
        let [
            energy,
            angular_momentum,
            sense,
            high,
            low,
            high_depth,
            low_depth,
            excess,
            half_range,
            ..,
        ] = numbers;
        let pair = |n: usize| Pair {
            hi: numbers[n],
            lo: numbers[n + 1],
        };
        Self {
            energy,
            angular_momentum,
            sense,
            turning: Turning {
                high,
                low,
                high_depth,
                low_depth,
                excess,
                half_range,
            },
            frequency: pair(9),
            precession: pair(11),
            frame: pair(13),
            circle: [numbers[15], numbers[16]],
            from_above: numbers[17] != 0.0,
            settled: numbers[18] != 0.0,
        }
    }

    /// With QUICK, a fixed number of steps and no branch, and whether they were enough.
    #[inline(always)]
    fn of<A: Arithmetic, const QUICK: bool>(state: &State<A>) -> Self {
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
        let (excess, kappa) = (
            Dd::select(bound, smaller, larger),
            Dd::select(bound, larger, smaller),
        );
        let third = two.plus(excess);
        let product = lambda_squared / third.scale(2.0); // s_a s_b
        let depths_product = kappa.scale(2.0).plus(product); // (2 − s_a)(2 − s_b)
        let half_sum =
            (Dd::select(bound, energy, two) - Dd::select(bound, excess, kappa)).scale(0.5);

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
        let (mean, [lower_sum, upper_sum], mean_settled) = mean_and_sums::<A, QUICK>(
            excess.plus(low_depth),
            excess.plus(high_depth),
            half_range,
            [lower, upper],
        );
        let frequency = mean * Dd::SQRT_HALF;
        let upper = leading + Dd::select(from_above, upper_sum, -upper_sum);
        let frame = (lower.plus(lower_sum) + upper) * Dd::SQRT_HALF;
        Self {
            energy: energy.hi,
            angular_momentum: lambda.hi,
            sense: if state.angular_momentum.hi < 0.0 {
                -1.0
            } else {
                1.0
            },
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
            2.0 * ROOT_EIGHTH * lambda * turning.half_range
                / (turning.high_depth * turning.low_depth)
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

/// The positive root of 2ν(ν + A)(ν + B) = λ² for A, B ≥ 0, and whether it was reached.
#[inline(always)]
fn smaller_root<A: Arithmetic, const QUICK: bool>(
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
    let mut step = 0.0;
    // Convergence is quadratic: after a relative step of 1e-8, what is left is below the last bit.
    if QUICK {
        macro_rules! steps { ($($n:literal)*) => { $( let _ = $n; (root, step) = newton(a, b, l, root); )* } }
        steps!(1 2 3 4 5);
    } else {
        root = root.min((0.5 * l).cbrt());
        for _ in 0..60 {
            (root, step) = newton(a, b, l, root);
            if step.abs() <= 1e-8 * root {
                break;
            }
        }
    }
    let precise = Dd::from(root);
    let (with_first, with_second) = (precise.plus(first), precise.plus(second));
    let value = (with_first * with_second * root).scale(2.0) - lambda_squared;
    let slope = 2.0 * (root * (with_first.hi + with_second.hi) + with_first.hi * with_second.hi);
    let precise = precise - Dd::from(value.hi / slope);
    let vanishes = l == 0.0;
    (
        Dd::select(vanishes, Dd::ZERO, precise),
        vanishes | (step.abs() <= 1e-8 * root),
    )
}

#[inline(always)]
fn newton(a: f64, b: f64, l: f64, root: f64) -> (f64, f64) {
    let (with_a, with_b) = (root + a, root + b);
    let value = 2.0 * root * with_a * with_b - l;
    let slope = 2.0 * (root * (with_a + with_b) + with_a * with_b);
    let step = value / slope;
    (root - step, step)
}

/// M(√larger, √smaller), for each first term W_1 the sum of the W_n with n ≥ 2, and whether all have converged.
#[inline(always)]
fn mean_and_sums<A: Arithmetic, const QUICK: bool>(
    larger: Dd<A>,
    smaller: Dd<A>,
    half_range: Dd<A>,
    first: [Dd<A>; 2],
) -> (Dd<A>, [Dd<A>; 2], bool) {
    let (a, b) = (larger.sqrt(), smaller.sqrt());
    // c_1 = (a_0² − b_0²)/(4 a_1) with a_0² − b_0² = 2·half_range
    let (a, b) = (a.plus(b).scale(0.5), (a * b).sqrt());
    let mut rung = Rung {
        a,
        b,
        c: half_range.scale(0.5) / a,
        terms: first,
        sums: [Dd::ZERO; 2],
    };
    if QUICK {
        macro_rules! steps { ($($n:literal)*) => { $( let _ = $n; rung = rung.next(); )* } }
        steps!(1 2 3);
    } else {
        if b.hi == 0.0 {
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
struct Rung<A> {
    a: Dd<A>,
    b: Dd<A>,
    c: Dd<A>,
    terms: [Dd<A>; 2],
    sums: [Dd<A>; 2],
}

impl<A: Arithmetic> Rung<A> {
    #[inline(always)]
    fn next(self) -> Self {
        let Self {
            a,
            b,
            c,
            terms: [lower, upper],
            sums: [lower_sum, upper_sum],
        } = self;
        let (a_squared, c_squared) = (a.square(), c.square());
        let lower = next_term(a_squared, c_squared, lower);
        let upper = next_term(a_squared, c_squared, upper);
        let mean = a.plus(b).scale(0.5);
        Self {
            a: mean,
            b: (a * b).sqrt(),
            c: c_squared / mean.scale(4.0),
            terms: [lower, upper],
            sums: [lower_sum.plus(lower), upper_sum.plus(upper)],
        }
    }

    /// What the next steps add is below 1e-12, so that binary64 is enough for it.
    #[inline(always)]
    fn is_nearly_there(&self) -> bool {
        let limit = 1e-6 * self.a.hi;
        (self.c.hi <= limit) & (self.terms[0].hi <= limit) & (self.terms[1].hi <= limit)
    }

    #[inline(always)]
    fn finish(self) -> (Dd<A>, [Dd<A>; 2]) {
        let (a, c, [lower, upper]) = (self.a.hi, self.c.hi, [self.terms[0].hi, self.terms[1].hi]);
        let next = |a: f64, c: f64, w: f64| 0.5 * w * ((c * c + w * w) / (a * a + w * w)).sqrt();
        let (lower_1, upper_1) = (next(a, c, lower), next(a, c, upper));
        // a_{n+1} = a_n − c_{n+1}
        let c_1 = 0.25 * c * c / a;
        let (lower_2, upper_2) = (next(a, c_1, lower_1), next(a, c_1, upper_1));
        (
            self.a - Dd::from(c_1 + 0.25 * c_1 * c_1 / a),
            [
                self.sums[0].plus(Dd::from(lower_1 + lower_2)),
                self.sums[1].plus(Dd::from(upper_1 + upper_2)),
            ],
        )
    }
}

/// W_{n+1} from W_n.
#[inline(always)]
fn next_term<A: Arithmetic>(a_squared: Dd<A>, c_squared: Dd<A>, term: Dd<A>) -> Dd<A> {
    let square = term.square();
    term.scale(0.5) * Dd::sqrt_ratio(c_squared.plus(square), a_squared.plus(square))
}
