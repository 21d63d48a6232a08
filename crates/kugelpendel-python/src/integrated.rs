//! Motions by the paper's equations (12) and (13), integrated.

use crate::columns::{Columns, Numbers, launcher};
use crate::stepped::{Asked, Leg, Stepped, made};
use kugelpendel::{Equation, IntegratedMotion, Pendulum};
use numpy::PyReadonlyArray1;
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;

/// Integrated motions in a row.
#[pyclass(frozen, module = "kugelpendel._core")]
pub(crate) struct IntegratedMotions(Stepped<IntegratedMotion>);

#[pymethods]
impl IntegratedMotions {
    /// Columns, each of length 1 or `count`, as for `RealMotions`; the equation is "plane" or "cubic".
    #[new]
    fn new(
        py: Python<'_>,
        count: usize,
        pendulum: Vec<PyReadonlyArray1<'_, f64>>,
        launch: (&str, Vec<PyReadonlyArray1<'_, f64>>),
        equation: &str,
    ) -> PyResult<Self> {
        let equation = match equation {
            "plane" => Equation::Plane,
            "cubic" => Equation::Cubic,
            _ => return Err(PyValueError::new_err(format!("there is no equation {equation:?}"))),
        };
        let (width, make) = launcher(launch.0)
            .ok_or_else(|| PyValueError::new_err(format!("there is no launch of kind {:?}", launch.0)))?;
        let pendulum = Columns::checked(&pendulum, 3, count)?;
        let values = Columns::checked(&launch.1, width, count)?;
        let motions = made(py, count, |index| {
            let [length, gravity, mass] = pendulum.row(index);
            IntegratedMotion::new(Pendulum { length, gravity, mass }, equation, make(&values, index))
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

    /// First and last time of each motion, if it ends within a time of its own, s.
    fn spans<'py>(&self, py: Python<'py>, within: PyReadonlyArray1<'py, f64>) -> PyResult<Numbers<'py>> {
        self.0.spans(py, &within, IntegratedMotion::span)
    }
}
