//! Integration by Taylor series: a step, the events within it, and the walk from step to step.

pub(crate) mod events;
pub(crate) mod series;
pub(crate) mod step;
pub(crate) mod walk;
