//! A motion, step by step, with everything that is asked about a stretch of time read off in one pass.

use crate::given::times::both_ways;
use crate::numbers::double_double::Pair;
use crate::taylor::events::Event;
use crate::taylor::step::{Checkpoint, Ending, Step, dimensionless, happens};
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

    /// When and why the motion ends, forwards or backwards, where that is known already.
    pub fn ended(&self, forwards: bool) -> Option<(f64, Ending)> {
        self.sides[usize::from(!forwards)].as_ref()?.ended
    }

    /// The side, at the step of the latest checkpoint that does not lie after a time.
    fn seek(&mut self, motion: &impl Stepper, side: usize, time: Pair) -> Progress<'_> {
        let direction = [1.0, -1.0][side];
        let mut steps = 0;
        let side = self.sides[side].get_or_insert_with(|| {
            let launch = motion.launch();
            let step = Step::before(launch);
            let checkpoints = vec![launch];
            Box::new(Side {
                direction,
                step,
                checkpoints,
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
}

/// A walk under way, which counts its steps.
struct Progress<'a> {
    side: &'a mut Side,
    kept: usize,
    steps: u64,
}

impl Progress<'_> {
    fn advance(&mut self, motion: &impl Stepper) {
        let Side { direction, step, checkpoints, stride, .. } = &mut *self.side;
        motion.advance(*direction, step);
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

    /// The next step, or the one of a later checkpoint that does not lie after a time: what lies between is not asked for.
    fn advance_towards(&mut self, motion: &impl Stepper, time: Pair) {
        let Side { direction, step, checkpoints, .. } = &mut *self.side;
        let is_later = checkpoints.last().is_some_and(|last| last.count > step.next.count);
        if is_later {
            let past = checkpoints.partition_point(|checkpoint| checkpoint.since(time) * *direction >= 0.0);
            if let Some(best) = checkpoints[..past].last().filter(|best| best.count > step.next.count) {
                *step = Step::before(*best);
            }
        }
        self.advance(motion);
    }

    /// Keeps where a request begins, or where one was left.
    fn remember(&mut self, start: Checkpoint) {
        let Side { recent, .. } = &mut *self.side;
        if recent.iter().all(|checkpoint| checkpoint.count != start.count) {
            recent.push_back(start);
            if recent.len() > RECENT {
                recent.pop_front();
            }
        }
    }

    /// When and why the motion ends, where it does so with this step.
    fn end(&mut self, omega0: f64) -> Option<(f64, Ending)> {
        let Side { step, ended, .. } = &mut *self.side;
        let end = step.ending.map(|ending| (step.seconds(step.size, omega0), ending));
        *ended = ended.or(end);
        end
    }
}

impl Drop for Progress<'_> {
    fn drop(&mut self) {
        STEPS.fetch_add(self.steps, Ordering::Relaxed);
    }
}

/// Reads what is asked, forwards and backwards.
///
/// # Errors
/// What halted it; an end of the motion is none where only events are asked for.
///
/// # Panics
/// If times and slices do not have the same count.
pub(crate) fn read(
    motion: &impl Stepper,
    readings: &mut Readings<'_>,
    walk: &mut Walk,
    stop: Stop<'_>,
) -> Result<(), Halt> {
    let count = readings.times.len();
    for (values, width) in [(&readings.position, 3), (&readings.velocity, 3), (&readings.tension, 1)] {
        assert!(values.is_empty() || values.len() == width * count, "{width} numbers to a time");
    }
    readings.found = vec![Vec::new(); readings.events.len()];
    both_ways(readings.times, |side, order| sweep(motion, side, order, readings, walk, stop))
}

fn sweep(
    motion: &impl Stepper,
    side: usize,
    order: &mut dyn Iterator<Item = usize>,
    readings: &mut Readings<'_>,
    walk: &mut Walk,
    stop: Stop<'_>,
) -> Result<(), Halt> {
    let (omega0, times) = (motion.omega0(), readings.times);
    let mut order = order.peekable();
    let mut looking = side == 0 && readings.most > 0;
    let [from, to] = readings.between;
    let first = match order.peek() {
        Some(&index) if looking => times[index].min(from),
        Some(&index) => times[index],
        None if looking => from,
        None => return Ok(()),
    };
    let direction = [1.0, -1.0][side];
    let (from_time, to_time) = (dimensionless(from, omega0), dimensionless(to, omega0));
    let mut progress = walk.seek(motion, side, dimensionless(first, omega0));
    let mut is_first = true;
    loop {
        let step = &progress.side.step;
        let mut touched = false;
        while let Some(&index) = order.peek() {
            let since = step.start.since(dimensionless(times[index], omega0));
            if step.is_before(since, direction) {
                break;
            }
            write(motion, step, since, index, readings);
            order.next();
            touched = true;
        }
        let covers = |time: Pair| !step.is_before(step.start.since(time), direction);
        // What ends before the start is passed over without a look.
        if looking && (covers(from_time) || step.ending.is_some()) {
            look(motion, step, [from, to], readings);
            touched = true;
            let found: usize = readings.found.iter().map(Vec::len).sum();
            looking = found < readings.most && !covers(to_time);
        }
        let done = order.peek().is_none() && !looking;
        if touched && std::mem::take(&mut is_first) {
            progress.remember(progress.side.step.start);
        }
        match progress.end(omega0.hi) {
            Some((time, ending)) if !done && order.peek().is_some() => {
                readings.until = time;
                return Err(Halt::Ended(time, ending));
            }
            end if done || end.is_some() => {
                readings.until = end.map_or(to, |(time, _)| time.min(to));
                return Ok(());
            }
            _ => {}
        }
        let read = progress.side.step.start;
        match order.peek() {
            Some(&index) if !looking => progress.advance_towards(motion, dimensionless(times[index], omega0)),
            _ => progress.advance(motion),
        }
        if progress.steps.is_multiple_of(PATIENCE) && stop() {
            // Whoever goes on from here begins within the last step that is read.
            progress.remember(read);
            // What is read lies before the step that is not, however its start is rounded.
            if side == 0 {
                readings.until = progress.side.step.seconds(0.0, omega0.hi).next_down();
                for found in &mut readings.found {
                    found.retain(|passage| passage.time <= readings.until);
                }
            }
            return Err(Halt::Interrupted);
        }
    }
}

fn write(motion: &impl Stepper, step: &Step, since: f64, index: usize, readings: &mut Readings<'_>) {
    let triple = 3 * index..3 * index + 3;
    if !readings.position.is_empty() || !readings.velocity.is_empty() {
        let StateVector { position, velocity } = motion.state(step, since);
        if let Some(out) = readings.position.get_mut(triple.clone()) {
            out.copy_from_slice(&position);
        }
        if let Some(out) = readings.velocity.get_mut(triple) {
            out.copy_from_slice(&velocity);
        }
    }
    if let Some(out) = readings.tension.get_mut(index) {
        *out = motion.pull(step, since);
    }
}

fn look(motion: &impl Stepper, step: &Step, [from, to]: [f64; 2], readings: &mut Readings<'_>) {
    let omega0 = motion.omega0().hi;
    for (event, found) in readings.events.iter().zip(&mut readings.found) {
        let event = match *event {
            Event::Radius(radius) => Event::Radius(radius / motion.length()),
            other => other,
        };
        for since in happens(step, event) {
            let time = step.seconds(since, omega0);
            if (from..=to).contains(&time) && found.len() < readings.most {
                let (state, tension) = (motion.state(step, since), motion.pull(step, since));
                found.push(Passage { time, state, tension });
            }
        }
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
    loop {
        let end = progress.end(omega0);
        if end.is_some() || progress.side.searched || enough(&progress.side.step) {
            progress.side.searched = true;
            return Ok(end);
        }
        progress.advance(motion);
        if progress.steps.is_multiple_of(PATIENCE) && stop() {
            return Err(Halt::Interrupted);
        }
    }
}
