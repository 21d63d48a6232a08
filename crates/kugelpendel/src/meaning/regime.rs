//! What kind of motion it is.

use crate::exact::motion::ExactMotion;

/// From turning heights closer than this, relative to the higher one, one sees a cone.
const CONE: f64 = 1e-3;

/// The kinds of motion that an eye tells apart.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Regime {
    /// The bob hangs at rest.
    Rest,
    /// The bob stands at rest on top.
    Balance,
    /// The bob creeps up to the top and never comes back.
    Separatrix,
    /// The bob swings to and fro in a vertical plane.
    Plane,
    /// The bob turns over the top in a vertical plane.
    Rotation,
    /// The bob circles below the support and all but keeps its height.
    Cone,
    /// The bob runs through a turning ellipse below the support.
    Ellipse,
    /// The path rises above the support.
    Above,
}

impl Regime {
    /// All of them, in the order in which they are told apart.
    pub const ALL: [Self; 8] = [
        Self::Rest,
        Self::Balance,
        Self::Separatrix,
        Self::Plane,
        Self::Rotation,
        Self::Cone,
        Self::Ellipse,
        Self::Above,
    ];

    /// A name that does not change: "rest", "balance", "separatrix", "plane", "rotation", "cone", "ellipse" or "above".
    pub fn name(self) -> &'static str {
        match self {
            Self::Rest => "rest",
            Self::Balance => "balance",
            Self::Separatrix => "separatrix",
            Self::Plane => "plane",
            Self::Rotation => "rotation",
            Self::Cone => "cone",
            Self::Ellipse => "ellipse",
            Self::Above => "above",
        }
    }

    /// Whether the paper's formula (25) for the precession has a meaning here.
    pub fn has_ellipse(self) -> bool {
        matches!(self, Self::Cone | Self::Ellipse)
    }
}

impl ExactMotion {
    /// What kind of motion it is.
    pub fn regime(&self) -> Regime {
        let [high, low] = self.turning_heights();
        if high <= 0.0 {
            Regime::Rest
        } else if self.frequency() <= 0.0 {
            if self.launch.still { Regime::Balance } else { Regime::Separatrix }
        } else if self.invariants.revolves() {
            Regime::Rotation
        } else if self.angular_momentum() == 0.0 {
            Regime::Plane
        } else if high > self.pendulum.length {
            Regime::Above
        } else if high - low <= CONE * high {
            Regime::Cone
        } else {
            Regime::Ellipse
        }
    }

    /// Whether the path rises above the level of the support.
    pub fn rises_above(&self) -> bool {
        self.turning_heights()[0] > self.pendulum.length
    }
}
