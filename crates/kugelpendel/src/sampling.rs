//! Positions and velocities at many times: scattered, or on a uniform grid, in blocks that the compiler vectorises.
//!
//! Both routes fill the same two buffers with cosines and sines, of the swing and of the turning frame, and share the
//! series. Scattered times take one reduction to turns and one polynomial each; on a grid, a block starts with one of
//! those and goes on by multiplication with a table of rotations, so no error accumulates from block to block. Blocks
//! are cut at fixed indices: the result does not depend on the number of threads.

use crate::arithmetic::{Arithmetic, dispatch};
use crate::double_double::{Dd, Pair, two_sum};
use crate::exact::{Chart, Clock, ExactMotion};
use crate::shape::Shape;
use crate::trigonometric::Trigonometric;
use crate::turns;
use std::f64::consts::TAU;

const BLOCK: usize = 256;

/// Blocks that one thread takes at a time; smaller requests stay on the caller's thread.
#[cfg(feature = "threads")]
const BLOCKS_PER_TASK: usize = 64;

/// What is written, three numbers to a time.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Quantity {
    /// x, y, z in m.
    Position,
    /// Their rates in m/s.
    Velocity,
}

/// When.
#[derive(Clone, Copy, Debug)]
pub enum Times<'a> {
    /// Any times, s.
    Scattered(&'a [f64]),
    /// start + step·k for k = first, first + 1, …: the sum is taken exactly, not rounded to a binary64 time.
    Grid {
        /// s.
        start: f64,
        /// s.
        step: f64,
        /// Index of the first time wanted.
        first: usize,
    },
}

impl Times<'_> {
    #[inline(always)]
    fn at<A: Arithmetic>(&self, index: usize) -> Pair {
        match *self {
            Times::Scattered(times) => Pair { hi: times[index], lo: 0.0 },
            Times::Grid { start, step, first } => {
                (Dd::<A>::product(step, (first + index) as f64) + Dd::from(start)).pair()
            }
        }
    }

    fn from(&self, index: usize) -> Self {
        match *self {
            Times::Scattered(times) => Times::Scattered(&times[index..]),
            Times::Grid { start, step, first } => Times::Grid { start, step, first: first + index },
        }
    }
}

impl ExactMotion {
    /// Fills `out`, three numbers to a time.
    ///
    /// # Panics
    /// If scattered times and `out` do not have the same count.
    pub fn fill(&self, quantity: Quantity, times: Times<'_>, out: &mut [f64]) {
        if let Times::Scattered(times) = times {
            assert_eq!(3 * times.len(), out.len(), "three numbers to a time");
        }
        let plan = Plan::new(self, &times);
        #[cfg(feature = "threads")]
        {
            use rayon::prelude::*;
            const TASK: usize = BLOCK * BLOCKS_PER_TASK;
            if out.len() > 3 * TASK {
                out.par_chunks_mut(3 * TASK)
                    .enumerate()
                    .for_each(|(task, part)| fill_part(&plan, quantity, times.from(task * TASK), part));
                return;
            }
        }
        fill_part(&plan, quantity, times, out);
    }

    /// Pull of the thread in N at each time; negative where a thread would be slack and the motion needs a rod.
    pub fn fill_tension(&self, times: &[f64], out: &mut [f64]) {
        let mut positions = [0.0; 3 * BLOCK];
        for (times, out) in times.chunks(BLOCK).zip(out.chunks_mut(BLOCK)) {
            let positions = &mut positions[..3 * times.len()];
            self.fill(Quantity::Position, Times::Scattered(times), positions);
            for (tension, position) in out.iter_mut().zip(positions.chunks_exact(3)) {
                *tension = self.tension_at(1.0 - position[2] / self.pendulum.length);
            }
        }
    }
}

/// Everything that is the same for every time.
struct Plan {
    chart: Chart,
    clock: Clock,
    length: f64,
    /// Turns of the frame at t = 0.
    turn: f64,
    rotations: Option<Box<Rotations>>,
}

/// Of the swing and of the frame, over the steps of one block of a grid.
struct Rotations {
    swing: [[f64; BLOCK]; 2],
    frame: [[f64; BLOCK]; 2],
}

impl Plan {
    fn new(motion: &ExactMotion, times: &Times<'_>) -> Self {
        let clock = motion.clock();
        let (chart, turn) = motion.chart(&clock);
        let rotations = match (times, clock, &chart) {
            (Times::Grid { step, .. }, Clock::Periodic { swings, frame, .. }, Chart::Trigonometric(_)) => {
                Some(rotations(*step, swings, frame))
            }
            _ => None,
        };
        Self { chart, clock, length: motion.pendulum.length, turn, rotations }
    }
}

dispatch! {
    fn rotations(step: f64, swings: Pair, frame: Pair) -> Box<Rotations> = rotations_with
}

#[inline(always)]
fn rotations_with<A: Arithmetic>(_: A, step: f64, swings: Pair, frame: Pair) -> Box<Rotations> {
    let mut table = Box::new(Rotations { swing: [[0.0; BLOCK]; 2], frame: [[0.0; BLOCK]; 2] });
    for k in 0..BLOCK {
        let time = Dd::<A>::product(step, k as f64).pair();
        let (whole, rest) = turns::fraction::<A>(halved(swings), time);
        (table.swing[0][k], table.swing[1][k]) = turns::cos_sin::<A>(whole, rest);
        let (whole, rest) = turns::fraction::<A>(frame, time);
        (table.frame[0][k], table.frame[1][k]) = turns::cos_sin::<A>(whole, rest);
    }
    table
}

/// A swing is half a turn of ζ.
#[inline(always)]
fn halved(pair: Pair) -> Pair {
    Pair { hi: 0.5 * pair.hi, lo: 0.5 * pair.lo }
}

dispatch! {
    fn fill_part(plan: &Plan, quantity: Quantity, times: Times<'_>, out: &mut [f64]) = fill_part_with
}

#[inline(always)]
fn fill_part_with<A: Arithmetic>(_: A, plan: &Plan, quantity: Quantity, times: Times<'_>, out: &mut [f64]) {
    match &plan.chart {
        Chart::Trigonometric(chart) => series::<A>(plan, chart, quantity, times, out),
        Chart::Hyperbolic(_) | Chart::Still(_) => {
            for (index, triple) in out.chunks_exact_mut(3).enumerate() {
                triple.copy_from_slice(&plan.point::<A>(quantity, times.at::<A>(index)));
            }
        }
    }
}

/// Cosines and sines of the swing and of the frame for one block.
struct Angles {
    swing: [[f64; BLOCK]; 2],
    frame: [[f64; BLOCK]; 2],
}

#[inline(always)]
fn series<A: Arithmetic>(
    plan: &Plan,
    chart: &Trigonometric,
    quantity: Quantity,
    times: Times<'_>,
    out: &mut [f64],
) {
    let Clock::Periodic { swings, frame, start } = plan.clock else { return };
    let rates = [TAU * 0.5 * swings.hi, TAU * frame.hi];
    let mut angles = Angles { swing: [[0.0; BLOCK]; 2], frame: [[0.0; BLOCK]; 2] };
    let (swings, start) = (halved(swings), halved(start));
    for (block, out) in out.chunks_mut(3 * BLOCK).enumerate() {
        let count = out.len() / 3;
        let first = block * BLOCK;
        match (&times, &plan.rotations) {
            (Times::Scattered(times), _) => {
                let times = &times[first..first + count];
                directions::<A>(times, swings, start.hi, &mut angles.swing);
                directions::<A>(times, frame, plan.turn, &mut angles.frame);
            }
            (Times::Grid { .. }, Some(table)) => {
                let time = times.at::<A>(first);
                rotate(anchor::<A>(swings, time, start), &table.swing, &mut angles.swing, count);
                let turn = Pair { hi: plan.turn, lo: 0.0 };
                rotate(anchor::<A>(frame, time, turn), &table.frame, &mut angles.frame, count);
            }
            (Times::Grid { .. }, None) => {}
        }
        match (quantity, chart.from_above) {
            (Quantity::Position, false) => by_degree::<A, false, false>(chart, &angles, plan.length, rates, out),
            (Quantity::Position, true) => by_degree::<A, true, false>(chart, &angles, plan.length, rates, out),
            (Quantity::Velocity, false) => by_degree::<A, false, true>(chart, &angles, plan.length, rates, out),
            (Quantity::Velocity, true) => by_degree::<A, true, true>(chart, &angles, plan.length, rates, out),
        }
    }
}

#[inline(always)]
fn directions<A: Arithmetic>(times: &[f64], rate: Pair, start: f64, [cos, sin]: &mut [[f64; BLOCK]; 2]) {
    for ((time, cos), sin) in times.iter().zip(cos).zip(sin) {
        let (whole, rest) = turns::fraction::<A>(rate, Pair { hi: *time, lo: 0.0 });
        (*cos, *sin) = turns::cos_sin::<A>(whole, rest + start);
    }
}

#[inline(always)]
fn anchor<A: Arithmetic>(rate: Pair, time: Pair, start: Pair) -> (f64, f64) {
    let (whole, rest) = turns::fraction::<A>(rate, time);
    turns::cos_sin::<A>(whole, rest + (start.hi + start.lo))
}

#[inline(always)]
fn rotate(
    (c, s): (f64, f64),
    [table_cos, table_sin]: &[[f64; BLOCK]; 2],
    [cos, sin]: &mut [[f64; BLOCK]; 2],
    count: usize,
) {
    for k in 0..count.min(BLOCK) {
        cos[k] = c * table_cos[k] - s * table_sin[k];
        sin[k] = s * table_cos[k] + c * table_sin[k];
    }
}

#[inline(always)]
fn by_degree<A: Arithmetic, const FROM_ABOVE: bool, const RATES: bool>(
    chart: &Trigonometric,
    angles: &Angles,
    length: f64,
    rates: [f64; 2],
    out: &mut [f64],
) {
    match chart.degree {
        1 => evaluate::<A, 1, FROM_ABOVE, RATES>(chart, angles, length, rates, out),
        2 => evaluate::<A, 2, FROM_ABOVE, RATES>(chart, angles, length, rates, out),
        3 => evaluate::<A, 3, FROM_ABOVE, RATES>(chart, angles, length, rates, out),
        _ => evaluate::<A, 4, FROM_ABOVE, RATES>(chart, angles, length, rates, out),
    }
}

#[inline(always)]
fn evaluate<A: Arithmetic, const DEGREE: usize, const FROM_ABOVE: bool, const RATES: bool>(
    chart: &Trigonometric,
    angles: &Angles,
    length: f64,
    [swing, frame]: [f64; 2],
    out: &mut [f64],
) {
    let count = (out.len() / 3).min(BLOCK);
    let (mut x, mut y, mut z) = ([0.0; BLOCK], [0.0; BLOCK], [0.0; BLOCK]);
    for k in 0..count {
        let shape = chart.at::<A, DEGREE, FROM_ABOVE, RATES>(angles.swing[0][k], angles.swing[1][k]);
        let point = seen_from_outside::<RATES>(&shape, [angles.frame[0][k], angles.frame[1][k]], swing, frame);
        (x[k], y[k], z[k]) = (length * point[0], length * point[1], length * point[2]);
    }
    for (k, triple) in out.chunks_exact_mut(3).enumerate() {
        (triple[0], triple[1], triple[2]) = (x[k], y[k], z[k]);
    }
}

/// From the turning frame to x, y and z = 1 − s, or to their rates, given the rates of the chart's variable and of the
/// frame in rad/s.
#[inline(always)]
fn seen_from_outside<const RATES: bool>(shape: &Shape, [c, s]: [f64; 2], swing: f64, frame: f64) -> [f64; 3] {
    let [x, y, z] = if RATES {
        [
            swing * shape.x_rate - frame * shape.y,
            swing * shape.y_rate + frame * shape.x,
            -swing * shape.height_rate,
        ]
    } else {
        [shape.x, shape.y, 1.0 - shape.height]
    };
    [c * x - s * y, s * x + c * y, z]
}

impl Plan {
    /// One time, for the charts that are not vectorised.
    #[inline(always)]
    fn point<A: Arithmetic>(&self, quantity: Quantity, time: Pair) -> [f64; 3] {
        let (shape, direction, swing, frame) = match (&self.chart, self.clock) {
            (Chart::Hyperbolic(chart), Clock::Periodic { swings, frame, start }) => {
                let (whole, rest) = turns::fraction::<A>(swings, time);
                let (sum, error) = two_sum(whole, start.hi);
                let small = rest + (error + start.lo);
                let crossed = A::round(sum + small);
                let fraction = (sum - crossed) + small;
                // Of the swings completed only oddness counts: each turns the frame by half a turn more.
                let completed = A::round(time.hi * swings.hi) + crossed;
                let odd = 0.5 * completed.rem_euclid(2.0);
                let twist = chart.twist();
                let (whole, rest) = turns::fraction::<A>(frame, time);
                let direction = turns::cos_sin::<A>(whole, rest + (self.turn + twist * fraction) + odd);
                let turning = TAU * (frame.hi + twist * swings.hi);
                (chart.at(chart.span * fraction), direction, chart.span * swings.hi, turning)
            }
            (Chart::Hyperbolic(chart), Clock::Once { rate, start }) => {
                let direction = turns::cos_sin::<A>(self.turn, 0.0);
                (chart.at(A::mul_add(rate, time.hi, start)), direction, rate, 0.0)
            }
            (Chart::Still([x, y, height]), _) => {
                (Shape { x: *x, y: *y, height: *height, ..Shape::default() }, (1.0, 0.0), 0.0, 0.0)
            }
            _ => (Shape::default(), (1.0, 0.0), 0.0, 0.0),
        };
        let direction = [direction.0, direction.1];
        match quantity {
            Quantity::Position => seen_from_outside::<false>(&shape, direction, swing, frame),
            Quantity::Velocity => seen_from_outside::<true>(&shape, direction, swing, frame),
        }
        .map(|v| v * self.length)
    }
}
