//! Real motions: flat arrays in, flat arrays out.

use crate::columns::{Numbers, new_array};
use crate::given::{Problems, Told, bad, each_case, problems, tell};
use kugelpendel::{Event, Halt, Invalid, Quantity, RealMotion, Thread, Walks, in_parallel};
use numpy::{IntoPyArray, PyReadonlyArray1};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use rayon::prelude::*;
use std::collections::HashMap;
use std::sync::Mutex;

/// Motions that are integrated at once before anyone asks for an interruption.
pub(crate) const GROUP: usize = 256;

/// Motions in a row, each with how far it has been integrated.
#[pyclass(frozen, module = "kugelpendel._core")]
pub(crate) struct RealMotions {
    motions: Vec<Result<RealMotion, Invalid>>,
    walks: Vec<Mutex<Walks>>,
}

#[pymethods]
impl RealMotions {
    /// Columns, each of length 1 or `count`: of the pendulum length, gravity, mass; of the launch as its kind has them; of
    /// what acts by their names, such as "drag.linear".
    #[new]
    fn new(
        py: Python<'_>,
        count: usize,
        pendulum: Vec<PyReadonlyArray1<'_, f64>>,
        launch: (&str, Vec<PyReadonlyArray1<'_, f64>>),
        acting: HashMap<String, PyReadonlyArray1<'_, f64>>,
        thread: &str,
        tolerance: f64,
    ) -> PyResult<Self> {
        let thread = match thread {
            "ends" => Thread::Ends,
            "flies" => Thread::Flies,
            "rod" => Thread::Rod,
            _ => return Err(PyValueError::new_err(format!("there is no thread that {thread:?}"))),
        };
        let motions = each_case(py, count, &pendulum, launch.0, &launch.1, &acting, |pendulum, launch, acting| {
            RealMotion::under(&acting, pendulum, launch, thread, tolerance)
        })?;
        let walks = (0..count).map(|_| Mutex::default()).collect();
        Ok(Self { motions, walks })
    }

    /// Index of each bad case and the number of its kind.
    fn problems<'py>(&self, py: Python<'py>) -> Problems<'py> {
        problems(py, bad(&self.motions))
    }

    /// What is wrong with one case.
    fn problem(&self, index: usize) -> Option<Told> {
        self.motions[index].as_ref().err().map(tell)
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
        azimuth: f64,
        between: [f64; 2],
        most: usize,
    ) -> PyResult<Numbers<'py>> {
        let event = match kind {
            "outer" => Event::Outer,
            "inner" => Event::Inner,
            "azimuth" => Event::Azimuth(azimuth),
            "slack" => Event::Slack,
            "taut" => Event::Taut,
            _ => return Err(PyValueError::new_err(format!("there is no event {kind:?}"))),
        };
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
pub(crate) struct Signal(Mutex<Option<PyErr>>);

impl Signal {
    /// Only the main thread ever sees one.
    pub(crate) fn arrived(&self) -> bool {
        let raised = Python::attach(|py| py.check_signals()).err();
        let arrived = raised.is_some();
        if arrived {
            *lock(&self.0) = raised;
        }
        arrived
    }

    pub(crate) fn raised(self) -> PyResult<()> {
        lock(&self.0).take().map_or(Ok(()), Err)
    }
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
                in_parallel(|| rows.for_each(|(index, (out, end))| row(GROUP * group + index, out, end)));
                if signal.arrived() {
                    return;
                }
            }
        });
        signal.raised()?;
        Ok((array, ends.into_pyarray(py)))
    }
}
