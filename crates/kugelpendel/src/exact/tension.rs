//! The pull of the thread, Olsson's (5a): m(g cos θ + v²/l), and where a thread would go slack.

use crate::exact::motion::ExactMotion;
use crate::exact::phase::Phase;
use crate::given::times::{Quantity, Times};

/// Times taken together.
const TENSIONS_PER_BLOCK: usize = 256;

impl ExactMotion {
    /// Pull of the thread at a height s (in lengths), N; negative where a thread would go slack.
    pub(crate) fn tension_at(&self, height: f64) -> f64 {
        self.pendulum.mass * self.pendulum.gravity * (2.0 * (self.invariants.energy - height) + (1.0 - height))
    }

    /// Smallest and largest pull of the thread, N: at the highest and at the lowest point.
    pub fn tension_range(&self) -> [f64; 2] {
        let t = &self.invariants.turning;
        [self.tension_at(t.high), self.tension_at(t.low)]
    }

    /// Whether the constraint has to push somewhere on the path, which a thread cannot.
    pub fn goes_slack(&self) -> bool {
        self.tension_range()[0] < 0.0
    }

    /// First time ≥ 0 after the launch at which a thread goes slack, s; infinite if it never does.
    pub fn slack_time(&self) -> f64 {
        if !self.goes_slack() {
            return f64::INFINITY;
        }
        let slack_height = (2.0 * self.invariants.energy + 1.0) / 3.0;
        if self.launch.height > slack_height {
            return 0.0;
        }
        let t = &self.invariants.turning;
        let cos = slack_height - 0.5 * (t.high + t.low);
        let sin = ((t.half_range - cos) * (t.half_range + cos)).max(0.0).sqrt();
        match self.phase() {
            Phase::Still => f64::INFINITY,
            Phase::Once { rate, start } => {
                let crossing = (slack_height.sqrt() / (2.0 - slack_height).sqrt()).asinh();
                if start <= crossing { (crossing - start) / rate } else { f64::INFINITY }
            }
            Phase::Periodic { start, .. } => {
                let crossing = self.invariants.fraction([cos, sin]);
                // Launched at or below that height, so before the crossing; less is rounding.
                ((crossing.hi - start.hi) + (crossing.lo - start.lo)).max(0.0) * self.radial_period()
            }
        }
    }

    /// Pull of the thread in N at each time; negative where a thread would be slack and the motion needs a rod.
    pub fn fill_tension(&self, times: &[f64], out: &mut [f64]) {
        let mut positions = [0.0; 3 * TENSIONS_PER_BLOCK];
        for (times, out) in times.chunks(TENSIONS_PER_BLOCK).zip(out.chunks_mut(TENSIONS_PER_BLOCK)) {
            let positions = &mut positions[..3 * times.len()];
            self.fill(Quantity::Position, Times::Scattered(times), positions);
            for (tension, position) in out.iter_mut().zip(positions.chunks_exact(3)) {
                *tension = self.tension_at(1.0 - position[2] / self.pendulum.length);
            }
        }
    }
}
