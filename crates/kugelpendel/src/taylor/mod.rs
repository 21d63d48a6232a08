//! Integration by Taylor series: a step, the events within it, the walk from step to step, and what is read on the way.

pub(crate) mod events;
pub(crate) mod layout;
pub(crate) mod products;
pub(crate) mod reach;
pub(crate) mod series;
pub(crate) mod step;
pub(crate) mod sweep;
pub(crate) mod walk;
