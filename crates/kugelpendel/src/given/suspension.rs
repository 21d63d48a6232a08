//! How the thread is held: not quite alike in all directions.

use crate::given::invalid::{Invalid, finite, positive};
use std::f64::consts::PI;

/// Stiffness and friction that depend on the direction.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Suspension {
    /// δ, rad/s: the frequency of small swings along the axis less that across it. The force is −2ω0δ(r·χ̂)χ̂.
    pub anisotropy: f64,
    /// χ, rad: azimuth of that axis.
    pub axis: f64,
    /// Δγ, 1/s: decay rate along its axis less that across it. The force is −Δγ(2(v·χ̂)χ̂ − v).
    pub damping_anisotropy: f64,
    /// Azimuth of the axis along which more is lost, rad.
    pub damping_axis: f64,
}

impl Suspension {
    /// # Errors
    /// What is not finite.
    pub fn check(&self) -> Result<(), Invalid> {
        finite(&[
            ("suspension.anisotropy", self.anisotropy, "rad/s"),
            ("suspension.axis", self.axis, "rad"),
            ("suspension.damping_anisotropy", self.damping_anisotropy, "1/s"),
            ("suspension.damping_axis", self.damping_axis, "rad"),
        ])
    }

    /// δ in rad/s from the periods of small swings along the axis and across it, s: 2π/T_along − 2π/T_across, as a product
    /// so that nearly equal periods lose no digits.
    ///
    /// # Errors
    /// Periods that are not positive and finite.
    pub fn anisotropy_from_periods(along: f64, across: f64) -> Result<f64, Invalid> {
        positive(&[("suspension.period_along", along, "s"), ("suspension.period_across", across, "s")])?;
        Ok(2.0 * PI * (across - along) / (along * across))
    }
}
