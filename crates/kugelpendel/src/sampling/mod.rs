//! Many times at once, whatever the motion.

pub(crate) mod blocks;
