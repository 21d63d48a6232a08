//! Motions that are integrated step by step, in a row: what the real ones and those by (12) and (13) have in common.

use crate::columns::{Numbers, new_array};
use crate::given::{Problems, Told, bad, problems, tell};
use crate::meaning::event;
use crate::signal::{Signal, lock};
use kugelpendel::{
    Case, Done, Ending, Follower, Halt, IntegratedMotion, Invalid, Passage, Pendulum, Readings, RealMotion, Stop, Walk,
    follow_all, in_parallel,
};
use numpy::{IntoPyArray, PyReadonlyArray1};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use rayon::prelude::*;
use std::sync::Mutex;

/// Checkpoints of a motion that is alone, and of each of many: some 130 kB and 2 kB.
const KEPT: [usize; 2] = [1024, 16];

/// Times and states of one kind of event: n times, then 3n of position, 3n of velocity, n of tension.
type Passages<'py> = (Numbers<'py>, Numbers<'py>, Numbers<'py>, Numbers<'py>);

/// How many of the times were read, up to when, when and why the motion ended ("" for not yet), position, velocity,
/// tension, and the events of each kind.
pub(crate) type Leg<'py> =
    (usize, f64, f64, &'static str, Numbers<'py>, Numbers<'py>, Numbers<'py>, Vec<Passages<'py>>);

/// What a motion is asked for at many times.
#[derive(Clone, Copy)]
pub(crate) enum Asked {
    Position,
    Velocity,
    Tension,
}

impl Asked {
    /// What is to be read into one row.
    fn readings<'a>(self, times: &'a [f64], row: &'a mut [f64]) -> Readings<'a> {
        let readings = Readings { times, ..Readings::default() };
        match self {
            Self::Position => Readings { position: row, ..readings },
            Self::Velocity => Readings { velocity: row, ..readings },
            Self::Tension => Readings { tension: row, ..readings },
        }
    }
}

/// A motion of the core that is integrated.
pub(crate) trait Readable: Sync + Sized {
    fn read(&self, readings: &mut Readings<'_>, walk: &mut Walk, stop: Stop<'_>) -> Result<(), Halt>;

    /// Reads many, up to `at_once` side by side; one by one where the motion does not know how.
    fn read_all<'a, T>(
        cases: &mut dyn Iterator<Item = Case<'a, Self, T>>,
        _at_once: usize,
        done: Done<'_, 'a, Self, T>,
        stop: Stop<'_>,
    ) {
        for mut case in cases {
            let halted = case.motion.read(&mut case.readings, &mut case.walk, stop);
            done(case, halted);
        }
    }
}

impl Readable for RealMotion {
    fn read(&self, readings: &mut Readings<'_>, walk: &mut Walk, stop: Stop<'_>) -> Result<(), Halt> {
        self.read(readings, walk, stop)
    }

    fn read_all<'a, T>(
        cases: &mut dyn Iterator<Item = Case<'a, Self, T>>,
        at_once: usize,
        done: Done<'_, 'a, Self, T>,
        stop: Stop<'_>,
    ) {
        Self::read_all(cases, at_once, done, stop);
    }
}

impl Readable for IntegratedMotion {
    fn read(&self, readings: &mut Readings<'_>, walk: &mut Walk, stop: Stop<'_>) -> Result<(), Halt> {
        self.read(readings, walk, stop)
    }
}

/// Motions in a row, each with how far it has been integrated.
pub(crate) struct Stepped<M> {
    motions: Vec<Result<M, Invalid>>,
    walks: Vec<Mutex<Walk>>,
}

impl<M: Readable> Stepped<M> {
    pub(crate) fn new(motions: Vec<Result<M, Invalid>>) -> Self {
        let kept = KEPT[usize::from(motions.len() > 1)];
        let walks = motions.iter().map(|_| Mutex::new(Walk::new(kept))).collect();
        Self { motions, walks }
    }

    /// Index of each bad case and the number of its kind.
    pub(crate) fn problems<'py>(&self, py: Python<'py>) -> Problems<'py> {
        problems(py, bad(&self.motions))
    }

    /// What is wrong with one case.
    pub(crate) fn problem(&self, index: usize) -> Option<Told> {
        self.motions[index].as_ref().err().map(tell)
    }

    /// The numbers asked for, and when each motion has ended before the last of the times, NaN where it has not; why the
    /// first has, "" where it has not.
    pub(crate) fn filled<'py>(
        &self,
        py: Python<'py>,
        times: &PyReadonlyArray1<'py, f64>,
        asked: Asked,
    ) -> PyResult<(Numbers<'py>, Numbers<'py>, &'static str)> {
        let times = times.as_slice()?;
        let size = if matches!(asked, Asked::Tension) { times.len() } else { 3 * times.len() };
        let mut ends = vec![f64::NAN; self.motions.len()];
        let mut why = "";
        let signal = Signal::default();
        let array = new_array(py, size * self.motions.len(), |out| match (&self.motions[..], &mut ends[..]) {
            ([Ok(motion)], [end]) => {
                out.fill(f64::NAN);
                let halted =
                    motion.read(&mut asked.readings(times, out), &mut lock(&self.walks[0]), &|| signal.ends_work());
                if let Err(Halt::Ended(time, ending)) = halted {
                    (*end, why) = (time, name(ending));
                }
            }
            _ if !out.is_empty() => {
                signal.watch(|| self.fill_all(times, asked, out, &mut ends, &|| signal.has_arrived()))
            }
            _ => {}
        });
        signal.raised()?;
        Ok((array, ends.into_pyarray(py), why))
    }

    /// How many motions there are.
    pub(crate) fn len(&self) -> usize {
        self.motions.len()
    }

    /// The numbers asked for of all motions, and when each that has ended did.
    fn fill_all(&self, times: &[f64], asked: Asked, out: &mut [f64], ends: &mut [f64], stop: Stop<'_>) {
        let rows = out.chunks_mut(out.len() / self.motions.len()).zip(ends).enumerate();
        let cases = rows.filter_map(|(index, (row, end))| {
            let (motion, walk) = self.taken(index, row, stop)?;
            Some(Case { tag: (index, end), motion, readings: asked.readings(times, row), walk })
        });
        self.shared_out(cases, |cases, at_once| {
            let mut done = |case: Case<'_, M, (usize, &mut f64)>, halted| {
                let (index, end) = case.tag;
                self.give_back(index, case.walk);
                if let Err(Halt::Ended(time, _)) = halted {
                    *end = time;
                }
            };
            M::read_all(cases, at_once, &mut done, stop);
        });
    }

    /// A good motion and its walk out of here, before its row is filled; the rows of the others are NaN.
    fn taken(&self, index: usize, row: &mut [f64], stop: Stop<'_>) -> Option<(&M, Walk)> {
        if stop() {
            return None; // nobody sees the array, of which to touch the rest may take long
        }
        row.fill(f64::NAN);
        let motion = self.motions[index].as_ref().ok()?;
        Some((motion, lock(&self.walks[index]).take()))
    }

    fn give_back(&self, index: usize, walk: Walk) {
        *lock(&self.walks[index]) = walk;
    }

    /// Shares cases out among the threads, each of which takes the next ones when it is done with some: `work` on those of
    /// a thread, so many at once.
    fn shared_out<C: Send>(
        &self,
        cases: impl Iterator<Item = C> + Send,
        work: impl Fn(&mut dyn Iterator<Item = C>, usize) + Sync,
    ) {
        let cases = Mutex::new(cases);
        in_parallel(|| {
            let threads = rayon::current_num_threads();
            let at_once = self.motions.len().div_ceil(threads);
            (0..threads).into_par_iter().for_each(|_| work(&mut std::iter::from_fn(|| lock(&cases).next()), at_once));
        });
    }

    /// A stretch of the first motion in one pass: states at ascending times, and the events of some kinds between two
    /// times. It is over after so many seconds of work, if any are given.
    pub(crate) fn leg<'py>(
        &self,
        py: Python<'py>,
        times: &PyReadonlyArray1<'py, f64>,
        events: &[(String, f64)],
        between: [f64; 2],
        most: usize,
        within: Option<f64>,
    ) -> PyResult<Leg<'py>> {
        let Some(Ok(motion)) = self.motions.first() else {
            return Err(PyValueError::new_err("there is no motion"));
        };
        let times = times.as_slice()?;
        if !times.is_sorted() {
            return Err(PyValueError::new_err("the times of a leg must be in order"));
        }
        let events = events.iter().map(|(kind, value)| event(kind, *value)).collect::<PyResult<Vec<_>>>()?;
        let signal = Signal::within(within);
        let count = times.len();
        let (mut position, mut velocity) = (vec![f64::NAN; 3 * count], vec![f64::NAN; 3 * count]);
        let mut tension = vec![f64::NAN; count];
        let (halt, found, until) = py.detach(|| {
            let mut readings = Readings {
                times,
                position: &mut position,
                velocity: &mut velocity,
                tension: &mut tension,
                events: &events,
                between,
                most,
                ..Readings::default()
            };
            let halt = motion.read(&mut readings, &mut lock(&self.walks[0]), &|| signal.ends_work()).err();
            (halt, readings.found, readings.until)
        });
        signal.raised()?;
        let known = lock(&self.walks[0]).ended(true).filter(|(time, _)| *time <= between[1]);
        let (end, why) = known.map_or((f64::NAN, ""), |(time, ending)| (time, name(ending)));
        let read = match halt {
            None => count,
            Some(Halt::Ended(..)) => tension.iter().position(|pull| pull.is_nan()).unwrap_or(count),
            Some(Halt::Interrupted) => times.partition_point(|time| *time <= until),
        };
        let found = found.iter().map(|passages| passages_array(py, passages)).collect();
        let [position, velocity, tension] = [position, velocity, tension].map(|values| values.into_pyarray(py));
        Ok((read, until, end, why, position, velocity, tension, found))
    }

    /// The spans of the motions, two numbers to each, NaN for the bad ones; `within` is one time in s or one for each.
    pub(crate) fn spans<'py>(
        &self,
        py: Python<'py>,
        within: &PyReadonlyArray1<'py, f64>,
        span: impl Fn(&M, f64, &mut Walk, Stop<'_>) -> Result<[f64; 2], Halt> + Sync,
    ) -> PyResult<Numbers<'py>> {
        let within = within.as_slice()?;
        if within.len() != 1 && within.len() != self.motions.len() {
            return Err(PyValueError::new_err("one time for all motions, or one for each"));
        }
        let signal = Signal::default();
        let one = |index: usize, stop: Stop<'_>| match &self.motions[index] {
            Ok(motion) => {
                let within = if within.len() == 1 { within[0] } else { within[index] };
                span(motion, within, &mut lock(&self.walks[index]), stop).unwrap_or([f64::NAN; 2])
            }
            Err(_) => [f64::NAN; 2],
        };
        let count = self.motions.len();
        let spans: Vec<_> = py.detach(|| match count {
            1 => one(0, &|| signal.ends_work()).to_vec(),
            _ => signal.watch(|| {
                in_parallel(|| {
                    let all = (0..count).into_par_iter();
                    all.flat_map_iter(|index| one(index, &|| signal.has_arrived())).collect()
                })
            }),
        });
        signal.raised()?;
        Ok(spans.into_pyarray(py))
    }
}

impl Stepped<RealMotion> {
    /// What each motion does up to the last of some ascending times, with a row of `width` numbers to write it to; NaN for
    /// the bad ones and those that end before. `given` are the point mass that moves like the bob, and how the ground turns.
    pub(crate) fn followed<'py>(
        &self,
        py: Python<'py>,
        width: usize,
        times: &[f64],
        given: impl Fn(usize) -> (Pendulum, f64) + Sync,
        write: impl Fn(&Follower<'_>, &mut [f64]) + Sync,
    ) -> PyResult<Numbers<'py>> {
        let signal = Signal::default();
        let count = self.motions.len();
        let (ends, mut pulls) = (Follower::ends(times), vec![f64::NAN; 2 * count]);
        let array = new_array(py, width * count, |out| {
            let stop = || signal.has_arrived();
            let rows = out.chunks_mut(width).zip(pulls.chunks_mut(2)).enumerate();
            let cases = rows.filter_map(|(index, (row, pulls))| {
                let (motion, walk) = self.taken(index, row, &stop)?;
                let mut follower = Follower::new(given(index), &ends, pulls);
                let readings = follower.readings()?;
                Some(Case { tag: (follower, (index, row)), motion, readings, walk })
            });
            signal.watch(|| {
                self.shared_out(cases, |cases, at_once| {
                    let mut done = |case: Case<'_, RealMotion, (Follower<'_>, (usize, &mut [f64]))>, halted| {
                        let (follower, (index, row)) = case.tag;
                        self.give_back(index, case.walk);
                        if halted == Ok(()) {
                            write(&follower, row);
                        }
                    };
                    follow_all(cases, at_once, &mut done, &stop);
                });
            });
        });
        signal.raised()?;
        Ok(array)
    }
}

fn name(ending: Ending) -> &'static str {
    match ending {
        Ending::Slack => "slack",
        Ending::Level => "level",
        Ending::Runaway => "runaway",
    }
}

fn passages_array<'py>(py: Python<'py>, passages: &[Passage]) -> Passages<'py> {
    let times: Vec<_> = passages.iter().map(|passage| passage.time).collect();
    let position: Vec<_> = passages.iter().flat_map(|passage| passage.state.position).collect();
    let velocity: Vec<_> = passages.iter().flat_map(|passage| passage.state.velocity).collect();
    let tension: Vec<_> = passages.iter().map(|passage| passage.tension).collect();
    (times.into_pyarray(py), position.into_pyarray(py), velocity.into_pyarray(py), tension.into_pyarray(py))
}
