//! A bob that is a ball and not a point, in air, on a thread that has a mass.

use crate::given::invalid::{Invalid, not_negative, positive, require};
use std::f64::consts::PI;

/// Of air at 20 °C, kg/m³, where nothing is said of it.
pub const AIR_DENSITY: f64 = 1.204;

/// A homogeneous ball.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bob {
    /// The radius, m.
    pub radius: f64,
    /// The density, kg/m³.
    pub density: f64,
    /// Of a thread that is the same all along its length, kg.
    pub thread_mass: f64,
    /// The air density, kg/m³.
    pub air_density: f64,
}

impl Bob {
    /// # Errors
    /// A radius or density that is not positive, masses or densities that are negative, and a bob lighter than air.
    pub fn check(&self) -> Result<(), Invalid> {
        let Self { radius, density, thread_mass, air_density } = *self;
        positive(&[("bob.radius", radius, "m"), ("bob.density", density, "kg/m³")])?;
        not_negative(&[("bob.thread_mass", thread_mass, "kg"), ("bob.air_density", air_density, "kg/m³")])?;
        require(density > air_density, || Invalid::LighterThanAir { density, air_density })
    }

    /// # Errors
    /// A length that is not positive, or not larger than the radius.
    pub(crate) fn fits(&self, length: f64) -> Result<(), Invalid> {
        positive(&[("pendulum.length", length, "m")])?;
        require(self.radius / length < 1.0, || Invalid::BobTooLarge { radius: self.radius, length })
    }

    /// 4/3 π r³ times the density, kg.
    pub fn mass(&self) -> f64 {
        4.0 / 3.0 * PI * self.radius.powi(3) * self.density
    }

    /// κ: small swings on a thread of this length, m, are those of a point mass under the gravity κg.
    ///
    /// κ = (1 − β + μ/2)/(1 + β/2 + (2/5)(r/l)² + μ/3), with β the density of the air over that of the bob (buoyancy above,
    /// half of the displaced air moved along below) and μ the thread's mass over the bob's. R. A. Nelson and M. G. Olsson,
    /// Am. J. Phys. 54, 112 (1986).
    ///
    /// # Errors
    /// As [`Bob::check`], and a length that is not larger than the radius.
    pub fn gravity_factor(&self, length: f64) -> Result<f64, Invalid> {
        self.check()?;
        self.fits(length)?;
        let ratio = self.radius / length;
        let (beta, mu) = (self.air_density / self.density, self.thread_mass / self.mass());
        Ok((1.0 - beta + mu / 2.0) / (1.0 + beta / 2.0 + 0.4 * (ratio * ratio) + mu / 3.0))
    }
}
