//! Olsson's two results for small ellipses: M. G. Olsson, Am. J. Phys. 49, 531 (1981), equations (25) and (26).

use crate::given::pendulum::Pendulum;

/// The 3/8 of (25): what the lower pole of the closed form gives, 1/8, and the upper one, 1/4.
pub const PRECESSION: f64 = 0.375;

/// The 1/8 of (26).
pub const SHIFT: f64 = 0.125;

/// The angular velocity of a small ellipse's major axis by (25), Ω = (3/8) ω0 ab/l², in rad/s.
///
/// The semi-axes are in metres; the sign of ab is the sense, positive counter-clockwise seen from above. The formula is
/// low by a relative (7/32)(a² + b²)/l²; [`crate::ExactMotion::precession`] is the exact rate.
pub fn precession(a: f64, b: f64, pendulum: &Pendulum) -> f64 {
    // In lengths, so that no product underflows before it must.
    let (a, b) = (a / pendulum.length, b / pendulum.length);
    PRECESSION * (a * b * pendulum.angular_frequency())
}

/// The angular frequency of a small ellipse's swing by (26), ω = ω0 √(1 − (a² + b²)/8l²), in rad/s.
///
/// The semi-axes are in metres. Not a number from a² + b² = 8l² on, where the formula has no value.
pub fn frequency(a: f64, b: f64, pendulum: &Pendulum) -> f64 {
    let (a, b) = (a / pendulum.length, b / pendulum.length);
    let shift = SHIFT * (a * a + b * b);
    if shift < 1.0 { pendulum.angular_frequency() * (1.0 - shift).sqrt() } else { f64::NAN }
}
