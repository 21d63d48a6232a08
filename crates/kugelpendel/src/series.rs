//! The trigonometric chart at many times: what the compiler vectorises.

use crate::arithmetic::Arithmetic;
use crate::clock::Clock;
use crate::double_double::Pair;
use crate::plan::Plan;
use crate::rotations::{BLOCK, Rotations, half};
use crate::shape::{Shape, product};
use crate::times::{Quantity, Times};
use crate::trigonometric::{MAX_DEGREE, Trigonometric};
use crate::turns;
use std::f64::consts::{PI, TAU};

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
        self.hands.at::<A>(Pair { hi: self.times[k], lo: 0.0 })
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

#[inline(always)]
pub(crate) fn series<A: Arithmetic>(
    plan: &Plan,
    chart: &Trigonometric,
    quantity: Quantity,
    times: Times<'_>,
    out: &mut [f64],
) {
    let Clock::Periodic { swings, frame, start } = plan.clock else {
        return;
    };
    let scale = Scale { length: plan.length, swing: PI * swings.hi, frame: TAU * frame.hi };
    let hands = Hands { swing: half(swings), frame, start: [0.5 * start.hi, plan.turn] };
    for (block, out) in out.chunks_mut(3 * BLOCK).enumerate() {
        let (first, count) = (block * BLOCK, out.len() / 3);
        match (times, &plan.rotations) {
            (Times::Scattered(times), _) => {
                let directions = Scattered { hands: &hands, times: &times[first..first + count] };
                by_degree::<A>(chart, quantity, scale, out, &directions);
            }
            (Times::Grid { .. }, Some(table)) => {
                let directions = Grid { anchor: hands.at::<A>(times.at::<A>(first)), table };
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

/// m, and the rates of ζ and of the frame in rad/s.
#[derive(Clone, Copy)]
pub(crate) struct Scale {
    pub(crate) length: f64,
    pub(crate) swing: f64,
    pub(crate) frame: f64,
}

/// From the turning frame to x, y and z, or to their rates.
#[inline(always)]
pub(crate) fn seen_from_outside<A: Arithmetic, const RATES: bool>(
    shape: &Shape,
    direction: [f64; 2],
    scale: Scale,
) -> [f64; 3] {
    let Scale { length, swing, frame } = scale;
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
