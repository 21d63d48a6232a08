//! Many times at once, whatever the motion.

pub(crate) mod blocks;
pub(crate) mod rotations;
#[cfg(feature = "threads")]
pub(crate) mod threads;
