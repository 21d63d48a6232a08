//! How far a motion is from the exact one.

use crate::exact::motion::ExactMotion;
use crate::meaning::olsson;
use std::f64::consts::TAU;

/// Swings that are compared unless a duration is given.
pub const SWINGS: f64 = 20.0;

/// Times in a swing: the largest error between two of them is larger by a thousandth at most.
const POINTS: f64 = 64.0;

/// Times in all; of longer durations each swing has fewer.
const MOST_POINTS: usize = 100_000;

/// Times of a short duration.
const LEAST_POINTS: usize = 200;

/// Half the narrowest ellipse that stands for the limit b → 0, as b/a: what is left of it is of order 1e-24.
const NARROW: f64 = 1e-12;

/// The a/l below which every error is smaller than 1e-17 and only rounding would be shown.
const TINY: f64 = 1e-9;

/// The relative error of an approximate value, signed: approximate over true, less 1; none where the true one is 0.
pub fn relative_error(approximate: f64, truth: f64) -> Option<f64> {
    (truth != 0.0).then(|| approximate / truth - 1.0)
}

/// Distances between positions and the true ones, three numbers each, in the unit of both.
pub fn distances(positions: &[f64], truth: &[f64]) -> Vec<f64> {
    let pairs = positions.chunks_exact(3).zip(truth.chunks_exact(3));
    let square = |(p, t): (&[f64], &[f64])| (0..3).map(|k| (p[k] - t[k]) * (p[k] - t[k])).sum::<f64>();
    pairs.map(|pair| square(pair).sqrt()).collect()
}

impl ExactMotion {
    /// What errors of position are given as a fraction of, in m: the outer turning radius, or the length where the path
    /// rises above the support.
    pub fn amplitude(&self) -> f64 {
        if self.rises_above() { self.pendulum.length } else { self.turning_radii()[0] }
    }

    /// The time that counts as a swing in a comparison, in s: there and back, or that of small swings where the motion
    /// never comes back.
    pub fn comparison_swing(&self) -> f64 {
        let frequency = self.frequency();
        TAU / if frequency > 0.0 { frequency } else { self.pendulum.angular_frequency() }
    }

    /// How many evenly spread times from 0 to the duration in s show the largest error to a thousandth.
    pub fn comparison_count(&self, duration: f64) -> usize {
        let wanted = (POINTS * duration / self.comparison_swing()).ceil();
        1 + (wanted as usize).clamp(LEAST_POINTS, MOST_POINTS)
    }
}

/// Up to which of the ascending sizes no error exceeds a level: 0 where the first one does already, infinite where none
/// does.
///
/// `worst` is the largest error at each size. Errors are powers of the size, near enough, between one and the next.
pub fn reach(sizes: &[f64], worst: &[f64], level: f64) -> f64 {
    let Some(beyond) = worst.iter().position(|error| error.abs() > level) else { return f64::INFINITY };
    if beyond == 0 {
        return 0.0;
    }
    let digits = |index: usize| worst[index].abs().max(f64::MIN_POSITIVE).ln();
    let (low, high) = (digits(beyond - 1), digits(beyond));
    let share = (level.ln() - low) / (high - low);
    sizes[beyond - 1] * (sizes[beyond] / sizes[beyond - 1]).powf(share)
}

/// The rates by which the formulas for small ellipses are judged.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct EllipseRates {
    /// The exact rates in rad/s, of an ellipse that is not narrower than 1e-12 of its length.
    pub precession: f64,
    /// The frequency of that ellipse in rad/s.
    pub frequency: f64,
    /// The turning radii of that ellipse over the length, b not negative.
    pub radii: [f64; 2],
    /// The relative error of (25), signed.
    pub formula_25: f64,
    /// The relative error of (26), signed.
    pub formula_26: f64,
    /// Whether the ellipse is so small that every formula is exact.
    pub tiny: bool,
}

impl EllipseRates {
    /// The turning radii of the motions by which an ellipse a by b (m) is judged: first a and b as launched, then the b of
    /// the narrowest ellipse that shows a precession.
    ///
    /// At b = 0 that is the limit b → 0. A swing of less than 1e-12 of the length is judged by its
    /// shape at a size that the numbers hold.
    pub fn radii(a: f64, b: f64, length: f64) -> [f64; 3] {
        let least = 1e-3 * TINY * length;
        let growth = if a > 0.0 && a < least { least / a } else { 1.0 };
        let (a, b) = (a * growth, b * growth);
        [a, b, b.abs().max(NARROW * a)]
    }

    /// Judges (25) and (26) on a motion that was launched between the turning radii a and b, in m.
    pub fn of(motion: &ExactMotion, a: f64, b: f64) -> Self {
        let pendulum = motion.pendulum();
        let (precession, frequency) = (motion.precession(), motion.frequency());
        let tiny = a / pendulum.length < TINY;
        let error = |formula: f64, truth: f64| if tiny { 0.0 } else { formula / truth - 1.0 };
        Self {
            precession,
            frequency,
            radii: [a / pendulum.length, b / pendulum.length],
            formula_25: error(olsson::precession(a, b, pendulum), precession),
            formula_26: error(olsson::frequency(a, b, pendulum), frequency),
            tiny,
        }
    }
}
