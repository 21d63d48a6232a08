//! Over a block of a uniform grid, the angles go on by multiplication with a table.

use crate::numbers::arithmetic::{Arithmetic, dispatch};
use crate::numbers::double_double::{Dd, Pair};
use crate::numbers::turns;

/// Times taken together.
pub(crate) const TIMES_PER_BLOCK: usize = 384;

/// Of the swing and of the frame, over the steps of one block of a grid.
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
