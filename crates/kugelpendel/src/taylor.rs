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
        self.series.map(|coefficients| sum(&coefficients, since))
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
    ended: bool,
}

impl Steps {
    pub(crate) fn new(equation: Equation, state: [f64; 4], direction: f64) -> Self {
        Self { equation, time: 0.0, direction, state, lost: [0.0; 4], ended: false }
    }

    /// The next step, or the time at which the equation ends.
    pub(crate) fn next(&mut self) -> Result<Step, f64> {
        let expansion = if self.ended { None } else { self.equation.series(self.state) };
        let Some((series, depth)) = expansion else {
            return Err(self.time);
        };
        let mut size = self.direction * radius(&series) / std::f64::consts::E.powi(2);
        // The motion itself goes on smoothly through the support's level, so a step may reach across it.
        if sum(&depth, size) <= 0.0 {
            size = bisected(&depth, size);
            self.ended = true;
        }
        let step = Step { start: self.time, size, series };
        for ((state, lost), series) in self.state.iter_mut().zip(&mut self.lost).zip(&step.series) {
            let rise = sum(&series[1..], size) * size + *lost;
            let next = *state + rise;
            *lost = rise - (next - *state);
            *state = next;
        }
        self.time += size;
        Ok(step)
    }
}

/// The value of a series.
fn sum(coefficients: &[f64], since: f64) -> f64 {
    coefficients.iter().rev().fold(0.0, |sum, c| sum * since + c)
}

/// Where a series that starts above zero and ends at or below it first reaches it, to the last bit.
fn bisected(coefficients: &Coefficients, end: f64) -> f64 {
    let (mut above, mut below) = (0.0, end);
    loop {
        let middle = 0.5 * (above + below);
        if middle == above || middle == below {
            return above;
        }
        if sum(coefficients, middle) > 0.0 { above = middle } else { below = middle }
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
