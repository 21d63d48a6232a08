//! What a motion means: the numbers that somebody reads off it, the same for every face of this crate.

pub(crate) mod apsides;
pub(crate) mod azimuth;
pub(crate) mod budget;
pub(crate) mod compare;
pub(crate) mod decay;
pub(crate) mod ellipse;
pub(crate) mod events;
pub(crate) mod half_turn;
pub(crate) mod measured;
pub mod olsson;
pub(crate) mod passage;
pub(crate) mod portrait;
pub mod push;
pub(crate) mod regime;
pub(crate) mod settled;
pub(crate) mod summary;
