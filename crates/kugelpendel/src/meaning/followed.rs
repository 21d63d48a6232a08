//! What a real motion does up to a time: followed once, and read off at its turning points.

use crate::given::pendulum::Pendulum;
use crate::meaning::apsides::{ApsidesTrack, Apsis, stands_since};
use crate::real::ensemble::{Case, Done};
use crate::real::motion::RealMotion;
use crate::taylor::events::Event;
use crate::taylor::walk::{Halt, Readings, Stop, Walk};
use std::cell::RefCell;
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
    let (ends, mut pulls) = (Follower::ends(times), [f64::NAN; 2]);
    let mut follower = Follower::new((pendulum, rotation), &ends, &mut pulls);
    while let Some(mut readings) = follower.readings() {
        motion.read(&mut readings, walk, stop)?;
        held(&readings, walk)?;
        follower.note(&readings);
    }
    Ok(follower.finish(times, ellipses))
}

/// Follows many motions to their last times as [`follow`] does, to the same bits, up to `at_once` of them side by side. A
/// case has [`Follower::readings`] of its first stretch; it is handed back with what halted it.
pub fn follow_all<'a, T>(
    cases: &mut dyn Iterator<Item = Case<'a, RealMotion, (Follower<'a>, T)>>,
    at_once: usize,
    done: Done<'_, 'a, RealMotion, (Follower<'a>, T)>,
    stop: Stop<'_>,
) {
    // Cases that are done with a stretch and have more to come go before those that have not begun.
    let under_way = RefCell::new(Vec::new());
    let mut next = std::iter::from_fn(|| under_way.borrow_mut().pop().or_else(|| cases.next()));
    let mut noted = |mut case: Case<'a, RealMotion, (Follower<'a>, T)>, halted: Result<(), Halt>| {
        let halted = halted.and_then(|()| held(&case.readings, &case.walk));
        if halted.is_ok() {
            case.tag.0.note(&case.readings);
            if let Some(readings) = case.tag.0.readings() {
                case.readings = readings;
                under_way.borrow_mut().push(case);
                return;
            }
        }
        done(case, halted);
    };
    RealMotion::read_all(&mut next, at_once, &mut noted, stop);
}

/// Where only events are asked for, an end of the motion halts nothing.
fn held(readings: &Readings<'_>, walk: &Walk) -> Result<(), Halt> {
    match walk.ended(true) {
        Some((time, ending)) if time < readings.between[1] => Err(Halt::Ended(time, ending)),
        _ => Ok(()),
    }
}

/// A motion that is followed, stretch by stretch.
#[derive(Debug)]
pub struct Follower<'a> {
    ends: &'a [f64; 2],
    /// For the tensions at those ends that are still to come.
    pulls: &'a mut [f64],
    /// When the next stretch begins, s; none after the last.
    from: Option<f64>,
    /// How long it is, s.
    stretch: f64,
    rotation: f64,
    track: ApsidesTrack,
    tension: [f64; 2],
    /// When the latest outer turning point was.
    noted: f64,
}

impl<'a> Follower<'a> {
    /// From when to when motions are followed to the last of some ascending times, s.
    pub fn ends(times: &[f64]) -> [f64; 2] {
        [0.0, times.last().copied().unwrap_or(0.0)]
    }

    /// Before the first stretch, with room for the tensions at both ends.
    pub fn new((pendulum, rotation): (Pendulum, f64), ends: &'a [f64; 2], pulls: &'a mut [f64]) -> Self {
        Self {
            ends,
            pulls,
            from: Some(ends[0]),
            stretch: TOGETHER * TAU / pendulum.angular_frequency(),
            rotation,
            track: ApsidesTrack::new(pendulum, rotation),
            tension: [f64::INFINITY, f64::NEG_INFINITY],
            noted: f64::NEG_INFINITY,
        }
    }

    /// What has to be read in the next stretch; none where there is none left.
    pub fn readings(&mut self) -> Option<Readings<'a>> {
        let (from, [start, until]) = (self.from?, *self.ends);
        let to = until.min(from + self.stretch);
        self.from = (to < until).then_some(to);
        let times = match (from == start, to == until) {
            (true, true) => &self.ends[..],
            (true, false) => &self.ends[..1],
            (false, true) => &self.ends[1..],
            (false, false) => &[],
        };
        let (tension, rest) = std::mem::take(&mut self.pulls).split_at_mut(times.len());
        self.pulls = rest;
        let events = &[Event::Outer, Event::Inner];
        Some(Readings { times, tension, events, between: [from, to], most: usize::MAX, ..Readings::default() })
    }

    /// Notes what has been read in it.
    pub fn note(&mut self, readings: &Readings<'_>) {
        let Readings { found, tension, .. } = readings;
        let seen = found.iter().flatten().map(|passage| passage.tension).chain(tension.iter().copied());
        self.tension = seen.fold(self.tension, |[least, most], pull| [least.min(pull), most.max(pull)]);
        // One at the very end of a stretch begins the next one too.
        let outer = found[0].iter().filter(|passage| passage.time > self.noted);
        let outer: Vec<_> = outer.map(|passage| (passage.time, passage.state)).collect();
        self.noted = outer.last().map_or(self.noted, |(time, _)| *time);
        self.track.add(&outer);
    }

    /// What it has come to, after the last stretch; see [`follow`].
    pub fn finish(&self, times: &[f64], ellipses: &mut [f64]) -> Followed {
        let apsides = self.track.track();
        for (time, out) in times.iter().zip(ellipses.chunks_exact_mut(3)) {
            out.copy_from_slice(&at(&apsides, *time));
        }
        let (passed, azimuths): (Vec<_>, Vec<_>) = apsides.iter().map(|apsis| (apsis.time, apsis.azimuth)).unzip();
        Followed {
            widest: self.track.widest(),
            tension: self.tension,
            quarter_turn: quarter_turn(&apsides),
            stands_since: stands_since(&passed, &azimuths, -self.rotation).unwrap_or(f64::INFINITY),
        }
    }
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
    use super::{Follower, follow, follow_all};
    use crate::exact::motion::ExactMotion;
    use crate::given::drive::Drive;
    use crate::given::forces::{Forces, Thread};
    use crate::given::launch::Launch;
    use crate::given::pendulum::Pendulum;
    use crate::real::ensemble::Case;
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

    #[test]
    fn side_by_side_they_are_followed_as_alone() {
        let ground = Forces { rotation: [4e-5, 5e-5], anisotropy: 2e-3, axis: 0.4, ..Forces::default() };
        let braked = Forces { damping: 1e-3, quadratic: 0.02, ..ground };
        let drives =
            [Drive::Absent, Drive::Phase { push: 2e-3, phase: 0.3 }, Drive::Radius { push: 2e-3, radius: 0.05 }];
        let mut motions = Vec::new();
        for k in 0..40 {
            let size = 0.02 * f64::from(k + 1);
            let launch = match k % 3 {
                0 => Launch::Ellipse { a: size, b: 0.3 * size, azimuth: 0.1 },
                1 => Launch::Ellipse { a: size, b: 0.0, azimuth: -0.7 },
                // Some of these end, since their threads go slack.
                _ => Launch::Angles { theta: 3.0 * size, phi: 0.2, theta_rate: 0.1, phi_rate: 0.4 },
            };
            let forces = [Forces::default(), ground, braked][k as usize / 2 % 3];
            let thread = [Thread::Ends, Thread::Rod, Thread::Flies][k as usize / 5 % 3];
            let drive = if matches!(thread, Thread::Flies) { Drive::Absent } else { drives[k as usize % 3] };
            motions.extend(RealMotion::new(PENDULUM, launch, forces, drive, thread, 0.0));
        }
        assert!(motions.len() > 30);
        let stop = || false;
        for times in [vec![0.0, 3.0, 1300.0], vec![40.0], vec![0.0]] {
            let alone: Vec<_> = motions
                .iter()
                .map(|motion| {
                    let mut ellipses = vec![0.0; 3 * times.len()];
                    let found = follow(motion, (PENDULUM, 5e-5), &times, &mut ellipses, &mut Walk::new(16), &stop);
                    format!("{:?}", found.map(|found| (found, ellipses)))
                })
                .collect();
            assert!(times[0] > 0.0 || alone.iter().any(|found| found.contains("Slack")) || times.len() == 1);
            let ends = Follower::ends(&times);
            for at_once in [1, 5, 99] {
                let mut pulls = vec![f64::NAN; 2 * motions.len()];
                let mut cases = motions.iter().zip(pulls.chunks_mut(2)).enumerate().map(|(tag, (motion, tension))| {
                    let mut follower = Follower::new((PENDULUM, 5e-5), &ends, tension);
                    let readings = follower.readings().unwrap_or_default();
                    Case { tag: (follower, tag), motion, readings, walk: Walk::new(16) }
                });
                let mut together = vec![String::new(); motions.len()];
                let mut done = |case: Case<'_, RealMotion, (Follower<'_>, usize)>, halted: Result<(), Halt>| {
                    let (follower, tag) = case.tag;
                    let mut ellipses = vec![0.0; 3 * times.len()];
                    together[tag] =
                        format!("{:?}", halted.map(|()| (follower.finish(&times, &mut ellipses), ellipses)));
                };
                follow_all(&mut cases, at_once, &mut done, &stop);
                for (tag, (together, alone)) in together.iter().zip(&alone).enumerate() {
                    assert_eq!(together, alone, "case {tag}, {at_once} at once, up to {times:?}");
                }
            }
        }
    }
}
