//! A form in a turning frame at many times, in blocks that the compiler vectorises.

use crate::given::times::{Quantity, Times};
use crate::numbers::arithmetic::{Arithmetic, dispatch, product};
use crate::numbers::double_double::{Dd, Pair};
use crate::numbers::turns;

/// One swing's form: x, y, z or their rates, given cosine and sine of ζ and of the frame's angle.
pub(crate) trait Form<A> {
    fn point<const RATES: bool>(&self, swing: [f64; 2], direction: [f64; 2]) -> [f64; 3];
}

/// Cosine and sine of the swing and of the frame at the k-th time of a block.
///
/// A trait and not a closure: what is not inlined into the dispatched function is not compiled for its processor.
trait Directions<A> {
    fn at(&self, k: usize) -> [[f64; 2]; 2];
}

/// ζ and the frame's angle as functions of the time, in turns.
pub(crate) struct SwingAndFrame {
    pub(crate) swing: Pair,
    pub(crate) frame: Pair,
    pub(crate) start: [f64; 2],
}

impl SwingAndFrame {
    #[inline(always)]
    fn at<A: Arithmetic>(&self, time: Pair) -> [[f64; 2]; 2] {
        let (whole, rest) = turns::fraction::<A>(self.swing, time);
        let swing = turns::cos_sin::<A>(whole, rest + self.start[0]);
        let (whole, rest) = turns::fraction::<A>(self.frame, time);
        [swing, turns::cos_sin::<A>(whole, rest + self.start[1])]
    }
}

struct Scattered<'a> {
    angles: &'a SwingAndFrame,
    times: &'a [f64],
}

impl<A: Arithmetic> Directions<A> for Scattered<'_> {
    #[inline(always)]
    fn at(&self, k: usize) -> [[f64; 2]; 2] {
        self.angles.at::<A>(Pair { hi: self.times[k], lo: 0.0 })
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

/// Fills `out`; a grid needs its table.
#[inline(always)]
pub(crate) fn blocks<A: Arithmetic>(
    form: &impl Form<A>,
    angles: &SwingAndFrame,
    table: Option<&Rotations>,
    quantity: Quantity,
    times: Times<'_>,
    out: &mut [f64],
) {
    for (block, out) in out.chunks_mut(3 * TIMES_PER_BLOCK).enumerate() {
        let (first, count) = (block * TIMES_PER_BLOCK, out.len() / 3);
        match (times, table) {
            (Times::Scattered(times), _) => {
                evaluate::<A>(form, quantity, &Scattered { angles, times: &times[first..first + count] }, out);
            }
            (Times::Grid { .. }, Some(table)) => {
                evaluate::<A>(form, quantity, &Grid { anchor: angles.at::<A>(times.at::<A>(first)), table }, out);
            }
            (Times::Grid { .. }, None) => unreachable!("a grid comes with its table of rotations"),
        }
    }
}

#[inline(always)]
fn evaluate<A: Arithmetic>(form: &impl Form<A>, quantity: Quantity, directions: &impl Directions<A>, out: &mut [f64]) {
    match quantity {
        Quantity::Position => each::<A, false>(form, directions, out),
        Quantity::Velocity => each::<A, true>(form, directions, out),
    }
}

#[inline(always)]
fn each<A: Arithmetic, const RATES: bool>(form: &impl Form<A>, directions: &impl Directions<A>, out: &mut [f64]) {
    let (triples, _) = out.as_chunks_mut::<3>();
    for k in 0..triples.len().min(TIMES_PER_BLOCK) {
        let [swing, direction] = directions.at(k);
        triples[k] = form.point::<RATES>(swing, direction);
    }
}

/// Times taken together.
pub(crate) const TIMES_PER_BLOCK: usize = 384;

/// Cosines and sines of the swing and of the frame over the steps of one block of a uniform grid: the angles go on by
/// multiplication with this table.
pub(crate) struct Rotations {
    pub(crate) swing: [[f64; TIMES_PER_BLOCK]; 2],
    pub(crate) frame: [[f64; TIMES_PER_BLOCK]; 2],
}

dispatch! {
    pub(crate) fn rotations(step: f64, swings: Pair, frame: Pair) -> Box<Rotations> = rotations_with
}

#[inline(always)]
fn rotations_with<A: Arithmetic>(_: A, step: f64, swings: Pair, frame: Pair) -> Box<Rotations> {
    let mut table = Box::new(Rotations { swing: [[0.0; TIMES_PER_BLOCK]; 2], frame: [[0.0; TIMES_PER_BLOCK]; 2] });
    for k in 0..TIMES_PER_BLOCK {
        let time = Dd::<A>::product(step, k as f64).pair();
        let (whole, rest) = turns::fraction::<A>(half(swings), time);
        [table.swing[0][k], table.swing[1][k]] = turns::cos_sin::<A>(whole, rest);
        let (whole, rest) = turns::fraction::<A>(frame, time);
        [table.frame[0][k], table.frame[1][k]] = turns::cos_sin::<A>(whole, rest);
    }
    table
}

/// A swing is half a turn of ζ; halved before whole turns are taken off, since afterwards an odd one would be lost.
#[inline(always)]
pub(crate) fn half(rate: Pair) -> Pair {
    Pair { hi: 0.5 * rate.hi, lo: 0.5 * rate.lo }
}
