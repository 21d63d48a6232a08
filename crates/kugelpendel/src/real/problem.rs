//! What the integration of a real pendulum has to know, without dimensions: lengths in l, times in 1/ω0.

use crate::given::drive::Drive;
use crate::given::forces::{Forces, Thread};
use crate::real::sphere::SphereField;
use crate::taylor::series::{FINEST, Point};

#[derive(Clone, Debug)]
pub(crate) struct Problem {
    pub(crate) field: SphereField,
    pub(crate) drive: Drive,
    pub(crate) thread: Thread,
    /// Of the last terms of a step's series against the state.
    pub(crate) tolerance: f64,
    pub(crate) launch: Point,
}

impl Problem {
    pub(crate) fn new(
        forces: &Forces,
        drive: Drive,
        thread: Thread,
        tolerance: f64,
        launch: Point,
        [length, omega0]: [f64; 2],
    ) -> Self {
        let field = SphereField::new(forces, length, omega0);
        let speed = length * omega0;
        let drive = match drive {
            Drive::Absent => Drive::Absent,
            Drive::Phase { push, phase } => Drive::Phase { push: push / speed, phase },
            Drive::Radius { push, radius } => Drive::Radius { push: push / speed, radius: radius / length },
        };
        Self { field, drive, thread, tolerance: tolerance.max(FINEST), launch }
    }
}
