//! Positions and velocities at many times: scattered, or on a uniform grid, in blocks that the compiler vectorises.
//!
//! Both routes need cosine and sine of the swing and of the turning frame and share the series. Scattered times take one
//! reduction to turns and one polynomial each; on a grid, a block starts with one of those and goes on by
//! multiplication with a table of rotations, so no error accumulates. Blocks are cut at fixed indices: the result does
//! not depend on the number of threads.

use crate::arithmetic::{Arithmetic, dispatch};
use crate::double_double::{Dd, Pair, two_sum};
use crate::exact::{Chart, Clock, ExactMotion};
use crate::shape::{Shape, product};
use crate::trigonometric::{MAX_DEGREE, Trigonometric};
use crate::turns;
use std::f64::consts::{PI, TAU};

const BLOCK: usize = 384;

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
            Times::Scattered(times) => Pair {
                hi: times[index],
                lo: 0.0,
            },
            Times::Grid { start, step, first } => {
                (Dd::<A>::product(step, (first + index) as f64) + Dd::from(start)).pair()
            }
        }
    }

    fn from(&self, index: usize) -> Self {
        match *self {
            Times::Scattered(times) => Times::Scattered(&times[index..]),
            Times::Grid { start, step, first } => Times::Grid {
                start,
                step,
                first: first + index,
            },
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
                    .for_each(|(task, part)| {
                        fill_part(&plan, quantity, times.from(task * TASK), part)
                    });
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
            (
                Times::Grid { step, .. },
                Clock::Periodic { swings, frame, .. },
                Chart::Trigonometric(_),
            ) => Some(rotations(*step, swings, frame)),
            _ => None,
        };
        Self {
            chart,
            clock,
            length: motion.pendulum.length,
            turn,
            rotations,
        }
    }
}

dispatch! {
    fn rotations(step: f64, swings: Pair, frame: Pair) -> Box<Rotations> = rotations_with
}

#[inline(always)]
fn rotations_with<A: Arithmetic>(_: A, step: f64, swings: Pair, frame: Pair) -> Box<Rotations> {
    let mut table = Box::new(Rotations {
        swing: [[0.0; BLOCK]; 2],
        frame: [[0.0; BLOCK]; 2],
    });
    for k in 0..BLOCK {
        let time = Dd::<A>::product(step, k as f64).pair();
        let (whole, rest) = turns::fraction::<A>(swings, time);
        [table.swing[0][k], table.swing[1][k]] = turns::cos_sin::<A>(0.5 * whole, 0.5 * rest);
        let (whole, rest) = turns::fraction::<A>(frame, time);
        [table.frame[0][k], table.frame[1][k]] = turns::cos_sin::<A>(whole, rest);
    }
    table
}

dispatch! {
    fn fill_part(plan: &Plan, quantity: Quantity, times: Times<'_>, out: &mut [f64]) = fill_part_with
}

#[inline(always)]
fn fill_part_with<A: Arithmetic>(
    _: A,
    plan: &Plan,
    quantity: Quantity,
    times: Times<'_>,
    out: &mut [f64],
) {
    match &plan.chart {
        Chart::Trigonometric(chart) => series::<A>(plan, chart, quantity, times, out),
        Chart::Hyperbolic(_) | Chart::Still(_) => {
            for (index, triple) in out.chunks_exact_mut(3).enumerate() {
                triple.copy_from_slice(&plan.point::<A>(quantity, times.at::<A>(index)));
            }
        }
    }
}

/// Cosine and sine of the swing and of the frame at the k-th time of a block.
///
/// A trait and not a closure: what is not inlined into the dispatched function is not compiled for its processor.
trait Directions<A> {
    fn at(&self, k: usize) -> [[f64; 2]; 2];
}

/// ζ and the frame's angle as functions of the time, in turns.
struct Hands {
    swing: Pair,
    frame: Pair,
    start: [f64; 2],
}

impl Hands {
    #[inline(always)]
    fn at<A: Arithmetic>(&self, time: Pair) -> [[f64; 2]; 2] {
        let (whole, rest) = turns::fraction::<A>(self.swing, time);
        let swing = turns::cos_sin::<A>(whole, rest + self.start[0]);
        let (whole, rest) = turns::fraction::<A>(self.frame, time);
        [swing, turns::cos_sin::<A>(whole, rest + self.start[1])]
    }
}

struct Scattered<'a> {
    hands: &'a Hands,
    times: &'a [f64],
}

impl<A: Arithmetic> Directions<A> for Scattered<'_> {
    #[inline(always)]
    fn at(&self, k: usize) -> [[f64; 2]; 2] {
        self.hands.at::<A>(Pair {
            hi: self.times[k],
            lo: 0.0,
        })
    }
}

struct Grid<'a> {
    anchor: [[f64; 2]; 2],
    table: &'a Rotations,
}

impl<A: Arithmetic> Directions<A> for Grid<'_> {
    #[inline(always)]
    fn at(&self, k: usize) -> [[f64; 2]; 2] {
        let Rotations { swing, frame } = self.table;
        [
            product::<A>(self.anchor[0], [swing[0][k], swing[1][k]]),
            product::<A>(self.anchor[1], [frame[0][k], frame[1][k]]),
        ]
    }
}

/// m, and the rates of ζ and of the frame in rad/s.
#[derive(Clone, Copy)]
struct Scale {
    length: f64,
    swing: f64,
    frame: f64,
}

#[inline(always)]
fn series<A: Arithmetic>(
    plan: &Plan,
    chart: &Trigonometric,
    quantity: Quantity,
    times: Times<'_>,
    out: &mut [f64],
) {
    let Clock::Periodic {
        swings,
        frame,
        start,
    } = plan.clock
    else {
        return;
    };
    let scale = Scale {
        length: plan.length,
        swing: PI * swings.hi,
        frame: TAU * frame.hi,
    };
    let swing = Pair {
        hi: 0.5 * swings.hi,
        lo: 0.5 * swings.lo,
    };
    let hands = Hands {
        swing,
        frame,
        start: [0.5 * start.hi, plan.turn],
    };
    for (block, out) in out.chunks_mut(3 * BLOCK).enumerate() {
        let (first, count) = (block * BLOCK, out.len() / 3);
        match (times, &plan.rotations) {
            (Times::Scattered(times), _) => {
                let directions = Scattered {
                    hands: &hands,
                    times: &times[first..first + count],
                };
                by_degree::<A>(chart, quantity, scale, out, &directions);
            }
            (Times::Grid { .. }, Some(table)) => {
                let directions = Grid {
                    anchor: hands.at::<A>(times.at::<A>(first)),
                    table,
                };
                by_degree::<A>(chart, quantity, scale, out, &directions);
            }
            (Times::Grid { .. }, None) => unreachable!("a grid comes with its table of rotations"),
        }
    }
}

#[inline(always)]
fn by_degree<A: Arithmetic>(
    chart: &Trigonometric,
    quantity: Quantity,
    scale: Scale,
    out: &mut [f64],
    directions: &impl Directions<A>,
) {
    macro_rules! evaluate {
        ($($degree:literal)+) => {
            match (chart.degree, chart.from_above, quantity) {
                $(
                    ($degree, false, Quantity::Position) => evaluate::<A, $degree, false, false>(chart, scale, out, directions),
                    ($degree, true, Quantity::Position) => evaluate::<A, $degree, true, false>(chart, scale, out, directions),
                    ($degree, false, Quantity::Velocity) => evaluate::<A, $degree, false, true>(chart, scale, out, directions),
                    ($degree, true, Quantity::Velocity) => evaluate::<A, $degree, true, true>(chart, scale, out, directions),
                )+
                degree => unreachable!("{degree:?} is not a degree from 1 to {MAX_DEGREE}"),
            }
        };
    }
    evaluate!(1 2 3 4);
}

#[inline(always)]
fn evaluate<A: Arithmetic, const DEGREE: usize, const FROM_ABOVE: bool, const RATES: bool>(
    chart: &Trigonometric,
    scale: Scale,
    out: &mut [f64],
    directions: &impl Directions<A>,
) {
    let (triples, _) = out.as_chunks_mut::<3>();
    for k in 0..triples.len().min(BLOCK) {
        let [[cos, sin], direction] = directions.at(k);
        let shape = chart.at::<A, DEGREE, FROM_ABOVE, RATES>(cos, sin);
        triples[k] = seen_from_outside::<A, RATES>(&shape, direction, scale);
    }
}

/// From the turning frame to x, y and z, or to their rates.
#[inline(always)]
fn seen_from_outside<A: Arithmetic, const RATES: bool>(
    shape: &Shape,
    direction: [f64; 2],
    scale: Scale,
) -> [f64; 3] {
    let Scale {
        length,
        swing,
        frame,
    } = scale;
    let (plan, z) = if RATES {
        let x = A::mul_add(swing, shape.x_rate, -(frame * shape.y));
        let y = A::mul_add(swing, shape.y_rate, frame * shape.x);
        ([x, y], -swing * shape.height_rate)
    } else {
        ([shape.x, shape.y], length - shape.height)
    };
    let [x, y] = product::<A>(direction, plan);
    [x, y, z]
}

impl Plan {
    /// One time, for the charts that are not vectorised.
    #[inline(always)]
    fn point<A: Arithmetic>(&self, quantity: Quantity, time: Pair) -> [f64; 3] {
        let (shape, direction, swing, frame) = match (&self.chart, self.clock) {
            (
                Chart::Hyperbolic(chart),
                Clock::Periodic {
                    swings,
                    frame,
                    start,
                },
            ) => {
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
                let direction =
                    turns::cos_sin::<A>(whole, rest + (self.turn + twist * fraction) + odd);
                let turning = TAU * (frame.hi + twist * swings.hi);
                (
                    chart.at(chart.span * fraction),
                    direction,
                    chart.span * swings.hi,
                    turning,
                )
            }
            (Chart::Hyperbolic(chart), Clock::Once { rate, start }) => {
                let direction = turns::cos_sin::<A>(self.turn, 0.0);
                (
                    chart.at(A::mul_add(rate, time.hi, start)),
                    direction,
                    rate,
                    0.0,
                )
            }
            (Chart::Still([x, y, height]), _) => (
                Shape {
                    x: *x,
                    y: *y,
                    height: *height,
                    ..Shape::default()
                },
                [1.0, 0.0],
                0.0,
                0.0,
            ),
            (chart, clock) => unreachable!("{clock:?} does not go with {chart:?}"),
        };
        let scale = Scale {
            length: self.length,
            swing,
            frame,
        };
        match quantity {
            Quantity::Position => seen_from_outside::<A, false>(&shape, direction, scale),
            Quantity::Velocity => seen_from_outside::<A, true>(&shape, direction, scale),
        }
    }
}
