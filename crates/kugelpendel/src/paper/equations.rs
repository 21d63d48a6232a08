//! Olsson's equations of motion in the plan view, as recurrences for Taylor coefficients.
//!
//! Dimensionless: lengths in l, time in 1/ω0. Both read r̈ = −Λ r with r = (x, y).

use crate::numbers::arithmetic::Arithmetic;
use crate::taylor::layout::{Alone, Layout};
use crate::taylor::products::{dot, inner_square, inner_terms, product, square, total};
use crate::taylor::series::{Coefficients, Point, RECIPROCALS, Series, VectorField};

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

impl<A: Arithmetic> VectorField<Alone<A>> for Equation {
    type Terms = PlanTerms;

    /// The guard is the depth below the support or, for (13), its square: the depth itself goes through zero, its square
    /// does not, so where there is the depth, it shows the end.
    #[inline(always)]
    fn next_order(&self, k: usize, series: &mut Series, terms: &mut PlanTerms) {
        let Series { position, velocity, guard, .. } = series;
        let PlanTerms { ratio, pull } = terms;
        let one = if k == 0 { 1.0 } else { 0.0 };
        let radius_squared = square::<Alone<A>>(k, position);
        let speed_squared = square::<Alone<A>>(k, velocity);
        let depth_squared = one - radius_squared;
        pull[k] = match self {
            Self::Cubic => {
                guard[k] = depth_squared;
                speed_squared - 0.5 * radius_squared + one
            }
            Self::Plane => {
                let outward = total::<Alone<A>>(&dot::<Alone<A>>(k, position, velocity));
                if k == 0 {
                    guard[0] = depth_squared.sqrt();
                    ratio[0] = outward / guard[0];
                } else {
                    guard[k] = (depth_squared - inner_square::<Alone<A>>(k, guard)) / (2.0 * guard[0]);
                    let known = inner_terms::<Alone<A>>(k, guard, ratio) + guard[k] * ratio[0];
                    ratio[k] = (outward - known) / guard[0];
                }
                let ends = if k == 0 { ratio[0] * ratio[0] } else { 2.0 * ratio[0] * ratio[k] };
                inner_square::<Alone<A>>(k, ratio) + ends + speed_squared + guard[k]
            }
        };
        let turned = product::<Alone<A>>(k, pull, position);
        position[k + 1] = Alone::<A>::times(&velocity[k], RECIPROCALS[k + 1]);
        velocity[k + 1] = Alone::<A>::times(&turned, -RECIPROCALS[k + 1]);
    }
}
