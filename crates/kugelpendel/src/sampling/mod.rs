//! Many times at once, whatever the motion.

pub(crate) mod blocks;
#[cfg(feature = "threads")]
pub(crate) mod threads;
