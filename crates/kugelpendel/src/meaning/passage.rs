//! When the bob passes a distance from the axis: the closed form, solved for the time.

use crate::exact::motion::ExactMotion;

impl ExactMotion {
    /// The time in s from a lowest point to the next passage of a distance from the vertical axis, m, below the support.
    /// None for a distance that the bob does not come to on the way, or which it keeps.
    pub fn passage_time(&self, radius: f64) -> Option<f64> {
        let turning = &self.invariants.turning;
        let share = radius / self.pendulum.length;
        let height = share * share / (1.0 + ((1.0 - share) * (1.0 + share)).sqrt());
        if !(turning.low..=turning.high).contains(&height) || turning.half_range == 0.0 {
            return None;
        }
        // The height's circle: s = mean + cos, and it rises where sin > 0.
        let cos = 0.5 * ((height - turning.low) - (turning.high - height));
        let sin = ((height - turning.low) * (turning.high - height)).sqrt();
        let fraction = self.invariants.fraction([cos, sin]);
        Some((fraction.hi + fraction.lo) * self.radial_period())
    }
}

#[cfg(test)]
mod tests {
    use crate::{ExactMotion, Launch, Pendulum, Quantity, Times};

    #[test]
    fn the_bob_is_there_at_that_time() {
        let pendulum = Pendulum { length: 2.0, gravity: 9.8, mass: 1.0 };
        for (a, b) in [(1.0, 0.3), (1.9, 0.0), (1e-3, 1e-4), (0.5, -0.49)] {
            let motion = ExactMotion::new(pendulum, Launch::Apsides { a, b, azimuth: 0.4 }).unwrap();
            for share in [0.01, 0.3, 0.9, 0.999] {
                let radius = b.abs() + share * (a - b.abs());
                let time = motion.passage_time(radius).unwrap();
                assert!(time > 0.0 && time < 0.5 * motion.radial_period());
                let mut place = [0.0; 3];
                // The launch is at an outer turning point.
                motion.fill(Quantity::Position, Times::Scattered(&[0.5 * motion.radial_period() + time]), &mut place);
                assert!((place[0].hypot(place[1]) - radius).abs() < 1e-14 * a, "{radius} of {a}, {b}");
            }
            assert_eq!(motion.passage_time(1.01 * a), None);
            assert!(b == 0.0 || motion.passage_time(0.99 * b.abs()).is_none());
        }
    }
}
