//! The averaged equations step by step, of order 8, with a polynomial over every step.
//!
//! Source: see [`super::tableau`].

use super::circles::{NUMBERS, SlowState};
use super::equations::AveragedEquations;
use super::tableau::{ALL, DENSE, ERROR, STAGE, STAGES};
use std::f64::consts::TAU;

/// Of a step: against the larger of C±, for Ψ in rad and for Γ; and for the phase in rad.
const TOLERANCE: f64 = 1e-10;
const PHASE_TOLERANCE: f64 = 1e-8;

/// Where a drive feeds them, C± grow as fast as e^Γ, and A± stay as they are: beyond this size Γ is taken into them.
const LARGEST: f64 = 1e100;

/// A step ends the motion where it would have to be shorter than this.
const SHORTEST: f64 = 1e-6;

/// Half a piece of a step in which an angle turns by more than this is halved again, rad, and how often at most.
const FAR: f64 = 1.0;
const HALVINGS: usize = 40;

/// Against the larger of C±: pieces shorter than this are not halved.
const NEAR: f64 = 10.0 * TOLERANCE;

/// How far the integration has come, forwards or backwards: the latest step.
#[derive(Clone, Debug)]
pub(super) struct AveragedStepper {
    direction: f64,
    /// Where the step begins, and its size with the sign of the direction; 0 before the first.
    start: f64,
    size: f64,
    /// The step as powers of the share s of it gone by and of 1 − s, in turn.
    series: [SlowState; 8],
    end: SlowState,
    slope: SlowState,
    /// What the next step will try.
    next: f64,
    /// arg B₊ and arg B₋, followed continuously: at the beginning of the step and at its end.
    angles: [f64; 2],
    end_angles: [f64; 2],
    pub(super) ended: bool,
}

/// The motion at one time.
#[derive(Clone, Copy, Debug)]
pub(super) struct Moment {
    pub(super) state: SlowState,
    /// arg B₊ and arg B₋, continuous from the launch on.
    pub(super) angles: [f64; 2],
}

impl Moment {
    /// The launch, by the sizes of A± and their arguments.
    pub(super) fn of([p, q]: [f64; 2], angles: [f64; 2]) -> Self {
        let [ahead, behind] = angles.map(f64::sin_cos);
        Self { state: [p * ahead.1, p * ahead.0, q * behind.1, q * behind.0, 0.0, 0.0, 0.0], angles }
    }

    /// That moment of a motion whose amplitudes do not change.
    pub(super) fn after(&self, time: f64, slope: &SlowState) -> Self {
        let mut state = self.state;
        for k in 4..NUMBERS {
            state[k] += slope[k] * time;
        }
        Self { state, angles: self.angles.map(|angle| angle + slope[5] * time) }
    }
}

impl AveragedStepper {
    pub(super) fn new(equations: &AveragedEquations, start: &Moment, direction: f64) -> Self {
        let state = start.state;
        let slope = equations.slope(&state);
        let mut series = [[0.0; NUMBERS]; 8];
        series[0] = state;
        let rate = size(&slope) / size(&state) + slope[6].abs();
        let next = direction * if rate > 0.0 && rate.is_finite() { (0.1 / rate).min(1e6) } else { 1e6 };
        let angles = start.angles;
        Self {
            direction,
            start: 0.0,
            size: 0.0,
            series,
            end: state,
            slope,
            next,
            angles,
            end_angles: angles,
            ended: false,
        }
    }

    /// Whether the time lies before the step begun last.
    pub(super) fn is_past(&self, time: f64) -> bool {
        (time - self.start) * self.direction < 0.0
    }

    pub(super) fn reaches(&self, time: f64) -> bool {
        (time - self.start - self.size) * self.direction <= 0.0
    }

    /// The time up to which it has come.
    pub(super) fn until(&self) -> f64 {
        self.start + self.size
    }

    pub(super) fn at(&self, time: f64) -> Moment {
        let share = if self.size == 0.0 { 0.0 } else { (time - self.start) / self.size };
        let state = at_share(&self.series, share);
        Moment { state, angles: followed(self.angles, &self.series, share, &state) }
    }

    /// The next step; none where the motion ends, that is where the bob comes level with the support.
    pub(super) fn advance(&mut self, equations: &AveragedEquations) {
        let (begin, begin_angles) = (self.end, self.end_angles);
        let mut slopes = [[0.0; NUMBERS]; ALL];
        slopes[0] = self.slope;
        let mut step = self.next;
        loop {
            for stage in 1..=STAGES {
                slopes[stage] = equations.slope(&after(&begin, step, STAGE[stage - 1], &slopes));
            }
            let end = after(&begin, step, STAGE[STAGES - 1], &slopes);
            let error = error(&slopes, size(&begin).max(size(&end)), step);
            if error <= 1.0 {
                for stage in STAGES + 1..ALL {
                    slopes[stage] = equations.slope(&after(&begin, step, STAGE[stage - 1], &slopes));
                }
                self.start += self.size;
                self.size = step;
                self.series = interpolant(&begin, &end, step, &slopes);
                self.end_angles = followed(begin_angles, &self.series, 1.0, &end);
                (self.end, self.slope) = rescaled(end, slopes[STAGES]);
                self.angles = begin_angles;
                self.next = step * (0.9 * error.powf(-0.125)).clamp(0.33, 6.0);
                return;
            }
            // A NaN means that a stage went beyond the support.
            step *= if error.is_nan() { 0.25 } else { (0.9 * error.powf(-0.125)).clamp(0.1, 0.9) };
            if step.abs() < SHORTEST {
                self.ended = true;
                return;
            }
        }
    }
}

fn after(begin: &SlowState, step: f64, weights: &[f64], slopes: &[SlowState; ALL]) -> SlowState {
    let mut state = *begin;
    for (weight, slope) in weights.iter().zip(slopes) {
        if *weight != 0.0 {
            for (value, rate) in state.iter_mut().zip(slope) {
                *value += step * weight * rate;
            }
        }
    }
    state
}

/// State and slope with Γ taken into C± where these have grown large.
fn rescaled(mut state: SlowState, mut slope: SlowState) -> (SlowState, SlowState) {
    if size(&state) > LARGEST {
        let scale = (-state[6]).exp();
        for k in 0..4 {
            state[k] *= scale;
            slope[k] *= scale;
        }
        state[6] = 0.0;
    }
    (state, slope)
}

/// The larger of C±.
fn size(state: &SlowState) -> f64 {
    state[0].hypot(state[1]).max(state[2].hypot(state[3]))
}

/// Of the step, in units of the tolerance.
fn error(slopes: &[SlowState; ALL], size: f64, step: f64) -> f64 {
    let circle = 1.0 / (TOLERANCE * size.max(f64::MIN_POSITIVE / TOLERANCE));
    let weights = [circle, circle, circle, circle, 1.0 / PHASE_TOLERANCE, 1.0 / TOLERANCE, 1.0 / TOLERANCE];
    let [fifth, third] = ERROR.map(|coefficients| {
        let sum = after(&[0.0; NUMBERS], 1.0, &coefficients, slopes);
        sum.iter().zip(&weights).map(|(value, weight)| (value * weight).powi(2)).sum::<f64>() / NUMBERS as f64
    });
    if fifth == 0.0 { 0.0 } else { step.abs() * fifth / (fifth + 0.01 * third).sqrt() }
}

fn interpolant(begin: &SlowState, end: &SlowState, step: f64, slopes: &[SlowState; ALL]) -> [SlowState; 8] {
    let mut series = [[0.0; NUMBERS]; 8];
    series[0] = *begin;
    for k in 0..NUMBERS {
        let (rise, first, last) = (end[k] - begin[k], step * slopes[0][k], step * slopes[STAGES][k]);
        series[1][k] = rise;
        series[2][k] = first - rise;
        series[3][k] = 2.0 * rise - first - last;
    }
    for (row, weights) in series[4..].iter_mut().zip(&DENSE) {
        *row = after(&[0.0; NUMBERS], step, weights, slopes);
    }
    series
}

/// The state when such a share of a step is over.
fn at_share(series: &[SlowState; 8], share: f64) -> SlowState {
    let mut state = series[7];
    for (k, series) in series[..7].iter().enumerate().rev() {
        let factor = if k % 2 == 0 { share } else { 1.0 - share };
        for (value, coefficient) in state.iter_mut().zip(series) {
            *value = *value * factor + coefficient;
        }
    }
    state
}

/// The angles of B± at the state when such a share of a step is over. Whole turns are those that C± make on the way: next to a
/// circle the smaller of them passes by zero, and the straight line to it may pass on the other side.
fn followed(angles: [f64; 2], series: &[SlowState; 8], share: f64, state: &SlowState) -> [f64; 2] {
    let direct = turned(&series[0], state);
    let along = wound(series, [0.0, share], [&series[0], state], HALVINGS);
    let common = state[5] - series[0][5];
    std::array::from_fn(|k| angles[k] + common + direct[k] + TAU * ((along[k] - direct[k]) / TAU).round())
}

/// By which angles C± have turned between two shares of a step, in pieces in which they turn by less than [`FAR`].
fn wound(series: &[SlowState; 8], [from, to]: [f64; 2], [first, last]: [&SlowState; 2], halvings: usize) -> [f64; 2] {
    let half = 0.5 * (from + to);
    let middle = at_share(series, half);
    let [before, after] = [turned(first, &middle), turned(&middle, last)];
    // What is as near to zero as the integration is exact has no direction.
    let near = NEAR * size(&series[0]);
    let settled = |k: usize| {
        let way = |from: &SlowState, to: &SlowState| (to[2 * k] - from[2 * k]).hypot(to[2 * k + 1] - from[2 * k + 1]);
        before[k].abs().max(after[k].abs()) < FAR || way(first, &middle).max(way(&middle, last)) < near
    };
    let [before, after] = if halvings == 0 || (settled(0) && settled(1)) {
        [before, after]
    } else {
        [
            wound(series, [from, half], [first, &middle], halvings - 1),
            wound(series, [half, to], [&middle, last], halvings - 1),
        ]
    };
    [before[0] + after[0], before[1] + after[1]]
}

/// The angles between C± of two states, from −π to π.
fn turned(from: &SlowState, to: &SlowState) -> [f64; 2] {
    [0, 2].map(|k| {
        let (cos, sin) = (from[k] * to[k] + from[k + 1] * to[k + 1], from[k] * to[k + 1] - from[k + 1] * to[k]);
        if cos == 0.0 && sin == 0.0 { 0.0 } else { sin.atan2(cos) }
    })
}

#[cfg(test)]
mod tests {
    use crate::envelope::{Envelope, EnvelopeMotion, EnvelopeWalks};
    use crate::given::drive::Drive;
    use crate::given::forces::Forces;
    use crate::given::launch::Launch;
    use crate::given::pendulum::Pendulum;
    use crate::plane::portrait::{Portrait, Verdict};

    /// A plane that turns back next to a circle, where one whole turn of A₋ in place of none would be half a turn of it.
    #[test]
    fn the_plane_keeps_its_branch_past_a_circle() {
        let pendulum = Pendulum { length: 10.0, gravity: 9.81, mass: 1.0 };
        for (share, azimuth) in (0..60_u32).flat_map(|k| [0.0_f64, 0.13, 0.26, 0.4].map(|azimuth| (k, azimuth))) {
            // From a thousandth to a fifth above the clamp that is just strong enough.
            let above = 1.0 + 1e-3 * 1.09_f64.powi(share as i32);
            let anisotropy = above * 2.0 * 5e-5 / (2.0 * azimuth).cos();
            let forces = Forces { rotation: [0.0, 5e-5], anisotropy, ..Forces::default() };
            let launch = Launch::Ellipse { a: 0.003, b: 0.0, azimuth };
            let motion = EnvelopeMotion::new(pendulum, launch, forces, Drive::Absent, true);
            let motion = motion.unwrap_or_else(|e| panic!("{e:?}"));
            let portrait = Portrait::new(&pendulum, &forces, 0.003, 0.0);
            let orbit = portrait.orbit(portrait.form(0.003, 0.0, azimuth));
            if orbit.verdict != Verdict::ToAndFro {
                continue;
            }
            let times: Vec<f64> = (0..=400).map(|k| 4.0 * orbit.period * f64::from(k) / 400.0).collect();
            let mut azimuths = vec![f64::NAN; times.len()];
            let read = motion.fill(Envelope::Azimuth, &times, &mut azimuths, &mut EnvelopeWalks::default(), &|| false);
            assert_eq!(read, Ok(()));
            let [low, high] = orbit.azimuths.map(|limit| limit + 0.02 * (limit - azimuth).signum());
            let outside = azimuths.iter().filter(|azimuth| **azimuth < low || **azimuth > high).count();
            assert_eq!(outside, 0, "{anisotropy} from {azimuth}: {orbit:?}");
        }
    }
}
