//! What a motion means: the numbers that somebody reads off it, the same for every face of this crate.

pub(crate) mod budget;
pub(crate) mod decay;
pub(crate) mod half_turn;
pub(crate) mod passage;
pub(crate) mod portrait;
pub mod push;
pub(crate) mod settled;
