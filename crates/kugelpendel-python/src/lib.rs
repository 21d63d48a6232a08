//! Python bindings of the `kugelpendel` crate: flat arrays in, flat arrays out. Shapes, names and units are the Python
//! side's business.

mod apsides;
mod builder;
mod columns;
mod envelope;
mod exact;
mod given;
mod harmonic;
mod integrated;
mod meaning;
mod portrait;
mod real;
mod signal;
mod stepped;

use pyo3::prelude::*;

/// How many steps of integration this process has taken so far, in all motions together.
#[pyfunction]
fn steps_taken() -> u64 {
    kugelpendel::steps_taken()
}

/// The compiled part of the Python package.
#[pymodule]
mod _core {
    /// Ω_E, rad/s: of the Earth against the stars.
    #[pymodule_export]
    const ROTATION: f64 = kugelpendel::ROTATION;
    #[pymodule_export]
    use super::steps_taken;
    #[pymodule_export]
    use crate::apsides::{ApsidesTracker, plane_rates};
    #[pymodule_export]
    use crate::builder::{
        PyDecay, budget_at_start, critical_amplitude, critical_anisotropy, critical_damping, passage_time,
        precession_pace, precession_stretches, settled, under_damping,
    };
    #[pymodule_export]
    use crate::columns::extent;
    #[pymodule_export]
    use crate::envelope::{EnvelopeMotions, averaged_fundamentals};
    #[pymodule_export]
    use crate::exact::ExactMotions;
    #[pymodule_export]
    use crate::given::{derived, launch_problem, pendulum_problem, problem, problem_kinds};
    #[pymodule_export]
    use crate::harmonic::HarmonicMotions;
    #[pymodule_export]
    use crate::integrated::IntegratedMotions;
    #[pymodule_export]
    use crate::meaning::{
        distances, events_on_a_grid, judged_radii, measured_rates, olsson_frequency, olsson_precession,
        osculating_ellipses, reach, relative_error, thread_pull, unwrapped,
    };
    #[pymodule_export]
    use crate::portrait::Portraits;
    #[pymodule_export]
    use crate::real::RealMotions;
    use pyo3::prelude::*;

    /// Finds NumPy's own module while an interruption is still an exception: in the first array it would be a panic.
    #[pymodule_init]
    fn find_numpy(module: &Bound<'_, PyModule>) -> PyResult<()> {
        numpy::get_array_module(module.py()).map(|_| ())
    }
}
