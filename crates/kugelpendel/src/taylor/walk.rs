//! A motion, step by step, and where its steps are kept so that it can be gone on from there.

use crate::numbers::double_double::Pair;
use crate::taylor::events::Event;
use crate::taylor::step::{Checkpoint, Ending, Step};
use std::collections::VecDeque;
use std::sync::atomic::{AtomicU64, Ordering};

/// A motion that is integrated.
pub(crate) trait Stepper {
    fn launch(&self) -> Checkpoint;
    /// Goes from a step to the one that begins where it ends.
    fn advance(&self, direction: f64, step: &mut Step);
    /// The bob so long after the start of a step, in SI.
    fn state(&self, step: &Step, since: f64) -> StateVector;
    /// The pull of the thread there, N.
    fn pull(&self, step: &Step, since: f64) -> f64;
    /// rad/s.
    fn omega0(&self) -> Pair;
    /// m.
    fn length(&self) -> f64;
}

/// Where the bob is, and how fast it moves.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StateVector {
    /// x, y, z in m from the support, z down.
    pub position: [f64; 3],
    /// Their rates in m/s.
    pub velocity: [f64; 3],
}

/// The bob at an event.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Passage {
    /// The time since the launch, s.
    pub time: f64,
    /// Where the bob is then, and how fast.
    pub state: StateVector,
    /// The pull of the thread, N.
    pub tension: f64,
}

/// What is to be read off a motion, and what has been.
///
/// Slices that are empty are not asked for; the others have three numbers to a time, `tension` has one. What lies beyond
/// an end of the motion stays as it was.
#[derive(Debug, Default)]
pub struct Readings<'a> {
    /// Times in s, in any order, before or after the launch.
    pub times: &'a [f64],
    /// x, y, z in m.
    pub position: &'a mut [f64],
    /// The velocity, m/s.
    pub velocity: &'a mut [f64],
    /// The tension, N.
    pub tension: &'a mut [f64],
    /// The events that are looked for.
    pub events: &'a [Event],
    /// The between, s, not before the launch: from when to when events are looked for, both ends included.
    pub between: [f64; 2],
    /// The walk ends once it has found so many events; 0 where it need not go from the one time to the other.
    pub most: usize,
    /// For each of `events` what was found, in order.
    pub found: Vec<Vec<Passage>>,
    /// s: all times and events up to here have been read, forwards in time.
    pub until: f64,
}

/// Why an integration has not come to the end of what was asked.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Halt {
    /// The motion ends, at this time in s.
    Ended(f64, Ending),
    /// Whoever asked does not want it any more.
    Interrupted,
}

/// Asked every few dozen steps; `true` ends the work.
pub type Stop<'a> = &'a (dyn Fn() -> bool + Sync);

/// Steps between two such questions: some hundred microseconds.
const PATIENCE: u64 = 64;

/// Requests whose beginnings are kept, so that the same stretch can be asked again for something else.
const RECENT: usize = 8;

static STEPS: AtomicU64 = AtomicU64::new(0);

/// How many steps of integration this process has taken so far, in all motions together.
pub fn steps_taken() -> u64 {
    STEPS.load(Ordering::Relaxed)
}

/// How far a motion has been followed, forwards and backwards, with checkpoints on the way.
///
/// A request goes on from the last checkpoint at or before its first time, with the same steps as from the launch: the
/// results do not depend on what was asked before.
#[derive(Clone, Debug)]
pub struct Walk {
    /// None where nobody has gone yet, or where somebody is on the way.
    sides: [Option<Box<Side>>; 2],
    kept: usize,
}

/// The walk in one direction of time.
#[derive(Clone, Debug)]
struct Side {
    direction: f64,
    step: Step,
    /// Evenly spread: the starts of the steps whose counts are multiples of `stride`.
    checkpoints: Vec<Checkpoint>,
    stride: u64,
    recent: VecDeque<Checkpoint>,
    ended: Option<(f64, Ending)>,
    /// An end has been looked for, as far as it is.
    searched: bool,
}

impl Walk {
    /// A walk that keeps up to so many checkpoints, each of some 130 bytes: going back costs at most the fraction
    /// 2/`kept` of going from the launch.
    pub fn new(kept: usize) -> Self {
        Self { sides: [None, None], kept: kept.max(2) }
    }

    /// Takes the walk away, and leaves one that has not begun.
    pub fn take(&mut self) -> Self {
        Self { sides: std::mem::take(&mut self.sides), kept: self.kept }
    }

    /// When and why the motion ends, forwards or backwards, where that is known already.
    pub fn ended(&self, forwards: bool) -> Option<(f64, Ending)> {
        self.sides[usize::from(!forwards)].as_ref()?.ended
    }

    /// Takes a side out of the walk, at the step of the latest checkpoint that does not lie after a time.
    pub(crate) fn seek(&mut self, motion: &impl Stepper, side: usize, time: Pair) -> Progress {
        let direction = [1.0, -1.0][side];
        let mut steps = 0;
        let mut side = self.sides[side].take().unwrap_or_else(|| {
            let launch = motion.launch();
            Box::new(Side {
                direction,
                step: Step::before(launch),
                checkpoints: vec![launch],
                stride: 1,
                recent: VecDeque::new(),
                ended: None,
                searched: false,
            })
        });
        let is_past = |checkpoint: &Checkpoint| checkpoint.since(time) * direction >= 0.0;
        let spread = side.checkpoints.partition_point(|checkpoint| is_past(checkpoint));
        let spread = side.checkpoints[..spread].last();
        let recent = side.recent.iter().filter(|checkpoint| is_past(checkpoint));
        let best = recent.chain(spread).max_by_key(|checkpoint| checkpoint.count).copied();
        let begun = side.step.size != 0.0 || side.step.ending.is_some();
        let here = begun && is_past(&side.step.start);
        if let Some(best) = best
            && !(here && side.step.start.count >= best.count)
        {
            side.step = Step::before(best);
            motion.advance(direction, &mut side.step);
            steps = 1;
        }
        Progress { side, kept: self.kept, steps }
    }

    /// Takes the side back, with all that it has come to know.
    pub(crate) fn keep(&mut self, progress: Progress) {
        STEPS.fetch_add(progress.steps, Ordering::Relaxed);
        let side = usize::from(progress.side.direction < 0.0);
        self.sides[side] = Some(progress.side);
    }
}

/// A walk under way in one direction of time, which counts its steps; it is handed back by [`Walk::keep`].
pub(crate) struct Progress {
    side: Box<Side>,
    kept: usize,
    steps: u64,
}

impl Progress {
    pub(crate) fn direction(&self) -> f64 {
        self.side.direction
    }

    pub(crate) fn step(&self) -> &Step {
        &self.side.step
    }

    pub(crate) fn step_mut(&mut self) -> &mut Step {
        &mut self.side.step
    }

    pub(crate) fn advance(&mut self, motion: &impl Stepper) {
        motion.advance(self.side.direction, &mut self.side.step);
        self.count_step();
    }

    /// Notes a step that has been taken.
    pub(crate) fn count_step(&mut self) {
        let Side { step, checkpoints, stride, .. } = &mut *self.side;
        self.steps += 1;
        let is_new = checkpoints.last().is_none_or(|last| last.count < step.start.count);
        if is_new && step.start.count.is_multiple_of(*stride) {
            checkpoints.push(step.start);
            if checkpoints.len() > self.kept {
                *stride *= 2;
                checkpoints.retain(|checkpoint| checkpoint.count.is_multiple_of(*stride));
            }
        }
    }

    /// Goes to before a later checkpoint that does not lie after a time, if there is one: what lies between is not asked
    /// for.
    pub(crate) fn skip_towards(&mut self, time: Pair) {
        let Side { direction, step, checkpoints, .. } = &mut *self.side;
        let is_later = checkpoints.last().is_some_and(|last| last.count > step.next.count);
        if is_later {
            let past = checkpoints.partition_point(|checkpoint| checkpoint.since(time) * *direction >= 0.0);
            if let Some(best) = checkpoints[..past].last().filter(|best| best.count > step.next.count) {
                *step = Step::before(*best);
            }
        }
    }

    /// Keeps the start of the present step, where a request begins or where one was left.
    pub(crate) fn remember(&mut self) {
        let Side { step: Step { start, .. }, recent, .. } = &mut *self.side;
        if recent.iter().all(|checkpoint| checkpoint.count != start.count) {
            recent.push_back(*start);
            if recent.len() > RECENT {
                recent.pop_front();
            }
        }
    }

    /// When and why the motion ends, where it does so with this step.
    pub(crate) fn end(&mut self, omega0: f64) -> Option<(f64, Ending)> {
        let Side { step, ended, .. } = &mut *self.side;
        let end = step.ending.map(|ending| (step.seconds(step.size, omega0), ending));
        *ended = ended.or(end);
        end
    }

    /// Whether it is time to ask whether to go on.
    pub(crate) fn may_stop(&self) -> bool {
        self.steps > 0 && self.steps.is_multiple_of(PATIENCE)
    }
}

/// Follows the motion until it ends or until enough has been seen: when and why it ends.
///
/// # Errors
/// An interruption.
pub(crate) fn find_end(
    motion: &impl Stepper,
    forwards: bool,
    walk: &mut Walk,
    stop: Stop<'_>,
    enough: impl Fn(&Step) -> bool,
) -> Result<Option<(f64, Ending)>, Halt> {
    if let Some(known) = walk.ended(forwards) {
        return Ok(Some(known));
    }
    let omega0 = motion.omega0().hi;
    let mut progress = walk.seek(motion, usize::from(!forwards), Pair { hi: 0.0, lo: 0.0 });
    let found = loop {
        let end = progress.end(omega0);
        if end.is_some() || progress.side.searched || enough(progress.step()) {
            progress.side.searched = true;
            break Ok(end);
        }
        progress.advance(motion);
        if progress.may_stop() && stop() {
            break Err(Halt::Interrupted);
        }
    };
    walk.keep(progress);
    found
}
