//! Averaged motions: flat arrays in, flat arrays out.

use crate::columns::{Numbers, new_array};
use crate::given::{Problems, Told, bad, each_case, problems, tell};
use crate::signal::lock;
use kugelpendel::{Envelope, EnvelopeMotion, EnvelopeWalks, Invalid, Quantity, in_parallel};
use numpy::{IntoPyArray, PyReadonlyArray1};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use rayon::prelude::*;
use std::collections::HashMap;
use std::sync::Mutex;

/// Motions in a row, each with how far it has been integrated.
#[pyclass(frozen, module = "kugelpendel._core")]
pub(crate) struct EnvelopeMotions {
    motions: Vec<Result<EnvelopeMotion, Invalid>>,
    walks: Vec<Mutex<EnvelopeWalks>>,
}

#[pymethods]
impl EnvelopeMotions {
    /// Columns as for `RealMotions`.
    #[new]
    fn new(
        py: Python<'_>,
        count: usize,
        pendulum: Vec<PyReadonlyArray1<'_, f64>>,
        launch: (&str, Vec<PyReadonlyArray1<'_, f64>>),
        acting: HashMap<String, PyReadonlyArray1<'_, f64>>,
        exact: bool,
    ) -> PyResult<Self> {
        let motions = each_case(py, count, &pendulum, launch.0, &launch.1, &acting, |pendulum, launch, acting| {
            EnvelopeMotion::under(&acting, pendulum, launch, exact)
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

    /// "position", "velocity", "semi_axes", "azimuth", "phase" or "rates", and when each motion has ended before one of
    /// the times, NaN where it has not.
    fn read<'py>(
        &self,
        py: Python<'py>,
        what: &str,
        times: PyReadonlyArray1<'py, f64>,
    ) -> PyResult<(Numbers<'py>, Numbers<'py>)> {
        let what = match what {
            "position" => Envelope::Point(Quantity::Position),
            "velocity" => Envelope::Point(Quantity::Velocity),
            "semi_axes" => Envelope::SemiAxes,
            "azimuth" => Envelope::Azimuth,
            "phase" => Envelope::Phase,
            "rates" => Envelope::Rates,
            _ => return Err(PyValueError::new_err(format!("an averaged motion has no {what:?}"))),
        };
        let times = times.as_slice()?;
        let mut ends = vec![f64::NAN; self.motions.len()];
        let size = what.width() * times.len();
        let row = |index: usize, row: &mut [f64], end: &mut f64| {
            row.fill(f64::NAN);
            let Ok(motion) = &self.motions[index] else { return };
            let mut walks = lock(&self.walks[index]);
            if let Err(time) = motion.fill(what, times, row, &mut walks) {
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
            let rows = out.par_chunks_mut(size).zip(&mut ends).enumerate();
            in_parallel(|| rows.for_each(|(index, (out, end))| row(index, out, end)));
        });
        Ok((array, ends.into_pyarray(py)))
    }

    /// The five strengths of the forces, each the largest of all motions, NaN not counted.
    fn strengths(&self) -> [f64; 5] {
        let all = self.motions.iter().flatten().map(EnvelopeMotion::strengths);
        all.fold([0.0; 5], |most, these| std::array::from_fn(|k| f64::max(most[k], these[k])))
    }

    /// The times in s between which each motion holds, two to a motion, looked for within a time; NaN for the bad ones.
    fn span<'py>(&self, py: Python<'py>, within: f64) -> Numbers<'py> {
        let span = |motion: &Result<EnvelopeMotion, Invalid>| motion.as_ref().map_or([f64::NAN; 2], |m| m.span(within));
        let spans: Vec<_> = py.detach(|| in_parallel(|| self.motions.par_iter().flat_map_iter(span).collect()));
        spans.into_pyarray(py)
    }
}
