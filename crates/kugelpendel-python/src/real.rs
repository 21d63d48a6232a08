//! Real motions: flat arrays in, flat arrays out.

use crate::columns::{Columns, Numbers};
use crate::given::{Problems, Told, each_case};
use crate::stepped::{Asked, Leg, Stepped};
use kugelpendel::{Pendulum, RealMotion, Thread};
use numpy::PyReadonlyArray1;
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use std::collections::HashMap;

/// Steps over which the ends of a motion are looked for: some hundred milliseconds of work.
const LOOKED: u64 = 100_000;

/// Real motions in a row.
#[pyclass(frozen, module = "kugelpendel._core")]
pub(crate) struct RealMotions(Stepped<RealMotion>);

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
        let motions = each_case(py, count, &pendulum, launch.0, &launch.1, &acting, |pendulum, launch, acting, _| {
            RealMotion::under(&acting, pendulum, launch, thread, tolerance)
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

    /// Each motion up to the last of some ascending times, s: the largest |b|, the least and the largest tension, when the
    /// plane has turned by a quarter, since when it stands, then a, b and azimuth at each time; NaN for the bad ones and those
    /// that end before. Columns length, gravity, mass of the point that moves like the bob, and rotation of the ground.
    fn course<'py>(
        &self,
        py: Python<'py>,
        columns: Vec<PyReadonlyArray1<'py, f64>>,
        times: PyReadonlyArray1<'py, f64>,
    ) -> PyResult<Numbers<'py>> {
        let (columns, times) = (Columns::checked(&columns, 4, self.0.len())?, times.as_slice()?);
        if !times.is_sorted() || times.first().is_none_or(|first| *first < 0.0) {
            return Err(PyValueError::new_err("the times must be in order, the first at least 0"));
        }
        let given = |index: usize| {
            let [length, gravity, mass, rotation] = columns.row(index);
            (Pendulum { length, gravity, mass }, rotation)
        };
        self.0.followed(py, 5 + 3 * times.len(), times, given, |follower, out| {
            let (numbers, ellipses) = out.split_at_mut(5);
            let found = follower.finish(times, ellipses);
            let [least, most] = found.tension;
            numbers.copy_from_slice(&[found.widest, least, most, found.quarter_turn, found.stands_since]);
        })
    }

    /// First and last time of each motion; ends are looked for over a time of its own, s, and not for ever.
    fn spans<'py>(&self, py: Python<'py>, within: PyReadonlyArray1<'py, f64>) -> PyResult<Numbers<'py>> {
        self.0.spans(py, &within, |motion, within, walk, stop| motion.span(within, LOOKED, walk, stop))
    }
}
