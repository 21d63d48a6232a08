//! Exact motions: flat arrays in, flat arrays out.

use crate::columns::{Columns, Numbers, known_launcher};
use crate::given::{Problems, Told, problems, tell};
use crate::meaning::event;
use crate::signal::{Signal, collected, fill_in_pieces, filled};
use kugelpendel::{EllipseRates, Ensemble, ExactMotion, Harmonic, IdealSummary, Pendulum, Quantity, Times};
use numpy::{Complex64, IntoPyArray, PyArray1, PyReadonlyArray1, PyReadwriteArray1};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;

/// So many motions are solved sooner than anyone could wish to stop them.
const FEW: usize = 4096;

/// Motions in a row.
#[pyclass(frozen, module = "kugelpendel._core")]
pub(crate) struct ExactMotions {
    ensemble: Ensemble,
}

/// Regime and sense; swing period, turning rate, whether less whole turns, full turn and once round; largest angle; the
/// rates by (25) and (26).
type Summary = (&'static str, f64, (f64, f64, bool, f64, f64), f64, f64, f64);

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
        let signal = Signal::default();
        let case = |i: usize| {
            let [length, gravity, mass] = pendulum.row(i);
            (Pendulum { length, gravity, mass }, launch(&values, i))
        };
        let ensemble = py.detach(|| match count {
            0..=FEW => Ensemble::new(count, case),
            _ => signal.watch(|| Ensemble::unless(|| signal.has_arrived(), count, case)),
        });
        signal.raised()?;
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

    fn sample<'py>(&self, py: Python<'py>, start: f64, step: f64, count: usize) -> PyResult<Numbers<'py>> {
        filled(py, [self.ensemble.len(), count, 3], |motions, times, out| {
            self.ensemble.fill(motions, Quantity::Position, Times::Grid { start, step, first: times.start }, out);
        })
    }

    /// The same into an array that is there already.
    fn sample_into(&self, py: Python<'_>, start: f64, step: f64, mut out: PyReadwriteArray1<'_, f64>) -> PyResult<()> {
        let out = out.as_slice_mut()?;
        let signal = Signal::default();
        let count = out.len() / (3 * self.ensemble.len()).max(1);
        py.detach(|| {
            fill_in_pieces(&signal, [count, 3], out, |motions, times, out| {
                self.ensemble.fill(motions, Quantity::Position, Times::Grid { start, step, first: times.start }, out);
            });
        });
        signal.raised()
    }

    fn tension<'py>(&self, py: Python<'py>, times: PyReadonlyArray1<'py, f64>) -> PyResult<Numbers<'py>> {
        let times = times.as_slice()?;
        filled(py, [self.ensemble.len(), times.len(), 1], |motions, some, out| {
            self.ensemble.fill_tension(motions, &times[some], out);
        })
    }

    fn frequency<'py>(&self, py: Python<'py>) -> PyResult<Numbers<'py>> {
        self.each(py, |motion| [motion.frequency()])
    }

    fn precession<'py>(&self, py: Python<'py>) -> PyResult<Numbers<'py>> {
        self.each(py, |motion| [motion.precession()])
    }

    fn radial_period<'py>(&self, py: Python<'py>) -> PyResult<Numbers<'py>> {
        self.each(py, |motion| [motion.radial_period()])
    }

    fn apsidal_angle<'py>(&self, py: Python<'py>) -> PyResult<Numbers<'py>> {
        self.each(py, |motion| [motion.apsidal_angle()])
    }

    fn apsis_time<'py>(&self, py: Python<'py>) -> PyResult<Numbers<'py>> {
        self.each(py, |motion| [motion.apsis_time()])
    }

    fn apsis_azimuth<'py>(&self, py: Python<'py>) -> PyResult<Numbers<'py>> {
        self.each(py, |motion| [motion.apsis_azimuth()])
    }

    fn energy<'py>(&self, py: Python<'py>) -> PyResult<Numbers<'py>> {
        self.each(py, |motion| [motion.energy()])
    }

    fn angular_momentum<'py>(&self, py: Python<'py>) -> PyResult<Numbers<'py>> {
        self.each(py, |motion| [motion.angular_momentum()])
    }

    fn slack_time<'py>(&self, py: Python<'py>) -> PyResult<Numbers<'py>> {
        self.each(py, |motion| [motion.slack_time()])
    }

    fn turning_radii<'py>(&self, py: Python<'py>) -> PyResult<Numbers<'py>> {
        self.each(py, ExactMotion::turning_radii)
    }

    fn turning_heights<'py>(&self, py: Python<'py>) -> PyResult<Numbers<'py>> {
        self.each(py, ExactMotion::turning_heights)
    }

    fn tension_range<'py>(&self, py: Python<'py>) -> PyResult<Numbers<'py>> {
        self.each(py, ExactMotion::tension_range)
    }

    fn swing_period<'py>(&self, py: Python<'py>) -> PyResult<Numbers<'py>> {
        self.each(py, |motion| [motion.swing_period()])
    }

    /// The ellipse at each launch: a and b in m, the azimuth of the long axis in rad, three numbers to a motion.
    fn ellipses<'py>(&self, py: Python<'py>) -> PyResult<Numbers<'py>> {
        self.each(py, |motion| {
            let ellipse = motion.ellipse();
            [ellipse.a, ellipse.b, ellipse.azimuth]
        })
    }

    /// What an error of position is given as a fraction of, m.
    fn amplitude<'py>(&self, py: Python<'py>) -> PyResult<Numbers<'py>> {
        self.each(py, |motion| [motion.amplitude()])
    }

    /// What the first motion is, as `Summary` in the Python package has it.
    fn summary(&self) -> PyResult<Summary> {
        let s = IdealSummary::of(self.first()?);
        let rates = (s.swing_period, s.turning, s.whole_turns, s.full_turn, s.once_round);
        Ok((s.regime.name(), s.sense, rates, s.largest_angle, s.formula_25, s.frequency_26))
    }

    /// Times of outer turning points of the first motion up to a time, s, at most so many and evenly spread.
    fn apsidal_times<'py>(&self, py: Python<'py>, until: f64, most: usize) -> PyResult<Numbers<'py>> {
        Ok(self.first()?.apsidal_times(until, most).into_pyarray(py))
    }

    /// By how much the first motion's outer turning points at these times and azimuths have moved round, rad.
    fn turned<'py>(
        &self,
        py: Python<'py>,
        times: PyReadonlyArray1<'py, f64>,
        azimuths: PyReadonlyArray1<'py, f64>,
    ) -> PyResult<Numbers<'py>> {
        let mut turned = azimuths.as_slice()?.to_vec();
        self.first()?.turned(times.as_slice()?, &mut turned);
        Ok(turned.into_pyarray(py))
    }

    /// A swing of the first motion as a comparison counts them, s.
    fn comparison_swing(&self) -> PyResult<f64> {
        Ok(self.first()?.comparison_swing())
    }

    /// At how many times the first motion is compared with others over a duration in s.
    fn comparison_count(&self, duration: f64) -> PyResult<usize> {
        Ok(self.first()?.comparison_count(duration))
    }

    /// For each motion, which was launched between turning radii a and b that are given as well: precession and frequency
    /// in rad/s, a/l and b/l, the relative errors of (25) and (26), and 1 where it is so small that every formula is exact.
    fn ellipse_rates<'py>(&self, py: Python<'py>, radii: Vec<PyReadonlyArray1<'py, f64>>) -> PyResult<Numbers<'py>> {
        let radii = Columns::checked(&radii, 2, self.ensemble.len())?;
        let row = |index: usize| {
            let [a, b] = radii.row(index);
            let Ok(motion) = self.ensemble.motion(index) else { return [f64::NAN; 7] };
            let rates = EllipseRates::of(motion, a, b);
            let [alpha, beta] = rates.radii;
            let tiny = if rates.tiny { 1.0 } else { 0.0 };
            [rates.precession, rates.frequency, alpha, beta, rates.formula_25, rates.formula_26, tiny]
        };
        Ok(collected(py, self.ensemble.len(), row)?.into_pyarray(py))
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
        let (event, motion, signal) = (event(kind, value)?, self.first()?, Signal::default());
        let times = py.detach(|| motion.events(event, between, most, &|| signal.ends_work()));
        signal.raised()?;
        Ok(times.unwrap_or_default().into_pyarray(py))
    }

    /// (order, frequency, amplitude) in the plan view and of the height, row after row; NaN and the order 0 where there
    /// is no spectrum, and why there is none of the first.
    fn spectrum<'py>(&self, py: Python<'py>, pairs: usize) -> PyResult<(Harmonics<'py>, Harmonics<'py>, Option<Told>)> {
        const ABSENT: Harmonic = Harmonic { order: 0, frequency: f64::NAN, amplitude: [f64::NAN; 2] };
        let signal = Signal::default();
        let (plan, vertical, first) = py.detach(|| {
            let (mut plan, mut vertical, mut first) = (Vec::new(), Vec::new(), None);
            for index in 0..self.ensemble.len() {
                if signal.ends_work() {
                    break;
                }
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
        signal.raised()?;
        Ok((columns(py, &plan), columns(py, &vertical), first))
    }
}

impl ExactMotions {
    fn first(&self) -> PyResult<&ExactMotion> {
        if self.ensemble.is_empty() {
            return Err(PyValueError::new_err("there is no motion"));
        }
        self.ensemble.motion(0).as_ref().map_err(|invalid| PyValueError::new_err(invalid.to_string()))
    }

    fn scattered<'py>(
        &self,
        py: Python<'py>,
        quantity: Quantity,
        times: &PyReadonlyArray1<'py, f64>,
    ) -> PyResult<Numbers<'py>> {
        let times = times.as_slice()?;
        filled(py, [self.ensemble.len(), times.len(), 3], |motions, some, out| {
            self.ensemble.fill(motions, quantity, Times::Scattered(&times[some]), out);
        })
    }

    fn each<'py, const N: usize>(
        &self,
        py: Python<'py>,
        quantity: impl Fn(&ExactMotion) -> [f64; N] + Send + Sync,
    ) -> PyResult<Numbers<'py>> {
        let row = |index: usize| self.ensemble.motion(index).as_ref().map_or([f64::NAN; N], &quantity);
        Ok(collected(py, self.ensemble.len(), row)?.into_pyarray(py))
    }
}

fn columns<'py>(py: Python<'py>, harmonics: &[Harmonic]) -> Harmonics<'py> {
    let order: Vec<_> = harmonics.iter().map(|h| h.order).collect();
    let frequency: Vec<_> = harmonics.iter().map(|h| h.frequency).collect();
    let amplitude: Vec<_> = harmonics.iter().map(|h| Complex64::new(h.amplitude[0], h.amplitude[1])).collect();
    (order.into_pyarray(py), frequency.into_pyarray(py), amplitude.into_pyarray(py))
}
