//! The averaged motion of a real pendulum: a turning ellipse whose size, form and plane change slowly.
//!
//! [`law`] has the equations, [`ideal`], [`drag`] and [`push`] the averages in them, [`steps`] integrates them with the
//! coefficients in [`tableau`].

mod drag;
mod ideal;
mod law;
mod push;
mod steps;
mod tableau;
#[cfg(test)]
mod tests;

use crate::exact::chart::Chart;
use crate::exact::motion::ExactMotion;
use crate::exact::phase::Phase;
use crate::exact::theta::shape::product;
use crate::given::drive::Drive;
use crate::given::forces::{Acting, Forces};
use crate::given::invalid::{Invalid, Seen, require};
use crate::given::launch::Launch;
use crate::given::pendulum::Pendulum;
use crate::given::times::{Quantity, Times, both_ways};
use crate::numbers::arithmetic::Portable;
use law::{Circles, Law};
use std::f64::consts::PI;
use steps::{Moment, Walk};

/// Beyond this share of the length, swings are not averaged: turning radii no longer tell motions apart.
const LARGEST: f64 = 0.9999;

/// Rates of the forces beyond this share of ω0 are refused: the mean motion is off by a tenth of itself within 100
/// swings (benchmarks/envelope.py).
const MOST: f64 = 0.1;

/// Steps in which an end of the motion is looked for.
const MOST_STEPS: usize = 5000;

/// From where, and under which forces.
#[derive(Clone, Debug)]
pub struct EnvelopeMotion {
    pendulum: Pendulum,
    law: Law,
    start: Moment,
    omega0: f64,
}

/// What is asked of the averaged motion.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Envelope {
    /// x, y, z in m or their rates in m/s.
    Point(Quantity),
    /// a and b, m: turning radii, b with the sign of the sense.
    SemiAxes,
    /// ψ of the major axis, rad, continuous.
    Azimuth,
    /// Θ since the outer turning point that was nearest at the launch, rad, continuous.
    Phase,
    /// Of the plane, rad/s, by their causes: the Earth, the ideal motion, the suspension's stiffness, its damping, the
    /// drive; then of a and of b, m/s.
    Rates,
}

impl Envelope {
    /// How many numbers it takes for each time.
    pub fn width(self) -> usize {
        match self {
            Self::Point(_) => 3,
            Self::SemiAxes => 2,
            Self::Azimuth | Self::Phase => 1,
            Self::Rates => 7,
        }
    }
}

/// How far the motion has been integrated, forwards and backwards. A request that begins no earlier goes on from there,
/// with the same steps as from the launch.
#[derive(Clone, Debug, Default)]
pub struct EnvelopeWalks([Option<Box<Walk>>; 2]);

/// The slow variables at one time, lengths in l.
struct Elements {
    a: f64,
    b: f64,
    azimuth: f64,
    phase: f64,
}

impl EnvelopeMotion {
    /// Under everything that acts; the pendulum is as given, without the bob's corrections. `exact` as in [`Self::new`].
    ///
    /// # Errors
    /// What [`Acting::settle`] and [`Self::new`] refuse.
    pub fn under(acting: &Acting, pendulum: Pendulum, launch: Launch, exact: bool) -> Result<Self, Invalid> {
        let effective = acting.settle(&pendulum, &launch)?;
        Self::new(effective, launch, acting.forces(), acting.drive, exact)
    }

    /// With `exact`, ω and Ω are those of the closed form, and linear drag is averaged at any amplitude.
    ///
    /// # Errors
    /// A pendulum or launch that makes no sense, one that rises to the support's level, and forces that change a swing
    /// too much to be averaged.
    pub fn new(pendulum: Pendulum, launch: Launch, forces: Forces, drive: Drive, exact: bool) -> Result<Self, Invalid> {
        let motion = ExactMotion::new(pendulum, launch)?;
        let omega0 = pendulum.angular_frequency();
        forces.check()?;
        drive.check()?;
        for (name, value, unit, most) in [
            ("suspension.anisotropy", forces.anisotropy, "rad/s", MOST),
            ("suspension.damping_anisotropy", forces.damping_anisotropy, "1/s", MOST),
            ("drag.linear", forces.damping, "1/s", 0.5),
        ] {
            let share = value.abs() / omega0;
            require(value.abs() <= most * omega0, || Invalid::TooStrong {
                value: Seen { name, value, unit },
                share,
                frequency: omega0,
                most,
            })?;
        }
        let law = Law::new(&forces, drive, pendulum.length, omega0, exact);
        let [mut place, mut rate] = [[0.0; 3]; 2];
        motion.fill(Quantity::Position, Times::Scattered(&[0.0]), &mut place);
        motion.fill(Quantity::Velocity, Times::Scattered(&[0.0]), &mut rate);
        let [x, y, z] = place;
        let start = if z > 0.0 { mean(&pendulum, &law, [x, y], [rate[0], rate[1]]) } else { None };
        let height = motion.turning_heights()[0];
        let start = start.ok_or(Invalid::RisesToSupport { height, length: pendulum.length })?;
        Ok(Self { pendulum, law, start, omega0 })
    }

    /// At an outer turning point of the mean motion itself: turning radii a and b in m, b with the sign of the sense, and the
    /// azimuth of the major axis in rad. A launch would be such an ellipse and what the forces add to its velocity.
    ///
    /// # Errors
    /// As [`Self::new`].
    pub fn at_apsis(
        pendulum: Pendulum,
        [a, b, azimuth]: [f64; 3],
        forces: Forces,
        drive: Drive,
        exact: bool,
    ) -> Result<Self, Invalid> {
        let launch = Launch::Apsides { a, b, azimuth };
        let mut motion = Self::new(pendulum, launch, forces, drive, exact)?;
        let ideal = ExactMotion::new(pendulum, launch)?;
        let [mut place, mut rate] = [[0.0; 3]; 2];
        ideal.fill(Quantity::Position, Times::Scattered(&[0.0]), &mut place);
        ideal.fill(Quantity::Velocity, Times::Scattered(&[0.0]), &mut rate);
        if let Some(start) = osculating(&pendulum, [place[0], place[1]], [rate[0], rate[1]]) {
            motion.start = start;
        }
        Ok(motion)
    }

    /// Fills `out`, [`Envelope::width`] numbers to a time; beyond an end it is left as it was.
    ///
    /// # Errors
    /// The time in s at which the bob comes level with the support.
    ///
    /// # Panics
    /// If times and `out` do not have the same count.
    pub fn fill(&self, what: Envelope, times: &[f64], out: &mut [f64], walks: &mut EnvelopeWalks) -> Result<(), f64> {
        assert_eq!(what.width() * times.len(), out.len(), "so many numbers to a time");
        both_ways(times, |side, order| self.sweep(side, order, what, times, out, walks))
    }

    /// By which share of itself each force changes a swing of the launch's size: linear and quadratic drag, the
    /// suspension's stiffness and damping, the drive.
    pub fn strengths(&self) -> [f64; 5] {
        let Circles { p, q, .. } = Circles::of(&self.start.state);
        self.law.strengths(p + q)
    }

    /// The times in s between which the motion holds, looked for up to `within` s and some thousand steps to both sides.
    pub fn span(&self, within: f64) -> [f64; 2] {
        [-1.0, 1.0].map(|direction| {
            if self.law.is_conservative() {
                return direction * f64::INFINITY;
            }
            let mut walk = Walk::new(&self.law, &self.start, direction);
            for _ in 0..MOST_STEPS {
                if walk.ended || walk.until().abs() >= within * self.omega0 {
                    break;
                }
                walk.advance(&self.law);
            }
            if walk.ended { walk.until() / self.omega0 } else { direction * f64::INFINITY }
        })
    }

    fn sweep(
        &self,
        side: usize,
        order: &mut dyn Iterator<Item = usize>,
        what: Envelope,
        times: &[f64],
        out: &mut [f64],
        walks: &mut EnvelopeWalks,
    ) -> Result<(), f64> {
        let width = what.width();
        let slot = &mut walks.0[side];
        for index in order {
            let time = times[index] * self.omega0;
            if slot.as_ref().is_some_and(|walk| walk.is_past(time)) {
                *slot = None;
            }
            let walk = slot.get_or_insert_with(|| Box::new(Walk::new(&self.law, &self.start, [1.0, -1.0][side])));
            while !walk.reaches(time) {
                if walk.ended {
                    return Err(walk.until() / self.omega0);
                }
                walk.advance(&self.law);
            }
            self.write(what, time, &walk.at(time), &mut out[width * index..width * (index + 1)]);
        }
        Ok(())
    }

    fn write(&self, what: Envelope, time: f64, moment: &Moment, out: &mut [f64]) {
        let length = self.pendulum.length;
        let elements = Elements::of(moment, time);
        match what {
            Envelope::SemiAxes => out.copy_from_slice(&[length * elements.a, length * elements.b]),
            Envelope::Azimuth => out[0] = elements.azimuth,
            Envelope::Phase => out[0] = elements.phase,
            Envelope::Rates => {
                let circles = Circles::of(&moment.state);
                let [ahead, behind] = self.law.growth(&circles);
                for (out, share) in out.iter_mut().zip(self.law.shares(&circles)) {
                    *out = share * self.omega0;
                }
                out[law::CAUSES] = (ahead + behind) * self.omega0 * length;
                out[law::CAUSES + 1] = (ahead - behind) * self.omega0 * length;
            }
            Envelope::Point(quantity) => out.copy_from_slice(&self.point(quantity, time, moment, &elements)),
        }
    }

    /// On the ideal motion between the two turning radii, with the rates that the forces add.
    fn point(&self, quantity: Quantity, time: f64, moment: &Moment, elements: &Elements) -> [f64; 3] {
        let (length, omega0) = (self.pendulum.length, self.omega0);
        let &Elements { a, b, azimuth, phase } = elements;
        let ideal = Launch::Apsides { a, b: b.clamp(-a, a), azimuth: 0.0 };
        let unit = Pendulum { length: 1.0, gravity: 1.0, mass: 1.0 };
        let motion = match ExactMotion::new(unit, ideal) {
            Ok(motion) => motion,
            // The swing has died away.
            Err(Invalid::TooSmall { .. }) => {
                return match quantity {
                    Quantity::Position => [0.0, 0.0, length],
                    Quantity::Velocity => [0.0; 3],
                };
            }
            Err(_) => return [f64::NAN; 3],
        };
        let at_launch = motion.phase();
        let (Chart::Trigonometric(chart), turn) = motion.chart(&at_launch) else {
            return match quantity {
                Quantity::Position => [0.0, 0.0, length],
                Quantity::Velocity => [0.0; 3],
            };
        };
        let Phase::Periodic { start, .. } = at_launch else { return [f64::NAN; 3] };
        let (sin, cos) = (PI * start.hi + phase).sin_cos();
        let shape = chart.at_any::<true>(cos, sin);
        let (sin, cos) = (azimuth + std::f64::consts::TAU * turn).sin_cos();
        let [x, y] = product::<Portable>([cos, sin], [shape.unit * shape.x, shape.unit * shape.y]);
        let depth = 1.0 - shape.unit * shape.height;
        match quantity {
            Quantity::Position => [length * x, length * y, length * depth],
            Quantity::Velocity => {
                let swing = motion.frequency();
                let turning = motion.precession();
                let rate = [swing * shape.x_rate - turning * shape.y, swing * shape.y_rate + turning * shape.x]
                    .map(|value| shape.unit * value);
                let [vx, vy] = product::<Portable>([cos, sin], rate);
                let [added_x, added_y] = slow_velocity(&self.law, moment, time);
                let [vx, vy] = [vx + added_x, vy + added_y];
                [vx, vy, -(x * vx + y * vy) / depth].map(|v| v * length * omega0)
            }
        }
    }
}

impl Elements {
    fn of(moment: &Moment, time: f64) -> Self {
        let Circles { p, q, .. } = Circles::of(&moment.state);
        let [ahead, behind] = moment.angles;
        let phase = time + moment.state[4] + 0.5 * (ahead - behind);
        Self { a: p + q, b: p - q, azimuth: 0.5 * (ahead + behind), phase }
    }
}

/// What the forces add to the velocity of the ideal motion, in lω0: of the swing's fundamental.
fn slow_velocity(law: &Law, moment: &Moment, time: f64) -> [f64; 2] {
    let [ahead, behind] = law.gentle(&Circles::of(&moment.state));
    let (sin, cos) = (time + moment.state[4]).sin_cos();
    let first = product::<Portable>([cos, sin], ahead);
    let second = product::<Portable>([cos, -sin], behind);
    [first[0] + second[0], first[1] + second[1]]
}

/// The mean motion that is at this place (m) with this velocity (m/s) at t = 0; none where it rises to the support.
///
/// Mean, not osculating: the velocity is that of the ideal motion and what the forces add to it, by iteration. For
/// forces linear in place and velocity that is exact.
fn mean(pendulum: &Pendulum, law: &Law, [x, y]: [f64; 2], velocity: [f64; 2]) -> Option<Moment> {
    let speed = pendulum.length * pendulum.angular_frequency();
    let mut added = [0.0; 2];
    let mut moment = osculating(pendulum, [x, y], velocity)?;
    for _ in 0..12 {
        let next = slow_velocity(law, &moment, 0.0);
        let moved = (next[0] - added[0]).hypot(next[1] - added[1]);
        added = next;
        moment = osculating(pendulum, [x, y], [velocity[0] - speed * added[0], velocity[1] - speed * added[1]])?;
        if moved <= 1e-16 {
            break;
        }
    }
    Some(moment)
}

/// The ideal motion with this position and velocity; none where it rises to the support.
fn osculating(pendulum: &Pendulum, [x, y]: [f64; 2], [vx, vy]: [f64; 2]) -> Option<Moment> {
    let motion = ExactMotion::new(*pendulum, Launch::Plane { x, y, vx, vy }).ok()?;
    let ellipse = motion.ellipse();
    let [a, b] = [ellipse.a, ellipse.b].map(|radius| radius / pendulum.length);
    if motion.rises_above() || a > LARGEST {
        return None;
    }
    let (p, q) = (0.5 * (a + b), 0.5 * (a - b));
    let angles = [ellipse.azimuth + ellipse.phase, ellipse.azimuth - ellipse.phase];
    let [ahead, behind] = angles.map(f64::sin_cos);
    Some(Moment { state: [p * ahead.1, p * ahead.0, q * behind.1, q * behind.0, 0.0, 0.0, 0.0], angles })
}
