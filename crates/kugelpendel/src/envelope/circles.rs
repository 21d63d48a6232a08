//! The slow variables: two circular amplitudes, and the state that is integrated.

use num_complex::Complex64;

/// C₊, C₋, Φ less ω0t, Ψ, Γ.
pub(super) type SlowState = [f64; NUMBERS];
pub(super) const NUMBERS: usize = 7;

/// A± without the fast phase, by their sizes and directions.
#[derive(Clone, Copy, Debug)]
pub(super) struct Circles {
    pub(super) p: f64,
    pub(super) q: f64,
    pub(super) ahead: Complex64,
    pub(super) behind: Complex64,
}

impl Circles {
    pub(super) fn of(state: &SlowState) -> Self {
        let [x, y, u, v, _, turned, faded] = *state;
        let (first, second, scale) = ((x * x + y * y).sqrt(), (u * u + v * v).sqrt(), (-faded).exp());
        let common = Complex64::cis(turned);
        let unit = |size: f64, re: f64, im: f64| {
            if size > 0.0 { common * Complex64::new(re / size, im / size) } else { Complex64::ONE }
        };
        Self { p: scale * first, q: scale * second, ahead: unit(first, x, y), behind: unit(second, u, v) }
    }

    pub(super) fn amplitudes(&self) -> [Complex64; 2] {
        [self.p * self.ahead, self.q * self.behind]
    }

    /// By which angles the directions differ from others.
    pub(super) fn turned_from(&self, others: &Self) -> [f64; 2] {
        [(self.ahead * others.ahead.conj()).arg(), (self.behind * others.behind.conj()).arg()]
    }

    pub(super) fn sizes(&self) -> [f64; 2] {
        [self.p, self.q]
    }

    pub(super) fn actions(&self) -> [f64; 2] {
        [self.p * self.p, self.q * self.q]
    }
}

impl From<[Complex64; 2]> for Circles {
    fn from([ahead, behind]: [Complex64; 2]) -> Self {
        let unit = |value: Complex64, size: f64| if size > 0.0 { value / size } else { Complex64::ONE };
        let (p, q) = (ahead.norm(), behind.norm());
        Self { p, q, ahead: unit(ahead, p), behind: unit(behind, q) }
    }
}
