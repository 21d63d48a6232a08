//! A point of the orbit in the frame that turns with the precession.

use crate::exact::invariants::constants::Turning;
use crate::numbers::arithmetic::{Arithmetic, product};

/// x + iy and the height above the bottom, and their derivatives with respect to the chart's own variable, in units of
/// `unit` m: multiplied last, for it comes out of a division that all else need not wait for.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Shape {
    pub(crate) x: f64,
    pub(crate) y: f64,
    pub(crate) height: f64,
    pub(crate) x_rate: f64,
    pub(crate) y_rate: f64,
    pub(crate) height_rate: f64,
    pub(crate) unit: f64,
}

/// A complex number with its derivative: a theta function at one instant.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct ThetaValue {
    pub(crate) re: f64,
    pub(crate) im: f64,
    pub(crate) re_rate: f64,
    pub(crate) im_rate: f64,
}

impl ThetaValue {
    pub(crate) fn scaled(self, scale: f64) -> Self {
        let Self { re, im, re_rate, im_rate } = self;
        Self { re: scale * re, im: scale * im, re_rate: scale * re_rate, im_rate: scale * im_rate }
    }
}

impl Shape {
    /// x + iy = αβ/δ² and height = |α|²/δ². With RATES = false the rates stay 0 and cost nothing.
    #[inline(always)]
    pub(crate) fn of<A: Arithmetic, const RATES: bool>(
        alpha: ThetaValue,
        beta: ThetaValue,
        delta: f64,
        delta_rate: f64,
    ) -> Self {
        let inverse = 1.0 / delta;
        let [re, im] = product::<A>([alpha.re, alpha.im], [beta.re, beta.im]);
        let square = A::mul_add(alpha.re, alpha.re, alpha.im * alpha.im);
        let mut shape = Self { x: re, y: im, height: square, unit: inverse * inverse, ..Self::default() };
        if RATES {
            let log_rate = -2.0 * delta_rate * inverse;
            let first = product::<A>([alpha.re_rate, alpha.im_rate], [beta.re, beta.im]);
            let second = product::<A>([alpha.re, alpha.im], [beta.re_rate, beta.im_rate]);
            let inner = A::mul_add(alpha.re, alpha.re_rate, alpha.im * alpha.im_rate);
            shape.x_rate = A::mul_add(re, log_rate, first[0] + second[0]);
            shape.y_rate = A::mul_add(im, log_rate, first[1] + second[1]);
            shape.height_rate = A::mul_add(square, log_rate, 2.0 * inner);
        }
        shape
    }
}

/// What α and β have to be multiplied by, given |α|/δ at the highest point, where |α|² ∝ s is largest, and |β|/δ at the
/// lowest, where |β|² ∝ 2 − s is; lengths in m.
pub(crate) fn scales(length: f64, turning: &Turning, alpha: f64, beta: f64) -> [f64; 2] {
    [(length * turning.high).sqrt() / alpha, (length * turning.low_depth).sqrt() / beta]
}
