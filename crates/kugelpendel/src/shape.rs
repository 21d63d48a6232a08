//! A point of the orbit in the frame that turns with the precession.

/// x + iy and the height s, and their derivatives with respect to the chart's own variable; lengths in l.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Shape {
    pub(crate) x: f64,
    pub(crate) y: f64,
    pub(crate) height: f64,
    pub(crate) x_rate: f64,
    pub(crate) y_rate: f64,
    pub(crate) height_rate: f64,
}

/// A complex number with its derivative: a theta function at one instant.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Factor {
    pub(crate) re: f64,
    pub(crate) im: f64,
    pub(crate) re_rate: f64,
    pub(crate) im_rate: f64,
}

/// How the factors α, β and the common denominator δ make up a point: x + iy = plan·αβ/δ², s = height·|α|²/δ².
#[derive(Clone, Copy, Debug)]
pub(crate) struct Scales {
    pub(crate) plan: f64,
    pub(crate) height: f64,
    /// −1 mirrors the motion: clockwise.
    pub(crate) sense: f64,
}

impl Scales {
    /// With RATES = false the rates stay 0 and cost nothing.
    #[inline(always)]
    pub(crate) fn shape<const RATES: bool>(&self, alpha: Factor, beta: Factor, delta: f64, delta_rate: f64) -> Shape {
        let inverse = 1.0 / delta;
        let inverse_square = inverse * inverse;
        let (px, py) = (self.plan * inverse_square, self.plan * self.sense * inverse_square);
        let hs = self.height * inverse_square;
        let (re, im) = (alpha.re * beta.re - alpha.im * beta.im, alpha.re * beta.im + alpha.im * beta.re);
        let square = alpha.re * alpha.re + alpha.im * alpha.im;
        let mut shape = Shape { x: px * re, y: py * im, height: hs * square, ..Shape::default() };
        if RATES {
            let log_rate = 2.0 * delta_rate * inverse;
            let re_rate = (alpha.re_rate * beta.re - alpha.im_rate * beta.im)
                + (alpha.re * beta.re_rate - alpha.im * beta.im_rate);
            let im_rate = (alpha.re_rate * beta.im + alpha.im_rate * beta.re)
                + (alpha.re * beta.im_rate + alpha.im * beta.re_rate);
            shape.x_rate = px * (re_rate - re * log_rate);
            shape.y_rate = py * (im_rate - im * log_rate);
            shape.height_rate =
                hs * (2.0 * (alpha.re * alpha.re_rate + alpha.im * alpha.im_rate) - square * log_rate);
        }
        shape
    }
}
