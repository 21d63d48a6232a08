//! When a coil pushes best, and how hard.
//!
//! A radial push p in each half swing, at the phase φ after the closest approach, gives a small straight swing
//! Δa = p cos φ/ω0, and drag takes (π/ω0)(γ + ka)a. Where it just holds the amplitude it turns a narrow ellipse by
//! −2(γ + ka)(b/a) cot 2φ, which cancels the intrinsic (3/8)ω0 ab/l² at tan 2φ = 8l²/(3Qa²), Q = ω0/2(γ + ka).
//! The method is that of R. A. Schumacher and B. Tarbet, arXiv:0902.1829 (2009).

use crate::given::decay::Decay;
use crate::given::pendulum::Pendulum;
use std::f64::consts::PI;

/// The phase in rad, from 0 to π/4, at which the push that holds the amplitude `a` in m cancels the intrinsic precession.
pub fn best_phase(pendulum: &Pendulum, decay: &Decay, a: f64) -> f64 {
    let quality = pendulum.angular_frequency() / (2.0 * decay.rate(a));
    0.5 * (8.0 * pendulum.length * pendulum.length).atan2(3.0 * quality * a * a)
}

/// The push in m/s that holds the amplitude `a` in m, at a phase in rad: πa(γ + ka)/cos φ.
pub fn holding(decay: &Decay, a: f64, phase: f64) -> f64 {
    PI * a * decay.rate(a) / phase.cos()
}

/// The amplitude in m to which a push in m/s at a phase in rad brings a swing; 0 where it takes energy away.
pub fn final_amplitude(decay: &Decay, push: f64, phase: f64) -> f64 {
    decay.balance(push * phase.cos() / PI)
}

#[cfg(test)]
mod tests {
    use super::{best_phase, final_amplitude, holding};
    use crate::given::decay::Decay;
    use crate::given::pendulum::Pendulum;

    #[test]
    fn the_push_that_holds_an_amplitude_leads_to_it() {
        let decay = Decay { linear: 1e-4, square: 3e-5 };
        for phase in [0.0, 0.3, 1.2] {
            assert!((final_amplitude(&decay, holding(&decay, 0.7, phase), phase) - 0.7).abs() < 1e-14);
        }
        assert_eq!(final_amplitude(&decay, 1e-3, 2.0), 0.0);
    }

    #[test]
    fn the_best_push_turns_back_what_a_narrow_ellipse_turns_by_itself() {
        let pendulum = Pendulum { length: 0.83, gravity: 9.8, mass: 1.0 };
        let (decay, a, b) = (Decay { linear: 1e-3, square: 0.0 }, 0.03, 1e-6);
        let phase = best_phase(&pendulum, &decay, a);
        let intrinsic = 0.375 * pendulum.angular_frequency() * a * b / (pendulum.length * pendulum.length);
        let back = -2.0 * decay.rate(a) * b / a / (2.0 * phase).tan();
        assert!((back / intrinsic + 1.0).abs() < 1e-12);
    }
}
