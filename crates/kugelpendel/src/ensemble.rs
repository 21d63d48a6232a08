//! Many motions side by side: one bad case stops nothing, and says why.

use crate::exact::ExactMotion;
use crate::invalid::Invalid;
use crate::launch::Launch;
use crate::pendulum::Pendulum;
use crate::sampling::{Quantity, Times};

/// Motions in a row, each good or with the reason why not.
#[derive(Clone, Debug)]
pub struct Ensemble {
    motions: Vec<Result<ExactMotion, Invalid>>,
}

impl Ensemble {
    /// `case(i)` names the i-th pendulum and launch.
    pub fn new(count: usize, case: impl Fn(usize) -> (Pendulum, Launch) + Sync) -> Self {
        let solve = |index: usize| {
            let (pendulum, launch) = case(index);
            ExactMotion::new(pendulum, launch)
        };
        #[cfg(feature = "threads")]
        let motions = {
            use rayon::prelude::*;
            (0..count).into_par_iter().with_min_len(1024).map(solve).collect()
        };
        #[cfg(not(feature = "threads"))]
        let motions = (0..count).map(solve).collect();
        Self { motions }
    }

    /// How many.
    pub fn len(&self) -> usize {
        self.motions.len()
    }

    /// Whether there are none.
    pub fn is_empty(&self) -> bool {
        self.motions.is_empty()
    }

    /// In their order.
    pub fn motions(&self) -> &[Result<ExactMotion, Invalid>] {
        &self.motions
    }

    /// N numbers of each motion, NaN for the bad ones.
    pub fn map<const N: usize>(&self, quantity: impl Fn(&ExactMotion) -> [f64; N]) -> Vec<f64> {
        let row = |motion: &Result<_, _>| motion.as_ref().map_or([f64::NAN; N], &quantity);
        self.motions.iter().flat_map(row).collect()
    }

    /// Positions or velocities, `out` divided evenly among the motions; NaN for the bad ones.
    pub fn fill(&self, quantity: Quantity, times: Times<'_>, out: &mut [f64]) {
        self.fill_rows(out, |motion, row| motion.fill(quantity, times, row));
    }

    /// Tensions, likewise.
    pub fn fill_tension(&self, times: &[f64], out: &mut [f64]) {
        self.fill_rows(out, |motion, row| motion.fill_tension(times, row));
    }

    fn fill_rows(&self, out: &mut [f64], fill: impl Fn(&ExactMotion, &mut [f64]) + Sync) {
        if out.is_empty() {
            return;
        }
        let size = out.len() / self.motions.len();
        let fill = |(motion, row): (&Result<ExactMotion, Invalid>, &mut [f64])| match motion {
            Ok(motion) => fill(motion, row),
            Err(_) => row.fill(f64::NAN),
        };
        #[cfg(feature = "threads")]
        if self.motions.len() > 1 {
            use rayon::prelude::*;
            self.motions.par_iter().zip(out.par_chunks_exact_mut(size)).for_each(fill);
            return;
        }
        self.motions.iter().zip(out.chunks_exact_mut(size)).for_each(fill);
    }
}
