//! What is given: pendulum, launch, what acts, times; and what is wrong with it where it makes no sense.

pub(crate) mod acting;
pub(crate) mod bob;
pub(crate) mod drag;
pub(crate) mod forces;
pub(crate) mod invalid;
pub(crate) mod launch;
pub(crate) mod pendulum;
pub(crate) mod pumping;
pub(crate) mod site;
pub(crate) mod suspension;
pub(crate) mod times;
pub(crate) mod wire;
