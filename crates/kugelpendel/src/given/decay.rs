//! How a plane swing dies away: a' = −γa − ka², k = (4/3π)cω0.
//!
//! Source: R. A. Nelson and M. G. Olsson, Am. J. Phys. 54, 112 (1986).

use std::f64::consts::PI;

/// What drag takes from a small plane swing.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Decay {
    /// γ, 1/s.
    pub linear: f64,
    /// k, 1/(m s).
    pub square: f64,
}

impl Decay {
    /// Of linear drag γ in 1/s and quadratic drag c in 1/m, at the angular frequency ω0 in rad/s.
    pub fn new(linear: f64, quadratic: f64, omega0: f64) -> Self {
        Self { linear, square: 4.0 / (3.0 * PI) * quadratic * omega0 }
    }

    /// −a'/a at an amplitude in m, 1/s.
    pub fn rate(&self, a: f64) -> f64 {
        self.linear + self.square * a
    }

    /// The amplitude in m after a time in s, from `a`: a e^(−γt)/(1 + ka(1 − e^(−γt))/γ).
    pub fn after(&self, a: f64, time: f64) -> f64 {
        let falls = -(-self.linear * time).exp_m1();
        let spread = if self.linear == 0.0 { time } else { falls / self.linear };
        a * (1.0 - falls) / (1.0 + self.square * a * spread)
    }

    /// The time in s from the amplitude `a` to `less`: ln(1 + γ(1/less − 1/a)/(γ/a + k))/γ; infinite without drag.
    pub fn until(&self, a: f64, less: f64) -> f64 {
        if self.rate(a) == 0.0 {
            return f64::INFINITY;
        }
        let gain = (1.0 / less - 1.0 / a) / (self.linear / a + self.square);
        if self.linear == 0.0 { gain } else { (self.linear * gain).ln_1p() / self.linear }
    }

    /// Where γa + ka² is what a push gives in m/s; infinite without drag, 0 for a push that gives nothing.
    pub fn balance(&self, gain: f64) -> f64 {
        if gain <= 0.0 {
            return 0.0;
        }
        let root = (self.linear * self.linear + 4.0 * self.square * gain).sqrt();
        2.0 * gain / (self.linear + root)
    }
}

#[cfg(test)]
mod tests {
    use super::Decay;

    #[test]
    fn the_amplitude_after_a_time_is_its_own_inverse() {
        for (linear, square) in [(1e-4, 0.0), (0.0, 1e-3), (1e-4, 1e-3), (1e-12, 1e-3)] {
            let decay = Decay { linear, square };
            for less in [0.9, 0.5, 1e-3] {
                let time = decay.until(1.0, less);
                assert!((decay.after(1.0, time) / less - 1.0).abs() < 1e-12, "{decay:?} to {less}");
            }
        }
        assert_eq!(Decay::default().until(1.0, 0.5), f64::INFINITY);
    }

    #[test]
    fn what_a_push_gives_is_lost_at_the_balance() {
        for (linear, square) in [(1e-4, 0.0), (0.0, 1e-3), (1e-4, 1e-3)] {
            let decay = Decay { linear, square };
            let a = decay.balance(2e-4);
            assert!((decay.rate(a) * a / 2e-4 - 1.0).abs() < 1e-14);
        }
        assert_eq!(Decay::default().balance(1.0), f64::INFINITY);
        assert_eq!(Decay { linear: 1.0, square: 0.0 }.balance(-1.0), 0.0);
    }
}
