//! What a motion keeps for ever.

pub(crate) mod constants;
pub(crate) mod cubic;
pub(crate) mod many;
pub(crate) mod zeta;
