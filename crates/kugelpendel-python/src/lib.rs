//! Python bindings of the `kugelpendel` crate: flat arrays in, flat arrays out. Shapes, names and units are the Python
//! side's business.

mod envelope;
mod real;

use envelope::EnvelopeMotions;
use kugelpendel::{
    Ensemble, Equation, ExactMotion, Harmonic, HarmonicMotion, IntegratedMotion, Launch, MAX_POWER, Pendulum, Quantity,
    Times,
};
use numpy::{Complex64, IntoPyArray, PyArray1, PyArrayMethods, PyReadonlyArray1, PyReadonlyArray2, PyReadwriteArray1};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use real::RealMotions;

/// Motions in a row.
#[pyclass(frozen, module = "kugelpendel._core")]
struct ExactMotions {
    ensemble: Ensemble,
}

type Numbers<'py> = Bound<'py, PyArray1<f64>>;
type Harmonics<'py> = (Bound<'py, PyArray1<i32>>, Numbers<'py>, Bound<'py, PyArray1<Complex64>>);

/// Columns of one value for all or of one value each.
struct Columns<'a>(Vec<&'a [f64]>);

impl<'a> Columns<'a> {
    /// # Errors
    /// Another count of columns, or of rows.
    fn checked(columns: &'a [PyReadonlyArray1<'_, f64>], width: usize, rows: usize) -> PyResult<Self> {
        let columns = Self(columns.iter().map(PyReadonlyArray1::as_slice).collect::<Result<_, _>>()?);
        if columns.0.len() != width || columns.0.iter().any(|column| column.len() != 1 && column.len() != rows) {
            return Err(PyValueError::new_err(format!("this takes {width} columns of 1 or {rows} numbers")));
        }
        Ok(columns)
    }

    fn row<const N: usize>(&self, index: usize) -> [f64; N] {
        std::array::from_fn(|k| if self.0[k].len() == 1 { self.0[k][0] } else { self.0[k][index] })
    }
}

/// Makes the launch of one row.
type Launcher = fn(&Columns<'_>, usize) -> Launch;

/// What turns a row of numbers into a launch of the given kind, and how many numbers it takes.
fn launcher(kind: &str) -> Option<(usize, Launcher)> {
    Some(match kind {
        "ellipse" => (3, |columns, i| {
            let [a, b, azimuth] = columns.row(i);
            Launch::Ellipse { a, b, azimuth }
        }),
        "apsides" => (3, |columns, i| {
            let [a, b, azimuth] = columns.row(i);
            Launch::Apsides { a, b, azimuth }
        }),
        "plane" => (4, |columns, i| {
            let [x, y, vx, vy] = columns.row(i);
            Launch::Plane { x, y, vx, vy }
        }),
        "angles" => (4, |columns, i| {
            let [theta, phi, theta_rate, phi_rate] = columns.row(i);
            Launch::Angles { theta, phi, theta_rate, phi_rate }
        }),
        "state" => (6, |columns, i| {
            let [x, y, z, vx, vy, vz] = columns.row(i);
            Launch::State { position: [x, y, z], velocity: [vx, vy, vz] }
        }),
        _ => return None,
    })
}

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
        let (width, launch) =
            launcher(kind).ok_or_else(|| PyValueError::new_err(format!("there is no launch of kind {kind:?}")))?;
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

    /// Index and sentence of each bad case.
    fn problems(&self) -> Vec<(usize, String)> {
        self.ensemble.problems().map(|(index, invalid)| (index, invalid.to_string())).collect()
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
    /// is no spectrum, and why.
    fn spectrum<'py>(&self, py: Python<'py>, pairs: usize) -> (Harmonics<'py>, Harmonics<'py>, Vec<(usize, String)>) {
        const ABSENT: Harmonic = Harmonic { order: 0, frequency: f64::NAN, amplitude: [f64::NAN; 2] };
        let (mut plan, mut vertical, mut problems) = (Vec::new(), Vec::new(), Vec::new());
        for index in 0..self.ensemble.len() {
            match self.ensemble.motion(index).clone().and_then(|motion| motion.spectrum(pairs)) {
                Ok(spectrum) => {
                    plan.extend(spectrum.plan);
                    vertical.extend(spectrum.vertical);
                }
                Err(reason) => {
                    problems.push((index, reason.to_string()));
                    plan.extend(vec![ABSENT; 2 * pairs]);
                    vertical.extend(vec![ABSENT; pairs + 1]);
                }
            }
        }
        (columns(py, &plan), columns(py, &vertical), problems)
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

    fn each<'py, const N: usize>(&self, py: Python<'py>, quantity: impl Fn(&ExactMotion) -> [f64; N]) -> Numbers<'py> {
        self.ensemble.map(quantity).into_pyarray(py)
    }
}

fn columns<'py>(py: Python<'py>, harmonics: &[Harmonic]) -> Harmonics<'py> {
    let order: Vec<_> = harmonics.iter().map(|h| h.order).collect();
    let frequency: Vec<_> = harmonics.iter().map(|h| h.frequency).collect();
    let amplitude: Vec<_> = harmonics.iter().map(|h| Complex64::new(h.amplitude[0], h.amplitude[1])).collect();
    (order.into_pyarray(py), frequency.into_pyarray(py), amplitude.into_pyarray(py))
}

/// Turning figures of a few harmonics in a row.
#[pyclass(frozen, module = "kugelpendel._core")]
struct HarmonicMotions {
    motions: Vec<HarmonicMotion>,
}

#[pymethods]
impl HarmonicMotions {
    /// `rows`: length, frequency, precession, apsis time and azimuth, then the powers of the inner and of the outer part.
    #[new]
    fn new(rows: PyReadonlyArray2<'_, f64>) -> PyResult<Self> {
        const WIDTH: usize = 5 + 2 * (MAX_POWER + 1);
        let rows = rows.as_array();
        if rows.ncols() != WIDTH {
            return Err(PyValueError::new_err(format!("a row takes {WIDTH} numbers, not {}", rows.ncols())));
        }
        let motions = rows.rows().into_iter().map(|row| HarmonicMotion {
            length: row[0],
            frequency: row[1],
            precession: row[2],
            apsis_time: row[3],
            apsis_azimuth: row[4],
            inner: std::array::from_fn(|k| row[5 + k]),
            outer: std::array::from_fn(|k| row[5 + MAX_POWER + 1 + k]),
        });
        Ok(Self { motions: motions.collect() })
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

/// Positions (or velocities) by one of the paper's equations from one launch, or the time at which it ends.
#[pyfunction]
#[pyo3(signature = (pendulum, equation, launch, times, velocity))]
fn integrated<'py>(
    py: Python<'py>,
    pendulum: [f64; 3],
    equation: &str,
    launch: [f64; 4],
    times: PyReadonlyArray1<'py, f64>,
    velocity: bool,
) -> PyResult<(Numbers<'py>, Option<f64>)> {
    let motion = integrated_motion(pendulum, equation, launch)?;
    let quantity = if velocity { Quantity::Velocity } else { Quantity::Position };
    let (times, mut end) = (times.as_slice()?, None);
    let array = new_array(py, 3 * times.len(), |out| {
        out.fill(f64::NAN);
        end = motion.fill(quantity, times, out).err();
    });
    Ok((array, end))
}

/// The times between which such a motion holds, if it ends within `period`.
#[pyfunction]
fn integrated_span(pendulum: [f64; 3], equation: &str, launch: [f64; 4], period: f64) -> PyResult<[f64; 2]> {
    Ok(integrated_motion(pendulum, equation, launch)?.span(period))
}

fn integrated_motion(pendulum: [f64; 3], equation: &str, launch: [f64; 4]) -> PyResult<IntegratedMotion> {
    let [length, gravity, mass] = pendulum;
    let equation = match equation {
        "plane" => Equation::Plane,
        "cubic" => Equation::Cubic,
        _ => return Err(PyValueError::new_err(format!("there is no equation {equation:?}"))),
    };
    Ok(IntegratedMotion { pendulum: Pendulum { length, gravity, mass }, equation, launch })
}

/// A new array, filled without holding the interpreter.
fn new_array<'py>(py: Python<'py>, size: usize, fill: impl FnOnce(&mut [f64]) + Send) -> Numbers<'py> {
    // SAFETY: every element is written by `fill` before anyone else sees the array.
    let array = unsafe { PyArray1::<f64>::new(py, size, false) };
    // SAFETY: nobody else has the array yet.
    let out = unsafe { array.as_slice_mut() }.unwrap_or_default();
    py.detach(|| fill(out));
    array
}

/// The sentence that says what is wrong with a pendulum, if anything is.
#[pyfunction]
fn pendulum_problem(length: f64, gravity: f64, mass: f64) -> Option<String> {
    Pendulum { length, gravity, mass }.check().err().map(|invalid| invalid.to_string())
}

/// The compiled part of the Python package.
#[pymodule]
mod _core {
    #[pymodule_export]
    use super::{
        EnvelopeMotions, ExactMotions, HarmonicMotions, RealMotions, integrated, integrated_span, pendulum_problem,
    };
}
