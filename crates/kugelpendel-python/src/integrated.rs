//! Motions by the paper's equations (12) and (13), integrated.

use crate::columns::{Numbers, new_array};
use kugelpendel::{Equation, IntegratedMotion, Pendulum, Quantity};
use numpy::PyReadonlyArray1;
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;

/// Positions (or velocities) by one of the paper's equations from one launch, or the time at which it ends.
#[pyfunction]
#[pyo3(signature = (pendulum, equation, launch, times, velocity))]
pub(crate) fn integrated<'py>(
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
pub(crate) fn integrated_span(pendulum: [f64; 3], equation: &str, launch: [f64; 4], period: f64) -> PyResult<[f64; 2]> {
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
