//! Real motions: flat arrays in, flat arrays out.

use crate::columns::{Columns, Numbers, launcher, new_array};
use crate::meaning::event;
use kugelpendel::{Drive, Forces, Halt, Invalid, Pendulum, Quantity, RealMotion, Thread, Walks};
use numpy::{IntoPyArray, PyReadonlyArray1};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use rayon::prelude::*;
use std::sync::Mutex;

/// Motions that are integrated at once before anyone asks for an interruption.
const GROUP: usize = 256;

/// Motions in a row, each with how far it has been integrated.
#[pyclass(frozen, module = "kugelpendel._core")]
pub(crate) struct RealMotions {
    motions: Vec<Result<RealMotion, Invalid>>,
    walks: Vec<Mutex<Walks>>,
}

/// The forces of one row: damping, quadratic drag, horizontal and vertical rotation, anisotropy, its axis, damping
/// anisotropy, its axis.
pub(crate) fn forces(columns: &Columns<'_>, index: usize) -> Forces {
    let [damping, quadratic, horizontal, vertical, anisotropy, axis, damping_anisotropy, damping_axis] =
        columns.row(index);
    let rotation = [horizontal, vertical];
    Forces { damping, quadratic, rotation, anisotropy, axis, damping_anisotropy, damping_axis }
}

/// The drive of one row: its push, and the phase or the radius, as `kind` says.
pub(crate) fn drive(kind: &str, columns: &Columns<'_>, index: usize) -> PyResult<Drive> {
    let [push, when] = columns.row(index);
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
        let motion = |index: usize| -> PyResult<Result<RealMotion, Invalid>> {
            let [length, gravity, mass] = pendulum.row(index);
            let pendulum = Pendulum { length, gravity, mass };
            let driven = self::drive(drive.0, &driving, index)?;
            let launch = make(&values, index);
            Ok(RealMotion::new(pendulum, launch, self::forces(&acting, index), driven, thread, tolerance))
        };
        let motions = (0..count).map(motion).collect::<PyResult<Vec<_>>>()?;
        let walks = (0..count).map(|_| Mutex::default()).collect();
        Ok(Self { motions, walks })
    }

    /// Index and sentence of each bad case.
    fn problems(&self) -> Vec<(usize, String)> {
        problems(&self.motions)
    }

    /// Positions and when each motion has ended before the last of the times, NaN where it has not.
    fn position<'py>(
        &self,
        py: Python<'py>,
        times: PyReadonlyArray1<'py, f64>,
    ) -> PyResult<(Numbers<'py>, Numbers<'py>)> {
        self.filled(py, &times, 3, |motion, times, row, walks, stop| {
            motion.fill(Quantity::Position, times, row, walks, stop)
        })
    }

    fn velocity<'py>(
        &self,
        py: Python<'py>,
        times: PyReadonlyArray1<'py, f64>,
    ) -> PyResult<(Numbers<'py>, Numbers<'py>)> {
        self.filled(py, &times, 3, |motion, times, row, walks, stop| {
            motion.fill(Quantity::Velocity, times, row, walks, stop)
        })
    }

    fn tension<'py>(
        &self,
        py: Python<'py>,
        times: PyReadonlyArray1<'py, f64>,
    ) -> PyResult<(Numbers<'py>, Numbers<'py>)> {
        self.filled(py, &times, 1, RealMotion::fill_tension)
    }

    /// Times of an event of the first motion, at most `most` of them.
    fn events<'py>(
        &self,
        py: Python<'py>,
        kind: &str,
        value: f64,
        between: [f64; 2],
        most: usize,
    ) -> PyResult<Numbers<'py>> {
        let event = event(kind, value)?;
        let Some(Ok(motion)) = self.motions.first() else {
            return Err(PyValueError::new_err("there is no motion"));
        };
        let signal = Signal::default();
        let found = py.detach(|| {
            let mut walks = lock(&self.walks[0]);
            motion.events(event, between, most, &mut walks, &|| signal.arrived())
        });
        signal.raised()?;
        Ok(found.unwrap_or_default().into_pyarray(py))
    }
}

/// A signal, such as Ctrl-C, that Python wants to raise.
#[derive(Default)]
struct Signal(Mutex<Option<PyErr>>);

impl Signal {
    /// Only the main thread ever sees one.
    fn arrived(&self) -> bool {
        let raised = Python::attach(|py| py.check_signals()).err();
        let arrived = raised.is_some();
        if arrived {
            *lock(&self.0) = raised;
        }
        arrived
    }

    fn raised(self) -> PyResult<()> {
        lock(&self.0).take().map_or(Ok(()), Err)
    }
}

/// Index and sentence of each bad case.
pub(crate) fn problems<M>(motions: &[Result<M, Invalid>]) -> Vec<(usize, String)> {
    let bad = |(index, motion): (usize, &Result<M, Invalid>)| Some((index, motion.as_ref().err()?.to_string()));
    motions.iter().enumerate().filter_map(bad).collect()
}

pub(crate) fn lock<T>(mutex: &Mutex<T>) -> std::sync::MutexGuard<'_, T> {
    mutex.lock().unwrap_or_else(std::sync::PoisonError::into_inner)
}

impl RealMotions {
    fn filled<'py>(
        &self,
        py: Python<'py>,
        times: &PyReadonlyArray1<'py, f64>,
        width: usize,
        fill: impl Fn(&RealMotion, &[f64], &mut [f64], &mut Walks, kugelpendel::Stop<'_>) -> Result<(), Halt> + Sync,
    ) -> PyResult<(Numbers<'py>, Numbers<'py>)> {
        let times = times.as_slice()?;
        let signal = Signal::default();
        let mut ends = vec![f64::NAN; self.motions.len()];
        let size = width * times.len();
        let row = |index: usize, row: &mut [f64], end: &mut f64| {
            row.fill(f64::NAN);
            let Ok(motion) = &self.motions[index] else { return };
            let mut walks = lock(&self.walks[index]);
            if let Err(Halt::Ended(time)) = fill(motion, times, row, &mut walks, &|| signal.arrived()) {
                *end = time;
            }
        };
        let array = new_array(py, size * self.motions.len(), |out| {
            if size == 0 {
                return;
            }
            if let [end] = &mut ends[..] {
                return row(0, out, end);
            }
            let groups = out.chunks_mut(GROUP * size).zip(ends.chunks_mut(GROUP)).enumerate();
            for (group, (out, ends)) in groups {
                let rows = out.par_chunks_mut(size).zip(ends).enumerate();
                rows.for_each(|(index, (out, end))| row(GROUP * group + index, out, end));
                if signal.arrived() {
                    return;
                }
            }
        });
        signal.raised()?;
        Ok((array, ends.into_pyarray(py)))
    }
}
