//! Frequency and precession of any motion, measured at its outer turning points as with a stopwatch and a protractor.

use crate::meaning::azimuth::nearest;
use crate::numbers::roots::Bracket;
use std::f64::consts::{PI, TAU};

/// Half swings that are averaged over: what an integrator leaves in one of them counts a 64th.
const HALF_SWINGS: usize = 64;

/// Points in a half swing at which a change of sign is looked for.
const GRID: usize = 24;

/// Rounds of closing in on the turning points; it doubles the digits most of the time, and halves at worst.
const ROUNDS: usize = 60;

/// The relative change of ρ² below which turning points drown in the tolerance of an integrator.
const ROUND_ENOUGH: f64 = 1e-9;

/// The angle in rad, turned in all those half swings, below which that is noise too.
const STANDSTILL: f64 = 1e-9;

/// Rates as they were measured, in rad/s, signed like those of the exact motion.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct MeasuredRates {
    /// The frequency of the swing; none on a circle and at rest, which show no turning points.
    pub frequency: Option<f64>,
    /// The precession; none where less than 1e-9 rad is turned in 64 half swings, and without a frequency.
    pub precession: Option<f64>,
}

/// Where a bob is and how fast: x, y in m and their rates in m/s.
pub type PlanState = [f64; 4];

/// Measures the rates of a motion over 64 half swings from t = 0 on.
///
/// `states` gives the plan view at ascending times in s; `half_swing` is about one radial period in s, and ten per cent
/// more or less do no harm. A turning point is a zero of x·vx + y·vy, which falls through it. A motion exact to ε has
/// times off by ε/(1 − b²/a²) and azimuths by ε, so the frequency is good to ε/64(1 − b²/a²) and the precession to
/// ε/(turned angle), relative.
///
/// # Errors
/// The first that `states` returns.
pub fn measured_rates<E>(
    half_swing: f64,
    mut states: impl FnMut(&[f64]) -> Result<Vec<PlanState>, E>,
) -> Result<MeasuredRates, E> {
    let count = (HALF_SWINGS + 2) * GRID + 1;
    let times: Vec<f64> = (0..count).map(|k| half_swing * (k as f64 / GRID as f64)).collect();
    let seen = states(&times)?;
    let squares = seen.iter().map(|[x, y, _, _]| x * x + y * y);
    let (least, most) = squares.fold((f64::INFINITY, 0.0), |(low, high), r| (f64::min(low, r), f64::max(high, r)));
    if most - least <= ROUND_ENOUGH * most {
        return Ok(MeasuredRates::default());
    }
    // Inward speeds, which rise through zero at an outer turning point.
    let inward: Vec<f64> = seen.iter().map(inward).collect();
    let changes = (0..count - 1).filter(|&k| inward[k] < 0.0 && inward[k + 1] >= 0.0).take(HALF_SWINGS + 1);
    let mut brackets: Vec<_> =
        changes.map(|k| Bracket::new([times[k], times[k + 1]], [inward[k], inward[k + 1]])).collect();
    if brackets.len() < 2 {
        return Ok(MeasuredRates::default());
    }
    for _ in 0..ROUNDS {
        let open: Vec<_> = (0..brackets.len()).filter_map(|k| Some((k, brackets[k].next()?))).collect();
        if open.is_empty() {
            break;
        }
        let times: Vec<f64> = open.iter().map(|(_, time)| *time).collect();
        for ((k, time), state) in open.into_iter().zip(states(&times)?) {
            brackets[k].tell(time, self::inward(&state));
        }
    }
    let turning: Vec<f64> = brackets.iter().map(Bracket::best).collect();
    let azimuths: Vec<f64> = states(&turning)?.iter().map(|[x, y, _, _]| y.atan2(*x)).collect();
    let intervals = turning.len() - 1;
    let elapsed = turning[intervals] - turning[0];
    // Half a turn from one to the next is the swing; the rest, brought to one branch, is precession.
    let turned: f64 = azimuths.windows(2).map(|pair| nearest(pair[1] - pair[0] - PI, 0.0, TAU)).sum();
    Ok(MeasuredRates {
        frequency: Some(PI * intervals as f64 / elapsed),
        precession: Some(turned / elapsed).filter(|_| turned.abs() > STANDSTILL),
    })
}

fn inward([x, y, vx, vy]: &PlanState) -> f64 {
    -(x * vx + y * vy)
}
