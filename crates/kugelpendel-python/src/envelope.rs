//! Averaged motions: flat arrays in, flat arrays out.

use crate::columns::{Columns, Numbers, launcher, new_array};
use crate::real::{drive, forces};
use crate::signal::lock;
use crate::stepped::problems;
use kugelpendel::{Envelope, EnvelopeMotion, EnvelopeWalks, Invalid, Pendulum, Quantity};
use numpy::{IntoPyArray, PyReadonlyArray1};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use rayon::prelude::*;
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
        forces: Vec<PyReadonlyArray1<'_, f64>>,
        drive: (&str, Vec<PyReadonlyArray1<'_, f64>>),
        exact: bool,
    ) -> PyResult<Self> {
        let (width, make) = launcher(launch.0)
            .ok_or_else(|| PyValueError::new_err(format!("there is no launch of kind {:?}", launch.0)))?;
        let pendulum = Columns::checked(&pendulum, 3, count)?;
        let values = Columns::checked(&launch.1, width, count)?;
        let acting = Columns::checked(&forces, 8, count)?;
        let driving = Columns::checked(&drive.1, 2, count)?;
        let cases = (0..count).map(|index| {
            let [length, gravity, mass] = pendulum.row(index);
            let pendulum = Pendulum { length, gravity, mass };
            let [push, when] = driving.row(index);
            let driven = self::drive(drive.0, push, when)?;
            Ok((pendulum, make(&values, index), self::forces(&acting, index), driven))
        });
        let cases = cases.collect::<PyResult<Vec<_>>>()?;
        let motions = py.detach(|| {
            let made = cases.into_par_iter().with_min_len(64);
            made.map(|(pendulum, launch, forces, drive)| EnvelopeMotion::new(pendulum, launch, forces, drive, exact))
                .collect()
        });
        let walks = (0..count).map(|_| Mutex::default()).collect();
        Ok(Self { motions, walks })
    }

    /// Index and sentence of each bad case.
    fn problems(&self) -> Vec<(usize, String)> {
        problems(&self.motions)
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
            rows.for_each(|(index, (out, end))| row(index, out, end));
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
        let spans: Vec<_> = py.detach(|| self.motions.par_iter().flat_map_iter(span).collect());
        spans.into_pyarray(py)
    }
}
