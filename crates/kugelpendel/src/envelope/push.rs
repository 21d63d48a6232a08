//! A push away from the axis once in each half swing, averaged at any amplitude.
//!
//! A sudden change of the radial velocity at the phase Θ changes the actions by push·∂ρ/∂Θ and push·∂ρ/∂ψ = 0, and the
//! angles by −push·∂ρ/∂J, ρ(Θ; J) being the distance from the axis; half its own square times cos² θ is energy as well.

use super::swing::Swing;
use crate::given::drive::Drive;
use crate::numbers::elliptic::Ladder;
use num_complex::Complex64;
use std::f64::consts::{FRAC_PI_2, PI};

#[derive(Clone, Copy, Debug)]
pub(super) struct Push {
    /// Θ at the push, from an outer turning point on.
    pub(super) phase: f64,
    /// Rate of J_Θ.
    pub(super) action: f64,
    /// What the phases of A± lose and gain: push·∂ρ/∂ ln X and push·∂ρ/∂ ln Y, as rates.
    pub(super) along: [f64; 2],
}

impl Push {
    /// None where there is no push in this swing, or no swing.
    pub(super) fn of(drive: &Drive, swing: &Swing) -> Option<Self> {
        let range = 2.0 * (swing.x * swing.y).sqrt();
        if range <= 1e-15 * (swing.x + swing.y) {
            return None; // a circle passes no closest point
        }
        let frequency = swing.form.frequency.value;
        let (push, phase) = match *drive {
            Drive::Absent => return None,
            Drive::Phase { push, phase } => (push, FRAC_PI_2 + phase * frequency),
            Drive::Radius { push, radius } => (push, FRAC_PI_2 + phase_at(radius, swing)?),
        };
        let (mut place, mut rate) = (Complex64::ZERO, Complex64::ZERO);
        let mut along = [Complex64::ZERO; 2];
        for (order, ahead, behind) in swing.form.harmonics() {
            let turn = Complex64::cis(order * phase);
            let (first, second) = (turn * ahead.value, turn.conj() * behind.value);
            place += first + second;
            rate += order * Complex64::I * (first - second);
            let (more, less) = (swing.along_actions(ahead), swing.along_actions(behind));
            for (k, along) in along.iter_mut().enumerate() {
                *along += turn * more[k] + turn.conj() * less[k];
            }
        }
        let distance = place.norm();
        // Straight through the lowest point, away from the axis is where the bob is going.
        let outward = if distance > 0.0 { place / distance } else { rate / rate.norm() };
        let along = along.map(|along| frequency / PI * push * (outward.conj() * along).re);
        let depth_squared = 1.0 - distance * distance;
        let gain = push * (outward.conj() * rate).re + 0.5 * push * push * depth_squared / frequency;
        Some(Self { phase, action: frequency / PI * gain, along })
    }
}

/// Θ since the closest approach at which the bob is that far from the axis, on the way out; none where it never is.
fn phase_at(radius: f64, swing: &Swing) -> Option<f64> {
    let &Swing { x, y, .. } = swing;
    if swing.is_harmonic {
        let (outer, inner) = (x.sqrt() + y.sqrt(), x.sqrt() - y.sqrt());
        let (above, below) = (radius * radius - inner * inner, outer * outer - radius * radius);
        return (above >= 0.0 && below >= 0.0).then(|| above.sqrt().atan2(below.sqrt()));
    }
    let range = 2.0 * (x * y).sqrt();
    let (sum, difference) = (x + y, x - y);
    let height = radius * radius / (1.0 + (1.0 - radius * radius).sqrt());
    let (low, high) = (0.5 * (sum - range), 0.5 * (sum + range));
    if !(low..=high).contains(&height) {
        return None;
    }
    let third = 2.0 + 0.25 * difference * difference / (2.0 - sum);
    let ladder = Ladder::new(third - low, third - high, range);
    Some(ladder.argument((height - low).sqrt().atan2((high - height).sqrt())))
}
