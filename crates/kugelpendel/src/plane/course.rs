//! What the plane of an averaged motion does in a stretch of time: a few numbers, from readings at evenly spread times.

use crate::envelope::{CAUSES, Envelope, EnvelopeMotion, EnvelopeWalks};
use crate::meaning::apsides::stands_since;
use crate::numbers::roots::Bracket;
use crate::plane::portrait::{Orbit, Portrait};
use crate::taylor::walk::{Halt, Stop};
use std::f64::consts::{FRAC_PI_2, TAU};

/// Readings at least and at most.
const READINGS: [f64; 2] = [400.0, 20_000.0];

/// Readings while the shape goes once round its sphere, as fast as it can.
const IN_A_TURN: f64 = 40.0;

/// Rounds of looking closer at an extreme, and steps in each.
const CLOSER: usize = 3;
const PLACES: usize = 24;

/// Rounds of closing in on a time; the digits double in most.
const ROUNDS: usize = 60;

/// From the launch to the end of a stretch of time.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PlaneCourse {
    /// The largest |b|, m.
    pub widest: f64,
    /// When the plane has turned by a quarter of a turn, either way, s; infinite where it has not.
    pub quarter_turn: f64,
    /// Since when the plane stands, s, as [`stands_since`] has it; infinite where it does not at the end.
    pub stands_since: f64,
}

/// The orbit of the launch on the portrait of its clamp, as it would be without drag and drive.
///
/// # Errors
/// Only the wish of `stop`.
pub fn clamp_orbit(motion: &EnvelopeMotion, stop: Stop<'_>) -> Result<Orbit, Halt> {
    let (pendulum, forces, _) = motion.given();
    let mut ellipse = [f64::NAN; 3];
    motion.fill(Envelope::Ellipse, &[0.0], &mut ellipse, &mut EnvelopeWalks::default(), stop)?;
    let [a, b, azimuth] = ellipse;
    let portrait = Portrait::new(pendulum, forces, a, b);
    Ok(portrait.orbit(portrait.form(a, b, azimuth)))
}

/// What the plane does from the launch to a time in s after it.
///
/// # Errors
/// What halted the motion before that time.
pub fn course(motion: &EnvelopeMotion, until: f64, stop: Stop<'_>) -> Result<PlaneCourse, Halt> {
    let read = |times: &[f64]| {
        let mut ellipses = vec![f64::NAN; 3 * times.len()];
        motion.fill(Envelope::Ellipse, times, &mut ellipses, &mut EnvelopeWalks::default(), stop)?;
        let (widths, azimuths): (Vec<_>, Vec<_>) = ellipses.chunks_exact(3).map(|row| (row[1].abs(), row[2])).unzip();
        Ok((widths, azimuths))
    };
    let times = spread(motion, [0.0, until], stop)?;
    let (widths, azimuths) = read(&times)?;
    let foucault = -motion.given().1.rotation[1];
    Ok(PlaneCourse {
        widest: largest(times.clone(), widths, |times| read(times).map(|(widths, _)| widths))?,
        quarter_turn: quarter_turn(motion, &times, &azimuths, stop)?,
        stands_since: stands_since(&times, &azimuths, foucault).unwrap_or(f64::INFINITY),
    })
}

/// The least and the largest rate of the plane between two times, in the sense in which the Earth turns it, or clockwise
/// where it does not: rad/s.
///
/// # Errors
/// What halted the motion before the second time.
pub fn pace(motion: &EnvelopeMotion, between: [f64; 2], stop: Stop<'_>) -> Result<[f64; 2], Halt> {
    let way = if motion.given().1.rotation[1] < 0.0 { 1.0 } else { -1.0 };
    let read = |times: &[f64], sign: f64| {
        let mut rates = vec![f64::NAN; Envelope::Rates.width() * times.len()];
        motion.fill(Envelope::Rates, times, &mut rates, &mut EnvelopeWalks::default(), stop)?;
        let totals = rates.chunks_exact(Envelope::Rates.width()).map(|row| row[..CAUSES].iter().sum::<f64>());
        Ok(totals.map(|rate| sign * rate).collect::<Vec<_>>())
    };
    let times = spread(motion, between, stop)?;
    let rates = read(&times, 1.0)?;
    let extreme = |sign: f64| {
        let signed = rates.iter().map(|rate| sign * rate).collect();
        largest(times.clone(), signed, |times| read(times, sign)).map(|most| sign * most)
    };
    Ok([extreme(-way)?, extreme(way)?])
}

/// The largest of some readings, looked for again and again about the one that it is at: next to a circle the ellipse and its
/// plane turn round within moments.
fn largest(
    mut times: Vec<f64>,
    mut readings: Vec<f64>,
    read: impl Fn(&[f64]) -> Result<Vec<f64>, Halt>,
) -> Result<f64, Halt> {
    for _ in 0..CLOSER {
        let (place, _) = peak(&readings);
        let (before, after) = (place.saturating_sub(1), (place + 1).min(times.len() - 1));
        times = evenly([times[before], times[after]], PLACES);
        readings = read(&times)?;
    }
    Ok(peak(&readings).1)
}

/// Evenly spread times from the first to the last, close enough for what the clamp, the ground and the ellipse itself do.
fn spread(motion: &EnvelopeMotion, [from, until]: [f64; 2], stop: Stop<'_>) -> Result<Vec<f64>, Halt> {
    let (pendulum, forces, _) = motion.given();
    let mut axes = [f64::NAN; 2];
    motion.fill(Envelope::SemiAxes, &[0.0], &mut axes, &mut EnvelopeWalks::default(), stop)?;
    let Portrait { rotation, anisotropy, intrinsic, .. } = Portrait::new(pendulum, forces, axes[0], axes[1]);
    let fastest = 2.0 * rotation.abs() + anisotropy.abs() + intrinsic + forces.damping_anisotropy.abs();
    let [least, most] = READINGS;
    let count = (IN_A_TURN * fastest / TAU * (until - from)).ceil().clamp(least, most);
    Ok(evenly([from, until], count as usize))
}

/// So many steps, and one time more.
fn evenly([from, until]: [f64; 2], count: usize) -> Vec<f64> {
    (0..=count).map(|k| from + (until - from) * (k as f64 / count as f64)).collect()
}

/// The largest of some readings and of the parabolas through three of them, and the reading that it is at.
fn peak(readings: &[f64]) -> (usize, f64) {
    let ends = [0, readings.len() - 1].map(|place| (place, readings[place]));
    let peaks = readings.windows(3).enumerate().filter_map(|(before, three)| {
        let (slope, bend) = (three[2] - three[0], three[0] - 2.0 * three[1] + three[2]);
        let top = three[1] >= three[0] && three[1] >= three[2];
        top.then(|| (before + 1, if bend < 0.0 { three[1] - slope * slope / (8.0 * bend) } else { three[1] }))
    });
    ends.into_iter().chain(peaks).fold((0, f64::NEG_INFINITY), |best, next| if next.1 > best.1 { next } else { best })
}

/// When the azimuth is a quarter of a turn from where it was at first, to the last bits.
fn quarter_turn(motion: &EnvelopeMotion, times: &[f64], azimuths: &[f64], stop: Stop<'_>) -> Result<f64, Halt> {
    let short = |azimuth: f64| (azimuth - azimuths[0]).abs() - FRAC_PI_2;
    let Some(after) = azimuths.iter().position(|azimuth| short(*azimuth) >= 0.0) else { return Ok(f64::INFINITY) };
    let ends = [after - 1, after];
    let mut bracket = Bracket::new(ends.map(|k| times[k]), ends.map(|k| short(azimuths[k])));
    let (mut walks, mut azimuth) = (EnvelopeWalks::default(), [f64::NAN]);
    motion.fill(Envelope::Azimuth, &[times[after - 1]], &mut azimuth, &mut walks, stop)?;
    for _ in 0..ROUNDS {
        let Some(time) = bracket.next() else { break };
        motion.fill(Envelope::Azimuth, &[time], &mut azimuth, &mut walks.clone(), stop)?;
        bracket.tell(time, short(azimuth[0]));
    }
    Ok(bracket.best())
}

#[cfg(test)]
mod tests {
    use super::{course, pace};
    use crate::envelope::{CAUSES, Envelope, EnvelopeMotion, EnvelopeWalks};
    use crate::given::drive::Drive;
    use crate::given::forces::Forces;
    use crate::given::launch::Launch;
    use crate::given::pendulum::Pendulum;
    use crate::taylor::walk::Halt;
    use std::f64::consts::FRAC_PI_2;

    const PENDULUM: Pendulum = Pendulum { length: 10.0, gravity: 9.81, mass: 1.0 };

    fn motion(anisotropy: f64, turn: f64) -> EnvelopeMotion {
        let forces = Forces { rotation: [0.0, turn], anisotropy, axis: 0.3, damping: 1e-5, ..Forces::default() };
        let launch = Launch::Ellipse { a: 0.3, b: 0.0, azimuth: 1.0 };
        EnvelopeMotion::new(PENDULUM, launch, forces, Drive::Absent, true).unwrap_or_else(|e| panic!("{e:?}"))
    }

    #[test]
    fn extremes_are_those_of_a_hundred_times_as_many_readings() {
        for (anisotropy, turn) in [(3e-5, 5.6e-5), (-2e-4, -5.6e-5), (6e-4, 5.6e-5)] {
            let motion = motion(anisotropy, turn);
            let until = 30.0 * 3600.0;
            let found = course(&motion, until, &|| false).unwrap_or_else(|e| panic!("{e:?}"));
            let [slowest, fastest] = pace(&motion, [0.0, until], &|| false).unwrap_or_else(|e| panic!("{e:?}"));
            let times: Vec<f64> = (0..=200_000).map(|k| until * f64::from(k) / 200_000.0).collect();
            let (mut axes, mut rates) = (vec![0.0; 2 * times.len()], vec![0.0; 7 * times.len()]);
            let fill = |what, out: &mut [f64]| motion.fill(what, &times, out, &mut EnvelopeWalks::default(), &|| false);
            assert_eq!((fill(Envelope::SemiAxes, &mut axes), fill(Envelope::Rates, &mut rates)), (Ok(()), Ok(())));
            let widest = axes.chunks(2).map(|row| row[1].abs()).fold(0.0, f64::max);
            assert!((found.widest / widest - 1.0).abs() < 1e-4, "{found:?} for {widest}");
            let way = -turn.signum();
            let along = rates.chunks(7).map(|row| way * row[..CAUSES].iter().sum::<f64>());
            let [least, most] = [along.clone().fold(f64::INFINITY, f64::min), along.fold(f64::NEG_INFINITY, f64::max)];
            let close = 1e-3 * (most - least);
            assert!((way * slowest - least).abs() < close, "{slowest} for {least}");
            assert!((way * fastest - most).abs() < close, "{fastest} for {most}");
        }
    }

    #[test]
    fn a_quarter_of_a_turn_is_one_to_the_last_bits() {
        let motion = motion(2e-5, 5.6e-5);
        let found = course(&motion, 20.0 * 3600.0, &|| false).unwrap_or_else(|e| panic!("{e:?}"));
        let mut azimuths = [0.0; 2];
        let times = [0.0, found.quarter_turn];
        let read = motion.fill(Envelope::Azimuth, &times, &mut azimuths, &mut EnvelopeWalks::default(), &|| false);
        assert_eq!(read, Ok(()));
        assert!(((azimuths[1] - azimuths[0]).abs() - FRAC_PI_2).abs() < 1e-12, "{azimuths:?}");
        let short = course(&motion, 0.5 * found.quarter_turn, &|| false).map(|found| found.quarter_turn);
        assert_eq!(short, Ok(f64::INFINITY));
    }

    #[test]
    fn a_plane_that_the_clamp_holds_stands_and_a_free_one_does_not() {
        let until = 40.0 * 3600.0;
        let since = |motion: &EnvelopeMotion| course(motion, until, &|| false).map(|found| found.stands_since);
        let forces = Forces { rotation: [0.0, 5.6e-5], damping: 2e-4, damping_anisotropy: 4e-4, ..Forces::default() };
        let launch = Launch::Ellipse { a: 0.3, b: 0.0, azimuth: 1.0 };
        let held = EnvelopeMotion::new(PENDULUM, launch, forces, Drive::Absent, true);
        let held = held.map(|motion| since(&motion).map(f64::is_finite));
        assert_eq!(held.ok(), Some(Ok(true)));
        assert_eq!(since(&motion(0.0, 5.6e-5)), Ok(f64::INFINITY));
    }

    #[test]
    fn whoever_does_not_want_it_any_more_is_obeyed() {
        assert_eq!(course(&motion(2e-5, 5.6e-5), 1e6, &|| true), Err(Halt::Interrupted));
    }
}
