//! The full equations on the sphere, as recurrences for Taylor coefficients: r̈ = F − Λr with Λ = v² + F·r.
//!
//! Λ is not divided by r·r: every step starts on the sphere to the last bit, and none is long enough for what is off by
//! an ulp to grow. Damping has no part in F·r, since v is at right angles to r.

use crate::given::forces::Forces;
use crate::numbers::arithmetic::{Arithmetic, horner};
use crate::numbers::lanes::{Lanes, Number};
use crate::taylor::events::{PIECES, Passages, Piece, SpeedSquaredRate, first_passages};
use crate::taylor::layout::{Alone, Layout, Several};
use crate::taylor::products::{
    early_terms_of_two, inner_square, product, square, square_and_early_terms, total, with_last_term,
};
use crate::taylor::series::{
    Coefficients, ORDER, Point, RECIPROCALS, Series, SeriesOf, VectorField, Vectors, polynomial,
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
pub(crate) fn slowest_point<A: Arithmetic>(series: &Series, direction: f64, size: f64) -> Option<f64> {
    let rate = SpeedSquaredRate::of::<Alone<A>>(series, direction);
    let mut piece = Piece::start::<A>(&rate, size, true);
    if !piece.next::<A>(&rate) {
        return None;
    }
    if least_speed_squared::<Alone<A>>(series, piece.ends[0], piece.values[0], size) >= slow_squared::<Alone<A>>(series)
    {
        return None;
    }
    let at = piece.time::<A>(&rate);
    let slowest = horner::<A, _>(&series.speed_squared, ORDER, at);
    (at.abs() > AT_ONCE && slowest < slow_squared::<Alone<A>>(series)).then_some(at + 0.5 * AT_ONCE * direction)
}

/// Marks the lanes, 1 << lane, in which [`slowest_point`] has to be asked.
#[inline(always)]
pub(crate) fn lanes_that_slow_down<L: Lanes>(series: &Series<L, [L; 3]>, direction: L, size: L) -> u32 {
    let Passages { mut lanes, before, below } =
        first_passages(&SpeedSquaredRate::of::<Several<L>>(series, direction), size, true);
    if lanes != 0 {
        let least = least_speed_squared::<Several<L>>(series, before, below, size);
        let slow = slow_squared::<Several<L>>(series);
        for (lane, (least, slow)) in least.numbers().iter().zip(slow.numbers()).enumerate() {
            lanes &= !(u32::from(least >= slow) << lane);
        }
    }
    lanes
}

/// Below this v² a slowest point is a turning point.
#[inline(always)]
fn slow_squared<L: Layout>(series: &SeriesOf<L>) -> L::Scalar {
    L::same(SLOW * SLOW) * series.speed_squared[0]
}

/// In a piece of a step with its minimum, where it is convex, v² does not fall below this: what its tangent at the beginning,
/// of a rate below zero, has come to at the end.
#[inline(always)]
fn least_speed_squared<L: Layout>(
    series: &SeriesOf<L>,
    before: L::Scalar,
    rate: L::Scalar,
    size: L::Scalar,
) -> L::Scalar {
    let piece = L::abs(size) * L::same(1.0 / PIECES as f64);
    L::mul_add(rate, piece, polynomial::<L>(&series.speed_squared, before))
}

/// The forces without dimensions, as matrices on r and v.
#[derive(Clone, Copy, Debug)]
pub(crate) struct SphereField<S = f64> {
    /// 2γ.
    damping: S,
    /// c·l.
    quadratic: S,
    /// On (x, y): −2δ χ̂χ̂ᵀ.
    stiffness: [[S; 2]; 2],
    /// On (x, y): −Δγ(2 χ̂χ̂ᵀ − 1), and the vertical part of the Coriolis force.
    coupling: [[S; 2]; 2],
    /// Twice the horizontal rotation.
    horizontal: S,
    pub(crate) kind: FieldKind,
}

/// What acts beside gravity and damping: other kinds have other operations.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum FieldKind {
    Bare,
    Forced,
    /// Quadratic drag, whatever else.
    Braked,
}

impl FieldKind {
    pub(crate) const COUNT: usize = 3;
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
        let quadratic = forces.quadratic * length;
        let kind = if quadratic != 0.0 {
            FieldKind::Braked
        } else if anisotropy != 0.0 || fading != 0.0 || horizontal != 0.0 || vertical != 0.0 {
            FieldKind::Forced
        } else {
            FieldKind::Bare
        };
        Self {
            damping: 2.0 * forces.damping / omega0,
            quadratic,
            stiffness: stiff.map(|row| row.map(|value| -anisotropy * value)),
            coupling,
            horizontal,
            kind,
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
}

impl<S: Number> SphereField<S> {
    /// Continues the series of the motion from where it starts, on a taut thread or in flight.
    #[inline(always)]
    pub(crate) fn continue_series<L: Layout<Scalar = S>>(
        &self,
        taut: bool,
        series: &mut SeriesOf<L>,
        terms: &mut SphereTerms<S, L::Vector>,
    ) {
        macro_rules! acting {
            ($forced:literal, $quadratic:literal, $taut:literal) => {
                VectorField::<L>::continue_series(&ActingField::<S, $forced, $quadratic, $taut>(self), series, terms)
            };
        }
        match (self.kind, taut) {
            (FieldKind::Bare, true) => acting!(false, false, true),
            (FieldKind::Forced, true) => acting!(true, false, true),
            (FieldKind::Braked, true) => acting!(true, true, true),
            (FieldKind::Bare | FieldKind::Forced, false) => acting!(true, false, false),
            (FieldKind::Braked, false) => acting!(true, true, false),
        }
    }

    /// All but gravity, damping and the thread.
    #[inline(always)]
    fn sideways<L: Layout<Scalar = S>>(&self, position: &L::Vector, velocity: &L::Vector) -> L::Vector {
        let ([x, y, _], [vx, vy, vz]) = (L::parts(position), L::parts(velocity));
        let along_x = self.along::<L>(0, [x, y], [vx, vy]);
        let along_y = self.along::<L>(1, [x, y], [vx, vy]);
        L::vector([L::mul_add(self.horizontal, vz, along_x), along_y, -self.horizontal * vx])
    }

    #[inline(always)]
    fn along<L: Layout<Scalar = S>>(&self, axis: usize, [x, y]: [S; 2], [vx, vy]: [S; 2]) -> S {
        let [sx, sy] = self.stiffness[axis];
        let [cx, cy] = self.coupling[axis];
        L::mul_add(cx, vx, L::mul_add(cy, vy, L::mul_add(sx, x, sy * y)))
    }
}

impl<L: Lanes> SphereField<L> {
    /// The same forces in all lanes.
    pub(crate) fn in_all_lanes(field: &SphereField) -> Self {
        let matrix = |matrix: [[f64; 2]; 2]| matrix.map(|row| row.map(L::same));
        Self {
            damping: L::same(field.damping),
            quadratic: L::same(field.quadratic),
            stiffness: matrix(field.stiffness),
            coupling: matrix(field.coupling),
            horizontal: L::same(field.horizontal),
            kind: field.kind,
        }
    }

    /// Lays forces of the same kind into a lane.
    pub(crate) fn set_lane(&mut self, lane: usize, field: &SphereField) {
        debug_assert_eq!(self.kind, field.kind, "other forces, other operations");
        let set = |lanes: &mut L, value: f64| lanes.numbers_mut()[lane] = value;
        set(&mut self.damping, field.damping);
        set(&mut self.quadratic, field.quadratic);
        set(&mut self.horizontal, field.horizontal);
        for (lanes, matrix) in [(&mut self.stiffness, field.stiffness), (&mut self.coupling, field.coupling)] {
            for (lanes, value) in lanes.as_flattened_mut().iter_mut().zip(matrix.as_flattened()) {
                set(lanes, *value);
            }
        }
    }
}

/// The forces, with what acts and whether the thread holds known to the compiler.
struct ActingField<'a, S, const FORCED: bool, const QUADRATIC: bool, const TAUT: bool>(&'a SphereField<S>);

impl<L: Layout, const FORCED: bool, const QUADRATIC: bool, const TAUT: bool> VectorField<L>
    for ActingField<'_, L::Scalar, FORCED, QUADRATIC, TAUT>
{
    type Terms = SphereTerms<L::Scalar, L::Vector>;

    #[inline(always)]
    fn next_order(&self, k: usize, series: &mut SeriesOf<L>, terms: &mut Self::Terms) {
        let ActingField(field) = self;
        let Series { position, velocity, guard, speed_squared } = series;
        let mut force = L::times(&velocity[k], -field.damping);
        if FORCED {
            terms.sideways[k] = field.sideways::<L>(&position[k], &velocity[k]);
            force = L::plus(force, terms.sideways[k], L::same(1.0));
        }
        if QUADRATIC {
            let speed = &mut terms.speed;
            let (squared, early) = square_and_early_terms::<L>(k, velocity, speed);
            if k == 0 {
                speed_squared[0] = squared + L::same(STILL * STILL);
                speed[0] = L::sqrt(speed_squared[0]);
                terms.half_slowness = L::same(0.5) / speed[0];
            } else {
                speed_squared[k] = squared;
                speed[k] = (squared - inner_square::<L>(k, speed)) * terms.half_slowness;
            }
            let drag = with_last_term::<L>(early, L::everywhere(speed[k]), velocity);
            force = L::plus(force, drag, -field.quadratic);
        }
        if k == 0 {
            let [fx, fy, fz] = L::parts(&force);
            force = L::vector([fx, fy, fz + L::same(1.0)]);
        }
        if TAUT {
            // Λ_K, and with it the thread's part of the force.
            let squared = if QUADRATIC { speed_squared[k] } else { square::<L>(k, velocity) };
            let [_, _, z] = L::parts(&position[k]);
            let pull = if FORCED {
                let sideways = &terms.sideways;
                let [others, pull] = early_terms_of_two::<L>(k, sideways, guard, position);
                let other = with_last_term::<L>(others, L::registers(&sideways[k]), position);
                guard[k] = squared + total::<L>(&other) + z;
                with_last_term::<L>(pull, L::everywhere(guard[k]), position)
            } else {
                guard[k] = squared + z;
                product::<L>(k, guard, position)
            };
            force = L::plus(force, pull, L::same(-1.0));
        }
        let share = L::same(RECIPROCALS[k + 1]);
        velocity[k + 1] = L::times(&force, share);
        position[k + 1] = L::times(&velocity[k], share);
    }
}

/// Series that are needed on the way.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct SphereTerms<S, V> {
    sideways: Vectors<V>,
    /// |v|.
    speed: Coefficients<S>,
    /// 1/(2|v|) where the step starts.
    half_slowness: S,
}
