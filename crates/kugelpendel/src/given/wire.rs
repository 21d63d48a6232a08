//! The wire that a pendulum hangs on; it takes no part in any motion, whose thread keeps its length.

use crate::given::invalid::{Invalid, finite, positive};
use std::f64::consts::FRAC_PI_4;

/// A round wire.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Wire {
    /// The diameter, m.
    pub diameter: f64,
    /// Young's modulus, Pa.
    pub young: f64,
    /// Relative change of the length per kelvin, 1/K.
    pub expansion: f64,
}

impl Wire {
    /// # Errors
    /// A diameter or modulus that is not positive, and an expansion that is not finite.
    pub fn check(&self) -> Result<(), Invalid> {
        positive(&[("wire.diameter", self.diameter, "m"), ("wire.young", self.young, "Pa")])?;
        finite(&[("wire.expansion", self.expansion, "1/K")])
    }

    /// πd²/4, m².
    pub fn cross_section(&self) -> f64 {
        FRAC_PI_4 * (self.diameter * self.diameter)
    }
}
