//! When something happens within a step: the first zero of a function, to the last bit.

use crate::taylor::Point;

/// What can be asked for.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Event {
    /// Farthest from the axis.
    Outer,
    /// Closest approach to the axis.
    Inner,
    /// The bob passes this azimuth, rad, either way.
    Azimuth(f64),
    /// The thread goes slack.
    Slack,
    /// The thread is taut again.
    Taut,
}

/// Pieces of a step that are looked at one by one; a step is at most a quarter of a swing.
const PIECES: usize = 8;

/// ½ d(ρ²)/dt.
#[inline(always)]
pub(crate) fn radial(point: &Point) -> f64 {
    point.place[0] * point.rate[0] + point.place[1] * point.rate[1]
}

/// The first time between 0 and `end` at which a function passes through zero, upwards or downwards in the sense of the
/// walk, which may go backwards in time. One that starts at zero passes through it there.
#[inline(always)]
pub(crate) fn first(value: impl Fn(f64) -> f64, end: f64, upwards: bool) -> Option<f64> {
    let mut found = None;
    crossings(value, end, upwards, |time| {
        found = Some(time);
        true
    });
    found
}

/// All of them, until `take` has enough.
#[inline(always)]
pub(crate) fn crossings(value: impl Fn(f64) -> f64, end: f64, upwards: bool, mut take: impl FnMut(f64) -> bool) {
    let sign = if upwards { 1.0 } else { -1.0 };
    let (mut before, mut below) = (0.0, sign * value(0.0));
    for piece in 1..=PIECES {
        let after = end * (piece as f64 / PIECES as f64);
        let above = sign * value(after);
        if below <= 0.0 && above > 0.0 {
            let zero =
                if below == 0.0 { before } else { between(|t| sign * value(t), [before, after], [below, above]) };
            if take(zero) {
                return;
            }
        }
        (before, below) = (after, above);
    }
}

/// The zero between two times, by the secant, halved where an end stays (the Illinois rule).
#[inline(always)]
fn between(value: impl Fn(f64) -> f64, times: [f64; 2], values: [f64; 2]) -> f64 {
    let ([mut below, mut above], [mut low, mut high]) = (times, values);
    let mut side = 0;
    for _ in 0..100 {
        let time = (below * high - above * low) / (high - low);
        let inside = time > below.min(above) && time < below.max(above);
        if !inside {
            break;
        }
        let found = value(time);
        if found == 0.0 {
            return time;
        }
        if found < 0.0 {
            (below, low) = (time, found);
            if side == -1 {
                high *= 0.5;
            }
            side = -1;
        } else {
            (above, high) = (time, found);
            if side == 1 {
                low *= 0.5;
            }
            side = 1;
        }
    }
    if low.abs() < high.abs() { below } else { above }
}
