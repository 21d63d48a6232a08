//! What the plane of a real swing comes to, with all that acts on it: the averaged motion, run until it shows.

use crate::envelope::{Envelope, EnvelopeMotion, EnvelopeWalks};
use crate::given::decay::Decay;
use crate::plane::budget::STALL;
use crate::plane::portrait::Verdict;
use crate::taylor::walk::{Halt, Stop};
use std::f64::consts::{PI, TAU};

/// A driven swing is looked at after so many times the decay time of its amplitude.
const SETTLES: f64 = 15.0;

/// A swing that dies away is looked at until so much of its amplitude is left.
const LEFT: f64 = 0.1;

/// Any other for so many turns of the Earth.
const TURNS: usize = 4;

/// Nothing is looked at that takes longer than this, s: 120 days, in which the Earth turns four times at 2° latitude.
const LONGEST: f64 = 120.0 * 86_400.0;

/// Readings in each of these, or until a swing has died away.
const READINGS: usize = 400;

/// A plane that moves by less than this in a turn of the Earth stands, rad.
const STILL: f64 = 0.01;

/// What came out, over the time that was looked at.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Settled {
    /// Whether the plane goes round: by more than half a turn within four turns of the Earth, or, where the swing dies away
    /// first, at more than [`STALL`] of the Earth's rate in its sense.
    pub verdict: Verdict,
    /// When the look begins, s: at the launch, or when a driven swing has settled.
    pub from: f64,
    /// When it ends, s.
    pub until: f64,
    /// By how much the plane turned in between, rad, counter-clockwise seen from above.
    pub turned: f64,
    /// The azimuths between which it was in the last turn of the Earth, rad.
    pub azimuths: [f64; 2],
    /// The largest |b| in that time, m.
    pub widest: f64,
    /// The amplitude at the end, m.
    pub amplitude: f64,
    /// Whether the swing dies away, so that the look is over its life.
    pub dies: bool,
}

/// Follows a motion until it shows what its plane comes to. `None` without a turning ground, where the motion ends or a drive
/// brakes it to less than a push alone makes a bob at rest swing by before it is looked at, where that would take longer than
/// 120 days, and where `stop`, which is asked all the time, says so.
pub fn settle(motion: &EnvelopeMotion, stop: Stop<'_>) -> Option<Settled> {
    let (pendulum, forces, drive) = motion.given();
    let (omega0, rotation) = (pendulum.angular_frequency(), forces.rotation[1]);
    if rotation == 0.0 {
        return None;
    }
    let mut walks = EnvelopeWalks::default();
    let mut read = |time: f64| -> Result<_, Halt> {
        let mut ellipse = [f64::NAN; 3];
        motion.fill(Envelope::Ellipse, &[time], &mut ellipse, &mut walks, stop)?;
        let [a, b, azimuth] = ellipse;
        Ok((azimuth, [a, b]))
    };
    let (_, [a, _]) = read(0.0).ok()?;
    let decay = Decay::new(forces.damping, forces.quadratic, omega0);
    let stroke = drive.push().abs() / omega0;
    let driven = stroke > 0.0;
    let loss = decay.rate(a);
    let turn = TAU / rotation.abs();
    let life = decay.until(a, LEFT * a);
    let dies = !driven && life < TURNS as f64 * turn;
    let from = if driven && loss > 0.0 { SETTLES / loss } else { 0.0 };
    let (windows, window) = if dies { (1, life) } else { (TURNS, turn) };
    if from + windows as f64 * window > LONGEST {
        return None;
    }
    if from > 0.0 {
        for reading in 0..READINGS {
            let (_, [left, _]) = read(from * reading as f64 / READINGS as f64).ok()?;
            if left < stroke {
                return None;
            }
        }
    }
    let (first, axes) = read(from).ok()?;
    let mut settled = Settled {
        verdict: Verdict::ToAndFro,
        from,
        until: from,
        turned: 0.0,
        azimuths: [first; 2],
        widest: axes[1].abs(),
        amplitude: axes[0],
        dies,
    };
    for index in 0..windows {
        settled.azimuths = [first + settled.turned; 2];
        settled.widest = 0.0;
        for reading in 1..=READINGS {
            let time = from + window * (index as f64 + reading as f64 / READINGS as f64);
            let (azimuth, [a, b]) = match read(time) {
                Ok(ellipse) => ellipse,
                Err(Halt::Ended(..)) => return Some(settled),
                Err(Halt::Interrupted) => return None,
            };
            settled.until = time;
            settled.turned = azimuth - first;
            settled.azimuths = [settled.azimuths[0].min(azimuth), settled.azimuths[1].max(azimuth)];
            settled.widest = settled.widest.max(b.abs());
            settled.amplitude = a;
        }
        let moved = settled.azimuths[1] - settled.azimuths[0];
        let alone = -rotation * (settled.until - from);
        if settled.turned.abs() > PI || (dies && settled.turned / alone > STALL) {
            settled.verdict = Verdict::Round;
            break;
        }
        if moved < STILL && !dies {
            settled.verdict = Verdict::Stands;
            break;
        }
    }
    Some(settled)
}
