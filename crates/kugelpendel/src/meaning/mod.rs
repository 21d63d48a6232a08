//! What a motion means: the numbers that somebody reads off it, the same for every face of this crate.

pub(crate) mod apsides;
pub(crate) mod azimuth;
pub(crate) mod compare;
pub(crate) mod ellipse;
pub(crate) mod events;
pub(crate) mod followed;
pub(crate) mod measured;
pub mod olsson;
pub(crate) mod passage;
pub(crate) mod regime;
pub(crate) mod summary;
