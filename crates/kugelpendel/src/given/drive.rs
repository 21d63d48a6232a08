//! A push away from the axis, once every half swing.

use crate::given::invalid::{Invalid, finite, positive, require};
use std::f64::consts::PI;

/// A push away from the axis, once every half swing.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum Drive {
    /// None.
    #[default]
    Absent,
    /// At a phase after the closest approach.
    Phase {
        /// Change of the horizontal velocity, m/s; negative pulls inwards.
        push: f64,
        /// rad, at least 0: the time since the closest approach times ω0.
        phase: f64,
    },
    /// On the way out.
    Radius {
        /// m/s.
        push: f64,
        /// Distance from the axis, m.
        radius: f64,
    },
}

impl Drive {
    /// # Errors
    /// A push that is not finite, a phase outside of 0 to π, and a radius that is not positive.
    pub fn check(&self) -> Result<(), Invalid> {
        finite(&[("drive.push", self.push(), "m/s")])?;
        match *self {
            Self::Absent => Ok(()),
            Self::Phase { phase, .. } => require((0.0..PI).contains(&phase), || Invalid::DrivePhase { phase }),
            Self::Radius { radius, .. } => positive(&[("drive.radius", radius, "m")]),
        }
    }

    /// Change of the horizontal velocity, m/s; 0 where there is no drive.
    pub fn push(&self) -> f64 {
        match *self {
            Self::Absent => 0.0,
            Self::Phase { push, .. } | Self::Radius { push, .. } => push,
        }
    }
}
