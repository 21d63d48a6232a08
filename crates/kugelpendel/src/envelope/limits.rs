//! How far an averaged motion can be trusted.
//!
//! What averaging leaves out is of second order in the forces, and where a suspension or a drive acts on wide swings a
//! first-order offset of the mean actions, which the intrinsic precession turns into an angle that grows with time. The
//! coefficients are bounds of what docs/scripts/averaging.py measures against the full equations.

use super::circles::Circles;
use super::equations::{AveragedEquations, CAUSES};
use super::{Envelope, EnvelopeMotion, EnvelopeWalks};
use crate::given::forces::Thread;
use crate::given::times::Quantity;
use crate::real::motion::RealMotion;
use crate::taylor::walk::{Halt, Readings, Stop, Walk};
use std::f64::consts::TAU;

/// Of each force's strength ε, in the order of [`EnvelopeMotion::strengths`]: what wavers, in ε; what grows with time like
/// ε (a/l)⁴; what grows with time like ε².
const BOUNDS: [[f64; 3]; CAUSES] =
    [[1.0, 0.0, 1.0], [1.0, 0.0, 1.0], [2.0, 0.06, 1.0], [2.0, 0.18, 4.0], [1.0, 0.006, 8.0]];

/// Of quadratic drag in air that turns with the ground: what is left out widens the ellipse at a share of ε Ω_z, and the
/// intrinsic precession, which goes like (a/l)², makes an angle of it.
const WIND: f64 = 0.06;

/// Of the horizontal rotation Ω_h/ω0: what wavers, in Ω_h a/l; what grows like Ω_h² with the time, with the time that the
/// plane takes to turn, and with (a/l)⁴(1 + 7(a/l)⁸): in second order it works like an uneven clamp.
const SWAY: [f64; 2] = [2.0, 0.03];

impl AveragedEquations {
    /// Bound of the azimuth's error in rad, within a time in 1/ω0, of a swing of the outer radius a that is not next to
    /// a circle.
    fn azimuth_error(&self, a: f64, time: f64) -> f64 {
        let [linear, quadratic, stiff, lossy, push] = self.strengths(a);
        let linear = linear.sqrt();
        // Without a drive, wide swings do not stay wide.
        let fading = if push > 0.0 { 0.0 } else { 4.0 * (linear - 0.5 * lossy).max(0.0) };
        let wide = if fading > 0.0 { -(-fading * time).exp_m1() / fading } else { time };
        let forces = [linear, quadratic, stiff, lossy, push].into_iter().zip(BOUNDS);
        let forces = forces.map(|(strength, [wavering, offset, second])| {
            strength * (wavering + offset * a.powi(4) * wide + second * strength * time)
        });
        let [sway, turn] = [self.sway.abs(), self.turn.abs()];
        let turning = if turn * time > 1.0 { 1.0 / turn } else { time };
        let size = a.powi(4) * (1.0 + 7.0 * a.powi(8));
        let wind = WIND * turn * a * a * time * (quadratic * time).min(1.0);
        forces.sum::<f64>() + wind + sway * (SWAY[0] * a + SWAY[1] * sway * size * turning * wide)
    }
}

impl EnvelopeMotion {
    /// By which share of itself each force changes a swing of the launch's size while its phase grows by 1: linear drag
    /// (of which the first order is exact: the square), quadratic drag, the suspension's stiffness, its damping, the
    /// drive.
    pub fn strengths(&self) -> [f64; CAUSES] {
        self.equations.strengths(self.outer())
    }

    /// Bound in rad of how far the azimuth is off within a time in s, for swings that are not next to a circle.
    pub fn azimuth_error(&self, within: f64) -> f64 {
        self.equations.azimuth_error(self.outer(), within * self.omega0)
    }

    /// The largest distance from where the full equations have the bob, as a share of the outer radius at that time,
    /// within so many swings of small amplitude or until one of the two motions ends.
    ///
    /// # Errors
    /// Only the wish of `stop`.
    pub fn measured_error(&self, swings: u32, stop: Stop<'_>) -> Result<f64, Halt> {
        const POINTS: u32 = 20;
        let (launch, forces, drive) = self.given;
        let Ok(full) = RealMotion::new(self.pendulum, launch, forces, drive, Thread::Rod, 0.0) else {
            return Ok(f64::NAN);
        };
        let (mut walks, mut walk) = (EnvelopeWalks::default(), Walk::new(2));
        let mut largest = 0.0_f64;
        for k in 0..=POINTS * swings {
            let time = [f64::from(k) / f64::from(POINTS) * TAU / self.omega0];
            let ([mut mean, mut real], mut radii) = ([[0.0; 3]; 2], [0.0; 2]);
            let point = Envelope::Point(Quantity::Position);
            let mut readings = Readings { times: &time, position: &mut real, ..Readings::default() };
            let found = self
                .fill(point, &time, &mut mean, &mut walks, stop)
                .and_then(|()| self.fill(Envelope::SemiAxes, &time, &mut radii, &mut walks, stop))
                .and_then(|()| full.read(&mut readings, &mut walk, stop));
            match found {
                Err(Halt::Interrupted) => return Err(Halt::Interrupted),
                Err(Halt::Ended(..)) => break,
                Ok(()) => {}
            }
            let apart = mean.iter().zip(real).map(|(mean, real)| (mean - real).powi(2)).sum::<f64>().sqrt();
            largest = largest.max(apart / radii[0]);
        }
        Ok(largest)
    }

    /// The outer turning radius over the length at the launch.
    fn outer(&self) -> f64 {
        self.equations.swing(&Circles::of(&self.start.state)).map_or(1.0, |swing| swing.radii()[0])
    }
}
