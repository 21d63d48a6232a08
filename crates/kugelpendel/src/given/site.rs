//! A place on the Earth: how fast its ground turns, and the gravity to expect there.

use crate::given::invalid::{Invalid, finite, positive, require};
use crate::given::pendulum::Pendulum;
use std::f64::consts::FRAC_PI_2;

/// Ω_E, rad/s: of the Earth against the stars, one turn in 86164 s (WGS84, NIMA TR8350.2 §3.2.4).
pub const ROTATION: f64 = 7.292115e-5;

// WGS84, NIMA TR8350.2 (2000), tables 3.1, 3.3 and 3.4.
const SEMI_MAJOR_AXIS: f64 = 6378137.0; // m
const FLATTENING: f64 = 1.0 / 298.257223563;
const ECCENTRICITY_SQUARED: f64 = 6.69437999014e-3;
const EQUATORIAL_GRAVITY: f64 = 9.7803253359; // m/s²
const SOMIGLIANA: f64 = 0.00193185265241;
const CENTRIFUGAL: f64 = 0.00344978650684; // ω²a²b/GM

/// To which TR8350.2 gives the expansion in the height, m.
const HIGHEST: f64 = 20e3;

/// The place on the Earth where a pendulum stands.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Site {
    /// Geodetic, rad, positive in the north.
    pub latitude: f64,
    /// As measured, m/s²; without it normal gravity is meant.
    pub gravity: Option<f64>,
    /// Above the ellipsoid, m.
    pub height: f64,
    /// Of the ground against the stars, rad/s: [`ROTATION`] on the Earth.
    pub rotation: f64,
}

impl Site {
    /// # Errors
    /// A latitude beyond a pole, a height beyond ±20 km, or a gravity that is not positive.
    pub fn check(&self) -> Result<(), Invalid> {
        let Self { latitude, gravity, height, rotation } = *self;
        finite(&[("site.latitude", latitude, "rad"), ("site.rotation", rotation, "rad/s")])?;
        require(latitude.abs() <= 90.0, || Invalid::BeyondPole { latitude })?;
        require(latitude.abs() <= FRAC_PI_2, || Invalid::Latitude { latitude })?;
        require(height.abs() <= HIGHEST, || Invalid::Height { height })?;
        gravity.map_or(Ok(()), |gravity| positive(&[("site.gravity", gravity, "m/s²")]))
    }

    /// # Errors
    /// A gravity given for the site that is not the pendulum's.
    pub(crate) fn agrees(&self, pendulum: &Pendulum) -> Result<(), Invalid> {
        let pendulum = pendulum.gravity;
        let site = self.gravity.unwrap_or(pendulum);
        require(site == pendulum, || Invalid::TwoGravities { site, pendulum })
    }

    /// Ω_h and Ω_z, rad/s: the ground's rotation towards the north and upwards.
    pub fn ground_rotation(&self) -> [f64; 2] {
        [self.rotation * self.latitude.cos(), self.rotation * self.latitude.sin()]
    }

    /// WGS84 normal gravity, m/s²: TR8350.2 (2000), eq. (4-1) and (4-3).
    pub fn normal_gravity(&self) -> f64 {
        let north = self.latitude.sin().powi(2);
        let ground = EQUATORIAL_GRAVITY * (1.0 + SOMIGLIANA * north) / (1.0 - ECCENTRICITY_SQUARED * north).sqrt();
        let up = self.height / SEMI_MAJOR_AXIS;
        let slope = 1.0 + FLATTENING + CENTRIFUGAL - 2.0 * FLATTENING * north;
        ground * (1.0 - 2.0 * slope * up + 3.0 * up * up)
    }
}
