//! Exact motions: flat arrays in, flat arrays out.

use crate::columns::{Columns, Numbers, known_launcher, new_array};
use crate::given::{Problems, Told, problems, tell};
use kugelpendel::{Ensemble, ExactMotion, Harmonic, Pendulum, Quantity, Times};
use numpy::{Complex64, IntoPyArray, PyArray1, PyReadonlyArray1, PyReadwriteArray1};
use pyo3::prelude::*;

/// Motions in a row.
#[pyclass(frozen, module = "kugelpendel._core")]
pub(crate) struct ExactMotions {
    ensemble: Ensemble,
}

type Harmonics<'py> = (Bound<'py, PyArray1<i32>>, Numbers<'py>, Bound<'py, PyArray1<Complex64>>);

#[pymethods]
impl ExactMotions {
    /// `pendulum`: columns length, gravity, mass; `values`: the launch's columns; each of length 1 or `count`.
    #[new]
    fn new(
        py: Python<'_>,
        count: usize,
        pendulum: Vec<PyReadonlyArray1<'_, f64>>,
        kind: &str,
        values: Vec<PyReadonlyArray1<'_, f64>>,
    ) -> PyResult<Self> {
        let (width, launch) = known_launcher(kind)?;
        let pendulum = Columns::checked(&pendulum, 3, count)?;
        let values = Columns::checked(&values, width, count)?;
        let ensemble = py.detach(|| {
            Ensemble::new(count, |i| {
                let [length, gravity, mass] = pendulum.row(i);
                (Pendulum { length, gravity, mass }, launch(&values, i))
            })
        });
        Ok(Self { ensemble })
    }

    /// Index of each bad case and the number of its kind.
    fn problems<'py>(&self, py: Python<'py>) -> Problems<'py> {
        problems(py, self.ensemble.problems())
    }

    /// What is wrong with one case.
    fn problem(&self, index: usize) -> Option<Told> {
        self.ensemble.motion(index).as_ref().err().map(tell)
    }

    fn position<'py>(&self, py: Python<'py>, times: PyReadonlyArray1<'py, f64>) -> PyResult<Numbers<'py>> {
        self.scattered(py, Quantity::Position, &times)
    }

    fn velocity<'py>(&self, py: Python<'py>, times: PyReadonlyArray1<'py, f64>) -> PyResult<Numbers<'py>> {
        self.scattered(py, Quantity::Velocity, &times)
    }

    fn sample<'py>(&self, py: Python<'py>, start: f64, step: f64, count: usize) -> Numbers<'py> {
        let times = Times::Grid { start, step, first: 0 };
        self.filled(py, 3 * count, |out| self.ensemble.fill(Quantity::Position, times, out))
    }

    /// The same into an array that is there already.
    fn sample_into(&self, py: Python<'_>, start: f64, step: f64, mut out: PyReadwriteArray1<'_, f64>) -> PyResult<()> {
        let out = out.as_slice_mut()?;
        py.detach(|| self.ensemble.fill(Quantity::Position, Times::Grid { start, step, first: 0 }, out));
        Ok(())
    }

    fn tension<'py>(&self, py: Python<'py>, times: PyReadonlyArray1<'py, f64>) -> PyResult<Numbers<'py>> {
        let times = times.as_slice()?;
        Ok(self.filled(py, times.len(), |out| self.ensemble.fill_tension(times, out)))
    }

    fn frequency<'py>(&self, py: Python<'py>) -> Numbers<'py> {
        self.each(py, |motion| [motion.frequency()])
    }

    fn precession<'py>(&self, py: Python<'py>) -> Numbers<'py> {
        self.each(py, |motion| [motion.precession()])
    }

    fn radial_period<'py>(&self, py: Python<'py>) -> Numbers<'py> {
        self.each(py, |motion| [motion.radial_period()])
    }

    fn apsidal_angle<'py>(&self, py: Python<'py>) -> Numbers<'py> {
        self.each(py, |motion| [motion.apsidal_angle()])
    }

    fn apsis_time<'py>(&self, py: Python<'py>) -> Numbers<'py> {
        self.each(py, |motion| [motion.apsis_time()])
    }

    fn apsis_azimuth<'py>(&self, py: Python<'py>) -> Numbers<'py> {
        self.each(py, |motion| [motion.apsis_azimuth()])
    }

    fn energy<'py>(&self, py: Python<'py>) -> Numbers<'py> {
        self.each(py, |motion| [motion.energy()])
    }

    fn angular_momentum<'py>(&self, py: Python<'py>) -> Numbers<'py> {
        self.each(py, |motion| [motion.angular_momentum()])
    }

    fn slack_time<'py>(&self, py: Python<'py>) -> Numbers<'py> {
        self.each(py, |motion| [motion.slack_time()])
    }

    fn turning_radii<'py>(&self, py: Python<'py>) -> Numbers<'py> {
        self.each(py, ExactMotion::turning_radii)
    }

    fn turning_heights<'py>(&self, py: Python<'py>) -> Numbers<'py> {
        self.each(py, ExactMotion::turning_heights)
    }

    fn tension_range<'py>(&self, py: Python<'py>) -> Numbers<'py> {
        self.each(py, ExactMotion::tension_range)
    }

    /// (order, frequency, amplitude) in the plan view and of the height, row after row; NaN and the order 0 where there
    /// is no spectrum, and why there is none of the first.
    fn spectrum<'py>(&self, py: Python<'py>, pairs: usize) -> (Harmonics<'py>, Harmonics<'py>, Option<Told>) {
        const ABSENT: Harmonic = Harmonic { order: 0, frequency: f64::NAN, amplitude: [f64::NAN; 2] };
        let (plan, vertical, first) = py.detach(|| {
            let (mut plan, mut vertical, mut first) = (Vec::new(), Vec::new(), None);
            for index in 0..self.ensemble.len() {
                match self.ensemble.motion(index).and_then(|motion| motion.spectrum(pairs)) {
                    Ok(spectrum) => {
                        plan.extend(spectrum.plan);
                        vertical.extend(spectrum.vertical);
                    }
                    Err(invalid) => {
                        first = first.or_else(|| (index == 0).then(|| tell(&invalid)));
                        plan.extend(vec![ABSENT; 2 * pairs]);
                        vertical.extend(vec![ABSENT; pairs + 1]);
                    }
                }
            }
            (plan, vertical, first)
        });
        (columns(py, &plan), columns(py, &vertical), first)
    }
}

impl ExactMotions {
    fn scattered<'py>(
        &self,
        py: Python<'py>,
        quantity: Quantity,
        times: &PyReadonlyArray1<'py, f64>,
    ) -> PyResult<Numbers<'py>> {
        let times = times.as_slice()?;
        Ok(self.filled(py, 3 * times.len(), |out| self.ensemble.fill(quantity, Times::Scattered(times), out)))
    }

    /// A new array with `width` numbers for each motion.
    fn filled<'py>(&self, py: Python<'py>, width: usize, fill: impl FnOnce(&mut [f64]) + Send) -> Numbers<'py> {
        new_array(py, width * self.ensemble.len(), fill)
    }

    fn each<'py, const N: usize>(
        &self,
        py: Python<'py>,
        quantity: impl Fn(&ExactMotion) -> [f64; N] + Send,
    ) -> Numbers<'py> {
        py.detach(|| self.ensemble.map(quantity)).into_pyarray(py)
    }
}

fn columns<'py>(py: Python<'py>, harmonics: &[Harmonic]) -> Harmonics<'py> {
    let order: Vec<_> = harmonics.iter().map(|h| h.order).collect();
    let frequency: Vec<_> = harmonics.iter().map(|h| h.frequency).collect();
    let amplitude: Vec<_> = harmonics.iter().map(|h| Complex64::new(h.amplitude[0], h.amplitude[1])).collect();
    (order.into_pyarray(py), frequency.into_pyarray(py), amplitude.into_pyarray(py))
}
