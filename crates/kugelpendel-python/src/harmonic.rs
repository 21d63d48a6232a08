//! Figures of a few harmonics: flat arrays in, flat arrays out.

use crate::columns::{Numbers, new_array};
use kugelpendel::{HarmonicMotion, MAX_POWER, Quantity, Times};
use numpy::ndarray::ArrayView1;
use numpy::{PyReadonlyArray1, PyReadonlyArray2};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;

/// Turning figures of a few harmonics in a row.
#[pyclass(frozen, module = "kugelpendel._core")]
pub(crate) struct HarmonicMotions {
    motions: Vec<HarmonicMotion>,
}

#[pymethods]
impl HarmonicMotions {
    /// `rows`: length, frequency, precession, apsis time and azimuth, then the powers of the inner and of the outer part.
    #[new]
    fn new(py: Python<'_>, rows: PyReadonlyArray2<'_, f64>) -> PyResult<Self> {
        const WIDTH: usize = 5 + 2 * (MAX_POWER + 1);
        let rows = rows.as_array();
        if rows.ncols() != WIDTH {
            return Err(PyValueError::new_err(format!("a row takes {WIDTH} numbers, not {}", rows.ncols())));
        }
        let motion = |row: ArrayView1<'_, f64>| HarmonicMotion {
            length: row[0],
            frequency: row[1],
            precession: row[2],
            apsis_time: row[3],
            apsis_azimuth: row[4],
            inner: std::array::from_fn(|k| row[5 + k]),
            outer: std::array::from_fn(|k| row[5 + MAX_POWER + 1 + k]),
        };
        Ok(Self { motions: py.detach(|| rows.rows().into_iter().map(motion).collect()) })
    }

    fn position<'py>(&self, py: Python<'py>, times: PyReadonlyArray1<'py, f64>) -> PyResult<Numbers<'py>> {
        let times = times.as_slice()?;
        Ok(self.filled(py, times.len(), Quantity::Position, Times::Scattered(times)))
    }

    fn velocity<'py>(&self, py: Python<'py>, times: PyReadonlyArray1<'py, f64>) -> PyResult<Numbers<'py>> {
        let times = times.as_slice()?;
        Ok(self.filled(py, times.len(), Quantity::Velocity, Times::Scattered(times)))
    }

    fn sample<'py>(&self, py: Python<'py>, start: f64, step: f64, count: usize) -> Numbers<'py> {
        self.filled(py, count, Quantity::Position, Times::Grid { start, step, first: 0 })
    }
}

impl HarmonicMotions {
    fn filled<'py>(&self, py: Python<'py>, count: usize, quantity: Quantity, times: Times<'_>) -> Numbers<'py> {
        new_array(py, 3 * count * self.motions.len(), |out| {
            if count > 0 {
                for (motion, row) in self.motions.iter().zip(out.chunks_exact_mut(3 * count)) {
                    motion.fill(quantity, times, row);
                }
            }
        })
    }
}
