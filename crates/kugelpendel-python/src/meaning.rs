//! What a motion means: flat arrays in, flat arrays out; a motion of Python's is asked by calling it.

use crate::columns::{Columns, Numbers};
use crate::signal::{Signal, collected};
use kugelpendel::{Ellipse, Event, Pendulum, StateVector, olsson};
use numpy::{IntoPyArray, PyArray1, PyReadonlyArray1, PyReadonlyArray2};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use std::f64::consts::PI;

/// Ellipses that are found between two looks at whether a signal has come; an exact motion is solved for each.
const ELLIPSES_TOGETHER: usize = 1 << 14;

/// The event of this name; the value is the azimuth in rad or the radius in m where it takes one.
pub(crate) fn event(kind: &str, value: f64) -> PyResult<Event> {
    Ok(match kind {
        "outer" => Event::Outer,
        "inner" => Event::Inner,
        "bottom" => Event::Bottom,
        "azimuth" => Event::Azimuth(value),
        "radius" => Event::Radius(value),
        "slack" => Event::Slack,
        "taut" => Event::Taut,
        _ => return Err(PyValueError::new_err(format!("there is no event {kind:?}"))),
    })
}

/// The precession by Olsson's (25): columns a, b, length, gravity, each of length 1 or `count`.
#[pyfunction]
pub(crate) fn olsson_precession<'py>(
    py: Python<'py>,
    count: usize,
    columns: Vec<PyReadonlyArray1<'py, f64>>,
) -> PyResult<Numbers<'py>> {
    by_olsson(py, count, &columns, olsson::precession)
}

/// The frequency by Olsson's (26), likewise.
#[pyfunction]
pub(crate) fn olsson_frequency<'py>(
    py: Python<'py>,
    count: usize,
    columns: Vec<PyReadonlyArray1<'py, f64>>,
) -> PyResult<Numbers<'py>> {
    by_olsson(py, count, &columns, olsson::frequency)
}

fn by_olsson<'py>(
    py: Python<'py>,
    count: usize,
    columns: &[PyReadonlyArray1<'py, f64>],
    formula: fn(f64, f64, &Pendulum) -> f64,
) -> PyResult<Numbers<'py>> {
    let columns = Columns::checked(columns, 4, count)?;
    let rate = |index: usize| {
        let [a, b, length, gravity] = columns.row(index);
        let rate = formula(a, b, &Pendulum { length, gravity, mass: 1.0 });
        [if length > 0.0 && gravity > 0.0 && rate.is_finite() { rate } else { f64::NAN }]
    };
    Ok(collected(py, count, rate)?.into_pyarray(py))
}

/// Osculating ellipses of `count` motions at the same times: a, b and the azimuth, continuous along the times of each.
///
/// Columns length, gravity, mass and rotation of the ground; positions and velocities motion after motion, time after
/// time.
#[pyfunction]
pub(crate) fn osculating_ellipses<'py>(
    py: Python<'py>,
    count: usize,
    columns: Vec<PyReadonlyArray1<'py, f64>>,
    positions: PyReadonlyArray1<'py, f64>,
    velocities: PyReadonlyArray1<'py, f64>,
    times: PyReadonlyArray1<'py, f64>,
) -> PyResult<(Numbers<'py>, Numbers<'py>, Numbers<'py>)> {
    let columns = Columns::checked(&columns, 4, count)?;
    let (positions, velocities, times) = (positions.as_slice()?, velocities.as_slice()?, times.as_slice()?);
    let size = count * times.len();
    if positions.len() != 3 * size || velocities.len() != 3 * size {
        return Err(PyValueError::new_err("positions, velocities and times do not go together"));
    }
    let triple = |numbers: &[f64], index: usize| std::array::from_fn(|k| numbers[3 * index + k]);
    let signal = Signal::default();
    let (axes, azimuth) = py.detach(|| {
        let case = |index: usize| {
            let [length, gravity, mass, rotation] = columns.row(index / times.len());
            (Pendulum { length, gravity, mass }, triple(positions, index), triple(velocities, index), rotation)
        };
        let mut ellipses = Vec::with_capacity(size);
        for first in (0..size).step_by(ELLIPSES_TOGETHER) {
            let together = ELLIPSES_TOGETHER.min(size - first);
            ellipses.extend(Ellipse::osculating(together, |index| case(first + index)));
            if signal.ends_work() {
                return Default::default();
            }
        }
        let mut azimuths: Vec<f64> = ellipses.iter().map(|ellipse| ellipse.azimuth).collect();
        if !times.is_empty() {
            azimuths.chunks_exact_mut(times.len()).for_each(|row| kugelpendel::unwrap_at(times, row, PI));
        }
        let axes: (Vec<_>, Vec<_>) = ellipses.iter().map(|ellipse| (ellipse.a, ellipse.b)).unzip();
        (axes, azimuths)
    });
    signal.raised()?;
    Ok((axes.0.into_pyarray(py), axes.1.into_pyarray(py), azimuth.into_pyarray(py)))
}

/// The pull of the thread at positions and velocities, motion after motion: columns length, gravity, mass.
#[pyfunction]
pub(crate) fn thread_pull<'py>(
    py: Python<'py>,
    count: usize,
    columns: Vec<PyReadonlyArray1<'py, f64>>,
    positions: PyReadonlyArray1<'py, f64>,
    velocities: PyReadonlyArray1<'py, f64>,
) -> PyResult<Numbers<'py>> {
    let columns = Columns::checked(&columns, 3, count)?;
    let (positions, velocities) = (positions.as_slice()?, velocities.as_slice()?);
    if positions.len() != velocities.len() || !positions.len().is_multiple_of(3 * count.max(1)) {
        return Err(PyValueError::new_err("positions and velocities do not go together"));
    }
    let (size, each) = (positions.len() / 3, positions.len() / 3 / count.max(1));
    let triple = |numbers: &[f64], index: usize| std::array::from_fn(|k| numbers[3 * index + k]);
    let pull = |index: usize| {
        let [length, gravity, mass] = columns.row(index / each);
        [Pendulum { length, gravity, mass }.pull(triple(positions, index), triple(velocities, index))]
    };
    Ok(collected(py, size, pull)?.into_pyarray(py))
}

/// Angles in order, continuous by whole periods; the first follows `start` where that is given.
#[pyfunction]
#[pyo3(signature = (angles, period, start = None))]
pub(crate) fn unwrapped<'py>(
    py: Python<'py>,
    angles: PyReadonlyArray1<'py, f64>,
    period: f64,
    start: Option<f64>,
) -> PyResult<Numbers<'py>> {
    let mut angles = angles.as_slice()?.to_vec();
    kugelpendel::unwrap(&mut angles, period, start);
    Ok(angles.into_pyarray(py))
}

/// Distances between two rows of points, three numbers each.
#[pyfunction]
pub(crate) fn distances<'py>(
    py: Python<'py>,
    positions: PyReadonlyArray1<'py, f64>,
    truth: PyReadonlyArray1<'py, f64>,
) -> PyResult<Numbers<'py>> {
    Ok(kugelpendel::distances(positions.as_slice()?, truth.as_slice()?).into_pyarray(py))
}

/// The relative error of an approximate value; none where the true one is 0.
#[pyfunction]
pub(crate) fn relative_error(approximate: f64, truth: f64) -> Option<f64> {
    kugelpendel::relative_error(approximate, truth)
}

/// Up to which of the ascending sizes no error exceeds a level: 0 for none, infinite for all.
#[pyfunction]
pub(crate) fn reach(sizes: PyReadonlyArray1<'_, f64>, worst: PyReadonlyArray1<'_, f64>, level: f64) -> PyResult<f64> {
    let (sizes, worst) = (sizes.as_slice()?, worst.as_slice()?);
    if sizes.len() != worst.len() {
        return Err(PyValueError::new_err("sizes and errors do not go together"));
    }
    Ok(kugelpendel::reach(sizes, worst, level))
}

/// The turning radii by which ellipses are judged, three numbers to each: columns a, b, length.
#[pyfunction]
pub(crate) fn judged_radii<'py>(
    py: Python<'py>,
    count: usize,
    columns: Vec<PyReadonlyArray1<'py, f64>>,
) -> PyResult<Numbers<'py>> {
    let columns = Columns::checked(&columns, 3, count)?;
    let radii = |index: usize| {
        let [a, b, length] = columns.row(index);
        kugelpendel::EllipseRates::radii(a, b, length)
    };
    Ok(collected(py, count, radii)?.into_pyarray(py))
}

/// Frequency and precession as a motion shows them: `states` gives positions and velocities at ascending times.
#[pyfunction]
pub(crate) fn measured_rates(states: &Bound<'_, PyAny>, half_swing: f64) -> PyResult<(Option<f64>, Option<f64>)> {
    let plan = |times: &[f64]| -> PyResult<Vec<[f64; 4]>> {
        let plan = |StateVector { position: [x, y, _], velocity: [vx, vy, _] }| [x, y, vx, vy];
        Ok(asked(states, times)?.into_iter().map(plan).collect())
    };
    let rates = kugelpendel::measured_rates(half_swing, plan)?;
    Ok((rates.frequency, rates.precession))
}

/// Times of an event of a motion that is asked likewise.
#[pyfunction]
#[allow(clippy::too_many_arguments)]
pub(crate) fn events_on_a_grid<'py>(
    states: &Bound<'py, PyAny>,
    kind: &str,
    value: f64,
    between: [f64; 2],
    span: [f64; 2],
    step: f64,
    most: usize,
    pendulum: [f64; 3],
) -> PyResult<Numbers<'py>> {
    let [length, gravity, mass] = pendulum;
    let pendulum = Pendulum { length, gravity, mass };
    let found = kugelpendel::events_on_a_grid(event(kind, value)?, between, span, step, most, &pendulum, |times| {
        states.py().check_signals()?;
        asked(states, times)
    })?;
    Ok(found.into_pyarray(states.py()))
}

/// What a callable of Python's says: positions and velocities, (n, 3) each.
fn asked(states: &Bound<'_, PyAny>, times: &[f64]) -> PyResult<Vec<StateVector>> {
    if times.is_empty() {
        return Ok(Vec::new());
    }
    let given = states.call1((PyArray1::from_slice(states.py(), times),))?;
    let (positions, velocities): (PyReadonlyArray2<'_, f64>, PyReadonlyArray2<'_, f64>) = given.extract()?;
    let (positions, velocities) = (positions.as_array(), velocities.as_array());
    if positions.dim() != (times.len(), 3) || velocities.dim() != (times.len(), 3) {
        return Err(PyValueError::new_err("positions and velocities must be (n, 3)"));
    }
    let state = |(x, v): (numpy::ndarray::ArrayView1<'_, f64>, numpy::ndarray::ArrayView1<'_, f64>)| StateVector {
        position: [x[0], x[1], x[2]],
        velocity: [v[0], v[1], v[2]],
    };
    Ok(positions.rows().into_iter().zip(velocities.rows()).map(state).collect())
}
