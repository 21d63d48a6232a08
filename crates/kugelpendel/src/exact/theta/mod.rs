//! The theta functions that a motion is made of.

pub(crate) mod blocks;
pub(crate) mod hyperbolic;
pub(crate) mod shape;
pub(crate) mod trigonometric;
