//! What a builder asks of the core: one number or a few for one pendulum.

use crate::given::{Columned, Named};
use crate::portrait::word;
use crate::signal::Signal;
use kugelpendel::{
    Cause, Decay, EnvelopeMotion, ExactMotion, Invalid, Launch, Pendulum, PrecessionBudget, settle, stretches,
};
use numpy::PyReadonlyArray1;
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;

/// How a plane swing dies away, and the pushes that hold it.
#[pyclass(frozen, module = "kugelpendel._core", name = "Decay")]
pub(crate) struct PyDecay(Decay);

#[pymethods]
impl PyDecay {
    /// Of linear drag in 1/s and quadratic drag in 1/m at an angular frequency in rad/s.
    #[new]
    fn new(linear: f64, quadratic: f64, omega0: f64) -> Self {
        Self(Decay::new(linear, quadratic, omega0))
    }

    fn rate(&self, a: f64) -> f64 {
        self.0.rate(a)
    }

    fn after(&self, a: f64, time: f64) -> f64 {
        self.0.after(a, time)
    }

    fn until(&self, a: f64, less: f64) -> f64 {
        self.0.until(a, less)
    }

    fn best_phase(&self, pendulum: [f64; 3], a: f64) -> f64 {
        kugelpendel::push::best_phase(&made(pendulum), &self.0, a)
    }

    fn holding(&self, a: f64, phase: f64) -> f64 {
        kugelpendel::push::holding(&self.0, a, phase)
    }

    fn final_amplitude(&self, push: f64, phase: f64) -> f64 {
        kugelpendel::push::final_amplitude(&self.0, push, phase)
    }
}

fn made([length, gravity, mass]: [f64; 3]) -> Pendulum {
    Pendulum { length, gravity, mass }
}

/// The averaged motion from an outer turning point: the pendulum as given (length, gravity, mass), the ellipse (a, b,
/// azimuth), and columns of what acts, with one number in each.
fn averaged(pendulum: [f64; 3], ellipse: [f64; 3], acting: &Columned<'_>) -> PyResult<EnvelopeMotion> {
    let wrong = |invalid: Invalid| PyValueError::new_err(invalid.to_string());
    let acting = Named::checked(acting, 1)?.acting()?(0);
    let effective = acting.effective_pendulum(&made(pendulum)).map_err(wrong)?;
    EnvelopeMotion::at_apsis(effective, ellipse, acting.forces(), acting.drive, 1.0).map_err(wrong)
}

/// The five shares of the plane's rate, rad/s, and the rates of a and b, m/s.
#[pyfunction]
pub(crate) fn budget_at_start(
    pendulum: [f64; 3],
    ellipse: [f64; 3],
    acting: Columned<'_>,
) -> PyResult<([f64; 5], [f64; 2])> {
    let motion = averaged(pendulum, ellipse, &acting)?;
    let (PrecessionBudget(shares), rates) = PrecessionBudget::at_start(&motion);
    Ok((shares, rates))
}

/// (verdict, from, until, turned, azimuths, widest, amplitude, dies).
type SettledRow = (&'static str, f64, f64, f64, [f64; 2], f64, f64, bool);

/// What the plane comes to with all that acts; None where the averaged motion ends before that.
#[pyfunction]
pub(crate) fn settled(
    py: Python<'_>,
    pendulum: [f64; 3],
    ellipse: [f64; 3],
    acting: Columned<'_>,
) -> PyResult<Option<SettledRow>> {
    let motion = averaged(pendulum, ellipse, &acting)?;
    let signal = Signal::default();
    let found = py.detach(|| settle(&motion, &|| signal.ends_work()));
    signal.raised()?;
    Ok(found.map(|s| (word(s.verdict), s.from, s.until, s.turned, s.azimuths, s.widest, s.amplitude, s.dies)))
}

/// (pace, start, stop, cause, against); words, and "" for no cause.
type StretchRow = (&'static str, f64, f64, &'static str, &'static str);

/// The times of one pace each: five shares to a time, row after row.
#[pyfunction]
pub(crate) fn precession_stretches(
    times: PyReadonlyArray1<'_, f64>,
    shares: PyReadonlyArray1<'_, f64>,
) -> PyResult<Vec<StretchRow>> {
    let (rows, _) = shares.as_slice()?.as_chunks::<5>();
    let budgets: Vec<_> = rows.iter().map(|row| PrecessionBudget(*row)).collect();
    let name = |cause: Option<Cause>| cause.map_or("", Cause::name);
    let found = stretches(times.as_slice()?, &budgets);
    Ok(found.iter().map(|s| (s.pace.name(), s.start, s.stop, name(s.cause), name(s.against))).collect())
}

/// The word for the pace of each time, "" where there is none: five shares to a time, row after row.
#[pyfunction]
pub(crate) fn precession_pace(shares: PyReadonlyArray1<'_, f64>) -> PyResult<Vec<&'static str>> {
    let (rows, _) = shares.as_slice()?.as_chunks::<5>();
    Ok(rows.iter().map(|row| PrecessionBudget(*row).pace().map_or("", kugelpendel::Pace::name)).collect())
}

/// The time from the closest approach to a distance from the axis, for the turning radii a and b; None where it is not passed.
#[pyfunction]
pub(crate) fn passage_time(pendulum: [f64; 3], ellipse: [f64; 2], radius: f64) -> PyResult<Option<f64>> {
    let launch = Launch::Apsides { a: ellipse[0], b: ellipse[1], azimuth: 0.0 };
    let motion =
        ExactMotion::new(made(pendulum), launch).map_err(|invalid| PyValueError::new_err(invalid.to_string()))?;
    Ok(motion.passage_time(radius))
}

/// (slowest, fastest, duration) of half a turn under damping that depends on the direction.
#[pyfunction]
pub(crate) fn under_damping(rotation: f64, anisotropy: f64) -> (f64, f64, f64) {
    let turn = kugelpendel::under_damping(rotation, anisotropy);
    (turn.slowest, turn.fastest, turn.duration)
}

#[pyfunction]
pub(crate) fn critical_damping(rotation: f64) -> f64 {
    kugelpendel::critical_damping(rotation)
}

/// For swings of the amplitude a.
#[pyfunction]
pub(crate) fn critical_anisotropy(pendulum: [f64; 3], rotation: f64, a: f64) -> f64 {
    let (length, omega0) = (pendulum[0], made(pendulum).angular_frequency());
    kugelpendel::critical_anisotropy(rotation, kugelpendel::intrinsic(omega0, (a / length) * (a / length)))
}

#[pyfunction]
pub(crate) fn critical_amplitude(pendulum: [f64; 3], rotation: f64, anisotropy: f64) -> f64 {
    kugelpendel::critical_amplitude(&made(pendulum), rotation, anisotropy)
}
