//! What turns the plane of a swing and what becomes of it: its budget by causes, the portrait of an uneven clamp, half
//! turns, pushes, what it does in a stretch of time, and where all of them together settle.

pub(crate) mod budget;
pub(crate) mod course;
pub(crate) mod half_turn;
pub(crate) mod portrait;
pub mod push;
pub(crate) mod settled;
