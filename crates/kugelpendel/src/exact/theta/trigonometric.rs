//! The closed form as theta series in the swing's own angle ζ: every motion but those next to the separatrix.
//!
//! In the frame turning with the precession, x + iy ∝ αβ with α = θ1(ζ − iη0)/θ4(ζ) and β = θ3(ζ + iη2)/θ4(ζ), or
//! β = θ2(ζ − iη1)/θ4(ζ) for paths near the top, where |α|² ∝ s and |β|² ∝ 2 − s (Whittaker, Analytical Dynamics,
//! §55; theta functions as in DLMF 20.2). The series are cut where the next term is below 2e-17 and summed as
//! polynomials in sin² ζ, in which θ4, the only one that is divided by, has positive coefficients only.

use crate::exact::invariants::constants::Invariants;
use crate::exact::theta::shape::{Shape, ThetaValue, scales};
use crate::numbers::arithmetic::{Arithmetic, horner};
use crate::numbers::elliptic::Ladder;

/// Terms beyond the first: q^(DEGREE + 1)² < 2e-17 for the nomes up to 0.21 that are left to this chart.
pub(crate) const MAX_DEGREE: usize = 4;
type Polynomial = [f64; MAX_DEGREE + 1];

#[derive(Clone, Copy, Debug)]
pub(crate) struct Trigonometric {
    pub(crate) degree: usize,
    /// Of α alone, whose terms fade faster: the same or one less.
    pub(crate) alpha_degree: usize,
    /// β is the theta_2 form: odd harmonics, like α.
    pub(crate) from_above: bool,
    /// What the spectrum needs: q, q·e^{2η0}, and η2 (from above η1).
    pub(crate) poles: [f64; 3],
    alpha: ThetaSeries,
    beta: ThetaSeries,
    /// θ4, real.
    delta: ThetaSeries,
}

impl Trigonometric {
    pub(crate) fn new(length: f64, invariants: &Invariants, ladder: &Ladder) -> Self {
        let turning = &invariants.turning;
        let nome = ladder.nome();
        let from_above = invariants.from_above;
        let [lower, upper] = invariants.first_zeta_terms();
        let (lower, lower_reduced) = ladder.imaginary_argument(lower);
        let (mut upper, upper_reduced) = ladder.imaginary_argument(upper);
        if turning.half_range == 0.0 && turning.high_depth > 0.0 {
            // On a cone to the last bit W_1 and c_1 vanish together, and sinh 2η2 = W_1/c_1 goes to 2√(s_c − s_a) Λ.
            let depths = turning.high_depth * turning.low_depth;
            let slope = std::f64::consts::SQRT_2 * invariants.angular_momentum / depths;
            upper = 0.5 * (slope * (turning.excess + turning.high_depth).sqrt()).asinh();
        }
        // Harmonics beyond the degree must not leave their lower powers behind, so they are not begun. Their terms go
        // like q^{n²}, in theta_3 like q^{n²}e^{2nη2}.
        let growth = if from_above { 1.0 } else { (2.0 * upper).exp() };
        let negligible = |n: usize| nome.powi((n * n) as i32) * growth.powi(n as i32) < 2e-17;
        let degree = (1..MAX_DEGREE).find(|degree| negligible(degree + 1)).unwrap_or(MAX_DEGREE);
        let last = (2 * degree + 1) as f64 * nome.powi((degree * degree) as i32) * lower_reduced.powi(degree as i32);
        let alpha_degree = if last < 2e-17 { degree - 1 } else { degree };
        let beta = if from_above {
            ThetaSeries::odd(degree, nome, upper, upper_reduced, 1.0)
        } else {
            ThetaSeries::even(degree, nome, upper, 1.0)
        };
        let mut chart = Self {
            degree,
            alpha_degree,
            from_above,
            poles: [nome, lower_reduced, upper],
            alpha: ThetaSeries::odd(alpha_degree, nome, lower, lower_reduced, -1.0),
            beta,
            delta: ThetaSeries::even(degree, nome, 0.0, -1.0),
        };
        let at_bottom = |polynomial: &Polynomial| polynomial[0];
        let at_top = |polynomial: &Polynomial| polynomial.iter().sum::<f64>();
        let alpha = at_top(&chart.alpha.im).abs() / at_top(&chart.delta.re);
        let beta = at_bottom(&chart.beta.re) / at_bottom(&chart.delta.re);
        let [alpha, beta] = scales(length, turning, alpha, beta);
        chart.alpha = chart.alpha.times(alpha, alpha * invariants.sense);
        chart.beta = chart.beta.times(beta, beta * invariants.sense);
        chart
    }

    /// [`Self::at`] with all terms: for single points.
    pub(crate) fn at_any<const RATES: bool>(&self, cos: f64, sin: f64) -> Shape {
        type Portable = crate::numbers::arithmetic::Portable;
        if self.from_above {
            self.at::<Portable, MAX_DEGREE, MAX_DEGREE, true, RATES>(cos, sin)
        } else {
            self.at::<Portable, MAX_DEGREE, MAX_DEGREE, false, RATES>(cos, sin)
        }
    }

    /// The point at ζ, given cos ζ and sin ζ.
    #[inline(always)]
    pub(crate) fn at<
        A: Arithmetic,
        const DEGREE: usize,
        const ALPHA: usize,
        const FROM_ABOVE: bool,
        const RATES: bool,
    >(
        &self,
        cos: f64,
        sin: f64,
    ) -> Shape {
        let square = sin * sin;
        let alpha = self.alpha.at::<A, RATES>([ALPHA; 2], square, [cos, sin]);
        let beta = if FROM_ABOVE {
            self.beta.at::<A, RATES>([DEGREE; 2], square, [cos, sin])
        } else {
            self.beta.at::<A, RATES>([DEGREE, DEGREE - 1], square, [1.0, sin * cos])
        };
        let delta = horner::<A, _>(&self.delta.re, DEGREE, square);
        let delta_rate = if RATES { sin * cos * horner::<A, _>(&self.delta.re_rate, DEGREE - 1, square) } else { 0.0 };
        Shape::of::<A, RATES>(alpha, beta, delta, delta_rate)
    }
}

/// Polynomials in sin² ζ. Odd series: re, im go with cos ζ, sin ζ; even ones with 1, sin ζ cos ζ, which takes a degree
/// from the polynomial; the rates the other way.
#[derive(Clone, Copy, Debug)]
struct ThetaSeries {
    re: Polynomial,
    im: Polynomial,
    re_rate: Polynomial,
    im_rate: Polynomial,
}

impl ThetaSeries {
    #[inline(always)]
    fn at<A: Arithmetic, const RATES: bool>(&self, degrees: [usize; 2], square: f64, [c, s]: [f64; 2]) -> ThetaValue {
        let [re, im] = degrees;
        let mut factor = ThetaValue {
            re: c * horner::<A, _>(&self.re, re, square),
            im: s * horner::<A, _>(&self.im, im, square),
            ..ThetaValue::default()
        };
        if RATES {
            factor.re_rate = s * horner::<A, _>(&self.re_rate, im, square);
            factor.im_rate = c * horner::<A, _>(&self.im_rate, re, square);
        }
        factor
    }

    /// The real part times one factor, the imaginary part times another.
    fn times(self, re: f64, im: f64) -> Self {
        let times = |factor: f64, polynomial: Polynomial| polynomial.map(|c| factor * c);
        Self {
            re: times(re, self.re),
            im: times(im, self.im),
            re_rate: times(re, self.re_rate),
            im_rate: times(im, self.im_rate),
        }
    }

    /// θ1(ζ − iη)·2i (sign −1) or θ2(ζ − iη)·2 (sign +1), divided by q^{1/4}e^η; `reduced` is q·e^{2η}.
    fn odd(degree: usize, nome: f64, eta: f64, reduced: f64, sign: f64) -> Self {
        let (mut growing, mut fading) = (Polynomial::default(), Polynomial::default());
        let mut weight = 1.0; // (±1)^n q^{n²} (q e^{2η})^n
        for n in 0..=degree {
            let order = (2 * n + 1) as f64;
            let difference = -(-2.0 * order * eta).exp_m1();
            growing[n] = weight * (2.0 - difference);
            fading[n] = weight * difference;
            weight *= sign * nome.powi(2 * n as i32 + 1) * reduced;
        }
        let (re, im) = if sign < 0.0 { (fading, growing) } else { (growing, fading) };
        let orders = |n: usize| (2 * n + 1) as f64;
        let (cos_basis, sin_basis) = ([[1.0, 0.0], [1.0, -4.0]], [[1.0, 0.0], [3.0, -4.0]]);
        Self {
            re: expand(re, cos_basis),
            im: expand(im, sin_basis),
            re_rate: expand(std::array::from_fn(|n| -orders(n) * re[n]), sin_basis),
            im_rate: expand(std::array::from_fn(|n| orders(n) * im[n]), cos_basis),
        }
    }

    /// θ3(ζ + iη) (sign +1) or θ4(ζ + iη) (sign −1).
    fn even(degree: usize, nome: f64, eta: f64, sign: f64) -> Self {
        let (mut re, mut im) = (Polynomial::default(), Polynomial::default());
        re[0] = 1.0;
        let mut power = 1.0;
        for n in 1..=degree {
            power *= sign * nome.powi(2 * n as i32 - 1); // (±1)^n q^{n²}
            let growth = 2.0 * n as f64 * eta;
            re[n] = 2.0 * power * growth.cosh();
            im[n] = -2.0 * power * growth.sinh();
        }
        let orders = |n: usize| (2 * n) as f64;
        let (cos_basis, sin_basis) = ([[1.0, 0.0], [1.0, -2.0]], [[0.0, 0.0], [2.0, 0.0]]);
        Self {
            re: expand(re, cos_basis),
            im: expand(im, sin_basis),
            re_rate: expand(std::array::from_fn(|n| -orders(n) * re[n]), sin_basis),
            im_rate: expand(std::array::from_fn(|n| orders(n) * im[n]), cos_basis),
        }
    }
}

/// Σ weights[n]·p_n as a polynomial in x = sin² ζ, where p_{n+1} = (2 − 4x) p_n − p_{n−1} starts with the two linear
/// p_0, p_1: multiple angles in powers.
fn expand(weights: Polynomial, [first, second]: [[f64; 2]; 2]) -> Polynomial {
    let mut basis = [Polynomial::default(); MAX_DEGREE + 1];
    basis[0][..2].copy_from_slice(&first);
    basis[1][..2].copy_from_slice(&second);
    for n in 1..MAX_DEGREE {
        for k in 0..=MAX_DEGREE {
            let raised = if k > 0 { 4.0 * basis[n][k - 1] } else { 0.0 };
            basis[n + 1][k] = 2.0 * basis[n][k] - raised - basis[n - 1][k];
        }
    }
    std::array::from_fn(|k| weights.iter().zip(&basis).map(|(weight, p)| weight * p[k]).sum())
}
