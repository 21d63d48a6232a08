//! The outer turning points of a real motion: how its ellipse changes, where its plane goes, and where it stands.

use crate::given::pendulum::Pendulum;
use crate::meaning::azimuth::nearest;
use crate::meaning::ellipse::Ellipse;
use crate::taylor::walk::StateVector;
use std::f64::consts::PI;

/// Turning points that are kept at most; half as many at least, evenly spread.
const KEPT: usize = 4096;

/// The ellipse at an outer turning point.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Apsis {
    /// The time, s.
    pub time: f64,
    /// The outer turning radius, m.
    pub a: f64,
    /// The inner turning radius, m, positive counter-clockwise seen from above.
    pub b: f64,
    /// Of the major axis, rad, followed continuously by half turns from the first turning point on.
    pub azimuth: f64,
}

/// What is noted at the outer turning points of a motion while it is followed.
#[derive(Clone, Debug)]
pub struct ApsidesTrack {
    pendulum: Pendulum,
    rotation: f64,
    kept: Vec<Apsis>,
    every: usize,
    seen: usize,
    last: Option<Apsis>,
    first_times: Vec<f64>,
    last_times: [f64; 3],
    widest: f64,
    flattest: f64,
}

impl ApsidesTrack {
    /// Of the point mass that moves like the bob, over ground that turns with `rotation` rad/s about the vertical.
    pub fn new(pendulum: Pendulum, rotation: f64) -> Self {
        Self {
            pendulum,
            rotation,
            kept: Vec::new(),
            every: 1,
            seen: 0,
            last: None,
            first_times: Vec::new(),
            last_times: [f64::NAN; 3],
            widest: 0.0,
            flattest: f64::INFINITY,
        }
    }

    /// Notes the next outer turning points, in order.
    pub fn add(&mut self, passages: &[(f64, StateVector)]) {
        let ellipses = Ellipse::osculating(passages.len(), |index| {
            let (_, StateVector { position, velocity }) = passages[index];
            (self.pendulum, position, velocity, self.rotation)
        });
        for ((time, _), Ellipse { a, b, azimuth, .. }) in passages.iter().zip(ellipses) {
            let azimuth = self.last.map_or(azimuth, |last| nearest(azimuth, last.azimuth, PI));
            let apsis = Apsis { time: *time, a, b, azimuth };
            if self.seen.is_multiple_of(self.every) {
                self.kept.push(apsis);
            }
            if self.kept.len() > KEPT {
                let mut index = 0;
                self.kept.retain(|_| {
                    index += 1;
                    index % 2 == 1
                });
                self.every *= 2;
            }
            if self.first_times.len() < 3 {
                self.first_times.push(*time);
            }
            let [_, former, latest] = self.last_times;
            self.last_times = [former, latest, *time];
            self.widest = self.widest.max(b.abs());
            self.flattest = self.flattest.min(b.abs() / a);
            self.last = Some(apsis);
            self.seen += 1;
        }
    }

    /// Turning points up to now, evenly spread, with the first and the last of them.
    pub fn track(&self) -> Vec<Apsis> {
        let mut track = self.kept.clone();
        track.extend(self.last.filter(|last| track.last() != Some(last)));
        track
    }

    /// The largest |b| of all turning points, m.
    pub fn widest(&self) -> f64 {
        self.widest
    }

    /// The least |b|/a of all turning points; infinite for none.
    pub fn flattest(&self) -> f64 {
        self.flattest
    }

    /// The periods of the first swing and of the last, there and back, s; not numbers for less than a swing.
    pub fn swing_periods(&self) -> [f64; 2] {
        let [first, _, last] = self.last_times;
        match self.first_times[..] {
            [start, _, end] => [end - start, last - first],
            _ => [f64::NAN; 2],
        }
    }
}

/// The share of Foucault's rate below which a plane stands.
pub const STANDSTILL: f64 = 0.1;

/// By how much Foucault's plane turns, in rad, in the shortest stretch over which it is seen whether a plane stands.
const LEAST_TURN: f64 = 0.01;

/// That stretch against all the time, at least.
const SHORTEST: f64 = 0.02;

/// The share of the time that is over at the end, over which the rate at the end is measured.
const END: f64 = 0.05;

/// The mean rate of an azimuth, rad/s; 0 for fewer than two times.
pub fn mean_rate(times: &[f64], azimuths: &[f64]) -> f64 {
    let ends = |values: &[f64]| Some(values.last()? - values.first()?);
    match (ends(times), ends(azimuths)) {
        (Some(elapsed), Some(turned)) if elapsed > 0.0 => turned / elapsed,
        _ => 0.0,
    }
}

/// The rate of an azimuth over the last twentieth of the time, rad/s; 0 for fewer than two times.
pub fn rate_at_the_end(times: &[f64], azimuths: &[f64]) -> f64 {
    let (Some(first), Some(last)) = (times.first(), times.last()) else { return 0.0 };
    let from = last - END * (last - first);
    let index = times.partition_point(|time| *time <= from).saturating_sub(1);
    mean_rate(&times[index..], &azimuths[index..])
}

/// Since when a plane stands that the Earth alone would turn with `foucault` rad/s: from then on to the end it turns by
/// less than a tenth of that in any stretch of the time in which the Earth turns it by 0.01 rad, or of a fiftieth of all
/// the time where that is longer. None where it does not stand at the end, where nothing would turn it, and where the
/// time is too short to tell.
pub fn stands_since(times: &[f64], azimuths: &[f64], foucault: f64) -> Option<f64> {
    let (start, end) = (*times.first()?, *times.last()?);
    let stretch = (LEAST_TURN / foucault.abs()).max(SHORTEST * (end - start));
    let mut since = None;
    let mut after = times.len() - 1;
    for index in (0..times.len()).rev().skip_while(|index| times[*index] + stretch > end) {
        while after > 0 && times[after - 1] >= times[index] + stretch {
            after -= 1;
        }
        let turned = (azimuths[after] - azimuths[index]).abs();
        if turned > STANDSTILL * foucault.abs() * (times[after] - times[index]) {
            break;
        }
        since = Some(times[index]);
    }
    since
}

#[cfg(test)]
mod tests {
    use super::{mean_rate, rate_at_the_end, stands_since};

    /// Turns like Foucault's plane for a while, then hangs about a place.
    fn track(until: f64, stop: f64, wobble: f64) -> (Vec<f64>, Vec<f64>) {
        let times: Vec<f64> = (0..=1000).map(|k| until * f64::from(k) / 1000.0).collect();
        let azimuths = times.iter().map(|t| -5e-5 * t.min(stop) + wobble * (t / 30.0).sin()).collect();
        (times, azimuths)
    }

    #[test]
    fn a_plane_stands_since_it_has_stopped() {
        let (times, azimuths) = track(20_000.0, 8000.0, 1e-4);
        let since = stands_since(&times, &azimuths, -5e-5).unwrap_or(f64::NAN);
        // A stretch that begins up to a tenth of its length before the stop turns by no more than a tenth.
        assert!((7940.0..=8020.0).contains(&since), "{since}");
        assert!(rate_at_the_end(&times, &azimuths).abs() < 1e-6);
        assert!((mean_rate(&times, &azimuths) + 2e-5).abs() < 1e-7);
    }

    #[test]
    fn a_plane_that_turns_or_cannot_be_told_does_not_stand() {
        let (times, azimuths) = track(20_000.0, 1e9, 0.0);
        assert_eq!(stands_since(&times, &azimuths, -5e-5), None);
        assert!((rate_at_the_end(&times, &azimuths) + 5e-5).abs() < 1e-12);
        let (times, azimuths) = track(100.0, 0.0, 0.0);
        assert_eq!(stands_since(&times, &azimuths, -5e-5), None);
        assert_eq!(stands_since(&times, &azimuths, 0.0), None);
        assert_eq!(stands_since(&[], &[], -5e-5), None);
        assert_eq!(rate_at_the_end(&[1.0], &[0.3]), 0.0);
    }
}
