//! The exact motion of the spherical pendulum: a bob on a thread, free to swing in every direction.
//!
//! ```
//! use kugelpendel::{ExactMotion, Launch, Pendulum};
//! let pendulum = Pendulum { length: 67.0, gravity: 9.8094, mass: 28.0 };
//! let motion = ExactMotion::new(pendulum, Launch::Ellipse { a: 3.0, b: 0.01, azimuth: 0.0 })?;
//! assert!((motion.precession() / 9.5926e-7 - 1.0).abs() < 1e-2); // rad/s
//! # Ok::<(), kugelpendel::Invalid>(())
//! ```
//!
//! Conventions: SI; the support at the origin, `z` down, so that the bob rests at (0, 0, l); azimuths, precession and
//! angular momentum positive counter-clockwise seen from above.

// Reading order. What is given: pendulum, launch (→ state), forces. What follows from it: invariants (cubic, zeta; block
// for many), exact (their names in SI), tension. How it moves: clock (phase), chart (trigonometric or hyperbolic, of
// elliptic's arguments, both made of shape), spectrum. Many times and many motions: times, rotations, plan, series,
// sampling, ensemble, blocks. The real pendulum: sphere (its equations), taylor, events, walk (step by step), real. The
// paper's approximations: harmonic; equations, integrated. Underneath: arithmetic, double_double, turns, invalid.
mod arithmetic;
mod block;
mod blocks;
mod chart;
mod clock;
mod cubic;
mod double_double;
mod elliptic;
mod ensemble;
mod envelope;
mod equations;
mod events;
mod exact;
mod forces;
mod harmonic;
mod hyperbolic;
mod integrated;
mod invalid;
mod invariants;
mod launch;
mod pendulum;
mod plan;
mod real;
mod rotations;
mod sampling;
mod series;
mod shape;
mod spectrum;
mod sphere;
mod taylor;
mod tension;
mod times;
mod trigonometric;
mod turns;
mod walk;
mod zeta;

#[cfg(test)]
mod tests;

pub use arithmetic::fused;
pub use ensemble::Ensemble;
pub use envelope::{Envelope, EnvelopeMotion, EnvelopeWalks};
pub use equations::Equation;
pub use events::Event;
pub use exact::ExactMotion;
pub use forces::{Drive, Forces, Thread};
pub use harmonic::{HarmonicMotion, MAX_POWER, Powers};
pub use integrated::IntegratedMotion;
pub use invalid::Invalid;
pub use launch::{Launch, TOLERANCE};
pub use pendulum::Pendulum;
pub use real::{Halt, RealMotion, Stop, Walks};

pub use spectrum::{Harmonic, Spectrum};
pub use times::{Quantity, Times};
