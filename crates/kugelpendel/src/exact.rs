//! The exact motion of one pendulum from one launch.

use crate::arithmetic::{Arithmetic, Portable, dispatch};
use crate::double_double::{Dd, Pair, two_sum};
use crate::elliptic::Ladder;
use crate::hyperbolic::Hyperbolic;
use crate::invalid::Invalid;
use crate::invariants::{BLOCK, Invariants};
use crate::launch::{Launch, State};
use crate::pendulum::Pendulum;
use crate::shape::Shape;
use crate::trigonometric::Trigonometric;
use std::f64::consts::{PI, TAU};
use std::ops::Range;

/// Below this 1 − m the series in q give way to those in q' (q = 0.19, q' = 0.0025 there).
const HYPERBOLIC_BELOW: f64 = 0.02;

/// Everything about the motion that does not depend on time; positions and velocities are in [`crate::sampling`].
#[derive(Clone, Copy, Debug)]
pub struct ExactMotion {
    pub(crate) pendulum: Pendulum,
    pub(crate) invariants: Invariants,
    launch: Start,
    omega0: Pair,
}

/// How far along the swing the motion is, given the time.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Clock {
    /// Swings (highest point to highest point) per second, turns of the frame per second, and the swing's fraction at
    /// the launch, counted from a lowest point.
    Periodic {
        swings: Pair,
        frame: Pair,
        start: Pair,
    },
    /// On the separatrix: h = rate·t + start.
    Once { rate: f64, start: f64 },
    /// At rest, hanging or upright.
    Still,
}

/// The launch as seen from above, dimensionless: it fixes the azimuth.
#[derive(Clone, Copy, Debug)]
struct Start {
    height: f64,
    plan: [f64; 2],
    plan_velocity: [f64; 2],
    still: bool,
}

/// One swing's form, made when positions are asked for.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Chart {
    Trigonometric(Trigonometric),
    Hyperbolic(Hyperbolic),
    /// x, y and the height, m.
    Still([f64; 3]),
}

dispatch! {
    /// As many as are given of both, at most BLOCK, all of them checked.
    fn solve(cases: &[(Pendulum, Launch)], out: &mut [ExactMotion]) = solve_with
}

#[inline(always)]
fn solve_with<A: Arithmetic>(_: A, cases: &[(Pendulum, Launch)], out: &mut [ExactMotion]) {
    let mut states = [State::<A>::REST; BLOCK];
    let mut invariants = [Invariants::ZERO; BLOCK];
    let count = cases.len();
    let mut known: Option<(f64, f64, Pair)> = None; // the same pendulum launched again and again is common
    for (((pendulum, launch), state), motion) in cases.iter().zip(&mut states).zip(&mut *out) {
        motion.pendulum = *pendulum;
        motion.omega0 = match known {
            Some((length, gravity, omega0))
                if length == pendulum.length && gravity == pendulum.gravity =>
            {
                omega0
            }
            _ => pendulum.precise_angular_frequency::<A>().pair(),
        };
        known = Some((pendulum.length, pendulum.gravity, motion.omega0));
        *state = launch.state(pendulum, Dd::of(motion.omega0));
    }
    Invariants::fill(&states[..count], &mut invariants[..count]);
    for ((motion, state), invariants) in out.iter_mut().zip(&states).zip(invariants) {
        motion.invariants = invariants;
        motion.launch = Start {
            height: state.height.hi,
            plan: state.plan,
            plan_velocity: state.plan_velocity,
            still: state.speed_squared.hi == 0.0
                && (state.height.hi <= 0.0 || state.depth.hi <= 0.0),
        };
    }
}

impl Invariants {
    fn ladder(&self) -> Ladder {
        let t = &self.turning;
        Ladder::new(
            t.excess + t.low_depth,
            t.excess + t.high_depth,
            2.0 * t.half_range,
        )
    }

    /// The fraction of a swing since the lowest point, in (−½, ½], of a point (s − mean, ∝ ṡ) on the height's circle.
    fn fraction(&self, [cos, sin]: [f64; 2]) -> Pair {
        let (ladder, radius) = (self.ladder(), self.turning.half_range);
        if cos <= 0.0 {
            // sn² = (s − s_b)/(s_a − s_b), as a tangent without cancellation
            let share = ladder.argument(sin.abs().atan2(radius - cos)) / PI;
            return Pair {
                hi: share.copysign(sin),
                lo: 0.0,
            };
        }
        // From the highest point back: K − F(φ) = F(φ'), tan φ' = cot φ/√(1 − m).
        let t = &self.turning;
        let (a, b) = (
            (t.excess + t.low_depth).sqrt(),
            (t.excess + t.high_depth).sqrt(),
        );
        let share = ladder.argument((sin.abs() * a).atan2((radius + cos) * b)) / PI;
        let (hi, lo) = two_sum(0.5, -share);
        if sin < 0.0 {
            Pair { hi: -hi, lo: -lo }
        } else {
            Pair { hi, lo }
        }
    }

    fn start(&self) -> Pair {
        self.fraction(self.circle)
    }

    /// The same on the separatrix, where the swing lasts for ever: h = asinh tan φ.
    fn separatrix_start(&self) -> f64 {
        let ([cos, sin], radius) = (self.circle, self.turning.half_range);
        let tangent = if cos <= 0.0 {
            sin.abs() / (radius - cos)
        } else {
            (radius + cos) / sin.abs()
        };
        tangent.asinh().copysign(sin)
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

    const UNSOLVED: Self = Self {
        pendulum: Pendulum {
            length: 1.0,
            gravity: 1.0,
            mass: 1.0,
        },
        invariants: Invariants::ZERO,
        launch: Start {
            height: 0.0,
            plan: [0.0; 2],
            plan_velocity: [0.0; 2],
            still: true,
        },
        omega0: Pair { hi: 1.0, lo: 0.0 },
    };

    /// The same for many, at most BLOCK at a time.
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
        let good: Vec<_> = (0..cases.len())
            .filter(good)
            .map(|index| cases[index])
            .collect();
        let mut motions = [Self::UNSOLVED; BLOCK];
        solve(&good, &mut motions[..good.len()]);
        let mut motions = motions.into_iter();
        verdicts
            .into_iter()
            .map(|verdict| verdict.map(|()| motions.next().unwrap_or(Self::UNSOLVED)))
            .collect()
    }

    pub(crate) fn omega0(&self) -> f64 {
        self.omega0.hi
    }

    pub(crate) fn is_still(&self) -> bool {
        self.launch.still
    }

    pub(crate) fn launch_height(&self) -> f64 {
        self.launch.height
    }

    fn near_separatrix(&self) -> bool {
        let t = &self.invariants.turning;
        t.excess + t.high_depth <= HYPERBOLIC_BELOW * (t.excess + t.low_depth)
    }

    pub(crate) fn clock(&self) -> Clock {
        let invariants = &self.invariants;
        if self.launch.still {
            return Clock::Still;
        }
        if invariants.frequency.hi == 0.0 {
            let turning = &invariants.turning;
            let rate = self.omega0.hi * (0.5 * (turning.excess + turning.low_depth)).sqrt();
            return Clock::Once {
                rate,
                start: invariants.separatrix_start(),
            };
        }
        let per_second = Dd::<Portable>::of(self.omega0) * Dd::INV_PI;
        let frame = if self.near_separatrix() {
            invariants.precession
        } else {
            invariants.frame
        };
        Clock::Periodic {
            swings: (per_second * Dd::of(invariants.frequency)).pair(),
            frame: (per_second * Dd::of(frame))
                .scale(0.5 * invariants.sense)
                .pair(),
            start: invariants.start(),
        }
    }

    pub fn pendulum(&self) -> &Pendulum {
        &self.pendulum
    }

    /// ω, rad/s: of the swing in the frame that turns with the precession; 0 on the separatrix. In a plane over the
    /// top, of the revolutions.
    pub fn frequency(&self) -> f64 {
        let frequency = self.invariants.frequency.hi * self.omega0.hi;
        if self.invariants.revolves() {
            2.0 * frequency
        } else {
            frequency
        }
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
        self.invariants.sense
            * PI
            * (1.0
                + if self.invariants.angular_momentum == 0.0 {
                    0.0
                } else {
                    ratio
                })
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
        [
            (t.high * t.high_depth).sqrt() * self.pendulum.length,
            (t.low * t.low_depth).sqrt() * self.pendulum.length,
        ]
    }

    /// Pull of the thread at a height s (in lengths), N; negative where a thread would go slack.
    pub(crate) fn tension_at(&self, height: f64) -> f64 {
        self.pendulum.mass
            * self.pendulum.gravity
            * (2.0 * (self.invariants.energy - height) + (1.0 - height))
    }

    /// Smallest and largest pull of the thread, N: at the highest and at the lowest point.
    pub fn tension_range(&self) -> [f64; 2] {
        let t = &self.invariants.turning;
        [self.tension_at(t.high), self.tension_at(t.low)]
    }

    /// Whether the constraint has to push somewhere on the path, which a thread cannot.
    pub fn goes_slack(&self) -> bool {
        self.tension_range()[0] < 0.0
    }

    /// First time ≥ 0 after the launch at which a thread goes slack, s; infinite if it never does.
    pub fn slack_time(&self) -> f64 {
        if !self.goes_slack() {
            return f64::INFINITY;
        }
        let slack_height = (2.0 * self.invariants.energy + 1.0) / 3.0;
        if self.launch.height > slack_height {
            return 0.0;
        }
        let t = &self.invariants.turning;
        let cos = slack_height - 0.5 * (t.high + t.low);
        let sin = ((t.half_range - cos) * (t.half_range + cos))
            .max(0.0)
            .sqrt();
        match self.clock() {
            Clock::Still => f64::INFINITY,
            Clock::Once { rate, start } => {
                let crossing = (slack_height.sqrt() / (2.0 - slack_height).sqrt()).asinh();
                if start <= crossing {
                    (crossing - start) / rate
                } else {
                    f64::INFINITY
                }
            }
            Clock::Periodic { start, .. } => {
                let crossing = self.invariants.fraction([cos, sin]);
                ((crossing.hi - start.hi) + (crossing.lo - start.lo)).rem_euclid(1.0)
                    * self.radial_period()
            }
        }
    }

    /// First time ≥ 0 at a highest point, s; infinite on the separatrix, 0 at rest.
    pub fn apsis_time(&self) -> f64 {
        match self.clock() {
            Clock::Still => 0.0,
            Clock::Once { .. } => f64::INFINITY,
            Clock::Periodic { start, .. } => ((0.5 - start.hi) - start.lo) * self.radial_period(),
        }
    }

    /// The chart, and by how many turns its frame is turned at the launch.
    pub(crate) fn chart(&self, clock: &Clock) -> (Chart, f64) {
        match *clock {
            Clock::Still => {
                let [x, y] = self.launch.plan;
                (
                    Chart::Still([x, y, self.launch.height].map(|v| v * self.pendulum.length)),
                    0.0,
                )
            }
            Clock::Periodic { start, .. } if !self.near_separatrix() => {
                let chart = Trigonometric::new(
                    self.pendulum.length,
                    &self.invariants,
                    &self.invariants.ladder(),
                );
                let (sin, cos) = (PI * start.hi).sin_cos();
                let shape = chart.at_any::<true>(cos, sin);
                let frame = self.invariants.sense * self.invariants.frame.hi;
                let turn = self.launch_turn(&shape, self.invariants.frequency.hi, frame);
                (Chart::Trigonometric(chart), turn)
            }
            Clock::Periodic { start, .. } => {
                let chart = Hyperbolic::new(self.pendulum.length, &self.invariants);
                let shape = chart.at(chart.span * start.hi);
                let twist = chart.twist();
                let frequency = self.invariants.frequency.hi;
                let frame =
                    self.invariants.sense * self.invariants.precession.hi + 2.0 * twist * frequency;
                let turn = self.launch_turn(&shape, chart.span * frequency / PI, frame);
                (Chart::Hyperbolic(chart), turn - twist * start.hi)
            }
            Clock::Once { rate, start } => {
                let chart = Hyperbolic::new(self.pendulum.length, &self.invariants);
                let turn = self.launch_turn(&chart.at(start), rate / self.omega0.hi, 0.0);
                (Chart::Hyperbolic(chart), turn)
            }
        }
    }

    /// The angle between launch and shape, in turns, from position and velocity together: either may vanish.
    fn launch_turn(&self, shape: &Shape, swing: f64, frame: f64) -> f64 {
        let Start {
            plan,
            plan_velocity,
            ..
        } = self.launch;
        let velocity = [
            swing * shape.x_rate - frame * shape.y,
            swing * shape.y_rate + frame * shape.x,
        ];
        let cos = plan[0] * shape.x
            + plan[1] * shape.y
            + plan_velocity[0] * velocity[0]
            + plan_velocity[1] * velocity[1];
        let sin = plan[1] * shape.x - plan[0] * shape.y + plan_velocity[1] * velocity[0]
            - plan_velocity[0] * velocity[1];
        sin.atan2(cos) / TAU
    }
}
