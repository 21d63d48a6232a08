//! A motion by one of the paper's equations in the plan view, integrated.

use crate::given::invalid::{Invalid, require};
use crate::given::launch::Launch;
use crate::given::pendulum::Pendulum;
use crate::numbers::arithmetic::{Arithmetic, dispatch};
use crate::numbers::double_double::Pair;
use crate::paper::equations::{Equation, PlanTerms};
use crate::real::motion::launch_point;
use crate::taylor::events::{Guard, first};
use crate::taylor::layout::Alone;
use crate::taylor::reach::reach;
use crate::taylor::series::{FINEST, Point, VectorField};
use crate::taylor::step::{Checkpoint, Ending, Step, point_at};
use crate::taylor::sweep::read;
use crate::taylor::walk::{Halt, Readings, StateVector, Stepper, Stop, Walk, find_end};

/// A pendulum that moves by an equation in the plan view, from its launch.
#[derive(Clone, Copy, Debug)]
pub struct IntegratedMotion {
    pendulum: Pendulum,
    equation: Equation,
    omega0: Pair,
    launch: Point,
}

impl IntegratedMotion {
    /// # Errors
    /// A pendulum or launch that makes no sense, and a launch on the upper half of the sphere.
    pub fn new(pendulum: Pendulum, equation: Equation, launch: Launch) -> Result<Self, Invalid> {
        let (mut launch, omega0) = launch_point(pendulum, launch)?;
        let z = launch.position[2];
        let above = -z * pendulum.length;
        require(z > 0.0, || Invalid::StartsAbove { above })?;
        (launch.position[2], launch.velocity[2]) = (0.0, 0.0);
        Ok(Self { pendulum, equation, omega0, launch })
    }

    /// Reads what is asked, in one pass over the steps of the integration.
    ///
    /// # Errors
    /// What halted it; an end of the motion is none where only events are asked for.
    ///
    /// # Panics
    /// If times and slices do not have the same count.
    pub fn read(&self, readings: &mut Readings<'_>, walk: &mut Walk, stop: Stop<'_>) -> Result<(), Halt> {
        read(self, readings, walk, stop)
    }

    /// The times in s between which the motion holds, given that it meets the support's level within `period`, in s.
    ///
    /// # Errors
    /// An interruption.
    pub fn span(&self, period: f64, walk: &mut Walk, stop: Stop<'_>) -> Result<[f64; 2], Halt> {
        let within = period * self.omega0.hi;
        let over = |step: &Step| step.start.time.hi.abs() > within;
        let mut end = |forwards| Ok(find_end(self, forwards, walk, stop, over)?.map(|(time, _)| time));
        let (last, first) = (end(true)?, end(false)?);
        Ok([first.unwrap_or(f64::NEG_INFINITY), last.unwrap_or(f64::INFINITY)])
    }
}

impl Stepper for IntegratedMotion {
    fn launch(&self) -> Checkpoint {
        Checkpoint::launch(self.launch)
    }

    fn advance(&self, direction: f64, step: &mut Step) {
        advance(self.equation, direction, step);
    }

    fn state(&self, step: &Step, since: f64) -> StateVector {
        let Point { position: [x, y, _, _], velocity: [vx, vy, _, _] } = point_at(step, since);
        let length = self.pendulum.length;
        let speed = length * self.omega0.hi;
        let depth = (1.0 - x * x - y * y).sqrt();
        StateVector {
            position: [x, y, depth].map(|value| value * length),
            velocity: [vx, vy, -(x * vx + y * vy) / depth].map(|value| value * speed),
        }
    }

    fn pull(&self, step: &Step, since: f64) -> f64 {
        self.pendulum.mass * self.pendulum.gravity * self.equation.pull(&point_at(step, since))
    }

    fn omega0(&self) -> Pair {
        self.omega0
    }

    fn length(&self) -> f64 {
        self.pendulum.length
    }
}

dispatch! {
    fn advance(equation: Equation, direction: f64, step: &mut Step) = advance_with
}

#[inline(always)]
fn advance_with<A: Arithmetic>(_: A, equation: Equation, direction: f64, step: &mut Step) {
    step.start = step.next;
    step.series.start(&step.start.point);
    if !equation.holds(&step.start.point) {
        (step.size, step.ending) = (0.0, Some(Ending::Level));
        return;
    }
    let series = &mut step.series;
    VectorField::<Alone<A>>::continue_series(&equation, series, &mut PlanTerms::default());
    let mut size = direction * reach(series.shares::<Alone<A>>(FINEST));
    step.ending = None;
    // The motion itself goes on smoothly through the support's level, so a step may reach across it.
    if !series.guard_holds::<A>(size)
        && let Some(end) = first::<A>(&Guard(series), size, false)
    {
        (size, step.ending) = (end, Some(Ending::Level));
    }
    step.size = size;
    step.next = step.start.after::<A>(size, series.at::<Alone<A>>(size));
}
