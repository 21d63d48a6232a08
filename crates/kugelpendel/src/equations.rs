//! Olsson's equations of motion in the plan view, as recurrences for Taylor coefficients.
//!
//! Dimensionless: lengths in l, time in 1/ω0. Both read r̈ = −Λ r with r = (x, y).

use crate::taylor::{Coefficients, ORDER};

/// Which.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Equation {
    /// (12), exact on the lower half: Λ = (r·ṙ)²/(1 − ρ²) + ṙ² + √(1 − ρ²), the first term of fourth order (the paper
    /// prints it with l² for l⁴).
    Plane,
    /// (13), to third order: Λ = 1 − ρ²/2 + ṙ².
    Cubic,
}

/// Series of x, y, vx, vy, and of a function that reaches zero where the equation ends.
pub(crate) type Expansion = ([Coefficients; 4], Coefficients);

impl Equation {
    /// `None` where the equation ends: at the support's level and above.
    pub(crate) fn series(self, [x0, y0, vx0, vy0]: [f64; 4]) -> Option<Expansion> {
        let zero: Coefficients = [0.0; ORDER + 1];
        let (mut x, mut y, mut vx, mut vy) = (zero, zero, zero, zero);
        (x[0], y[0], vx[0], vy[0]) = (x0, y0, vx0, vy0);
        let (mut depth_squared, mut depth, mut ratio, mut pull) = (zero, zero, zero, zero);
        for k in 0..=ORDER {
            let radius_squared = product(&x, &x, k) + product(&y, &y, k);
            let speed_squared = product(&vx, &vx, k) + product(&vy, &vy, k);
            // Both end at the support's level: (12) divides by the depth below it, (13) would leave the sphere.
            let square = one(k) - radius_squared;
            depth_squared[k] = square;
            if k == 0 && (square.is_nan() || square <= 0.0) {
                return None;
            }
            pull[k] = match self {
                Self::Cubic => speed_squared - 0.5 * radius_squared + one(k),
                Self::Plane => {
                    // depth = √(1 − ρ²), ratio = r·ṙ/depth
                    if k == 0 {
                        depth[0] = square.sqrt();
                    } else {
                        let known: f64 = (1..k).map(|i| depth[i] * depth[k - i]).sum();
                        depth[k] = (square - known) / (2.0 * depth[0]);
                    }
                    let outward = product(&x, &vx, k) + product(&y, &vy, k);
                    let known: f64 = (1..=k).map(|i| depth[i] * ratio[k - i]).sum();
                    ratio[k] = (outward - known) / depth[0];
                    product(&ratio, &ratio, k) + speed_squared + depth[k]
                }
            };
            if k < ORDER {
                let next = (k + 1) as f64;
                (x[k + 1], y[k + 1]) = (vx[k] / next, vy[k] / next);
                (vx[k + 1], vy[k + 1]) = (-product(&pull, &x, k) / next, -product(&pull, &y, k) / next);
            }
        }
        // The depth itself goes through zero, its square does not: where there is the depth, it shows the end.
        Some(([x, y, vx, vy], if self == Self::Plane { depth } else { depth_squared }))
    }
}

/// The k-th coefficient of a product.
fn product(a: &Coefficients, b: &Coefficients, k: usize) -> f64 {
    (0..=k).map(|i| a[i] * b[k - i]).sum()
}

/// The k-th coefficient of 1.
fn one(k: usize) -> f64 {
    if k == 0 { 1.0 } else { 0.0 }
}
