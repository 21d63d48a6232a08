//! Olsson's equations of motion in the plan view, as recurrences for Taylor coefficients.
//!
//! Dimensionless: lengths in l, time in 1/ω0. Both read r̈ = −Λ r with r = (x, y).

use crate::numbers::arithmetic::Arithmetic;
use crate::taylor::series::{
    Coefficients, Point, RECIPROCALS, Series, VectorField, dot, inner_terms, product, square, total,
};

/// Which of the paper's two equations of motion is integrated.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Equation {
    /// (12), exact on the lower half: Λ = (r·ṙ)²/(1 − ρ²) + ṙ² + √(1 − ρ²), the first term of fourth order (the paper
    /// prints it with l² for l⁴).
    Plane,
    /// (13), to third order: Λ = 1 − ρ²/2 + ṙ².
    Cubic,
}

impl Equation {
    /// Both end at the support's level: (12) divides by the depth below it, (13) would leave the sphere.
    pub(crate) fn holds(self, point: &Point) -> bool {
        let [x, y, _, _] = point.position;
        x * x + y * y < 1.0
    }

    /// Λ: the pull of the thread against the weight.
    pub(crate) fn pull(self, point: &Point) -> f64 {
        let Point { position: [x, y, _, _], velocity: [vx, vy, _, _] } = *point;
        let (radius_squared, speed_squared) = (x * x + y * y, vx * vx + vy * vy);
        match self {
            Self::Plane => {
                let (outward, depth_squared) = (x * vx + y * vy, 1.0 - radius_squared);
                outward * outward / depth_squared + speed_squared + depth_squared.sqrt()
            }
            Self::Cubic => speed_squared - 0.5 * radius_squared + 1.0,
        }
    }
}

/// What Λ is made of.
#[derive(Default)]
pub(crate) struct PlanTerms {
    /// r·ṙ/depth.
    ratio: Coefficients,
    pull: Coefficients,
}

impl<A: Arithmetic> VectorField<A> for Equation {
    type Terms = PlanTerms;

    /// The guard is the depth below the support or, for (13), its square: the depth itself goes through zero, its square
    /// does not, so where there is the depth, it shows the end.
    #[inline(always)]
    fn next_order<const K: usize>(&self, series: &mut Series, terms: &mut PlanTerms) {
        let Series { position, velocity, guard, .. } = series;
        let PlanTerms { ratio, pull } = terms;
        let one = if K == 0 { 1.0 } else { 0.0 };
        let radius_squared = square::<A, K>(position);
        let speed_squared = square::<A, K>(velocity);
        let depth_squared = one - radius_squared;
        pull[K] = match self {
            Self::Cubic => {
                guard[K] = depth_squared;
                speed_squared - 0.5 * radius_squared + one
            }
            Self::Plane => {
                let outward = total(&dot::<A, K>(position, velocity));
                if K == 0 {
                    guard[0] = depth_squared.sqrt();
                    ratio[0] = outward / guard[0];
                } else {
                    guard[K] = (depth_squared - inner_terms::<A, K>(guard, guard)) / (2.0 * guard[0]);
                    let known = inner_terms::<A, K>(guard, ratio) + guard[K] * ratio[0];
                    ratio[K] = (outward - known) / guard[0];
                }
                let ends = if K == 0 { ratio[0] * ratio[0] } else { 2.0 * ratio[0] * ratio[K] };
                inner_terms::<A, K>(ratio, ratio) + ends + speed_squared + guard[K]
            }
        };
        let turned = product::<A, K>(pull, position);
        position[K + 1] = velocity[K].map(|v| v * RECIPROCALS[K + 1]);
        velocity[K + 1] = turned.map(|f| -f * RECIPROCALS[K + 1]);
    }
}
