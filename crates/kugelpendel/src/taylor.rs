//! Integration by Taylor series of the orders up to [`ORDER`], with a step chosen from their decay.
//!
//! Source: Jorba & Zou, Experimental Mathematics 14, 99 (2005): for errors at the last bit, the order −½ ln ε and a step
//! of 1/e² of the radius of convergence, estimated from the last two coefficients.

use crate::equations::Equation;

/// Of the last term; e^(−2·ORDER) is far below the rounding of the first.
pub(crate) const ORDER: usize = 24;

/// Coefficients of one function of the time over a step.
pub(crate) type Coefficients = [f64; ORDER + 1];

/// One step: x, y and their rates as polynomials in the time since `start`.
pub(crate) struct Step {
    pub(crate) start: f64,
    pub(crate) size: f64,
    series: [Coefficients; 4],
}

impl Step {
    /// x, y, vx, vy at a time within the step.
    pub(crate) fn at(&self, time: f64) -> [f64; 4] {
        let since = time - self.start;
        self.series.map(|c| c.iter().rev().fold(0.0, |sum, c| sum * since + c))
    }
}

/// Step after step from t = 0, forwards or backwards.
pub(crate) struct Steps {
    equation: Equation,
    time: f64,
    direction: f64,
    state: [f64; 4],
    /// What rounding has taken from the state, given back with the next step.
    lost: [f64; 4],
}

impl Steps {
    pub(crate) fn new(equation: Equation, state: [f64; 4], direction: f64) -> Self {
        Self { equation, time: 0.0, direction, state, lost: [0.0; 4] }
    }

    /// The next step, or the time at which the equation ends.
    pub(crate) fn next(&mut self) -> Result<Step, f64> {
        let Some(series) = self.equation.series(self.state) else {
            return Err(self.time);
        };
        let size = self.direction * radius(&series) / std::f64::consts::E.powi(2);
        let step = Step { start: self.time, size, series };
        for ((state, lost), series) in self.state.iter_mut().zip(&mut self.lost).zip(&step.series) {
            let rise = series.iter().skip(1).rev().fold(0.0, |sum, c| sum * size + c) * size + *lost;
            let sum = *state + rise;
            *lost = rise - (sum - *state);
            *state = sum;
        }
        self.time += size;
        Ok(step)
    }
}

/// Of convergence, by the last two coefficients of all four functions against the size of the first ones.
fn radius(series: &[Coefficients; 4]) -> f64 {
    let largest = |order: usize| series.iter().fold(0.0_f64, |size, c| size.max(c[order].abs()));
    let size = largest(0);
    let estimate = |order: usize| (size / largest(order)).powf(1.0 / order as f64);
    let radius = estimate(ORDER).min(estimate(ORDER - 1));
    // At rest nothing limits the step.
    if radius.is_finite() { radius } else { 1.0 }
}
