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

// Reading order. What is given: `given` (pendulum, launch, forces, times, and what is said of bad ones). The closed form:
// `exact`, with the constants of a motion in its `invariants` and the functions of time in its `theta`. Many times and
// many motions: `sampling`. The real pendulum: `taylor` integrates, `real` has its equations step by step, `envelope` their
// average. The paper's approximations: `paper`. What somebody reads off a motion: `meaning`. Underneath: `numbers`.
mod envelope;
mod exact;
mod given;
mod meaning;
mod numbers;
mod paper;
mod plane;
mod real;
mod sampling;
mod taylor;

#[cfg(test)]
mod tests;

pub use envelope::{Envelope, EnvelopeMotion, EnvelopeWalks};
pub use exact::ensemble::Ensemble;
pub use exact::motion::ExactMotion;
pub use given::*;
pub use meaning::apsides::{ApsidesTrack, Apsis, STANDSTILL, mean_rate, rate_at_the_end, stands_since};
pub use meaning::azimuth::{nearest, unwrap, unwrap_at};
pub use meaning::compare::{EllipseRates, SWINGS, distances, reach, relative_error};
pub use meaning::ellipse::Ellipse;
pub use meaning::events::events_on_a_grid;
pub use meaning::followed::{Followed, Follower, follow, follow_all};
pub use meaning::measured::{MeasuredRates, PlanState, measured_rates};
pub use meaning::olsson;
pub use meaning::regime::Regime;
pub use meaning::summary::IdealSummary;
pub use numbers::arithmetic::fused;
pub use paper::equations::Equation;
pub use paper::harmonic::{HarmonicLaw, HarmonicMotion, MAX_POWER, Powers};
pub use paper::integrated::IntegratedMotion;
pub use plane::budget::{ALIKE, Cause, Pace, PrecessionBudget, STALL, Stretch, stretches};
pub use plane::course::{PlaneCourse, clamp_orbit, course, pace};
pub use plane::half_turn::{HalfTurn, critical_damping, under_damping};
pub use plane::portrait::{
    EllipseForm, Equilibrium, Orbit, Portrait, Verdict, critical_amplitude, critical_anisotropy, intrinsic,
};
pub use plane::push;
pub use plane::settled::{Settled, settle};
pub use real::ensemble::{Case, Done};
pub use real::motion::RealMotion;
#[cfg(feature = "threads")]
pub use sampling::threads::in_parallel;
pub use taylor::events::Event;
pub use taylor::step::Ending;
pub use taylor::walk::{Halt, Passage, Readings, StateVector, Stop, Walk, steps_taken};

pub use exact::spectrum::{Harmonic, Spectrum};
