//! What is settled once for all the times of a request.

use crate::exact::chart::Chart;
use crate::exact::motion::ExactMotion;
use crate::exact::phase::Phase;
use crate::given::times::Times;
use crate::sampling::blocks::{Rotations, rotations};

/// Everything about a request that is the same for every time.
pub(crate) struct Plan {
    pub(crate) chart: Chart,
    pub(crate) phase: Phase,
    pub(crate) length: f64,
    /// Turns of the frame at t = 0.
    pub(crate) turn: f64,
    pub(crate) rotations: Option<Box<Rotations>>,
}

impl Plan {
    pub(crate) fn new(motion: &ExactMotion, times: &Times<'_>) -> Self {
        let phase = motion.phase();
        let (chart, turn) = motion.chart(&phase);
        let rotations = match (times, phase, &chart) {
            (Times::Grid { step, .. }, Phase::Periodic { swings, frame, .. }, Chart::Trigonometric(_)) => {
                Some(rotations(*step, swings, frame))
            }
            _ => None,
        };
        Self { chart, phase, length: motion.pendulum.length, turn, rotations }
    }
}
