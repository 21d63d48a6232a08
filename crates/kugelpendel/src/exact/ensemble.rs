//! Many motions side by side: one bad case stops nothing, and says why.

use crate::exact::invariants::many::LAUNCHES_PER_BLOCK;
use crate::exact::motion::ExactMotion;
use crate::given::invalid::Invalid;
use crate::given::launch::Launch;
use crate::given::pendulum::Pendulum;
use crate::given::times::{Quantity, Times};
#[cfg(feature = "threads")]
use crate::sampling::threads::in_parallel;
use std::ops::Range;

/// Motions in a row, each good or with the reason why not.
#[derive(Clone, Debug)]
pub struct Ensemble {
    /// All but the last of them full.
    blocks: Vec<Vec<Result<ExactMotion, Invalid>>>,
    len: usize,
}

impl Ensemble {
    /// `case(i)` names the i-th pendulum and launch.
    pub fn new(len: usize, case: impl Fn(usize) -> (Pendulum, Launch) + Sync) -> Self {
        Self::unless(|| false, len, case)
    }

    /// The same, of use only if it is not to stop: from then on nothing is solved, and there are no motions to ask for.
    pub fn unless(
        stop: impl Fn() -> bool + Sync,
        len: usize,
        case: impl Fn(usize) -> (Pendulum, Launch) + Sync,
    ) -> Self {
        let solve = |block: usize| {
            let first = block * LAUNCHES_PER_BLOCK;
            if stop() {
                return Vec::new();
            }
            ExactMotion::solve_block(first..len.min(first + LAUNCHES_PER_BLOCK), &case)
        };
        let blocks = len.div_ceil(LAUNCHES_PER_BLOCK);
        #[cfg(feature = "threads")]
        if blocks > 16 {
            use rayon::prelude::*;
            let blocks = in_parallel(|| (0..blocks).into_par_iter().with_min_len(16).map(solve).collect());
            return Self { blocks, len };
        }
        Self { blocks: (0..blocks).map(solve).collect(), len }
    }

    /// How many.
    pub fn len(&self) -> usize {
        self.len
    }

    /// Whether there are none.
    pub fn is_empty(&self) -> bool {
        self.len == 0
    }

    /// The i-th.
    ///
    /// # Panics
    /// If there are not so many.
    pub fn motion(&self, index: usize) -> &Result<ExactMotion, Invalid> {
        &self.blocks[index / LAUNCHES_PER_BLOCK][index % LAUNCHES_PER_BLOCK]
    }

    /// Index and reason of each bad case.
    pub fn problems(&self) -> impl Iterator<Item = (usize, &Invalid)> {
        let all = self.blocks.iter().flatten().enumerate();
        all.filter_map(|(index, motion)| motion.as_ref().err().map(|invalid| (index, invalid)))
    }

    /// N numbers of each motion, NaN for the bad ones.
    pub fn map<const N: usize>(&self, quantity: impl Fn(&ExactMotion) -> [f64; N]) -> Vec<f64> {
        let mut numbers = Vec::with_capacity(N * self.len);
        for motion in self.blocks.iter().flatten() {
            numbers.extend_from_slice(&motion.as_ref().map_or([f64::NAN; N], &quantity));
        }
        numbers
    }

    /// Positions or velocities of some of the motions, `out` divided evenly among them; NaN for the bad ones.
    pub fn fill(&self, motions: Range<usize>, quantity: Quantity, times: Times<'_>, out: &mut [f64]) {
        self.fill_rows(motions, out, |motion, row| motion.fill(quantity, times, row));
    }

    /// Tensions, likewise.
    pub fn fill_tension(&self, motions: Range<usize>, times: &[f64], out: &mut [f64]) {
        self.fill_rows(motions, out, |motion, row| motion.fill_tension(times, row));
    }

    fn fill_rows(&self, motions: Range<usize>, out: &mut [f64], fill: impl Fn(&ExactMotion, &mut [f64]) + Sync) {
        if out.is_empty() {
            return;
        }
        let size = out.len() / motions.len();
        let fill = |(index, row): (usize, &mut [f64])| match self.motion(motions.start + index) {
            Ok(motion) => fill(motion, row),
            Err(_) => row.fill(f64::NAN),
        };
        #[cfg(feature = "threads")]
        if motions.len() > 1 {
            use rayon::prelude::*;
            in_parallel(|| out.par_chunks_exact_mut(size).enumerate().for_each(fill));
            return;
        }
        out.chunks_exact_mut(size).enumerate().for_each(fill);
    }
}
