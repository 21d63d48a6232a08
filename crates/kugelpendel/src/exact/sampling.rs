//! Positions and velocities at many times: scattered, or on a uniform grid, in blocks that the compiler vectorises.
//!
//! Both routes need cosine and sine of the swing and of the turning frame and share the series. Scattered times take one
//! reduction to turns and one polynomial each; on a grid, a block starts with one of those and goes on by
//! multiplication with a table of rotations, so no error accumulates. Blocks are cut at fixed indices: the result does
//! not depend on the number of threads.

use crate::exact::chart::Chart;
use crate::exact::motion::ExactMotion;
use crate::exact::phase::Phase;
use crate::exact::plan::Plan;
use crate::exact::theta::blocks::{Scale, fill_theta, seen_from_outside};
use crate::exact::theta::shape::Shape;
use crate::given::times::{Quantity, Times};
use crate::numbers::arithmetic::{Arithmetic, dispatch};
use crate::numbers::double_double::{Pair, two_sum};
use crate::numbers::turns;
#[cfg(feature = "threads")]
use crate::sampling::threads::in_parallel;
use std::f64::consts::TAU;

/// Times that one thread takes at once; smaller requests stay on the caller's thread.
#[cfg(feature = "threads")]
const TASK: usize = 64 * crate::sampling::blocks::TIMES_PER_BLOCK;

impl ExactMotion {
    /// Fills `out`, three numbers to a time.
    ///
    /// # Panics
    /// If scattered times and `out` do not have the same count.
    pub fn fill(&self, quantity: Quantity, times: Times<'_>, out: &mut [f64]) {
        if let Times::Scattered(times) = times {
            assert_eq!(3 * times.len(), out.len(), "three numbers to a time");
        }
        Plan::new(self, &times).fill(quantity, times, out);
    }
}

/// Cuts a large request into tasks for the threads there are.
pub(crate) fn in_tasks(times: Times<'_>, out: &mut [f64], fill: impl Fn(Times<'_>, &mut [f64]) + Sync) {
    #[cfg(feature = "threads")]
    if out.len() > 3 * TASK {
        use rayon::prelude::*;
        let parts = out.par_chunks_mut(3 * TASK).enumerate();
        return in_parallel(|| parts.for_each(|(task, part)| fill(times.from(task * TASK), part)));
    }
    fill(times, out);
}

dispatch! {
    fn fill_part(plan: &Plan, quantity: Quantity, times: Times<'_>, out: &mut [f64]) = fill_part_with
}

#[inline(always)]
pub(crate) fn fill_part_with<A: Arithmetic>(_: A, plan: &Plan, quantity: Quantity, times: Times<'_>, out: &mut [f64]) {
    match &plan.chart {
        Chart::Trigonometric(chart) => fill_theta::<A>(plan, chart, quantity, times, out),
        Chart::Hyperbolic(_) | Chart::Still(_) => {
            for (index, triple) in out.chunks_exact_mut(3).enumerate() {
                triple.copy_from_slice(&plan.point::<A>(quantity, times.at::<A>(index)));
            }
        }
    }
}

impl Plan {
    /// Fills `out`, three numbers to a time.
    pub(crate) fn fill(&self, quantity: Quantity, times: Times<'_>, out: &mut [f64]) {
        in_tasks(times, out, |times, out| fill_part(self, quantity, times, out));
    }

    /// One time, for the charts that are not vectorised.
    #[inline(always)]
    fn point<A: Arithmetic>(&self, quantity: Quantity, time: Pair) -> [f64; 3] {
        let (shape, direction, swing, frame) = match (&self.chart, self.phase) {
            (Chart::Hyperbolic(chart), Phase::Periodic { swings, frame, start }) => {
                let (whole, rest) = turns::fraction::<A>(swings, time);
                let (sum, error) = two_sum(whole, start.hi);
                let small = rest + (error + start.lo);
                let crossed = A::round(sum + small);
                let fraction = (sum - crossed) + small;
                // Of the swings completed only oddness counts: each turns the frame by half a turn more.
                // They are counted in two parts, since beyond 2^53 the sum of the two would be rounded to an even number.
                let whole_swings = A::round(time.hi * swings.hi);
                let odd = 0.5 * (whole_swings.rem_euclid(2.0) + crossed.rem_euclid(2.0)).rem_euclid(2.0);
                let twist = chart.twist();
                let (whole, rest) = turns::fraction::<A>(frame, time);
                let direction = turns::cos_sin::<A>(whole, rest + (self.turn + twist * fraction) + odd);
                let turning = TAU * (frame.hi + twist * swings.hi);
                (chart.at(chart.span * fraction), direction, chart.span * swings.hi, turning)
            }
            (Chart::Hyperbolic(chart), Phase::Once { rate, start }) => {
                let direction = turns::cos_sin::<A>(self.turn, 0.0);
                (chart.at(A::mul_add(rate, time.hi, start)), direction, rate, 0.0)
            }
            (Chart::Still([x, y, height]), _) => {
                (Shape { x: *x, y: *y, height: *height, unit: 1.0, ..Shape::default() }, [1.0, 0.0], 0.0, 0.0)
            }
            (chart, phase) => unreachable!("{phase:?} does not go with {chart:?}"),
        };
        let scale = Scale { length: self.length, swing, frame };
        match quantity {
            Quantity::Position => seen_from_outside::<A, false>(&shape, direction, scale),
            Quantity::Velocity => seen_from_outside::<A, true>(&shape, direction, scale),
        }
    }
}
