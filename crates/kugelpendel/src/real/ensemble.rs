//! Many real motions: as many side by side as the processor has lanes, and where one is done the next takes its place.

use crate::given::times::{Order, orders};
use crate::numbers::arithmetic::{Fused, Portable, fused, widest};
#[cfg(target_arch = "x86_64")]
use crate::numbers::lanes::{EightLanes, FourLanes, Instructions};
use crate::numbers::lanes::{Lanes, PlainLanes};
use crate::real::lanes::{Abreast, LaneStep};
use crate::real::motion::RealMotion;
use crate::real::sphere::FieldKind;
use crate::taylor::events::Event;
use crate::taylor::sweep::{Sweep, prepare};
use crate::taylor::walk::{Halt, Readings, Stop, Walk};
use std::collections::VecDeque;

/// Lanes of the widest vectors.
const MOST_LANES: usize = 8;

/// Cases that wait until others, with forces of another kind, have left the lanes; then it is their turn.
const MOST_WAITING: usize = 64;

/// Steps between two questions whether to go on: some hundred microseconds.
const PATIENCE: u64 = 64;

/// A motion of many, what is asked of it, and its walk.
#[derive(Debug)]
pub struct Case<'a, M, T> {
    /// What the caller tells the cases apart by.
    pub tag: T,
    /// The motion itself.
    pub motion: &'a M,
    /// What is to be read, and where it goes.
    pub readings: Readings<'a>,
    /// How far the motion has been followed.
    pub walk: Walk,
}

/// Is handed each case when it is done, in no particular order, with what has halted it.
pub type Done<'d, 'a, M, T> = &'d mut dyn FnMut(Case<'a, M, T>, Result<(), Halt>);

impl RealMotion {
    /// Reads what is asked of many motions, to the last bit as [`Self::read`] reads it of each, up to `at_once` of them side
    /// by side. Another thread may take its cases from the same source.
    ///
    /// Once `stop` asks for it, all cases that are left come back as interrupted.
    ///
    /// # Panics
    /// If times and slices of a case do not have the same count.
    pub fn read_all<'a, T>(
        cases: &mut dyn Iterator<Item = Case<'a, Self, T>>,
        at_once: usize,
        done: Done<'_, 'a, Self, T>,
        stop: Stop<'_>,
    ) {
        if at_once <= 1 {
            for mut case in cases {
                let halted = case.motion.read(&mut case.readings, &mut case.walk, stop);
                done(case, halted);
            }
            return;
        }
        match widest() {
            #[cfg(target_arch = "x86_64")]
            Instructions::Avx512 => side_by_side::<EightLanes, T>(cases, at_once, done, stop),
            #[cfg(target_arch = "x86_64")]
            Instructions::Avx2 => side_by_side::<FourLanes, T>(cases, at_once, done, stop),
            _ if fused() => side_by_side::<PlainLanes<Fused, 4>, T>(cases, at_once, done, stop),
            _ => side_by_side::<PlainLanes<Portable, 4>, T>(cases, at_once, done, stop),
        }
    }
}

pub(crate) fn side_by_side<'a, L: Lanes, T>(
    cases: &mut dyn Iterator<Item = Case<'a, RealMotion, T>>,
    at_once: usize,
    done: Done<'_, 'a, RealMotion, T>,
    stop: Stop<'_>,
) {
    let mut queue = Queue { cases, waiting: Default::default() };
    while let Some(first) = queue.first() {
        let mut group = Group::<L, T> {
            lanes: Abreast::new(&first.motion.problem.field),
            occupants: (0..at_once.clamp(1, L::COUNT)).map(|_| None).collect(),
        };
        if !group.go(first, &mut queue, done, stop) {
            queue.drain(|case| done(case, Err(Halt::Interrupted)));
        }
    }
}

/// Where cases come from. Only those with forces of the same kind go side by side; the others wait.
struct Queue<'q, 'a, T> {
    cases: &'q mut dyn Iterator<Item = Case<'a, RealMotion, T>>,
    waiting: [VecDeque<Case<'a, RealMotion, T>>; FieldKind::COUNT],
}

impl<'a, T> Queue<'_, 'a, T> {
    /// Of the kind that waits most, or the next.
    fn first(&mut self) -> Option<Case<'a, RealMotion, T>> {
        let most = self.waiting.iter_mut().max_by_key(|waiting| waiting.len());
        most.and_then(VecDeque::pop_front).or_else(|| self.cases.next())
    }

    /// The next of a kind; none where too many others wait already.
    fn next(&mut self, kind: FieldKind) -> Option<Case<'a, RealMotion, T>> {
        if let Some(case) = self.waiting[kind as usize].pop_front() {
            return Some(case);
        }
        while self.waiting.iter().map(VecDeque::len).sum::<usize>() < MOST_WAITING {
            let case = self.cases.next()?;
            match case.motion.problem.field.kind {
                found if found == kind => return Some(case),
                other => self.waiting[other as usize].push_back(case),
            }
        }
        None
    }

    fn drain(&mut self, mut each: impl FnMut(Case<'a, RealMotion, T>)) {
        self.waiting.iter_mut().flat_map(|waiting| waiting.drain(..)).for_each(&mut each);
        for case in &mut *self.cases {
            each(case);
        }
    }
}

/// Cases that go side by side.
struct Group<'a, L, T> {
    lanes: Abreast<L>,
    occupants: Vec<Option<Occupant<'a, T>>>,
}

impl<'a, L: Lanes, T> Group<'a, L, T> {
    /// Goes on until no case is left, or none that would go with these; `false` if that was not to be waited for.
    fn go(
        &mut self,
        first: Case<'a, RealMotion, T>,
        queue: &mut Queue<'_, 'a, T>,
        done: Done<'_, 'a, RealMotion, T>,
        stop: Stop<'_>,
    ) -> bool {
        let mut first = Some(first);
        for rounds in 1.. {
            self.fill(&mut first, queue, done);
            match self.occupants.iter().flatten().count() {
                0 => break,
                // Alone it is faster with its directions side by side.
                1 => {
                    for occupant in self.occupants.iter_mut().filter_map(Option::take) {
                        occupant.finish(done, stop);
                    }
                }
                _ => self.advance(done),
            }
            if rounds % PATIENCE == 0 && stop() {
                for (lane, occupant) in self.occupants.iter_mut().enumerate() {
                    if let Some(occupant) = occupant.take() {
                        occupant.interrupt(&self.lanes, lane, done);
                    }
                }
                return false;
            }
        }
        true
    }

    /// Gives the lanes that are empty to the next cases.
    fn fill(
        &mut self,
        first: &mut Option<Case<'a, RealMotion, T>>,
        queue: &mut Queue<'_, 'a, T>,
        done: Done<'_, 'a, RealMotion, T>,
    ) {
        let kind = self.lanes.kind();
        for (lane, place) in self.occupants.iter_mut().enumerate() {
            while place.is_none() {
                let Some(case) = first.take().or_else(|| queue.next(kind)) else { return };
                self.lanes.set_lane(lane, &case.motion.problem);
                let mut occupant = Occupant::new(case);
                if occupant.read() {
                    *place = Some(occupant);
                } else {
                    done(occupant.case, occupant.outcome);
                }
            }
        }
    }

    /// One step of all, with what is to be read in it.
    fn advance(&mut self, done: Done<'_, 'a, RealMotion, T>) {
        let mut steps = [const { None }; MOST_LANES];
        for (occupant, step) in self.occupants.iter_mut().zip(&mut steps) {
            *step = occupant.as_mut().and_then(Occupant::next_step);
        }
        self.lanes.advance(&mut steps[..L::COUNT]);
        for (lane, place) in self.occupants.iter_mut().enumerate() {
            let Some(Occupant { sweep: Some(sweep), complete, turns_only, .. }) = place else { continue };
            sweep.progress.count_step();
            let may_happen = !*turns_only || self.lanes.may_turn(lane);
            *complete = sweep.touches(may_happen) || sweep.progress.step().ending.is_some();
            if *complete {
                self.lanes.complete(lane, sweep.progress.step_mut());
                if let Some(over) = place.take_if(|occupant| !occupant.read()) {
                    done(over.case, over.outcome);
                }
            }
        }
    }
}

/// A case in its lane.
struct Occupant<'a, T> {
    case: Case<'a, RealMotion, T>,
    /// Forwards, then backwards.
    sweep: Option<Sweep<Order>>,
    /// The times before the launch, if they are still to come.
    behind: Option<Order>,
    /// The present step has its series with it, and not in the lanes only.
    complete: bool,
    outcome: Result<(), Halt>,
    /// No other events are looked for than turning points.
    turns_only: bool,
}

impl<'a, T> Occupant<'a, T> {
    fn new(mut case: Case<'a, RealMotion, T>) -> Self {
        prepare(&mut case.readings);
        let [ahead, behind] = orders(case.readings.times);
        let sweep = Sweep::begin(case.motion, 0, ahead, &case.readings, &mut case.walk);
        let turns_only = case.readings.events.iter().all(|event| matches!(event, Event::Outer | Event::Inner));
        Self { case, sweep, behind: Some(behind), complete: true, outcome: Ok(()), turns_only }
    }

    /// Reads what lies in the present step, and turns to the times before the launch after the others: whether there is more
    /// to come.
    fn read(&mut self) -> bool {
        let Self { case: Case { motion, readings, walk, .. }, sweep, behind, outcome, .. } = self;
        loop {
            match sweep {
                Some(present) => {
                    let Some(over) = present.read(*motion, readings) else { return true };
                    *outcome = outcome.and(over);
                    if let Some(over) = sweep.take() {
                        walk.keep(over.progress);
                    }
                }
                None => match behind.take() {
                    Some(order) => *sweep = Sweep::begin(*motion, 1, order, readings, walk),
                    None => return false,
                },
            }
        }
    }

    fn next_step(&mut self) -> Option<LaneStep<'_>> {
        let sweep = self.sweep.as_mut()?;
        sweep.prepare_step();
        let (problem, direction) = (&self.case.motion.problem, sweep.progress.direction());
        let is_watched = self.turns_only && sweep.is_looking();
        Some(LaneStep { problem, direction, step: sweep.progress.step_mut(), is_watched })
    }

    /// Goes on without a lane.
    fn finish(mut self, done: Done<'_, 'a, RealMotion, T>, stop: Stop<'_>) {
        let Case { motion, readings, walk, .. } = &mut self.case;
        if let Some(mut sweep) = self.sweep {
            sweep.prepare_step();
            sweep.progress.advance(*motion);
            self.outcome = self.outcome.and(sweep.finish(*motion, readings, walk, stop));
        }
        if let Some(order) = self.behind
            && let Some(sweep) = Sweep::begin(*motion, 1, order, readings, walk)
        {
            self.outcome = self.outcome.and(sweep.finish(*motion, readings, walk, stop));
        }
        done(self.case, self.outcome);
    }

    /// Leaves its lane before it is done.
    fn interrupt<L: Lanes>(mut self, lanes: &Abreast<L>, lane: usize, done: Done<'_, 'a, RealMotion, T>) {
        if let Some(mut sweep) = self.sweep {
            if !self.complete {
                lanes.complete(lane, sweep.progress.step_mut());
            }
            sweep.interrupt(self.case.motion, &mut self.case.readings);
            self.case.walk.keep(sweep.progress);
        }
        done(self.case, self.outcome.and(Err(Halt::Interrupted)));
    }
}
