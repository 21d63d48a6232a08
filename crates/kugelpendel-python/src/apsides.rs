//! The outer turning points of a real motion: flat arrays in, flat arrays out.

use crate::columns::Numbers;
use crate::signal::lock;
use kugelpendel::{Pendulum, StateVector};
use numpy::{IntoPyArray, PyReadonlyArray1};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use std::sync::Mutex;

/// What is noted at the outer turning points.
#[pyclass(frozen, module = "kugelpendel._core")]
pub(crate) struct ApsidesTracker(Mutex<kugelpendel::ApsidesTrack>);

#[pymethods]
impl ApsidesTracker {
    /// Length, gravity and mass of the pendulum, and the rate at which the ground turns about the vertical.
    #[new]
    fn new(pendulum: [f64; 3], rotation: f64) -> Self {
        let [length, gravity, mass] = pendulum;
        Self(Mutex::new(kugelpendel::ApsidesTrack::new(Pendulum { length, gravity, mass }, rotation)))
    }

    /// The next turning points: n times, 3n numbers of position and of velocity.
    fn add(
        &self,
        py: Python<'_>,
        times: PyReadonlyArray1<'_, f64>,
        position: PyReadonlyArray1<'_, f64>,
        velocity: PyReadonlyArray1<'_, f64>,
    ) -> PyResult<()> {
        let (times, position, velocity) = (times.as_slice()?, position.as_slice()?, velocity.as_slice()?);
        if position.len() != 3 * times.len() || velocity.len() != 3 * times.len() {
            return Err(PyValueError::new_err("times, positions and velocities do not go together"));
        }
        py.detach(|| {
            let points = position.chunks_exact(3).zip(velocity.chunks_exact(3)).zip(times);
            let passages: Vec<_> = points
                .map(|((r, v), time)| {
                    (*time, StateVector { position: [r[0], r[1], r[2]], velocity: [v[0], v[1], v[2]] })
                })
                .collect();
            lock(&self.0).add(&passages);
        });
        Ok(())
    }

    /// Time, a, b and azimuth of the turning points kept, four numbers to each.
    fn track<'py>(&self, py: Python<'py>) -> Numbers<'py> {
        let track = lock(&self.0).track();
        let rows: Vec<f64> = track.iter().flat_map(|apsis| [apsis.time, apsis.a, apsis.b, apsis.azimuth]).collect();
        rows.into_pyarray(py)
    }

    /// The largest |b|, the least |b|/a, and the periods of the first and the last swing.
    fn extremes(&self) -> (f64, f64, f64, f64) {
        let track = lock(&self.0);
        let [first, last] = track.swing_periods();
        (track.widest(), track.flattest(), first, last)
    }
}

/// The mean rate of an azimuth, that at the end, and since when it stands beside Foucault's rate, if it does.
#[pyfunction]
pub(crate) fn plane_rates(
    times: PyReadonlyArray1<'_, f64>,
    azimuths: PyReadonlyArray1<'_, f64>,
    foucault: f64,
) -> PyResult<(f64, f64, Option<f64>)> {
    let (times, azimuths) = (times.as_slice()?, azimuths.as_slice()?);
    if times.len() != azimuths.len() {
        return Err(PyValueError::new_err("times and azimuths do not go together"));
    }
    Ok((
        kugelpendel::mean_rate(times, azimuths),
        kugelpendel::rate_at_the_end(times, azimuths),
        kugelpendel::stands_since(times, azimuths, foucault),
    ))
}
