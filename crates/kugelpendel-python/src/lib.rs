//! Python bindings of the `kugelpendel` crate.

use pyo3::prelude::*;

/// The compiled part of the Python package.
#[pymodule]
mod _core {}
