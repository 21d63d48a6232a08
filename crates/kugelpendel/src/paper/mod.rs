//! The paper's approximations: (12), (13), (16), (20).

pub(crate) mod equations;
pub(crate) mod harmonic;
pub(crate) mod integrated;
