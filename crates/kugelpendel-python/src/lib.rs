//! Python bindings of the `kugelpendel` crate: flat arrays in, flat arrays out. Shapes, names and units are the Python
//! side's business.

mod apsides;
mod columns;
mod envelope;
mod exact;
mod harmonic;
mod integrated;
mod meaning;
mod real;
mod signal;
mod stepped;

use kugelpendel::Pendulum;
use pyo3::prelude::*;

/// The sentence that says what is wrong with a pendulum, if anything is.
#[pyfunction]
fn pendulum_problem(length: f64, gravity: f64, mass: f64) -> Option<String> {
    Pendulum { length, gravity, mass }.check().err().map(|invalid| invalid.to_string())
}

/// How many steps of integration this process has taken so far, in all motions together.
#[pyfunction]
fn steps_taken() -> u64 {
    kugelpendel::steps_taken()
}

/// The compiled part of the Python package.
#[pymodule]
mod _core {
    #[pymodule_export]
    use super::pendulum_problem;
    #[pymodule_export]
    use super::steps_taken;
    #[pymodule_export]
    use crate::apsides::{ApsidesTrack, plane_rates};
    #[pymodule_export]
    use crate::envelope::EnvelopeMotions;
    #[pymodule_export]
    use crate::exact::ExactMotions;
    #[pymodule_export]
    use crate::harmonic::HarmonicMotions;
    #[pymodule_export]
    use crate::integrated::IntegratedMotions;
    #[pymodule_export]
    use crate::meaning::{
        distances, events_on_a_grid, measured_rates, olsson_frequency, olsson_precession, osculating_ellipses, reach,
        relative_error, thread_pull, unwrapped, widened,
    };
    #[pymodule_export]
    use crate::real::RealMotions;
}
