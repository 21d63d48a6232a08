//! The numbers that a report of an ideal motion gives.

use crate::exact::motion::ExactMotion;
use crate::meaning::olsson;
use crate::meaning::regime::Regime;
use std::f64::consts::TAU;

/// What an ideal motion is, in SI; angles in rad, azimuths and rates positive counter-clockwise seen from above.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct IdealSummary {
    /// What kind of motion it is.
    pub regime: Regime,
    /// 1 for counter-clockwise seen from above, −1 for clockwise, 0 for neither.
    pub sense: f64,
    /// The time there and back, or once round a vertical circle, 2π/ω in s; infinite on the separatrix.
    pub swing_period: f64,
    /// The rate of the outer turning points on the branch that turns least, in rad/s.
    pub turning: f64,
    /// Whether whole turns were taken off for that, in place of half turns.
    pub whole_turns: bool,
    /// The time for one turn of the ellipse, or of the highest point, in s; infinite where nothing turns.
    pub full_turn: f64,
    /// The time for one turn of the bob about the vertical on a cone, in s; infinite elsewhere.
    pub once_round: f64,
    /// The largest angle from the downward vertical, in rad.
    pub largest_angle: f64,
    /// The precession by (25), in rad/s; not a number where it does not apply.
    pub formula_25: f64,
    /// The frequency by (26), in rad/s; not a number where it does not apply.
    pub frequency_26: f64,
}

impl IdealSummary {
    /// Reads all of it off one motion.
    pub fn of(motion: &ExactMotion) -> Self {
        let regime = motion.regime();
        let (turning, whole_turns) = motion.turning_rate();
        let momentum = motion.angular_momentum();
        let sense = if momentum == 0.0 { 0.0 } else { momentum.signum() };
        let [outer, inner] = motion.turning_radii();
        let (a, b) = (outer, sense * inner);
        let turns = matches!(regime, Regime::Ellipse | Regime::Above) && turning != 0.0;
        let below_in_plane = regime == Regime::Plane && !motion.rises_above();
        Self {
            regime,
            sense,
            swing_period: motion.swing_period(),
            turning,
            whole_turns,
            full_turn: if turns { TAU / turning.abs() } else { f64::INFINITY },
            once_round: if regime == Regime::Cone {
                TAU / (motion.precession().abs() + motion.frequency())
            } else {
                f64::INFINITY
            },
            largest_angle: motion.largest_angle(),
            formula_25: if regime.has_ellipse() { olsson::precession(a, b, &motion.pendulum) } else { f64::NAN },
            frequency_26: if regime.has_ellipse() || below_in_plane {
                olsson::frequency(a, b, &motion.pendulum)
            } else {
                f64::NAN
            },
        }
    }
}

impl ExactMotion {
    /// The time there and back, or once round a vertical circle, 2π/ω in s; infinite on the separatrix.
    pub fn swing_period(&self) -> f64 {
        TAU / self.frequency()
    }

    /// The largest angle from the downward vertical, in rad.
    pub fn largest_angle(&self) -> f64 {
        let turning = &self.invariants.turning;
        2.0 * turning.high.sqrt().atan2(turning.high_depth.max(0.0).sqrt())
    }
}
