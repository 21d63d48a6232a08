//! The form of one swing in its own frame, and how that frame stands at the launch.

use crate::exact::motion::{ExactMotion, Start};
use crate::exact::phase::Phase;
use crate::exact::theta::hyperbolic::Hyperbolic;
use crate::exact::theta::shape::Shape;
use crate::exact::theta::trigonometric::Trigonometric;
use std::f64::consts::{PI, TAU};

/// Below this 1 − m the series in q give way to those in q' (q = 0.19, q' = 0.0025 there).
const HYPERBOLIC_BELOW: f64 = 0.02;

/// One swing's form, made when positions are asked for.
#[derive(Clone, Debug)]
// One at a time is made, on the stack of whoever asks.
#[expect(clippy::large_enum_variant)]
pub(crate) enum Chart {
    Trigonometric(Trigonometric),
    Hyperbolic(Hyperbolic),
    /// x, y and the height, m.
    Still([f64; 3]),
}

impl ExactMotion {
    pub(crate) fn near_separatrix(&self) -> bool {
        let t = &self.invariants.turning;
        t.excess + t.high_depth <= HYPERBOLIC_BELOW * (t.excess + t.low_depth)
    }

    /// The chart, and by how many turns its frame is turned at the launch.
    pub(crate) fn chart(&self, phase: &Phase) -> (Chart, f64) {
        match *phase {
            Phase::Still => {
                let [x, y] = self.launch.plan;
                (Chart::Still([x, y, self.launch.height].map(|v| v * self.pendulum.length)), 0.0)
            }
            Phase::Periodic { start, .. } if !self.near_separatrix() => {
                let chart = Trigonometric::new(self.pendulum.length, &self.invariants, &self.invariants.ladder());
                let (sin, cos) = (PI * start.hi).sin_cos();
                let shape = chart.at_any::<true>(cos, sin);
                let frame = self.invariants.sense * self.invariants.frame.hi;
                let turn = self.launch_turn(&shape, self.invariants.frequency.hi, frame);
                (Chart::Trigonometric(chart), turn)
            }
            Phase::Periodic { start, .. } => {
                let chart = Hyperbolic::new(self.pendulum.length, &self.invariants);
                let shape = chart.at(chart.span * start.hi);
                let twist = chart.twist();
                let frequency = self.invariants.frequency.hi;
                let frame = self.invariants.sense * self.invariants.precession.hi + 2.0 * twist * frequency;
                let turn = self.launch_turn(&shape, chart.span * frequency / PI, frame);
                (Chart::Hyperbolic(chart), turn - twist * start.hi)
            }
            Phase::Once { rate, start } => {
                let chart = Hyperbolic::new(self.pendulum.length, &self.invariants);
                let turn = self.launch_turn(&chart.at(start), rate / self.omega0.hi, 0.0);
                (Chart::Hyperbolic(chart), turn)
            }
        }
    }

    /// The angle between launch and shape, in turns, from position and velocity together: either may vanish.
    fn launch_turn(&self, shape: &Shape, swing: f64, frame: f64) -> f64 {
        let Start { plan, plan_velocity, .. } = self.launch;
        let velocity = [swing * shape.x_rate - frame * shape.y, swing * shape.y_rate + frame * shape.x];
        let cos =
            plan[0] * shape.x + plan[1] * shape.y + plan_velocity[0] * velocity[0] + plan_velocity[1] * velocity[1];
        let sin =
            plan[1] * shape.x - plan[0] * shape.y + plan_velocity[1] * velocity[0] - plan_velocity[0] * velocity[1];
        sin.atan2(cos) / TAU
    }
}
