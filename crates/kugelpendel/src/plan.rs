//! Everything about a request that is the same for every time.

use crate::chart::Chart;
use crate::clock::Clock;
use crate::exact::ExactMotion;
use crate::rotations::{Rotations, rotations};
use crate::times::Times;

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
