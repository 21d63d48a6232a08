//! Azimuths brought to one branch: an axis has no front end, and an angle no number of turns.

use std::f64::consts::{FRAC_PI_2, PI, TAU};

use crate::exact::motion::ExactMotion;
use crate::meaning::regime::Regime;

/// Makes angles continuous by whole periods, so that each differs from the one before it by half a period at most.
///
/// The first follows `from` where that is given. What is not a number stays so, and the next one follows the last that
/// was. The period is 2π for a direction, π for an axis.
pub fn unwrap(angles: &mut [f64], period: f64, from: Option<f64>) {
    let mut last = from;
    for angle in angles.iter_mut().filter(|angle| angle.is_finite()) {
        if let Some(last) = last {
            *angle = nearest(*angle, last, period);
        }
        last = Some(*angle);
    }
}

/// [`unwrap`] in the order of the times, which need not be sorted.
pub fn unwrap_at(times: &[f64], angles: &mut [f64], period: f64) {
    let mut order: Vec<usize> = (0..times.len()).collect();
    order.sort_by(|a, b| times[*a].total_cmp(&times[*b]));
    let mut sorted: Vec<f64> = order.iter().map(|index| angles[*index]).collect();
    unwrap(&mut sorted, period, None);
    for (index, angle) in order.into_iter().zip(sorted) {
        angles[index] = angle;
    }
}

/// The angle, by whole periods, that is nearest to another one.
pub fn nearest(angle: f64, to: f64, period: f64) -> f64 {
    angle + period * ((to - angle) / period).round()
}

impl ExactMotion {
    /// The mean rate at which the outer turning points move round, in rad/s, on the branch that turns least, and whether
    /// whole turns were taken off in place of half turns.
    ///
    /// That is the precession where half a turn lies between successive outer turning points; where it is closer to a
    /// whole one, for a path over the top, it is the precession less half a turn for each radial period.
    pub fn turning_rate(&self) -> (f64, bool) {
        let (precession, period) = (self.precession(), self.radial_period());
        if self.regime() != Regime::Above || precession.abs() * period <= FRAC_PI_2 {
            return (precession, false);
        }
        (precession - (PI / period).copysign(precession), true)
    }

    /// By how much the outer turning points at these azimuths and times, in rad and s, have moved round since the first.
    ///
    /// The azimuths are replaced by it, in rad, unwrapped by the half or whole turns that [`Self::turning_rate`] leaves
    /// open.
    pub fn turned(&self, times: &[f64], azimuths: &mut [f64]) {
        let (rate, whole) = self.turning_rate();
        let period = if whole { TAU } else { PI };
        let (Some(&start), Some(&first)) = (times.first(), azimuths.first()) else { return };
        for (time, azimuth) in times.iter().zip(azimuths) {
            *azimuth = nearest(*azimuth - first, rate * (time - start), period);
        }
    }

    /// Times of outer turning points from t = 0 up to `until`, in s, at most `most` of them and evenly spread.
    ///
    /// There are none at rest and on the separatrix, or where the first comes too late.
    pub fn apsidal_times(&self, until: f64, most: usize) -> Vec<f64> {
        let (first, period) = (self.apsis_time(), self.radial_period());
        if self.turning_heights()[0] <= 0.0 || !period.is_finite() || first > until || most == 0 {
            return Vec::new();
        }
        let last = ((until - first) / period).floor();
        let count = (most as f64).min(last + 1.0);
        let every = if count > 1.0 { last / (count - 1.0) } else { 0.0 };
        (0..count as usize).map(|k| first + period * (k as f64 * every).round_ties_even()).collect()
    }
}
