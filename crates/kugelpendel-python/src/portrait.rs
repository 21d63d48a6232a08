//! The portrait on the sphere, for the swings of one size in one clamp.

use crate::columns::Numbers;
use crate::signal::collected;
use kugelpendel::{EllipseForm, Orbit, Verdict};
use numpy::{IntoPyArray, PyReadonlyArray1};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;

/// One size of swing.
#[pyclass(frozen, module = "kugelpendel._core")]
pub(crate) struct Portraits(kugelpendel::Portrait);

/// (invariant, limits, verdict, period, rate, slowest, fastest, azimuths), as the core has them.
type OrbitRow = (f64, [f64; 2], &'static str, f64, f64, f64, f64, [f64; 2]);

/// The word for a verdict.
pub(crate) fn word(verdict: Verdict) -> &'static str {
    match verdict {
        Verdict::Round => "round",
        Verdict::ToAndFro => "to and fro",
        Verdict::Stands => "stands",
    }
}

#[pymethods]
impl Portraits {
    /// Ω_z, δ (the true difference of the frequencies), χ, μ; rad/s and rad.
    #[new]
    fn new(rotation: f64, anisotropy: f64, axis: f64, intrinsic: f64) -> Self {
        Self(kugelpendel::Portrait { rotation, anisotropy, axis, intrinsic })
    }

    /// Of all ellipses with the a² + b² of the given one, m.
    #[staticmethod]
    fn of(pendulum: [f64; 3], rotation: f64, suspension: [f64; 2], ellipse: [f64; 2]) -> Self {
        let [length, gravity, mass] = pendulum;
        let [anisotropy, axis] = suspension;
        let forces = kugelpendel::Forces { rotation: [0.0, rotation], anisotropy, axis, ..Default::default() };
        let pendulum = kugelpendel::Pendulum { length, gravity, mass };
        Self(kugelpendel::Portrait::new(&pendulum, &forces, ellipse[0], ellipse[1]))
    }

    /// Ω_z, δ, χ, μ.
    fn values(&self) -> [f64; 4] {
        [self.0.rotation, self.0.anisotropy, self.0.axis, self.0.intrinsic]
    }

    /// Circularity and longitude of an ellipse.
    fn form(&self, a: f64, b: f64, azimuth: f64) -> [f64; 2] {
        let form = self.0.form(a, b, azimuth);
        [form.circularity, form.longitude]
    }

    /// a and b over √(a² + b²) of an ellipse of some circularity.
    #[staticmethod]
    fn semi_axes(circularity: f64) -> [f64; 2] {
        EllipseForm { circularity, longitude: 0.0 }.semi_axes()
    }

    fn orbit(&self, circularity: f64, longitude: f64) -> OrbitRow {
        let Orbit { invariant, limits, verdict, period, rate, slowest, fastest, azimuths } =
            self.0.orbit(EllipseForm { circularity, longitude });
        (invariant, limits, word(verdict), period, rate, slowest, fastest, azimuths)
    }

    /// Circularities and longitudes along the orbit.
    fn path<'py>(
        &self,
        py: Python<'py>,
        circularity: f64,
        longitude: f64,
        count: usize,
    ) -> (Numbers<'py>, Numbers<'py>) {
        let path = self.0.path(EllipseForm { circularity, longitude }, count);
        let column = |number: fn(&EllipseForm) -> f64| path.iter().map(number).collect::<Vec<_>>().into_pyarray(py);
        (column(|form| form.circularity), column(|form| form.longitude))
    }

    /// H at many places.
    fn invariants<'py>(
        &self,
        py: Python<'py>,
        circularity: PyReadonlyArray1<'py, f64>,
        longitude: PyReadonlyArray1<'py, f64>,
    ) -> PyResult<Numbers<'py>> {
        self.each(py, &circularity, &longitude, |portrait, form| portrait.invariant(form))
    }

    /// The mean rate of the plane from many places: 0 where it does not go round.
    fn rates<'py>(
        &self,
        py: Python<'py>,
        circularity: PyReadonlyArray1<'py, f64>,
        longitude: PyReadonlyArray1<'py, f64>,
    ) -> PyResult<Numbers<'py>> {
        self.each(py, &circularity, &longitude, |portrait, form| portrait.orbit(form).rate)
    }

    /// (circularity, longitude, stable) of each shape that stays as it is.
    fn equilibria(&self) -> Vec<(f64, f64, bool)> {
        let found = self.0.equilibria();
        found.iter().map(|each| (each.form.circularity, each.form.longitude, each.stable)).collect()
    }
}

impl Portraits {
    fn each<'py>(
        &self,
        py: Python<'py>,
        circularity: &PyReadonlyArray1<'py, f64>,
        longitude: &PyReadonlyArray1<'py, f64>,
        number: impl Fn(&kugelpendel::Portrait, EllipseForm) -> f64 + Send + Sync,
    ) -> PyResult<Numbers<'py>> {
        let (circularity, longitude) = (circularity.as_slice()?, longitude.as_slice()?);
        if circularity.len() != longitude.len() {
            return Err(PyValueError::new_err("as many longitudes as circularities"));
        }
        let row = |index: usize| {
            [number(&self.0, EllipseForm { circularity: circularity[index], longitude: longitude[index] })]
        };
        Ok(collected(py, circularity.len(), row)?.into_pyarray(py))
    }
}
