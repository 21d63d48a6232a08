//! Everything about a request that is the same for every time.

use crate::exact::chart::Chart;
use crate::exact::motion::ExactMotion;
use crate::exact::phase::Clock;
use crate::given::times::Times;
use crate::sampling::rotations::{Rotations, rotations};

/// The chart, the clock and what a grid adds.
pub(crate) struct Plan {
    pub(crate) chart: Chart,
    pub(crate) clock: Clock,
    pub(crate) length: f64,
    /// Turns of the frame at t = 0.
    pub(crate) turn: f64,
    pub(crate) rotations: Option<Box<Rotations>>,
}

impl Plan {
    pub(crate) fn new(motion: &ExactMotion, times: &Times<'_>) -> Self {
        let clock = motion.clock();
        let (chart, turn) = motion.chart(&clock);
        let rotations = match (times, clock, &chart) {
            (Times::Grid { step, .. }, Clock::Periodic { swings, frame, .. }, Chart::Trigonometric(_)) => {
                Some(rotations(*step, swings, frame))
            }
            _ => None,
        };
        Self { chart, clock, length: motion.pendulum.length, turn, rotations }
    }
}
