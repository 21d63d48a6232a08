//! A motion by one of the paper's equations in the plan view, integrated.

use crate::given::pendulum::Pendulum;
use crate::given::times::{Quantity, both_ways};
use crate::numbers::arithmetic::{Arithmetic, dispatch};
use crate::paper::equations::Equation;
use crate::taylor::events::{Guard, first};
use crate::taylor::series::{FINEST, Law, Point, Series};

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
        both_ways(times, |side, order| self.sweep([1.0, -1.0][side], order, quantity, times, out))
    }

    /// The times in s between which the motion holds, given that it meets the support's level within `period`.
    pub fn span(&self, period: f64) -> [f64; 2] {
        [-1.0, 1.0].map(|direction| {
            let mut step = self.start(direction);
            loop {
                if !next(&mut step) {
                    return step.start / self.pendulum.angular_frequency();
                }
                if step.start.abs() > period * self.pendulum.angular_frequency() {
                    return direction * f64::INFINITY;
                }
            }
        })
    }

    /// Before the first step.
    fn start(&self, direction: f64) -> Step {
        let (length, omega0) = (self.pendulum.length, self.pendulum.angular_frequency());
        let [x, y, vx, vy] = self.launch;
        let speed = length * omega0;
        let next = Point { place: [x / length, y / length, 0.0, 0.0], rate: [vx / speed, vy / speed, 0.0, 0.0] };
        Step { equation: self.equation, direction, start: 0.0, size: 0.0, series: Series::ZERO, next, last: false }
    }

    fn sweep(
        &self,
        direction: f64,
        order: &mut dyn Iterator<Item = usize>,
        quantity: Quantity,
        times: &[f64],
        out: &mut [f64],
    ) -> Result<(), f64> {
        let omega0 = self.pendulum.angular_frequency();
        let mut step = self.start(direction);
        if !next(&mut step) {
            return Err(0.0);
        }
        for index in order {
            let time = times[index] * omega0;
            while (time - step.start).abs() > step.size.abs() {
                let end = step.start + step.size;
                // The end itself, after its conversion to seconds and back, still belongs to the last step.
                if step.last && (time - end).abs() <= 1e-15 * end.abs() {
                    break;
                }
                if !next(&mut step) {
                    return Err(step.start / omega0);
                }
            }
            out[3 * index..3 * index + 3].copy_from_slice(&self.point(quantity, at(&step, time)));
        }
        Ok(())
    }

    fn point(&self, quantity: Quantity, Point { place: [x, y, _, _], rate: [vx, vy, _, _] }: Point) -> [f64; 3] {
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

/// A step, and how it goes on.
struct Step {
    equation: Equation,
    direction: f64,
    /// In 1/ω0.
    start: f64,
    size: f64,
    series: Series,
    next: Point,
    /// Ends at the support's level.
    last: bool,
}

dispatch! {
    /// The next step; `false` where there is none.
    fn next(step: &mut Step) -> bool = next_with
}

#[inline(always)]
fn next_with<A: Arithmetic>(_: A, step: &mut Step) -> bool {
    step.start += step.size;
    step.size = 0.0;
    if step.last || !step.equation.holds(&step.next) {
        return false;
    }
    step.series.start(&step.next);
    Law::<A>::continue_series(&step.equation, &mut step.series);
    let Step { series, .. } = &*step;
    let mut size = step.direction * series.reach(FINEST);
    // The motion itself goes on smoothly through the support's level, so a step may reach across it.
    if !series.guard_holds(size) {
        let end = first::<A>(&Guard(series), size, false);
        step.last = end.is_some();
        size = end.unwrap_or(size);
    }
    step.size = size;
    step.next = step.series.at::<A>(size);
    true
}

dispatch! {
    fn at(step: &Step, time: f64) -> Point = at_with
}

#[inline(always)]
fn at_with<A: Arithmetic>(_: A, step: &Step, time: f64) -> Point {
    step.series.at::<A>(time - step.start)
}
