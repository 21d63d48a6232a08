//! What is given: pendulum, launch, forces, times; and what is said when it makes no sense.

pub(crate) mod forces;
pub(crate) mod invalid;
pub(crate) mod launch;
pub(crate) mod pendulum;
pub(crate) mod times;
