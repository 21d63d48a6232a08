//! Elliptic integrals, nomes and arguments by the descending Landen transformation, in binary64.
//!
//! Built from a_0² = s_c − s_b, b_0² = s_c − s_a and a_0² − b_0² itself, so that neither m near 0 nor m near 1 loses
//! digits. Conventions: the parameter is m = 1 − (b_0/a_0)², angles in radians, nome q = exp(−πK'/K).
//! Source: Abramowitz & Stegun 16.12, 17.6; NIST DLMF 19.8, 22.7.

use crate::numbers::landen::Landen;

const STEPS: usize = 12;

/// The arithmetic-geometric ladder down to c_n ≤ 1e-9 a_n.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Ladder {
    rungs: [Landen<f64>; STEPS + 1],
    last: usize,
}

impl Ladder {
    /// From a_0², b_0² and a_0² − b_0².
    pub(crate) fn new(larger: f64, smaller: f64, difference: f64) -> Self {
        // c_1² needs no c_0, which the difference has with all its digits.
        let mut rung = Landen { a: larger.sqrt(), b: smaller.sqrt(), c: 0.0 };
        let mut ladder = Self { rungs: [rung; STEPS + 1], last: 0 };
        while ladder.last < STEPS {
            rung = rung.next();
            if ladder.last == 0 {
                rung.c = 0.25 * difference / rung.a;
            }
            ladder.last += 1;
            ladder.rungs[ladder.last] = rung;
            if rung.c <= 1e-9 * rung.a {
                break;
            }
        }
        ladder
    }

    /// M(a_0, b_0) = πa_0/2K.
    pub(crate) fn mean(&self) -> f64 {
        self.rungs[self.last].a
    }

    /// The 2^(last − 1)-th root: from the last rung back to the first.
    fn root(&self, value: f64) -> f64 {
        (1..self.last).fold(value, |v, _| v.sqrt())
    }

    pub(crate) fn nome(&self) -> f64 {
        self.root(self.rungs[self.last].c / (4.0 * self.mean()))
    }

    /// (π/2K) F(φ|m) for 0 ≤ φ ≤ π/2: the argument of the theta functions, in radians.
    pub(crate) fn argument(&self, amplitude: f64) -> f64 {
        let (mut phi, mut argument, mut weight) = (amplitude, amplitude, 0.5);
        for n in 0..self.last {
            let Landen { a, b, .. } = self.rungs[n];
            let (sin, cos) = phi.sin_cos();
            // tan(2φ_n − φ_{n+1}) = (a_n − b_n) sin φ cos φ/(a_n cos² φ + b_n sin² φ), and a_n − b_n = 2c_{n+1}.
            let delta = (2.0 * self.rungs[n + 1].c * sin * cos).atan2(a * cos * cos + b * sin * sin);
            argument -= weight * delta;
            weight *= 0.5;
            phi = 2.0 * phi - delta;
        }
        argument
    }

    /// For a zeta sum with first term W_1 (see `invariants`): η, the imaginary part of that theta function's argument,
    /// and q·e^{2η}, which stays finite where η does not (the cone). From sinh 2^n η → W_n/c_n.
    pub(crate) fn imaginary_argument(&self, first: f64) -> (f64, f64) {
        let (mut w, mut n) = (first, 1);
        let mut rung = self.rungs[1];
        // Both c_n and W_n have to become negligible; below the ladder only c_n² still falls.
        while n < self.last || (w > 1e-9 * rung.a && n < 3 * STEPS) {
            w *= 0.5 * ((rung.c * rung.c + w * w) / (rung.a * rung.a + w * w)).sqrt();
            n += 1;
            rung = if n <= self.last { self.rungs[n] } else { Landen { c: 0.25 * rung.c * rung.c / rung.a, ..rung } };
        }
        let sum = w + w.hypot(rung.c);
        let reduced = (1..n).fold(sum / (4.0 * rung.a), |v, _| v.sqrt());
        let nome = self.nome();
        let eta = if reduced > 2.0 * nome {
            0.5 * (reduced / nome).ln()
        } else if w > 0.0 {
            (w / rung.c).asinh() * 0.5_f64.powi(n as i32)
        } else {
            0.0
        };
        (eta, reduced)
    }
}
