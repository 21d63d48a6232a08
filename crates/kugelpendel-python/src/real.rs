//! Real motions: flat arrays in, flat arrays out.

use crate::columns::{Columns, Numbers, launcher};
use crate::stepped::{Asked, Leg, Stepped, made};
use kugelpendel::{Drive, Forces, Pendulum, RealMotion, Thread};
use numpy::PyReadonlyArray1;
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;

/// Steps over which the ends of a motion are looked for: some hundred milliseconds of work.
const LOOKED: u64 = 100_000;

/// Real motions in a row.
#[pyclass(frozen, module = "kugelpendel._core")]
pub(crate) struct RealMotions(Stepped<RealMotion>);

/// The forces of one row: damping, quadratic drag, horizontal and vertical rotation, anisotropy, its axis, damping
/// anisotropy, its axis.
pub(crate) fn forces(columns: &Columns<'_>, index: usize) -> Forces {
    let [damping, quadratic, horizontal, vertical, anisotropy, axis, damping_anisotropy, damping_axis] =
        columns.row(index);
    let rotation = [horizontal, vertical];
    Forces { damping, quadratic, rotation, anisotropy, axis, damping_anisotropy, damping_axis }
}

/// A drive with a push and a phase or a radius, as `kind` says.
pub(crate) fn drive(kind: &str, push: f64, when: f64) -> PyResult<Drive> {
    match kind {
        "" => Ok(Drive::Absent),
        "phase" => Ok(Drive::Phase { push, phase: when }),
        "radius" => Ok(Drive::Radius { push, radius: when }),
        _ => Err(PyValueError::new_err(format!("there is no drive by {kind:?}"))),
    }
}

#[pymethods]
impl RealMotions {
    /// Columns, each of length 1 or `count`: of the pendulum length, gravity, mass; of the launch as its kind has them;
    /// eight of the forces; of the drive push and phase or radius.
    #[new]
    #[allow(clippy::too_many_arguments)]
    fn new(
        py: Python<'_>,
        count: usize,
        pendulum: Vec<PyReadonlyArray1<'_, f64>>,
        launch: (&str, Vec<PyReadonlyArray1<'_, f64>>),
        forces: Vec<PyReadonlyArray1<'_, f64>>,
        drive: (&str, Vec<PyReadonlyArray1<'_, f64>>),
        thread: &str,
        tolerance: f64,
    ) -> PyResult<Self> {
        let thread = match thread {
            "ends" => Thread::Ends,
            "flies" => Thread::Flies,
            "rod" => Thread::Rod,
            _ => return Err(PyValueError::new_err(format!("there is no thread that {thread:?}"))),
        };
        let (width, make) = launcher(launch.0)
            .ok_or_else(|| PyValueError::new_err(format!("there is no launch of kind {:?}", launch.0)))?;
        let pendulum = Columns::checked(&pendulum, 3, count)?;
        let values = Columns::checked(&launch.1, width, count)?;
        let acting = Columns::checked(&forces, 8, count)?;
        let driving = Columns::checked(&drive.1, 2, count)?;
        self::drive(drive.0, 0.0, 0.0)?;
        let motions = made(py, count, |index| {
            let [length, gravity, mass] = pendulum.row(index);
            let pendulum = Pendulum { length, gravity, mass };
            let [push, when] = driving.row(index);
            let driven = self::drive(drive.0, push, when).unwrap_or_default();
            RealMotion::new(pendulum, make(&values, index), self::forces(&acting, index), driven, thread, tolerance)
        })?;
        Ok(Self(Stepped::new(motions)))
    }

    /// Index and sentence of each bad case.
    fn problems(&self) -> Vec<(usize, String)> {
        self.0.problems()
    }

    /// Positions, when each motion has ended before the last of the times, NaN where it has not, and why the first has.
    fn position<'py>(
        &self,
        py: Python<'py>,
        times: PyReadonlyArray1<'py, f64>,
    ) -> PyResult<(Numbers<'py>, Numbers<'py>, &'static str)> {
        self.0.filled(py, &times, Asked::Position)
    }

    fn velocity<'py>(
        &self,
        py: Python<'py>,
        times: PyReadonlyArray1<'py, f64>,
    ) -> PyResult<(Numbers<'py>, Numbers<'py>, &'static str)> {
        self.0.filled(py, &times, Asked::Velocity)
    }

    fn tension<'py>(
        &self,
        py: Python<'py>,
        times: PyReadonlyArray1<'py, f64>,
    ) -> PyResult<(Numbers<'py>, Numbers<'py>, &'static str)> {
        self.0.filled(py, &times, Asked::Tension)
    }

    /// A stretch of the first motion in one pass; see [`Stepped::leg`].
    fn leg<'py>(
        &self,
        py: Python<'py>,
        times: PyReadonlyArray1<'py, f64>,
        events: Vec<(String, f64)>,
        between: [f64; 2],
        most: usize,
        within: Option<f64>,
    ) -> PyResult<Leg<'py>> {
        self.0.leg(py, &times, &events, between, most, within)
    }

    /// First and last time of each motion; ends are looked for over a time of its own, s, and not for ever.
    fn spans<'py>(&self, py: Python<'py>, within: PyReadonlyArray1<'py, f64>) -> PyResult<Numbers<'py>> {
        self.0.spans(py, &within, |motion, within, walk, stop| motion.span(within, LOOKED, walk, stop))
    }
}
