//! What is given: pendulum, launch, what acts, times; and what is wrong with it where it makes no sense.

pub(crate) mod bob;
pub(crate) mod decay;
pub(crate) mod drag;
pub(crate) mod drive;
pub(crate) mod forces;
pub(crate) mod invalid;
pub(crate) mod launch;
pub(crate) mod nearest;
pub(crate) mod pendulum;
pub(crate) mod site;
pub(crate) mod suspension;
pub(crate) mod times;
pub(crate) mod wire;

pub use bob::{AIR_DENSITY, Bob};
pub use decay::Decay;
pub use drag::{Drag, StillAir};
pub use drive::Drive;
pub use forces::{Acting, Forces, Thread};
pub use invalid::{Invalid, Seen};
pub use launch::{FASTEST, Launch, SMALLEST, TOLERANCE};
pub use pendulum::{EXTREMES, Pendulum, STANDARD_GRAVITY};
pub use site::{ROTATION, Site};
pub use suspension::Suspension;
pub use times::{Quantity, Times};
pub use wire::Wire;
