//! A motion by one of the paper's equations in the plan view, integrated.

use crate::equations::Equation;
use crate::pendulum::Pendulum;
use crate::taylor::{Step, Steps};
use crate::times::Quantity;

/// From where, and by which law; every request is integrated afresh from t = 0, so nothing is kept.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct IntegratedMotion {
    /// What swings.
    pub pendulum: Pendulum,
    /// By which law.
    pub equation: Equation,
    /// x, y in m and vx, vy in m/s, on the lower half.
    pub launch: [f64; 4],
}

impl IntegratedMotion {
    /// Fills `out`, three numbers to a time; beyond an end it is left as it was.
    ///
    /// # Errors
    /// The time in s at which the bob reaches the support's level, where both laws end.
    ///
    /// # Panics
    /// If times and `out` do not have the same count.
    pub fn fill(&self, quantity: Quantity, times: &[f64], out: &mut [f64]) -> Result<(), f64> {
        assert_eq!(3 * times.len(), out.len(), "three numbers to a time");
        let mut order: Vec<usize> = (0..times.len()).collect();
        order.sort_by(|a, b| times[*a].total_cmp(&times[*b]));
        let first_ahead = order.partition_point(|index| times[*index] < 0.0);
        let (behind, ahead) = order.split_at(first_ahead);
        let ahead = self.sweep(1.0, ahead.iter(), quantity, times, out);
        ahead.and(self.sweep(-1.0, behind.iter().rev(), quantity, times, out))
    }

    /// The times in s between which the motion holds, given that it meets the support's level within `period`.
    pub fn span(&self, period: f64) -> [f64; 2] {
        [-1.0, 1.0].map(|direction| {
            let mut steps = self.steps(direction);
            loop {
                match steps.next() {
                    Err(end) => return end / self.pendulum.angular_frequency(),
                    Ok(step) if step.start.abs() > period * self.pendulum.angular_frequency() => {
                        return direction * f64::INFINITY;
                    }
                    Ok(_) => {}
                }
            }
        })
    }

    fn steps(&self, direction: f64) -> Steps {
        let (length, omega0) = (self.pendulum.length, self.pendulum.angular_frequency());
        let [x, y, vx, vy] = self.launch;
        let speed = length * omega0;
        Steps::new(self.equation, [x / length, y / length, vx / speed, vy / speed], direction)
    }

    fn sweep<'a>(
        &self,
        direction: f64,
        order: impl Iterator<Item = &'a usize>,
        quantity: Quantity,
        times: &[f64],
        out: &mut [f64],
    ) -> Result<(), f64> {
        let omega0 = self.pendulum.angular_frequency();
        let mut steps = self.steps(direction);
        let mut step: Option<Step> = None;
        for &index in order {
            let time = times[index] * omega0;
            while step.as_ref().is_none_or(|step| (time - step.start).abs() > step.size.abs()) {
                match steps.next() {
                    Ok(next) => step = Some(next),
                    // The end itself, after its conversion to seconds and back, still belongs to the last step.
                    Err(end) if (time - end).abs() <= 1e-15 * end.abs() => break,
                    Err(end) => return Err(end / omega0),
                }
            }
            let Some(current) = &step else { return Err(0.0) };
            out[3 * index..3 * index + 3].copy_from_slice(&self.point(quantity, current.at(time)));
        }
        Ok(())
    }

    fn point(&self, quantity: Quantity, [x, y, vx, vy]: [f64; 4]) -> [f64; 3] {
        let length = self.pendulum.length;
        let depth = (1.0 - x * x - y * y).sqrt();
        match quantity {
            Quantity::Position => [x, y, depth].map(|v| v * length),
            Quantity::Velocity => {
                let speed = length * self.pendulum.angular_frequency();
                [vx, vy, -(x * vx + y * vy) / depth].map(|v| v * speed)
            }
        }
    }
}
