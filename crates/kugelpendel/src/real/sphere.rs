//! The full equations on the sphere, as recurrences for Taylor coefficients: r̈ = F − Λr with Λ = v² + F·r.
//!
//! Λ is not divided by r·r: every step starts on the sphere to the last bit, and none is long enough for what is off by
//! an ulp to grow. Damping has no part in F·r, since v is at right angles to r.

use crate::given::forces::Forces;
use crate::numbers::arithmetic::{Arithmetic, horner};
use crate::taylor::events::{SpeedSquaredRate, first};
use crate::taylor::series::{
    Coefficients, ORDER, Point, RECIPROCALS, Series, Vector, VectorField, Vectors, dot, inner_terms, product, square,
    total,
};

/// Speeds, in lω0, that quadratic drag does not tell from rest: |v| has no series at v = 0, √(v² + s²) has, and the
/// difference of the two forces, below c·s²/2, is lost in rounding.
const STILL: f64 = 1e-9;

/// A slowest point that is no slower than this, against the step's start, is no turning point to quadratic drag.
const SLOW: f64 = 0.1;

/// A step may go so far beyond a turning point, and does, so that the events there lie within it: what drag does in so short
/// a time, near rest, is lost in rounding too.
const AT_ONCE: f64 = 1e-6;

/// Where a step has to end for quadratic drag: where the bob is slowest. In a plane swing the series of |v| goes on
/// through zero as that of v, below zero.
#[inline(always)]
pub(crate) fn slowest_point<A: Arithmetic>(series: &Series, size: f64) -> Option<f64> {
    let at = first::<A>(&SpeedSquaredRate(series, size.signum()), size, true)?;
    let slowest = horner::<A, _>(&series.speed_squared, ORDER, at);
    (at.abs() > AT_ONCE && slowest < SLOW * SLOW * series.speed_squared[0])
        .then_some(at + 0.5 * AT_ONCE * size.signum())
}

/// The forces without dimensions, as matrices on r and v.
#[derive(Clone, Copy, Debug)]
pub(crate) struct SphereField {
    /// 2γ.
    damping: f64,
    /// c·l.
    pub(crate) quadratic: f64,
    /// On (x, y): −2δ χ̂χ̂ᵀ.
    stiffness: [[f64; 2]; 2],
    /// On (x, y): −Δγ(2 χ̂χ̂ᵀ − 1), and the vertical part of the Coriolis force.
    coupling: [[f64; 2]; 2],
    /// Twice the horizontal rotation.
    horizontal: f64,
    /// Whether anything acts beside gravity and damping.
    forced: bool,
}

impl SphereField {
    pub(crate) fn new(forces: &Forces, length: f64, omega0: f64) -> Self {
        let projector = |angle: f64| {
            let (sin, cos) = angle.sin_cos();
            [[cos * cos, sin * cos], [sin * cos, sin * sin]]
        };
        let stiff = projector(forces.axis);
        let damped = projector(forces.damping_axis);
        let [horizontal, vertical] = forces.rotation.map(|rate| 2.0 * rate / omega0);
        let (anisotropy, fading) = (2.0 * forces.anisotropy / omega0, forces.damping_anisotropy / omega0);
        let mut coupling = damped.map(|row| row.map(|value| -2.0 * fading * value));
        coupling[0][0] += fading;
        coupling[1][1] += fading;
        coupling[0][1] += vertical;
        coupling[1][0] -= vertical;
        Self {
            damping: 2.0 * forces.damping / omega0,
            quadratic: forces.quadratic * length,
            stiffness: stiff.map(|row| row.map(|value| -anisotropy * value)),
            coupling,
            horizontal,
            forced: anisotropy != 0.0 || fading != 0.0 || horizontal != 0.0 || vertical != 0.0,
        }
    }

    /// Continues the series of the motion from where it starts, on a taut thread or in flight.
    #[inline(always)]
    pub(crate) fn continue_series<A: Arithmetic>(&self, taut: bool, series: &mut Series) {
        match (self.forced, self.quadratic != 0.0, taut) {
            (false, false, true) => VectorField::<A>::continue_series(&ActingField::<false, false, true>(self), series),
            (true, false, true) => VectorField::<A>::continue_series(&ActingField::<true, false, true>(self), series),
            (_, true, true) => VectorField::<A>::continue_series(&ActingField::<true, true, true>(self), series),
            (_, false, false) => VectorField::<A>::continue_series(&ActingField::<true, false, false>(self), series),
            (_, true, false) => VectorField::<A>::continue_series(&ActingField::<true, true, false>(self), series),
        }
    }

    /// Whether a free pendulum can never again come near the height of the support, so that its thread stays taut: its
    /// energy is too small, no force adds to it, and what acts sideways is weak beside gravity.
    pub(crate) fn stays_below(&self, point: &Point) -> bool {
        /// Of the height of the support, and of gravity.
        const MARGIN: f64 = 0.1;
        let Point { position: [_, _, z, _], velocity: [vx, vy, vz, _] } = *point;
        let largest = |matrix: [[f64; 2]; 2]| matrix.as_flattened().iter().fold(0.0, |most: f64, x| most.max(x.abs()));
        // The part of the coupling that damps: Δγ, which adds energy along one axis where it is more than 2γ.
        let [[cxx, cxy], [cyx, cyy]] = self.coupling;
        let fading = (0.5 * (cxx - cyy)).hypot(0.5 * (cxy + cyx));
        let sideways = largest(self.stiffness) + largest(self.coupling) + self.horizontal.abs();
        let energy = 0.5 * (vx * vx + vy * vy + vz * vz) + (1.0 - z);
        fading <= self.damping && sideways < MARGIN / 4.0 && energy < 1.0 - MARGIN
    }

    /// All but gravity, damping and the thread.
    #[inline(always)]
    fn sideways<A: Arithmetic>(&self, position: &Vector, velocity: &Vector) -> Vector {
        let [x, y, _, _] = *position;
        let [vx, vy, vz, _] = *velocity;
        let along = |axis: usize| {
            let [sx, sy] = self.stiffness[axis];
            let [cx, cy] = self.coupling[axis];
            A::mul_add(cx, vx, A::mul_add(cy, vy, A::mul_add(sx, x, sy * y)))
        };
        [A::mul_add(self.horizontal, vz, along(0)), along(1), -self.horizontal * vx, 0.0]
    }
}

/// The forces, with what acts and whether the thread holds known to the compiler.
struct ActingField<'a, const FORCED: bool, const QUADRATIC: bool, const TAUT: bool>(&'a SphereField);

impl<A: Arithmetic, const FORCED: bool, const QUADRATIC: bool, const TAUT: bool> VectorField<A>
    for ActingField<'_, FORCED, QUADRATIC, TAUT>
{
    type Terms = SphereTerms;

    #[inline(always)]
    fn next_order<const K: usize>(&self, series: &mut Series, terms: &mut SphereTerms) {
        let ActingField(field) = self;
        let Series { position, velocity, guard, speed_squared } = series;
        let mut force = velocity[K].map(|v| -field.damping * v);
        if FORCED {
            terms.sideways[K] = field.sideways::<A>(&position[K], &velocity[K]);
            force = plus(force, terms.sideways[K], 1.0);
        }
        if QUADRATIC {
            let speed = &mut terms.speed;
            speed_squared[K] = square::<A, K>(velocity) + if K == 0 { STILL * STILL } else { 0.0 };
            speed[K] = if K == 0 {
                speed_squared[0].sqrt()
            } else {
                (speed_squared[K] - inner_terms::<A, K>(speed, speed)) / (2.0 * speed[0])
            };
            let drag = product::<A, K>(speed, velocity);
            force = plus(force, drag, -field.quadratic);
        }
        if K == 0 {
            force[2] += 1.0;
        }
        if TAUT {
            // Λ_K, and with it the thread's part of the force.
            let squared = if QUADRATIC { speed_squared[K] } else { square::<A, K>(velocity) };
            let other = if FORCED { total(&dot::<A, K>(&terms.sideways, position)) } else { 0.0 };
            guard[K] = squared + other + position[K][2];
            let pull = product::<A, K>(guard, position);
            force = plus(force, pull, -1.0);
        }
        let share = RECIPROCALS[K + 1];
        velocity[K + 1] = force.map(|f| f * share);
        position[K + 1] = velocity[K].map(|v| v * share);
    }
}

/// Series that are needed on the way.
#[derive(Default)]
pub(crate) struct SphereTerms {
    sideways: Vectors,
    /// |v|.
    speed: Coefficients,
}

#[inline(always)]
fn plus(sum: Vector, term: Vector, factor: f64) -> Vector {
    std::array::from_fn(|lane| sum[lane] + factor * term[lane])
}
