//! The full equations on the sphere, as recurrences for Taylor coefficients: r̈ = F − Λr with Λ = v² + F·r.
//!
//! Λ is not divided by r·r: every step starts on the sphere to the last bit, and none is long enough for what is off by
//! an ulp to grow. Damping has no part in F·r, since v is at right angles to r.

use crate::given::forces::Forces;
use crate::numbers::arithmetic::{Arithmetic, horner};
use crate::taylor::events::{Quickening, first};
use crate::taylor::series::{
    Coefficients, Law, ORDER, RECIPROCALS, Series, Vector, Vectors, dot, inner_terms, product, square, total,
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
pub(crate) fn turning_point<A: Arithmetic>(series: &Series, size: f64) -> Option<f64> {
    let at = first::<A>(&Quickening(series, size.signum()), size, true)?;
    let slowest = horner::<A, _>(&series.speed_squared, ORDER, at);
    (at.abs() > AT_ONCE && slowest < SLOW * SLOW * series.speed_squared[0])
        .then_some(at + 0.5 * AT_ONCE * size.signum())
}

/// The forces without dimensions, as matrices on r and v.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Sphere {
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
    pub(crate) forced: bool,
}

impl Sphere {
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

    /// All but gravity, damping and the thread.
    #[inline(always)]
    fn sideways<A: Arithmetic>(&self, place: &Vector, rate: &Vector) -> Vector {
        let [x, y, _, _] = *place;
        let [vx, vy, vz, _] = *rate;
        let along = |axis: usize| {
            let [sx, sy] = self.stiffness[axis];
            let [cx, cy] = self.coupling[axis];
            A::mul_add(cx, vx, A::mul_add(cy, vy, A::mul_add(sx, x, sy * y)))
        };
        [A::mul_add(self.horizontal, vz, along(0)), along(1), -self.horizontal * vx, 0.0]
    }
}

/// Which of the forces there are, and whether the thread holds, known to the compiler.
pub(crate) struct Kind<'a, const FORCED: bool, const QUADRATIC: bool, const TAUT: bool>(pub(crate) &'a Sphere);

impl<A: Arithmetic, const FORCED: bool, const QUADRATIC: bool, const TAUT: bool> Law<A>
    for Kind<'_, FORCED, QUADRATIC, TAUT>
{
    type Work = Work;

    #[inline(always)]
    fn next_order<const K: usize>(&self, series: &mut Series, work: &mut Work) {
        let Kind(law) = self;
        let Series { place, rate, guard, speed_squared } = series;
        let mut force = rate[K].map(|v| -law.damping * v);
        if FORCED {
            work.sideways[K] = law.sideways::<A>(&place[K], &rate[K]);
            force = plus(force, work.sideways[K], 1.0);
        }
        if QUADRATIC {
            let speed = &mut work.speed;
            speed_squared[K] = square::<A, K>(rate) + if K == 0 { STILL * STILL } else { 0.0 };
            speed[K] = if K == 0 {
                speed_squared[0].sqrt()
            } else {
                (speed_squared[K] - inner_terms::<A, K>(speed, speed)) / (2.0 * speed[0])
            };
            let drag = product::<A, K>(speed, rate);
            force = plus(force, drag, -law.quadratic);
        }
        if K == 0 {
            force[2] += 1.0;
        }
        if TAUT {
            // Λ_K, and with it the thread's part of the force.
            let squared = if QUADRATIC { speed_squared[K] } else { square::<A, K>(rate) };
            let other = if FORCED { total(&dot::<A, K>(&work.sideways, place)) } else { 0.0 };
            guard[K] = squared + other + place[K][2];
            let pull = product::<A, K>(guard, place);
            force = plus(force, pull, -1.0);
        }
        let share = RECIPROCALS[K + 1];
        rate[K + 1] = force.map(|f| f * share);
        place[K + 1] = rate[K].map(|v| v * share);
    }
}

/// Series that are needed on the way.
#[derive(Default)]
pub(crate) struct Work {
    sideways: Vectors,
    /// |v|.
    speed: Coefficients,
}

#[inline(always)]
fn plus(sum: Vector, term: Vector, factor: f64) -> Vector {
    std::array::from_fn(|lane| sum[lane] + factor * term[lane])
}
