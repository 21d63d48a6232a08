//! Everything that is asked about a stretch of time, read off in one pass over the steps.

use crate::given::times::both_ways;
use crate::numbers::double_double::Pair;
use crate::taylor::events::Event;
use crate::taylor::step::{Step, dimensionless, happens};
use crate::taylor::walk::{Halt, Passage, Progress, Readings, StateVector, Stepper, Stop, Walk};

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
    prepare(readings);
    both_ways(readings.times, |side, order| match Sweep::begin(motion, side, order, readings, walk) {
        Some(sweep) => sweep.finish(motion, readings, walk, stop),
        None => Ok(()),
    })
}

/// Makes room for what is found.
///
/// # Panics
/// As [`read`].
pub(crate) fn prepare(readings: &mut Readings<'_>) {
    let count = readings.times.len();
    for (values, width) in [(&readings.position, 3), (&readings.velocity, 3), (&readings.tension, 1)] {
        assert!(values.is_empty() || values.len() == width * count, "{width} numbers to a time");
    }
    readings.found = vec![Vec::new(); readings.events.len()];
}

/// What is asked of a motion in one direction of time, on the way.
pub(crate) struct Sweep<O> {
    pub(crate) progress: Progress,
    /// Of the times that are still to come.
    order: O,
    /// The next of them, with its index, in 1/ω0.
    next: Option<(usize, Pair)>,
    /// Events are looked for, still.
    looking: bool,
    /// From when to when they are, in 1/ω0.
    between: [Pair; 2],
    /// Nothing has been read yet.
    is_first: bool,
}

impl<O: Iterator<Item = usize>> Sweep<O> {
    /// Begins at the first of the times on this side, or of the events; none where nothing is asked there.
    pub(crate) fn begin(
        motion: &impl Stepper,
        side: usize,
        mut order: O,
        readings: &Readings<'_>,
        walk: &mut Walk,
    ) -> Option<Self> {
        let omega0 = motion.omega0();
        let looking = side == 0 && readings.most > 0;
        let [from, to] = readings.between;
        let next = order.next();
        let first = match next.map(|index| readings.times[index]) {
            Some(time) if looking => time.min(from),
            Some(time) => time,
            None if looking => from,
            None => return None,
        };
        let next = next.map(|index| (index, dimensionless(readings.times[index], omega0)));
        let progress = walk.seek(motion, side, dimensionless(first, omega0));
        let between = [dimensionless(from, omega0), dimensionless(to, omega0)];
        Some(Self { progress, order, next, looking, between, is_first: true })
    }

    /// Whether something may be read in the present step, in which events may happen or not.
    pub(crate) fn touches(&self, may_happen: bool) -> bool {
        let looking = self.looking && (may_happen || self.is_first || self.covers(self.between[1]));
        looking || self.next.is_some_and(|(_, time)| self.covers(time))
    }

    /// Whether events are looked for in the present step.
    pub(crate) fn is_looking(&self) -> bool {
        self.looking
    }

    fn covers(&self, time: Pair) -> bool {
        let step = self.progress.step();
        !step.is_before(step.start.since(time), self.progress.direction())
    }

    /// Reads what lies in the present step: the outcome, once there is no more to read.
    pub(crate) fn read(&mut self, motion: &impl Stepper, readings: &mut Readings<'_>) -> Option<Result<(), Halt>> {
        let omega0 = motion.omega0();
        let mut touched = false;
        while let Some((index, time)) = self.next.filter(|(_, time)| self.covers(*time)) {
            let step = self.progress.step();
            write(motion, step, step.start.since(time), index, readings);
            self.next = self.order.next().map(|index| (index, dimensionless(readings.times[index], omega0)));
            touched = true;
        }
        let [from_time, to_time] = self.between;
        // What ends before the start is passed over without a look.
        if self.looking && (self.covers(from_time) || self.progress.step().ending.is_some()) {
            look(motion, self.progress.step(), readings);
            touched = true;
            let found: usize = readings.found.iter().map(Vec::len).sum();
            self.looking = found < readings.most && !self.covers(to_time);
        }
        let done = self.next.is_none() && !self.looking;
        if touched && std::mem::take(&mut self.is_first) {
            self.progress.remember();
        }
        let to = readings.between[1];
        match self.progress.end(omega0.hi) {
            Some((time, ending)) if !done && self.next.is_some() => {
                readings.until = time;
                Some(Err(Halt::Ended(time, ending)))
            }
            end if done || end.is_some() => {
                readings.until = end.map_or(to, |(time, _)| time.min(to));
                Some(Ok(()))
            }
            _ => None,
        }
    }

    /// Goes to before the next step, or before that of a later checkpoint where nothing is asked on the way there.
    pub(crate) fn prepare_step(&mut self) {
        if let (Some((_, time)), false) = (self.next, self.looking) {
            self.progress.skip_towards(time);
        }
    }

    /// Leaves off after the present step, which has been read; whoever goes on from here begins within it.
    pub(crate) fn interrupt(&mut self, motion: &impl Stepper, readings: &mut Readings<'_>) {
        self.progress.remember();
        // What is read lies before the step that is not, however its start is rounded.
        if self.progress.direction() > 0.0 {
            let Pair { hi, lo } = self.progress.step().next.time;
            readings.until = ((hi + lo) / motion.omega0().hi).next_down();
            for found in &mut readings.found {
                found.retain(|passage| passage.time <= readings.until);
            }
        }
    }

    /// Reads all that is left.
    pub(crate) fn finish(
        mut self,
        motion: &impl Stepper,
        readings: &mut Readings<'_>,
        walk: &mut Walk,
        stop: Stop<'_>,
    ) -> Result<(), Halt> {
        let outcome = loop {
            if let Some(outcome) = self.read(motion, readings) {
                break outcome;
            }
            if self.progress.may_stop() && stop() {
                self.interrupt(motion, readings);
                break Err(Halt::Interrupted);
            }
            self.prepare_step();
            self.progress.advance(motion);
        };
        walk.keep(self.progress);
        outcome
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

fn look(motion: &impl Stepper, step: &Step, readings: &mut Readings<'_>) {
    let omega0 = motion.omega0().hi;
    let [from, to] = readings.between;
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
