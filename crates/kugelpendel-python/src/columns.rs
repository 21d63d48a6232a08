//! Columns of numbers on their way in, and new arrays on their way out.

use kugelpendel::Launch;
use numpy::{PyArray1, PyArrayMethods, PyReadonlyArray1};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;

pub(crate) type Numbers<'py> = Bound<'py, PyArray1<f64>>;

/// The smallest and the largest of some numbers, 0 and 0 of none; nothing where one of them is not finite.
#[pyfunction]
pub(crate) fn extent(numbers: PyReadonlyArray1<'_, f64>) -> PyResult<Option<(f64, f64)>> {
    /// Numbers side by side, so that one comparison need not wait for the other.
    const LANES: usize = 8;
    let numbers = numbers.as_slice()?;
    let first = numbers.first().copied().unwrap_or_default();
    let (mut least, mut most, mut finite) = ([first; LANES], [first; LANES], [0.0; LANES]);
    let (chunks, rest) = numbers.as_chunks::<LANES>();
    let mut look = |chunk: &[f64; LANES]| {
        for (lane, &number) in chunk.iter().enumerate() {
            least[lane] = if number < least[lane] { number } else { least[lane] };
            most[lane] = if number > most[lane] { number } else { most[lane] };
            // Anything but 0 once a number is not finite.
            finite[lane] += number * 0.0;
        }
    };
    chunks.iter().for_each(&mut look);
    let mut last = [first; LANES];
    last[..rest.len()].copy_from_slice(rest);
    look(&last);
    let is_finite = finite == [0.0; LANES];
    let (least, most) = (least.into_iter().fold(first, f64::min), most.into_iter().fold(first, f64::max));
    Ok(is_finite.then_some((least, most)))
}

/// # Errors
/// An unknown kind.
pub(crate) fn known_launcher(kind: &str) -> PyResult<(usize, Launcher)> {
    launcher(kind).ok_or_else(|| PyValueError::new_err(format!("there is no launch of kind {kind:?}")))
}

/// Columns of one value for all or of one value each.
pub(crate) struct Columns<'a>(Vec<&'a [f64]>);

impl<'a> Columns<'a> {
    /// # Errors
    /// Another count of columns, or of rows.
    pub(crate) fn checked(columns: &'a [PyReadonlyArray1<'_, f64>], width: usize, rows: usize) -> PyResult<Self> {
        Self::of(columns.iter().map(PyReadonlyArray1::as_slice).collect::<Result<_, _>>()?, width, rows)
    }

    /// # Errors
    /// As [`Self::checked`].
    pub(crate) fn of(columns: Vec<&'a [f64]>, width: usize, rows: usize) -> PyResult<Self> {
        if columns.len() != width || columns.iter().any(|column| column.len() != 1 && column.len() != rows) {
            return Err(PyValueError::new_err(format!("this takes {width} columns of 1 or {rows} numbers")));
        }
        Ok(Self(columns))
    }

    pub(crate) fn row<const N: usize>(&self, index: usize) -> [f64; N] {
        std::array::from_fn(|k| if self.0[k].len() == 1 { self.0[k][0] } else { self.0[k][index] })
    }
}

/// Makes the launch of one row.
pub(crate) type Launcher = fn(&Columns<'_>, usize) -> Launch;

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
        "at_rest" => (2, |columns, i| {
            let [theta, phi] = columns.row(i);
            Launch::Angles { theta, phi, theta_rate: 0.0, phi_rate: 0.0 }
        }),
        "state" => (6, |columns, i| {
            let [x, y, z, vx, vy, vz] = columns.row(i);
            Launch::State { position: [x, y, z], velocity: [vx, vy, vz] }
        }),
        _ => return None,
    })
}

/// A new array, filled without holding the interpreter.
pub(crate) fn new_array<'py>(py: Python<'py>, size: usize, fill: impl FnOnce(&mut [f64]) + Send) -> Numbers<'py> {
    // SAFETY: every element is written by `fill` before anyone else sees the array.
    let array = unsafe { PyArray1::<f64>::new(py, size, false) };
    // SAFETY: nobody else has the array yet.
    let out = unsafe { array.as_slice_mut() }.unwrap_or_default();
    py.detach(|| fill(out));
    array
}
