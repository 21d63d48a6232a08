//! The closed form: a motion, many of them, at one time and at many.

pub(crate) mod chart;
pub(crate) mod ensemble;
pub(crate) mod invariants;
pub(crate) mod motion;
pub(crate) mod phase;
pub(crate) mod plan;
pub(crate) mod sampling;
pub(crate) mod spectrum;
pub(crate) mod tension;
pub(crate) mod theta;
