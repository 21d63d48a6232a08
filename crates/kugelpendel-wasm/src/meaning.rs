//! What a motion means: the numbers that the page says in words.

use crate::exchange::{answer, received, tell};
use crate::given::Given;
use crate::motion::{Motion, plan_states};
use kugelpendel::{ExactMotion, IdealSummary, Invalid, Launch, Pendulum, Regime, measured_rates, relative_error};
use std::convert::Infallible;

/// Tells the summary of the ideal motion that starts as given: the regime's place in [`Regime::ALL`], sense, ω, Ω, 2π/ω, π/ω,
/// apsidal angle, turning rate, whether by whole turns, full turn, once round, largest angle, (25), (26), their errors, radii
/// and heights of the turning points, least and largest tension, slack time, largest speed.
#[unsafe(no_mangle)]
pub extern "C" fn summary() -> u32 {
    answer(Given::receive().and_then(|given| Ok(summed(&given.ideal()?))))
}

fn summed(motion: &ExactMotion) -> [f64; 24] {
    let summary = IdealSummary::of(motion);
    let [outer, inner] = motion.turning_radii();
    let [high, low] = motion.turning_heights();
    let [least, most] = motion.tension_range();
    let error = |approximate: f64, truth: f64| relative_error(approximate, truth).unwrap_or(f64::NAN);
    let regime = Regime::ALL.iter().position(|regime| *regime == summary.regime).unwrap_or(0);
    [
        regime as f64,
        summary.sense,
        motion.frequency(),
        motion.precession(),
        summary.swing_period,
        motion.radial_period(),
        motion.apsidal_angle(),
        summary.turning,
        f64::from(summary.whole_turns),
        summary.full_turn,
        summary.once_round,
        summary.largest_angle,
        summary.formula_25,
        summary.frequency_26,
        error(summary.formula_25, motion.precession()),
        // Of the period, which is the inverse.
        error(motion.frequency(), summary.frequency_26),
        outer,
        inner,
        high,
        low,
        least,
        most,
        motion.slack_time(),
        (2.0 * motion.energy()).sqrt(),
    ]
}

/// Tells frequency and precession of a law as they are measured at its turning points, and the errors of its period and of its
/// precession; NaN for what shows none.
#[unsafe(no_mangle)]
pub extern "C" fn measured(law: u32) -> u32 {
    answer(measure(law))
}

fn measure(law: u32) -> Result<[f64; 4], Invalid> {
    let exact = Given::receive()?.ideal()?;
    let mut motion = Motion::new(law)?;
    let Ok(rates) = measured_rates(exact.radial_period(), |times| Ok::<_, Infallible>(plan_states(&mut motion, times)));
    let error = |approximate: Option<f64>, truth: f64| {
        approximate.and_then(|approximate| relative_error(approximate, truth)).unwrap_or(f64::NAN)
    };
    let period = rates.frequency.and_then(|frequency| relative_error(exact.frequency(), frequency));
    Ok([
        rates.frequency.unwrap_or(f64::NAN),
        rates.precession.unwrap_or(f64::NAN),
        period.unwrap_or(f64::NAN),
        error(rates.precession, exact.precession()),
    ])
}

/// Tells the place on the sphere nearest to a ray; received are the length, the eye and the direction.
#[unsafe(no_mangle)]
pub extern "C" fn nearest_place() {
    let [length, x, y, z, dx, dy, dz, ..] = received();
    tell(&sphere(length).nearest_place([x, y, z], [dx, dy, dz]));
}

/// Tells position and velocity of the launch nearest to a state; received are the length, the position and the velocity.
#[unsafe(no_mangle)]
pub extern "C" fn nearest_launch() {
    let [length, x, y, z, vx, vy, vz, ..] = received();
    if let Launch::State { position, velocity } = sphere(length).nearest_launch([x, y, z], [vx, vy, vz]) {
        let ([x, y, z], [vx, vy, vz]) = (position, velocity);
        tell(&[x, y, z, vx, vy, vz]);
    }
}

fn sphere(length: f64) -> Pendulum {
    Pendulum { length, gravity: 1.0, mass: 1.0 }
}
