//! The real pendulum: the full equations, step by step.

pub(crate) mod ensemble;
mod lanes;
pub(crate) mod motion;
pub(crate) mod problem;
mod pumping;
pub(crate) mod sphere;
pub(crate) mod step;

#[cfg(test)]
mod tests;
