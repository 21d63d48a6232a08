//! The averaged equations, in variables without singularities.
//!
//! x + iy = A₊ + A₋ with A± = B± e^{±iΦ}, a = |B₊| + |B₋|, b = |B₊| − |B₋|. Φ, the common fast phase, is a quadrature,
//! so that B± are slow at any amplitude. Dimensionless: lengths in l, time in 1/ω0.
//! Source: physics.md §5, there with the singular a, b, ψ; its Θ' is given the mean frequency shift δ/2 here.

use super::drag::quadratic;
use super::ideal::Ideal;
use crate::arithmetic::Portable;
use crate::forces::{Drive, Forces};
use crate::shape::product;
use std::f64::consts::{FRAC_PI_2, PI};

type Complex = [f64; 2];

/// B₊, B₋ and Φ less ω0t.
pub(super) type State = [f64; 5];

/// Which share of the plane's rate is meant; the order of [`Law::shares`].
pub(super) const CAUSES: usize = 5;

#[derive(Clone, Copy, Debug)]
pub(super) struct Law {
    exact: bool,
    /// Ω_z.
    turn: f64,
    /// γ, c.
    drag: [f64; 2],
    /// (δ/2) e^{2iχ}, with δ the true difference of the two frequencies.
    stiff: Complex,
    /// (Δγ/2) e^{2iχd}.
    lossy: Complex,
    /// Of the phase's rate.
    shift: f64,
    drive: Drive,
}

/// What one state's circular amplitudes say: their sizes and directions.
struct Circles {
    p: f64,
    q: f64,
    ahead: Complex,
    behind: Complex,
}

impl Circles {
    fn of(state: &State) -> Self {
        let (p, q) = (state[0].hypot(state[1]), state[2].hypot(state[3]));
        let unit = |size: f64, re: f64, im: f64| if size > 0.0 { [re / size, im / size] } else { [1.0, 0.0] };
        Self { p, q, ahead: unit(p, state[0], state[1]), behind: unit(q, state[2], state[3]) }
    }
}

impl Law {
    pub(super) fn new(forces: &Forces, drive: Drive, length: f64, omega0: f64, exact: bool) -> Self {
        let delta = forces.anisotropy / omega0;
        // The frequency along the axis is √(ω0² + 2ω0δ).
        let split = (1.0 + 2.0 * delta).sqrt() - 1.0;
        let (damping, turn) = (forces.damping / omega0, forces.rotation[1] / omega0);
        let direction = |size: f64, axis: f64| [size * (2.0 * axis).cos(), size * (2.0 * axis).sin()];
        Self {
            exact,
            turn,
            drag: [damping, forces.quadratic * length],
            stiff: direction(0.5 * split, forces.axis),
            lossy: direction(0.5 * forces.damping_anisotropy / omega0, forces.damping_axis),
            // √(ω0² − γ² + Ω_z²), and half-way between the two frequencies of the suspension.
            shift: 0.5 * (split - damping * damping + turn * turn),
            drive: match drive {
                Drive::Absent => drive,
                Drive::Phase { push, phase } => Drive::Phase { push: push / (length * omega0), phase },
                Drive::Radius { push, radius } => {
                    Drive::Radius { push: push / (length * omega0), radius: radius / length }
                }
            },
        }
    }

    pub(super) fn is_conservative(&self) -> bool {
        self.drag == [0.0; 2] && self.lossy == [0.0; 2] && self.drive == Drive::Absent
    }

    /// ω and Ω of the ideal motion.
    pub(super) fn ideal(&self, p: f64, q: f64) -> Ideal {
        match (self.exact, self.drag[0] != 0.0) {
            (false, _) => Ideal::bracketed(p, q),
            (true, false) => Ideal::exact::<false>(p, q),
            (true, true) => Ideal::exact::<true>(p, q),
        }
    }

    /// Rates of the state; NaN where the bob would be level with the support.
    pub(super) fn slope(&self, state: &State) -> State {
        let circles = Circles::of(state);
        let ideal = self.ideal(circles.p, circles.q);
        let mut rates = self.gentle(state, &circles, &ideal);
        self.add_pushes(&circles, &ideal, &mut rates);
        let [x, y, u, v, _] = *state;
        rates[0] -= ideal.precession * y;
        rates[1] += ideal.precession * x;
        rates[2] -= ideal.precession * v;
        rates[3] += ideal.precession * u;
        rates[4] += ideal.frequency - 1.0;
        rates
    }

    /// What everything but the ideal motion and the drive does to B± and Φ.
    pub(super) fn perturbation(&self, state: &State) -> State {
        let circles = Circles::of(state);
        let ideal = self.ideal(circles.p, circles.q);
        self.gentle(state, &circles, &ideal)
    }

    fn gentle(&self, state: &State, circles: &Circles, ideal: &Ideal) -> State {
        let Circles { p, q, .. } = *circles;
        let [x, y, u, v, _] = *state;
        let [linear, square] = self.drag;
        let mut fading = ideal.decay.map(|decay| linear * decay);
        if square != 0.0 {
            let rates = quadratic(p, q);
            fading = [fading[0] + square * rates[0], fading[1] + square * rates[1]];
        }
        let mut rates = [
            fading[0] * x + self.turn * y,
            fading[0] * y - self.turn * x,
            fading[1] * u + self.turn * v,
            fading[1] * v - self.turn * u,
            self.shift,
        ];
        for (first, sign, other) in [(0, 1.0, [u, -v]), (2, -1.0, [x, -y])] {
            let [re, im] = product::<Portable>(self.coupling(sign), other);
            rates[first] += re;
            rates[first + 1] += im;
        }
        rates
    }

    /// κ in B±' = κ B̄∓: of the anisotropic suspension ±i(δ/2)e^{2iχ}, of the anisotropic damping −(Δγ/2)e^{2iχd}.
    fn coupling(&self, sign: f64) -> Complex {
        [-sign * self.stiff[1] - self.lossy[0], sign * self.stiff[0] - self.lossy[1]]
    }

    fn add_pushes(&self, circles: &Circles, ideal: &Ideal, rates: &mut State) {
        let Some([ahead, behind]) = self.pushes(circles, ideal) else { return };
        let (first, second) = (product::<Portable>(ahead, circles.ahead), product::<Portable>(behind, circles.behind));
        for (rate, push) in rates.iter_mut().zip([first[0], first[1], second[0], second[1]]) {
            *rate += push;
        }
    }

    /// B₊'/e^{i arg B₊} and B₋'/e^{i arg B₋} of the drive: Δξ' = push·ξ/|ξ| once in each half swing π/ω.
    fn pushes(&self, circles: &Circles, ideal: &Ideal) -> Option<[Complex; 2]> {
        let Circles { p, q, .. } = *circles;
        // cos 2Θ, sin 2Θ at the push; Θ counts from an outer turning point.
        let (push, [cos, sin]) = match self.drive {
            Drive::Absent => return None,
            Drive::Phase { push, phase } => {
                let (sin, cos) = (2.0 * (FRAC_PI_2 + phase * ideal.frequency)).sin_cos();
                (push, [cos, sin])
            }
            Drive::Radius { push, radius } => {
                // ρ² = p² + q² + 2pq cos 2Θ, and ρ grows where sin 2Θ < 0.
                let cos = (radius * radius - p * p - q * q) / (2.0 * p * q);
                if !(-1.0..=1.0).contains(&cos) {
                    return None;
                }
                (push, [cos, -(1.0 - cos * cos).sqrt()])
            }
        };
        // e^{−iΘ}ξ/|ξ| and its mirror image; through the axis itself the way is straight on.
        let outward = |own: f64, other: f64, sign: f64| {
            let (re, im) = (own + other * cos, sign * other * sin);
            let radius = re.hypot(im);
            if radius > 0.0 { [re / radius, im / radius] } else { [0.0, -sign] }
        };
        let strength = 0.5 * push * ideal.frequency / PI;
        let (ahead, behind) = (outward(p, q, -1.0), outward(q, p, 1.0));
        // 1/2i and −1/2i
        Some([[strength * ahead[1], -strength * ahead[0]], [-strength * behind[1], strength * behind[0]]])
    }

    /// The plane's rate by its causes: the Earth, the ideal motion, the suspension's stiffness, its damping, the drive.
    pub(super) fn shares(&self, state: &State) -> [f64; CAUSES] {
        let circles = Circles::of(state);
        let Circles { p, q, ahead, behind } = circles;
        let ideal = self.ideal(p, q);
        // ½ Im(B₊'/B₊ + B₋'/B₋); the axes' directions against the plane's: e^{−2iψ}.
        let plane = product::<Portable>(ahead, behind);
        let seen = |axis: Complex| product::<Portable>(axis, [plane[0], -plane[1]]);
        let per = |weight: f64, value: f64| if value == 0.0 { 0.0 } else { weight * value };
        let stiff = per(0.5 * (q / p - p / q), seen(self.stiff)[0]);
        let lossy = per(-0.5 * (q / p + p / q), seen(self.lossy)[1]);
        let drive = self
            .pushes(&circles, &ideal)
            .map_or(0.0, |[first, second]| 0.5 * (per(1.0 / p, first[1]) + per(1.0 / q, second[1])));
        [-self.turn, ideal.precession, stiff, lossy, drive]
    }
}
