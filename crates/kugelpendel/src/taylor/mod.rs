//! Integration by Taylor series, and the zeros of functions of a step.

pub(crate) mod events;
pub(crate) mod series;
