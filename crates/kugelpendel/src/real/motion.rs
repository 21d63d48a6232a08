//! The motion of a real pendulum: the full equations, integrated.

use crate::exact::motion::ExactMotion;
use crate::given::drive::Drive;
use crate::given::forces::{Acting, Forces, Thread};
use crate::given::invalid::Invalid;
use crate::given::launch::Launch;
use crate::given::pendulum::Pendulum;
use crate::given::times::{Quantity, Times};
use crate::numbers::double_double::Pair;
use crate::real::problem::Problem;
use crate::real::step::advance;
use crate::taylor::series::Point;
use crate::taylor::step::{Checkpoint, Step, guard_at, point_at};
use crate::taylor::sweep::read;
use crate::taylor::walk::{Halt, Readings, StateVector, Stepper, Stop, Walk, find_end};

/// A pendulum among the forces that act on it, from its launch.
#[derive(Clone, Debug)]
pub struct RealMotion {
    pendulum: Pendulum,
    omega0: Pair,
    pub(super) problem: Problem,
}

impl RealMotion {
    /// Under everything that acts; the pendulum is as given, without the bob's corrections.
    ///
    /// # Errors
    /// What [`Acting::settle`] refuses.
    pub fn under(
        acting: &Acting,
        pendulum: Pendulum,
        launch: Launch,
        thread: Thread,
        tolerance: f64,
    ) -> Result<Self, Invalid> {
        let effective = acting.settle(&pendulum, &launch)?;
        Self::new(effective, launch, acting.forces(), acting.drive, thread, tolerance)
    }

    /// The pendulum's gravity is what moves the bob, buoyancy and all taken into account.
    ///
    /// # Errors
    /// A pendulum, launch, force or drive that makes no sense.
    pub fn new(
        pendulum: Pendulum,
        launch: Launch,
        forces: Forces,
        drive: Drive,
        thread: Thread,
        tolerance: f64,
    ) -> Result<Self, Invalid> {
        forces.check()?;
        drive.check()?;
        let (launch, omega0) = launch_point(pendulum, launch)?;
        let scale = [pendulum.length, omega0.hi];
        Ok(Self { pendulum, omega0, problem: Problem::new(&forces, drive, thread, tolerance, launch, scale) })
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

    /// The times in s between which the motion can be followed; the first is 0 for one that is driven or flies, since a
    /// push or a jerk cannot be undone.
    ///
    /// Ends are looked for over so many s and steps each way. Forwards the search is over sooner for a free pendulum whose
    /// energy will never again lift it to the support: its thread stays taut.
    ///
    /// # Errors
    /// An interruption.
    pub fn span(&self, within: f64, most: u64, walk: &mut Walk, stop: Stop<'_>) -> Result<[f64; 2], Halt> {
        let Problem { drive, thread, .. } = &self.problem;
        let within = within * self.omega0.hi;
        let over = |step: &Step| step.start.count >= most || step.start.time.hi.abs() >= within;
        let stays = |step: &Step| *drive == Drive::Absent && self.problem.field.stays_below(&step.start.point);
        let last = find_end(self, true, walk, stop, |step| over(step) || stays(step))?;
        let first = if *drive != Drive::Absent || *thread == Thread::Flies {
            0.0
        } else {
            find_end(self, false, walk, stop, over)?.map_or(f64::NEG_INFINITY, |(time, _)| time)
        };
        Ok([first, last.map_or(f64::INFINITY, |(time, _)| time)])
    }
}

/// Position and velocity of a launch without dimensions, and ω0.
pub(crate) fn launch_point(pendulum: Pendulum, launch: Launch) -> Result<(Point, Pair), Invalid> {
    let exact = ExactMotion::new(pendulum, launch)?;
    let (mut position, mut velocity) = ([0.0; 3], [0.0; 3]);
    exact.fill(Quantity::Position, Times::Scattered(&[0.0]), &mut position);
    exact.fill(Quantity::Velocity, Times::Scattered(&[0.0]), &mut velocity);
    let speed = pendulum.length * exact.omega0.hi;
    let [x, y, z] = position.map(|value| value / pendulum.length);
    let [vx, vy, vz] = velocity.map(|value| value / speed);
    Ok((Point { position: [x, y, z, 0.0], velocity: [vx, vy, vz, 0.0] }, exact.omega0))
}

impl Stepper for RealMotion {
    fn launch(&self) -> Checkpoint {
        Checkpoint::launch(self.problem.launch)
    }

    fn advance(&self, direction: f64, step: &mut Step) {
        advance(&self.problem, direction, step);
    }

    fn state(&self, step: &Step, since: f64) -> StateVector {
        let Point { position: [x, y, z, _], velocity: [vx, vy, vz, _] } = point_at(step, since);
        let speed = self.pendulum.length * self.omega0.hi;
        StateVector {
            position: [x, y, z].map(|value| value * self.pendulum.length),
            velocity: [vx, vy, vz].map(|value| value * speed),
        }
    }

    /// 0 where the thread is slack.
    fn pull(&self, step: &Step, since: f64) -> f64 {
        let weight = self.pendulum.mass * self.pendulum.gravity;
        if step.start.free { 0.0 } else { weight * guard_at(step, since) }
    }

    fn omega0(&self) -> Pair {
        self.omega0
    }

    fn length(&self) -> f64 {
        self.pendulum.length
    }
}
