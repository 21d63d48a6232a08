//! What acts on the bob of a real pendulum beside gravity and the thread, as its equations of motion take it.

use crate::given::invalid::{Invalid, finite, positive, require};
use std::f64::consts::PI;

/// Per unit of mass; all zero for the ideal pendulum.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Forces {
    /// γ in −2γv, 1/s: amplitudes fade like e^{−γt}.
    pub damping: f64,
    /// c in −c|v|v, 1/m.
    pub quadratic: f64,
    /// Of the ground: its horizontal part, northwards (along y), and its upward part, rad/s.
    pub rotation: [f64; 2],
    /// δ, rad/s: by how much the frequency along `axis` is higher than across it.
    pub anisotropy: f64,
    /// Azimuth of the stiff axis, rad.
    pub axis: f64,
    /// Δγ, 1/s: by how much amplitudes fade faster along `damping_axis` than across it.
    pub damping_anisotropy: f64,
    /// rad.
    pub damping_axis: f64,
}

impl Forces {
    /// # Errors
    /// What is not finite.
    pub fn check(&self) -> Result<(), Invalid> {
        let [horizontal, vertical] = self.rotation;
        finite(&[
            ("drag.linear", self.damping, "1/s"),
            ("drag.quadratic", self.quadratic, "1/m"),
            ("site.horizontal_rotation", horizontal, "rad/s"),
            ("site.vertical_rotation", vertical, "rad/s"),
            ("suspension.anisotropy", self.anisotropy, "rad/s"),
            ("suspension.axis", self.axis, "rad"),
            ("suspension.damping_anisotropy", self.damping_anisotropy, "1/s"),
            ("suspension.damping_axis", self.damping_axis, "rad"),
        ])
    }
}

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

/// What a thread does when its tension is used up.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Thread {
    /// The motion ends there.
    #[default]
    Ends,
    /// The bob flies until the thread is taut again, which takes away the speed along it.
    Flies,
    /// It is a rod, and can push.
    Rod,
}
