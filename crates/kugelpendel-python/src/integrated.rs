//! Motions by the paper's equations (12) and (13), integrated.

use crate::columns::Numbers;
use crate::given::{Problems, Told, each_case};
use crate::stepped::{Asked, Leg, Stepped};
use kugelpendel::{Equation, IntegratedMotion};
use numpy::PyReadonlyArray1;
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use std::collections::HashMap;

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
        let nothing = HashMap::new();
        let motions = each_case(py, count, &pendulum, launch.0, &launch.1, &nothing, |pendulum, launch, _, _| {
            IntegratedMotion::new(pendulum, equation, launch)
        })?;
        Ok(Self(Stepped::new(motions)))
    }

    /// Index of each bad case and the number of its kind.
    fn problems<'py>(&self, py: Python<'py>) -> Problems<'py> {
        self.0.problems(py)
    }

    /// What is wrong with one case.
    fn problem(&self, index: usize) -> Option<Told> {
        self.0.problem(index)
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
