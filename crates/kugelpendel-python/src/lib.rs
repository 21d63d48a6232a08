//! Python bindings of the `kugelpendel` crate: flat arrays in, flat arrays out. Shapes, names and units are the Python
//! side's business.

mod builder;
mod columns;
mod envelope;
mod exact;
mod given;
mod harmonic;
mod integrated;
mod portrait;
mod real;

use pyo3::prelude::*;

/// The compiled part of the Python package.
#[pymodule]
mod _core {
    /// Ω_E, rad/s: of the Earth against the stars.
    #[pymodule_export]
    const ROTATION: f64 = kugelpendel::ROTATION;
    #[pymodule_export]
    use crate::builder::{
        PyDecay, budget_at_start, critical_amplitude, critical_anisotropy, critical_damping, passage_time,
        precession_pace, precession_stretches, settled, under_damping,
    };
    #[pymodule_export]
    use crate::envelope::EnvelopeMotions;
    #[pymodule_export]
    use crate::exact::ExactMotions;
    #[pymodule_export]
    use crate::given::{derived, launch_problem, pendulum_problem, problem, problem_kinds};
    #[pymodule_export]
    use crate::harmonic::HarmonicMotions;
    #[pymodule_export]
    use crate::integrated::{integrated, integrated_span};
    #[pymodule_export]
    use crate::portrait::Portrait;
    #[pymodule_export]
    use crate::real::RealMotions;
}
