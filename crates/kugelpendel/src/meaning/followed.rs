//! What a real motion does up to a time: followed once, and read off at its turning points.

use crate::given::pendulum::Pendulum;
use crate::meaning::apsides::{ApsidesTrack, Apsis, stands_since};
use crate::real::motion::RealMotion;
use crate::taylor::events::Event;
use crate::taylor::walk::{Halt, Readings, Stop, Walk};
use std::f64::consts::{FRAC_PI_2, TAU};

/// Swings between two times at which what was found is put away.
const TOGETHER: f64 = 256.0;

/// From the launch to the last time that was asked for.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Followed {
    /// The largest |b| at the outer turning points, m.
    pub widest: f64,
    /// The least and the largest pull of the thread, N: at the launch, at the turning points and at the end.
    pub tension: [f64; 2],
    /// When the plane has turned by a quarter of a turn, either way, s; infinite where it has not.
    pub quarter_turn: f64,
    /// Since when the plane stands, s, as [`stands_since`] has it; infinite where it does not at the end.
    pub stands_since: f64,
}

/// Follows a motion to the last of some ascending times in s, none before the launch, and fills `ellipses` with a and b in
/// m and the azimuth in rad, three numbers to a time: between the outer turning points before and after it in a straight
/// line, and on in that of the nearest two where it has none on one side. NaN where there are fewer than two.
///
/// `pendulum` is the point mass that moves like the bob, `rotation` the rate of the ground about the vertical, rad/s.
///
/// # Errors
/// What halted the motion before the last time.
pub fn follow(
    motion: &RealMotion,
    (pendulum, rotation): (Pendulum, f64),
    times: &[f64],
    ellipses: &mut [f64],
    walk: &mut Walk,
    stop: Stop<'_>,
) -> Result<Followed, Halt> {
    let until = times.last().copied().unwrap_or(0.0);
    let stretch = TOGETHER * TAU / pendulum.angular_frequency();
    let mut track = ApsidesTrack::new(pendulum, rotation);
    let (mut from, mut tension, mut noted) = (0.0, [f64::INFINITY, f64::NEG_INFINITY], f64::NEG_INFINITY);
    loop {
        let to = until.min(from + stretch);
        let mut pulls = [f64::NAN; 2];
        let mut readings = Readings {
            times: &[from, to],
            tension: &mut pulls,
            events: &[Event::Outer, Event::Inner],
            between: [from, to],
            most: usize::MAX,
            ..Readings::default()
        };
        motion.read(&mut readings, walk, stop)?;
        let found = std::mem::take(&mut readings.found);
        let seen = found.iter().flatten().map(|passage| passage.tension).chain(pulls);
        tension = seen.fold(tension, |[least, most], pull| [least.min(pull), most.max(pull)]);
        // One at the very end of a stretch begins the next one too.
        let outer = found[0].iter().filter(|passage| passage.time > noted);
        let outer: Vec<_> = outer.map(|passage| (passage.time, passage.state)).collect();
        noted = outer.last().map_or(noted, |(time, _)| *time);
        track.add(&outer);
        if to >= until {
            break;
        }
        from = to;
    }
    let apsides = track.track();
    for (time, out) in times.iter().zip(ellipses.chunks_exact_mut(3)) {
        out.copy_from_slice(&at(&apsides, *time));
    }
    let (passed, azimuths): (Vec<_>, Vec<_>) = apsides.iter().map(|apsis| (apsis.time, apsis.azimuth)).unzip();
    Ok(Followed {
        widest: track.widest(),
        tension,
        quarter_turn: quarter_turn(&apsides),
        stands_since: stands_since(&passed, &azimuths, -rotation).unwrap_or(f64::INFINITY),
    })
}

/// a, b and azimuth at a time, on the line through two turning points.
fn at(apsides: &[Apsis], time: f64) -> [f64; 3] {
    let after = apsides.partition_point(|apsis| apsis.time < time).clamp(1, apsides.len().saturating_sub(1).max(1));
    let (Some(first), Some(last)) = (apsides.get(after - 1), apsides.get(after)) else { return [f64::NAN; 3] };
    let share = (time - first.time) / (last.time - first.time);
    let between = |from: f64, to: f64| from + share * (to - from);
    [between(first.a, last.a), between(first.b, last.b), between(first.azimuth, last.azimuth)]
}

/// When the azimuth is a quarter of a turn from that of the first turning point, s.
fn quarter_turn(apsides: &[Apsis]) -> f64 {
    let Some(start) = apsides.first() else { return f64::INFINITY };
    let turned = |apsis: &Apsis| (apsis.azimuth - start.azimuth).abs();
    let Some(after) = apsides.iter().position(|apsis| turned(apsis) >= FRAC_PI_2) else { return f64::INFINITY };
    let [before, after] = [&apsides[after - 1], &apsides[after]];
    let share = (FRAC_PI_2 - turned(before)) / (turned(after) - turned(before));
    before.time + share * (after.time - before.time)
}

#[cfg(test)]
mod tests {
    use super::follow;
    use crate::exact::motion::ExactMotion;
    use crate::given::drive::Drive;
    use crate::given::forces::{Forces, Thread};
    use crate::given::launch::Launch;
    use crate::given::pendulum::Pendulum;
    use crate::real::motion::RealMotion;
    use crate::taylor::step::Ending;
    use crate::taylor::walk::{Halt, Walk};
    use std::f64::consts::FRAC_PI_2;

    const PENDULUM: Pendulum = Pendulum { length: 1.0, gravity: 9.81, mass: 2.0 };

    #[test]
    fn an_ideal_motion_is_read_off_as_its_closed_form_has_it() {
        let launch = Launch::Apsides { a: 0.3, b: -0.1, azimuth: 0.4 };
        let exact = ExactMotion::new(PENDULUM, launch).unwrap_or_else(|e| panic!("{e:?}"));
        let motion = RealMotion::new(PENDULUM, launch, Forces::default(), Drive::Absent, Thread::Ends, 0.0);
        let motion = motion.unwrap_or_else(|e| panic!("{e:?}"));
        let times = [0.0, 20.0, 1500.0];
        let mut ellipses = [f64::NAN; 9];
        let found = follow(&motion, (PENDULUM, 0.0), &times, &mut ellipses, &mut Walk::new(2), &|| false);
        let found = found.unwrap_or_else(|e| panic!("{e:?}"));
        for (time, row) in times.iter().zip(ellipses.chunks(3)) {
            let expected = [0.3, -0.1, 0.4 + exact.precession() * time];
            assert!(row.iter().zip(expected).all(|(seen, told)| (seen - told).abs() < 1e-9), "{row:?} at {time}");
        }
        let [least, most] = exact.tension_range();
        assert!((found.widest - 0.1).abs() < 1e-10, "{found:?}");
        assert!((found.tension[0] - least).abs() < 1e-9 && (found.tension[1] - most).abs() < 1e-9, "{found:?}");
        let quarter = FRAC_PI_2 / exact.precession().abs();
        assert!((found.quarter_turn - quarter).abs() < 1e-6 * quarter, "{found:?} for {quarter}");
        assert_eq!(found.stands_since, f64::INFINITY);
    }

    #[test]
    fn what_ends_before_the_last_time_says_so_and_less_than_a_swing_has_no_plane() {
        let launch = Launch::Angles { theta: 2.0, phi: 0.0, theta_rate: 0.0, phi_rate: 0.1 };
        let motion = RealMotion::new(PENDULUM, launch, Forces::default(), Drive::Absent, Thread::Ends, 0.0);
        let motion = motion.unwrap_or_else(|e| panic!("{e:?}"));
        let mut ellipses = [0.0; 3];
        let read = |times, ellipses: &mut [f64]| {
            follow(&motion, (PENDULUM, 0.0), times, ellipses, &mut Walk::new(2), &|| false)
        };
        assert!(matches!(read(&[10.0], &mut ellipses), Err(Halt::Ended(_, Ending::Slack))));
        let launch = Launch::Ellipse { a: 0.1, b: 0.0, azimuth: 0.0 };
        let swing = RealMotion::new(PENDULUM, launch, Forces::default(), Drive::Absent, Thread::Ends, 0.0);
        let swing = swing.unwrap_or_else(|e| panic!("{e:?}"));
        let found = follow(&swing, (PENDULUM, 0.0), &[0.3], &mut ellipses, &mut Walk::new(2), &|| false);
        assert!(found.is_ok() && ellipses.iter().all(|number| number.is_nan()), "{found:?} {ellipses:?}");
    }
}
