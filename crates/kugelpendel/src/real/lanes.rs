//! One step of several cases at once, each in its lane, with the bits that it has alone.
//!
//! The series of all lanes are made together, and in most steps nothing happens: no push, no slack thread, no turning point
//! that cuts the step. Where something might, the lane's step is concluded as that of a single motion.

use crate::given::drive::Drive;
use crate::given::forces::Thread;
#[cfg(target_arch = "x86_64")]
use crate::numbers::lanes::Instructions;
use crate::numbers::lanes::Lanes;
use crate::real::problem::Problem;
use crate::real::sphere::{FieldKind, SphereField, SphereTerms, lanes_that_slow_down};
use crate::real::step::{advance_by, conclude, conclude_quietly, is_finite, longest, onto_sphere};
use crate::taylor::events::{Beyond, Outward, lanes_that_pass, lanes_that_turn};
use crate::taylor::layout::Several;
use crate::taylor::series::{Point, Series, in_lane};
use crate::taylor::step::{Checkpoint, Step};

/// What one lane is to do: a step of a motion, in a sense of time.
pub(crate) struct LaneStep<'a> {
    pub(crate) problem: &'a Problem,
    pub(crate) direction: f64,
    pub(crate) step: &'a mut Step,
    /// Whether it matters that the bob turns, farthest from the axis or closest to it.
    pub(crate) is_watched: bool,
}

/// Cases with forces of the same kind, each in its lane.
pub(crate) struct Abreast<L> {
    field: SphereField<L>,
    series: Series<L, [L; 3]>,
    terms: SphereTerms<L, [L; 3]>,
    tolerance: L,
    direction: L,
    /// Of a drive that waits for it.
    radius: L,
    /// Lanes, as 1 << lane, whose last step has its series with it already.
    alone: u32,
    /// Lanes in whose last step the bob may turn, of those that are watched.
    turning: u32,
}

impl<L: Lanes> Abreast<L> {
    /// Lanes for cases with forces like these.
    pub(crate) fn new(field: &SphereField) -> Self {
        Self {
            field: SphereField::in_all_lanes(field),
            series: Series::zero(),
            terms: SphereTerms::default(),
            tolerance: L::default(),
            direction: L::same(1.0),
            radius: L::default(),
            alone: 0,
            turning: 0,
        }
    }

    pub(crate) fn kind(&self) -> FieldKind {
        self.field.kind
    }

    /// Gives a lane to a case.
    pub(crate) fn set_lane(&mut self, lane: usize, problem: &Problem) {
        self.field.set_lane(lane, &problem.field);
        self.tolerance.numbers_mut()[lane] = problem.tolerance;
        let Drive::Radius { radius, .. } = problem.drive else { return };
        self.radius.numbers_mut()[lane] = radius;
    }

    /// Goes from the steps of the lanes to those that begin where they end; lanes without one are empty. The steps' series
    /// stay here until [`Self::complete`] is asked for them.
    pub(crate) fn advance(&mut self, steps: &mut [Option<LaneStep<'_>>]) {
        match L::NEEDS {
            #[cfg(target_arch = "x86_64")]
            Instructions::Avx512 => {
                #[target_feature(enable = "avx512f,avx2,fma")]
                fn vectors<L: Lanes>(lanes: &mut Abreast<L>, steps: &mut [Option<LaneStep<'_>>]) {
                    lanes.advance_with(steps);
                }
                // SAFETY: whoever works with these lanes has asked the processor for what they need.
                unsafe { vectors(self, steps) }
            }
            #[cfg(target_arch = "x86_64")]
            Instructions::Avx2 => {
                #[target_feature(enable = "avx2,fma")]
                fn vectors<L: Lanes>(lanes: &mut Abreast<L>, steps: &mut [Option<LaneStep<'_>>]) {
                    lanes.advance_with(steps);
                }
                // SAFETY: as above.
                unsafe { vectors(self, steps) }
            }
            _ => self.advance_with(steps),
        }
    }

    /// Lays the series of a lane into its step, if it is not there.
    pub(crate) fn complete(&self, lane: usize, step: &mut Step) {
        if self.alone & (1 << lane) == 0 {
            self.series.copy_lane(lane, &mut step.series);
        }
    }

    /// Whether the bob may turn in the last step of a lane that is watched: as [`crossings`](crate::taylor::events::crossings)
    /// of [`Outward`] would find it.
    pub(crate) fn may_turn(&self, lane: usize) -> bool {
        (self.alone | self.turning) & (1 << lane) != 0
    }

    #[inline(always)]
    fn advance_with(&mut self, steps: &mut [Option<LaneStep<'_>>]) {
        self.alone = 0;
        let mut together = false;
        for (lane, step) in steps.iter_mut().enumerate() {
            let Some(LaneStep { problem, direction, step, .. }) = step else { continue };
            if step.next.free {
                advance_by::<L::Single, false>(problem, *direction, step);
                self.alone |= 1 << lane;
            } else {
                self.direction.numbers_mut()[lane] = *direction;
                self.series.start_lane(lane, &step.next.point);
                together = true;
            }
        }
        if !together {
            return;
        }
        let flying = self.alone;
        let series = &mut self.series;
        self.field.continue_series::<Several<L>>(true, series, &mut self.terms);
        let [last, before] = series.shares::<Several<L>>(self.tolerance);
        let mut size = L::default();
        let (last, before, directions) = (last.numbers(), before.numbers(), self.direction.numbers());
        for (lane, size) in size.numbers_mut().iter_mut().enumerate() {
            *size = longest([last[lane], before[lane]], directions[lane]);
        }
        let margin = series.guard_margin::<Several<L>>(size);
        let slowest = match self.field.kind {
            FieldKind::Braked => lanes_that_slow_down(series, self.direction, size),
            FieldKind::Bare | FieldKind::Forced => 0,
        };
        let pushed = self.lanes_that_are_pushed(size, steps);
        if steps.iter().flatten().any(|step| step.is_watched) {
            self.turning = lanes_that_turn(&Outward(&self.series), size);
        }
        let mut point: Point<[L; 3]> = self.series.at::<Several<L>>(size);
        onto_sphere::<Several<L>>(&mut point);

        for (lane, step) in steps.iter_mut().enumerate() {
            let Some(LaneStep { problem, direction, step, .. }) = step else { continue };
            if flying & (1 << lane) != 0 {
                continue;
            }
            let size = size.numbers()[lane];
            let point = Point { position: in_lane(&point.position, lane), velocity: in_lane(&point.velocity, lane) };
            let taut = problem.thread == Thread::Rod || margin.numbers()[lane] > 0.0;
            let undisturbed = (slowest | pushed) & (1 << lane) == 0;
            if taut && undisturbed && size != 0.0 && is_finite(&point) {
                conclude_quietly::<L::Single>(size, point, step);
            } else {
                self.series.copy_lane(lane, &mut step.series);
                self.alone |= 1 << lane;
                conclude::<L::Single>(problem, *direction, size, step);
            }
        }
    }

    /// Marks the lanes in which a drive may push, or comes to push after the step.
    #[inline(always)]
    fn lanes_that_are_pushed(&self, size: L, steps: &[Option<LaneStep<'_>>]) -> u32 {
        let (mut due, mut inwards, mut at_phase, mut at_radius) = (0, 0, 0, 0);
        for (lane, step) in steps.iter().enumerate() {
            let Some(LaneStep { problem, step, .. }) = step else { continue };
            let Checkpoint { armed, push_in, .. } = step.next;
            let this = 1 << lane;
            match problem.drive {
                Drive::Absent => continue,
                Drive::Phase { .. } if armed && push_in.is_none() => at_phase |= this,
                Drive::Radius { .. } if armed && push_in.is_none() => at_radius |= this,
                _ => {}
            }
            due |= if push_in.is_some_and(|time| time <= size.numbers()[lane]) { this } else { 0 };
            inwards |= if armed { 0 } else { this };
        }
        if at_phase != 0 {
            due |= at_phase & lanes_that_pass(&Outward(&self.series), size, true);
        }
        if at_radius != 0 {
            due |= at_radius & lanes_that_pass(&Beyond(&self.series, self.radius), size, true);
        }
        if inwards != 0 {
            due |= inwards & lanes_that_pass(&Outward(&self.series), size, false);
        }
        due
    }
}
