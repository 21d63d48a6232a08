//! The exact motion of one pendulum from one launch.

use crate::exact::invariants::constants::{Invariants, Turning};
use crate::exact::invariants::many::LAUNCHES_PER_BLOCK;
use crate::given::invalid::Invalid;
use crate::given::launch::{Launch, LaunchState};
use crate::given::pendulum::Pendulum;
use crate::numbers::arithmetic::{Arithmetic, dispatch};
use crate::numbers::double_double::{Dd, Pair};
use std::f64::consts::{PI, TAU};
use std::ops::Range;

/// Everything about the motion that does not depend on time; positions and velocities are in [`crate::exact::sampling`].
#[derive(Clone, Copy, Debug)]
pub struct ExactMotion {
    pub(crate) pendulum: Pendulum,
    pub(crate) invariants: Invariants,
    pub(crate) launch: Start,
    /// ω0 in rad/s.
    pub(crate) omega0: Pair,
}

/// The launch as seen from above, dimensionless: it fixes the azimuth.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Start {
    pub(crate) height: f64,
    pub(crate) plan: [f64; 2],
    pub(crate) plan_velocity: [f64; 2],
    /// At rest, hanging or upright.
    pub(crate) still: bool,
}

dispatch! {
    /// As many as are given of both, at most LAUNCHES_PER_BLOCK, all of them checked.
    fn solve(cases: &[(Pendulum, Launch)], out: &mut [ExactMotion]) = solve_with
}

#[inline(always)]
pub(crate) fn solve_with<A: Arithmetic>(_: A, cases: &[(Pendulum, Launch)], out: &mut [ExactMotion]) {
    let mut states = [LaunchState::<A>::REST; LAUNCHES_PER_BLOCK];
    let mut invariants = [Invariants::ZERO; LAUNCHES_PER_BLOCK];
    let count = cases.len();
    let mut known: Option<(f64, f64, Pair)> = None; // the same pendulum launched again and again is common
    for (((pendulum, launch), state), motion) in cases.iter().zip(&mut states).zip(&mut *out) {
        motion.pendulum = *pendulum;
        motion.omega0 = match known {
            Some((length, gravity, omega0)) if length == pendulum.length && gravity == pendulum.gravity => omega0,
            _ => pendulum.precise_angular_frequency::<A>().pair(),
        };
        known = Some((pendulum.length, pendulum.gravity, motion.omega0));
        *state = launch.state(pendulum, Dd::of(motion.omega0));
    }
    Invariants::fill_block(&states[..count], &mut invariants[..count]);
    for ((motion, state), invariants) in out.iter_mut().zip(&states).zip(invariants) {
        let (height, depth) = (state.height.hi, state.depth.hi);
        let still = state.speed_squared.hi == 0.0 && (height <= 0.0 || depth <= 0.0);
        motion.invariants = invariants;
        if still {
            // Upright, what the constants leave open is whether the bob stays or is on the separatrix: it stays.
            motion.invariants.turning = Turning {
                high: height,
                low: height,
                high_depth: depth,
                low_depth: depth,
                excess: 0.0,
                half_range: 0.0,
            };
        }
        motion.launch = Start { height, plan: state.plan, plan_velocity: state.plan_velocity, still };
    }
}

impl ExactMotion {
    /// # Errors
    /// A pendulum or launch that makes no sense; see [`Pendulum::check`] and [`Launch::check`].
    pub fn new(pendulum: Pendulum, launch: Launch) -> Result<Self, Invalid> {
        pendulum.check()?;
        launch.check(&pendulum)?;
        let mut motion = [Self::UNSOLVED];
        solve(&[(pendulum, launch)], &mut motion);
        Ok(motion[0])
    }

    pub(crate) const UNSOLVED: Self = Self {
        pendulum: Pendulum { length: 1.0, gravity: 1.0, mass: 1.0 },
        invariants: Invariants::ZERO,
        launch: Start { height: 0.0, plan: [0.0; 2], plan_velocity: [0.0; 2], still: true },
        omega0: Pair { hi: 1.0, lo: 0.0 },
    };

    /// The same for many, at most LAUNCHES_PER_BLOCK at a time.
    pub(crate) fn solve_block(
        indices: Range<usize>,
        case: impl Fn(usize) -> (Pendulum, Launch),
    ) -> Vec<Result<Self, Invalid>> {
        let cases: Vec<_> = indices.map(case).collect();
        let verdict = |(pendulum, launch): &(Pendulum, Launch)| {
            pendulum.check()?;
            launch.check(pendulum)
        };
        let verdicts: Vec<_> = cases.iter().map(verdict).collect();
        let good = |index: &usize| verdicts[*index].is_ok();
        let good: Vec<_> = (0..cases.len()).filter(good).map(|index| cases[index]).collect();
        let mut motions = [Self::UNSOLVED; LAUNCHES_PER_BLOCK];
        solve(&good, &mut motions[..good.len()]);
        let mut motions = motions.into_iter();
        verdicts.into_iter().map(|verdict| verdict.map(|()| motions.next().unwrap_or(Self::UNSOLVED))).collect()
    }

    /// The pendulum that swings.
    pub fn pendulum(&self) -> &Pendulum {
        &self.pendulum
    }

    /// ω, rad/s: of the swing in the frame that turns with the precession; 0 on the separatrix. In a plane over the
    /// top, of the revolutions.
    pub fn frequency(&self) -> f64 {
        let frequency = self.invariants.frequency.hi * self.omega0.hi;
        if self.invariants.revolves() { 2.0 * frequency } else { frequency }
    }

    /// Ω, rad/s, positive counter-clockwise seen from above; 0 for motion in a vertical plane.
    pub fn precession(&self) -> f64 {
        if self.invariants.angular_momentum == 0.0 {
            return 0.0;
        }
        self.invariants.sense * self.invariants.precession.hi * self.omega0.hi
    }

    /// T, s: from one highest point to the next; infinite on the separatrix.
    pub fn radial_period(&self) -> f64 {
        PI / (self.invariants.frequency.hi * self.omega0.hi)
    }

    /// Azimuth from one highest point to the next, rad, signed: π + ΩT.
    pub fn apsidal_angle(&self) -> f64 {
        if self.invariants.revolves() {
            return TAU;
        }
        let ratio = self.invariants.precession.hi / self.invariants.frequency.hi;
        self.invariants.sense * PI * (1.0 + if self.invariants.angular_momentum == 0.0 { 0.0 } else { ratio })
    }

    /// Above the lowest point, J/kg.
    pub fn energy(&self) -> f64 {
        self.invariants.energy * self.pendulum.gravity * self.pendulum.length
    }

    /// x·vy − y·vx, m²/s, positive counter-clockwise seen from above.
    pub fn angular_momentum(&self) -> f64 {
        let length = self.pendulum.length;
        self.invariants.sense * self.invariants.angular_momentum * self.omega0.hi * length * length
    }

    /// Heights above the lowest point of the sphere, m: of the highest and of the lowest point of the path.
    pub fn turning_heights(&self) -> [f64; 2] {
        let t = &self.invariants.turning;
        [t.high * self.pendulum.length, t.low * self.pendulum.length]
    }

    /// Distances from the vertical axis, m, at the highest and at the lowest point of the path.
    pub fn turning_radii(&self) -> [f64; 2] {
        let t = &self.invariants.turning;
        [(t.high * t.high_depth).sqrt() * self.pendulum.length, (t.low * t.low_depth).sqrt() * self.pendulum.length]
    }
}
