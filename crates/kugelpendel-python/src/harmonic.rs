//! Figures of a few harmonics: flat arrays in, flat arrays out.

use crate::columns::Numbers;
use crate::given::{Problems, Told, bad, each_case, problems, tell};
use crate::meaning::event;
use crate::signal::{Signal, collected, filled};
use kugelpendel::{HarmonicLaw, HarmonicMotion, Invalid, MAX_POWER, Quantity, Times};
use numpy::{IntoPyArray, PyReadonlyArray1, PyReadonlyArray2};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use std::collections::HashMap;
use std::ops::Range;

/// Turning figures of a few harmonics in a row.
#[pyclass(frozen, module = "kugelpendel._core")]
pub(crate) struct HarmonicMotions {
    motions: Vec<Result<HarmonicMotion, Invalid>>,
}

#[pymethods]
impl HarmonicMotions {
    /// Columns as for `ExactMotions`; the law is "linear" or "olsson".
    #[new]
    fn new(
        py: Python<'_>,
        count: usize,
        pendulum: Vec<PyReadonlyArray1<'_, f64>>,
        kind: &str,
        values: Vec<PyReadonlyArray1<'_, f64>>,
        law: &str,
    ) -> PyResult<Self> {
        let law = match law {
            "linear" => HarmonicLaw::Linear,
            "olsson" => HarmonicLaw::Olsson,
            _ => return Err(PyValueError::new_err(format!("there is no law {law:?}"))),
        };
        let nothing = HashMap::new();
        let motions = each_case(py, count, &pendulum, kind, &values, &nothing, |pendulum, launch, _, _| {
            HarmonicMotion::new(pendulum, launch, law)
        })?;
        Ok(Self { motions })
    }

    /// The same turning points and phases under other rates, and with powers of the inner and of the outer part: a row
    /// for each motion.
    fn with_figures(&self, rows: PyReadonlyArray2<'_, f64>) -> PyResult<Self> {
        const POWERS: usize = MAX_POWER + 1;
        let rows = rows.as_array();
        if rows.dim() != (self.motions.len(), 2 + 2 * POWERS) {
            return Err(PyValueError::new_err(format!("the rows are {:?}", rows.dim())));
        }
        let motions = self.motions.iter().zip(rows.rows()).map(|(motion, row)| {
            let powers = |first: usize| std::array::from_fn(|k| row[first + k]);
            let (inner, outer) = (powers(2), powers(2 + POWERS));
            motion.map(|motion| motion.with_figure(row[0], row[1], inner, outer))
        });
        Ok(Self { motions: motions.collect() })
    }

    /// How many powers each part of a figure has.
    #[staticmethod]
    fn powers() -> usize {
        MAX_POWER + 1
    }

    /// Index of each bad case and the number of its kind.
    fn problems<'py>(&self, py: Python<'py>) -> Problems<'py> {
        problems(py, bad(&self.motions))
    }

    /// What is wrong with one case.
    fn problem(&self, index: usize) -> Option<Told> {
        self.motions[index].as_ref().err().map(tell)
    }

    /// Outer semi-axes and inner ones, signed; two numbers a motion.
    fn semi_axes<'py>(&self, py: Python<'py>) -> PyResult<Numbers<'py>> {
        self.each(py, HarmonicMotion::semi_axes)
    }

    fn frequency<'py>(&self, py: Python<'py>) -> PyResult<Numbers<'py>> {
        self.each(py, |motion| [motion.frequency])
    }

    fn precession<'py>(&self, py: Python<'py>) -> PyResult<Numbers<'py>> {
        self.each(py, |motion| [motion.precession])
    }

    fn position<'py>(&self, py: Python<'py>, times: PyReadonlyArray1<'py, f64>) -> PyResult<Numbers<'py>> {
        self.scattered(py, Quantity::Position, &times)
    }

    fn velocity<'py>(&self, py: Python<'py>, times: PyReadonlyArray1<'py, f64>) -> PyResult<Numbers<'py>> {
        self.scattered(py, Quantity::Velocity, &times)
    }

    fn sample<'py>(&self, py: Python<'py>, start: f64, step: f64, count: usize) -> PyResult<Numbers<'py>> {
        filled(py, [self.motions.len(), count, 3], |motions, times, out| {
            self.fill(motions, Quantity::Position, Times::Grid { start, step, first: times.start }, out);
        })
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
        let times = py.detach(|| motion.events(event, between, most, &|| signal.ends_work()));
        signal.raised()?;
        Ok(times.unwrap_or_default().into_pyarray(py))
    }
}

impl HarmonicMotions {
    fn each<'py, const N: usize>(
        &self,
        py: Python<'py>,
        quantity: impl Fn(&HarmonicMotion) -> [f64; N] + Send + Sync,
    ) -> PyResult<Numbers<'py>> {
        let row = |index: usize| self.motions[index].as_ref().map_or([f64::NAN; N], &quantity);
        Ok(collected(py, self.motions.len(), row)?.into_pyarray(py))
    }

    fn scattered<'py>(
        &self,
        py: Python<'py>,
        quantity: Quantity,
        times: &PyReadonlyArray1<'py, f64>,
    ) -> PyResult<Numbers<'py>> {
        let times = times.as_slice()?;
        filled(py, [self.motions.len(), times.len(), 3], |motions, some, out| {
            self.fill(motions, quantity, Times::Scattered(&times[some]), out);
        })
    }

    fn fill(&self, motions: Range<usize>, quantity: Quantity, times: Times<'_>, out: &mut [f64]) {
        let size = out.len() / motions.len();
        for (motion, row) in self.motions[motions].iter().zip(out.chunks_exact_mut(size)) {
            match motion {
                Ok(motion) => motion.fill(quantity, times, row),
                Err(_) => row.fill(f64::NAN),
            }
        }
    }
}
