//! The same closed form next to the separatrix and on it, after Jacobi's imaginary transformation.
//!
//! With q' = exp(−πK/K') the series run in the real exponential of the time since the last lowest point, and no digit
//! is lost where those in q no longer converge (DLMF 20.7.30–33):
//!
//! ```text
//! x + iy ∝ (−1)^n e^{2i(ψ0 − ψ2)f} θ1(ψ0 + ih) θ3(ψ2 − ih)/θ2(ih)²,   h = f·ln(1/q'),
//! ```
//!
//! where n counts the swings and |f| ≤ ½ is the fraction of one. On the separatrix q' = 0 and h is the time itself.

use crate::exact::invariants::constants::Invariants;
use crate::exact::theta::shape::{Shape, ThetaValue, scales};
use crate::numbers::arithmetic::Portable;
use crate::numbers::elliptic::Ladder;
use std::f64::consts::PI;

#[derive(Clone, Copy, Debug)]
pub(crate) struct Hyperbolic {
    nome: f64,
    /// ln(1/q'); infinite on the separatrix.
    pub(crate) span: f64,
    /// ψ0, ψ2.
    lower: f64,
    upper: f64,
    /// What α and β have to be multiplied by.
    scales: [f64; 2],
    /// −1 mirrors the motion: clockwise.
    sense: f64,
}

impl Hyperbolic {
    pub(crate) fn new(length: f64, invariants: &Invariants) -> Self {
        let turning = &invariants.turning;
        let ladder = Ladder::new(
            turning.excess + turning.low_depth,
            2.0 * turning.half_range,
            turning.excess + turning.high_depth,
        );
        let nome = ladder.nome();
        let mut chart = Self {
            nome,
            span: -nome.ln(),
            lower: ladder.argument(turning.low.sqrt().atan2((2.0 * turning.half_range).sqrt())),
            upper: ladder.argument(turning.excess.sqrt().atan2(turning.high_depth.sqrt())),
            scales: [1.0; 2],
            sense: invariants.sense,
        };
        let (top, bottom) = (chart.factors(0.5 * chart.span), chart.factors(0.0));
        let ratio = |factor: ThetaValue, delta: f64| factor.re.hypot(factor.im) / delta;
        let (alpha, beta) = (ratio(top.alpha, top.delta), ratio(bottom.beta, bottom.delta));
        chart.scales = scales(length, turning, alpha, beta);
        chart
    }

    /// 2(ψ0 − ψ2) in turns: how far the frame turns in a swing besides the precession.
    pub(crate) fn twist(&self) -> f64 {
        self.sense * self.argument_difference() / PI
    }

    /// ψ0 − ψ2.
    pub(crate) fn argument_difference(&self) -> f64 {
        self.lower - self.upper
    }

    /// At h since the lowest point; the rates are with respect to h.
    pub(crate) fn at(&self, h: f64) -> Shape {
        let Factors { alpha, beta, delta, delta_rate, fading } = self.factors(h);
        let [alpha_scale, beta_scale] = self.scales;
        // α and δ are scaled by 2e^{−|h|}: once too often in the plan view, not at all in the height.
        let (alpha, beta) = (alpha.scaled(alpha_scale), beta.scaled(beta_scale * fading));
        let shape = Shape::of::<Portable, true>(alpha, beta, delta, delta_rate);
        Shape { y: self.sense * shape.y, y_rate: self.sense * shape.y_rate, ..shape }
    }

    /// θ1(ψ0 + ih) and θ2(ih), both divided by q'^{1/4}e^{|h|}, and θ3(ψ2 − ih).
    fn factors(&self, h: f64) -> Factors {
        let (q, size, sign) = (self.nome, h.abs(), 1.0_f64.copysign(h));
        let fading = (-size).exp();
        // q'e^{2|h|} ≤ 1 as one exponential; 0 on the separatrix, where q' = 0 and h is unbounded.
        let growing = if q > 0.0 { (2.0 * size - self.span).exp() } else { 0.0 };
        let (mut alpha, mut delta, mut delta_rate) = (ThetaValue::default(), 0.0, 0.0);
        for n in 0..3 {
            let order = (2 * n + 1) as f64;
            let large = q.powi(n * n) * growing.powi(n);
            let small = q.powi(n * n + n) * fading.powi(2 * n + 2);
            let cosh = large + small;
            let sinh = sign * if n == 0 { -(-2.0 * size).exp_m1() } else { large - small };
            let (sin, cos) = (order * self.lower).sin_cos();
            let alternating = if n == 1 { -1.0 } else { 1.0 };
            alpha.re += alternating * sin * cosh;
            alpha.im += alternating * cos * sinh;
            alpha.re_rate += alternating * order * sin * sinh;
            alpha.im_rate += alternating * order * cos * cosh;
            delta += cosh;
            delta_rate += order * sinh;
        }
        let mut beta = ThetaValue { re: 1.0, ..ThetaValue::default() };
        for n in 1..4 {
            let order = (2 * n) as f64;
            let large = q.powi(n * n - n) * growing.powi(n);
            let small = q.powi(n * n) * fading.powi(2 * n);
            let (cosh, sinh) = (large + small, sign * (large - small));
            let (sin, cos) = (order * self.upper).sin_cos();
            beta.re += cos * cosh;
            beta.im += sin * sinh;
            beta.re_rate += order * cos * sinh;
            beta.im_rate += order * sin * cosh;
        }
        Factors { alpha, beta, delta, delta_rate, fading }
    }
}

struct Factors {
    alpha: ThetaValue,
    beta: ThetaValue,
    delta: f64,
    delta_rate: f64,
    /// e^{−|h|}.
    fading: f64,
}
