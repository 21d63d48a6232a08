//! The averaged equations, in variables without singularities.
//!
//! x + iy = A₊ + A₋ with A± = B± e^{±iΦ}, a = |B₊| + |B₋|, b = |B₊| − |B₋|: the two circular amplitudes and their fast
//! phase. What is common to both is a quadrature of its own as well, B± = C± e^{−Γ + iΨ}, so that C± do not change at
//! all for the ideal motion under linear drag on a turning ground. Dimensionless: lengths in l, time in 1/ω0.
//! In the singular a, b, ψ the same equations are in docs/conventions.md; drag is that of air which turns with the ground.

use super::drag::Quadratic;
use super::ideal::Ideal;
use super::push::averaged;
use crate::exact::theta::shape::product;
use crate::given::drive::Drive;
use crate::given::forces::Forces;
use crate::numbers::arithmetic::Portable;

type Complex = [f64; 2];

/// C₊, C₋, Φ less ω0t, Ψ, Γ.
pub(super) type State = [f64; NUMBERS];
pub(super) const NUMBERS: usize = 7;

/// How many shares the plane's rate has; see [`Law::shares`].
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

/// B± by their sizes and directions.
#[derive(Clone, Copy, Debug)]
pub(super) struct Circles {
    pub(super) p: f64,
    pub(super) q: f64,
    ahead: Complex,
    behind: Complex,
}

impl Circles {
    pub(super) fn of(state: &State) -> Self {
        let [x, y, u, v, _, turned, faded] = *state;
        let (first, second, scale) = (x.hypot(y), u.hypot(v), (-faded).exp());
        let (sin, cos) = turned.sin_cos();
        let unit = |size: f64, re: f64, im: f64| {
            if size > 0.0 { product::<Portable>([cos, sin], [re / size, im / size]) } else { [1.0, 0.0] }
        };
        Self { p: scale * first, q: scale * second, ahead: unit(first, x, y), behind: unit(second, u, v) }
    }

    fn amplitudes(&self) -> [Complex; 2] {
        [self.ahead.map(|value| self.p * value), self.behind.map(|value| self.q * value)]
    }
}

impl Law {
    pub(super) fn new(forces: &Forces, drive: Drive, length: f64, omega0: f64, exact: bool) -> Self {
        // The frequency along the axis is √(ω0² + 2ω0δ).
        let split = (1.0 + 2.0 * forces.anisotropy / omega0).sqrt() - 1.0;
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

    fn ideal(&self, p: f64, q: f64) -> Ideal {
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
        let fading = self.fading(&circles, &ideal);
        let common = 0.5 * (fading[0] + fading[1]);
        let apart = 0.5 * (fading[0] - fading[1]);
        let [x, y, u, v, _, turned, faded] = *state;
        let mut rates = [
            apart * x,
            apart * y,
            -apart * u,
            -apart * v,
            (ideal.frequency - 1.0) + self.shift,
            ideal.precession - self.turn,
            -common,
        ];
        let [coupled, pushed] = [self.coupled(&circles), self.pushed(&circles, &ideal)];
        if coupled.is_some() || pushed.is_some() {
            let (sin, cos) = turned.sin_cos();
            let back = [cos, -sin].map(|value| value * faded.exp());
            for added in [coupled, pushed].into_iter().flatten() {
                for (k, part) in added.into_iter().enumerate() {
                    let [re, im] = product::<Portable>(back, part);
                    rates[2 * k] += re;
                    rates[2 * k + 1] += im;
                }
            }
        }
        rates
    }

    /// What everything but the ideal motion and the drive adds to the rates of B± e^{±iΦ}, at Φ = 0.
    pub(super) fn gentle(&self, circles: &Circles) -> [Complex; 2] {
        let fading = self.fading(circles, &self.ideal(circles.p, circles.q));
        let coupled = self.coupled(circles).unwrap_or_default();
        let [ahead, behind] = circles.amplitudes();
        let turned = |[re, im]: Complex, fading: f64, angular: f64, [more_re, more_im]: Complex| {
            [fading * re - angular * im + more_re, fading * im + angular * re + more_im]
        };
        [
            turned(ahead, fading[0], self.shift - self.turn, coupled[0]),
            turned(behind, fading[1], -self.shift - self.turn, coupled[1]),
        ]
    }

    /// p'/p and q'/q by drag alike in all directions. Against the ground, A± go round with ω0 ∓ Ω_z.
    fn fading(&self, circles: &Circles, ideal: &Ideal) -> [f64; 2] {
        let [linear, square] = self.drag;
        let mut fading = [0.0; 2];
        if linear != 0.0 {
            fading = [linear * (ideal.decay[0] + self.turn), linear * (ideal.decay[1] - self.turn)];
        }
        if square != 0.0 {
            let Quadratic { decay, wind } = Quadratic::of(circles.p, circles.q);
            fading[0] += square * (decay[0] + self.turn * wind[0]);
            fading[1] += square * (decay[1] - self.turn * wind[1]);
        }
        fading
    }

    /// κ± B̄∓: of the anisotropic suspension κ± = ±i(δ/2)e^{2iχ}, of the anisotropic damping −(Δγ/2)(1 ± Ω_z)e^{2iχd}.
    fn coupled(&self, circles: &Circles) -> Option<[Complex; 2]> {
        if self.stiff == [0.0; 2] && self.lossy == [0.0; 2] {
            return None;
        }
        let [ahead, behind] = circles.amplitudes();
        let coupled = |sign: f64, [re, im]: Complex| {
            let loss = 1.0 + sign * self.turn;
            let factor = [-sign * self.stiff[1] - loss * self.lossy[0], sign * self.stiff[0] - loss * self.lossy[1]];
            product::<Portable>(factor, [re, -im])
        };
        Some([coupled(1.0, behind), coupled(-1.0, ahead)])
    }

    fn pushed(&self, circles: &Circles, ideal: &Ideal) -> Option<[Complex; 2]> {
        let [ahead, behind] = averaged(&self.drive, circles.p, circles.q, ideal.frequency)?;
        Some([product::<Portable>(ahead, circles.ahead), product::<Portable>(behind, circles.behind)])
    }

    /// The plane's rate by its causes: the Earth, the ideal motion, the suspension's stiffness, its damping, the drive.
    pub(super) fn shares(&self, circles: &Circles) -> [f64; CAUSES] {
        let Circles { p, q, ahead, behind } = *circles;
        let ideal = self.ideal(p, q);
        // ½ Im(B₊'/B₊ + B₋'/B₋); the axes' directions against the plane's, e^{−2iψ}.
        let plane = product::<Portable>(ahead, behind);
        let seen = |axis: Complex| product::<Portable>(axis, [plane[0], -plane[1]]);
        let times = |weight: f64, value: f64| if value == 0.0 { 0.0 } else { weight * value };
        let stiff = times(0.5 * (q / p - p / q), seen(self.stiff)[0]);
        let turn = self.turn;
        let lossy = times(-0.5 * ((1.0 + turn) * q / p + (1.0 - turn) * p / q), seen(self.lossy)[1]);
        let drive = averaged(&self.drive, p, q, ideal.frequency);
        let drive = drive.map_or(0.0, |[first, second]| 0.5 * (times(1.0 / p, first[1]) + times(1.0 / q, second[1])));
        [-turn, ideal.precession, stiff, lossy, drive]
    }

    /// p' and q', everything together.
    pub(super) fn growth(&self, circles: &Circles) -> [f64; 2] {
        let ideal = self.ideal(circles.p, circles.q);
        let [p, q] = self.fading(circles, &ideal);
        let mut rates = [p * circles.p, q * circles.q];
        for added in [self.coupled(circles), self.pushed(circles, &ideal)].into_iter().flatten() {
            rates[0] += circles.ahead[0] * added[0][0] + circles.ahead[1] * added[0][1];
            rates[1] += circles.behind[0] * added[1][0] + circles.behind[1] * added[1][1];
        }
        rates
    }

    /// By which share of itself a swing of amplitude a changes while its phase grows by 1: under linear drag (of which the
    /// first order is exact: the square), quadratic drag, the suspension's stiffness, its damping, and the drive.
    pub(super) fn strengths(&self, a: f64) -> [f64; CAUSES] {
        let size = |[re, im]: Complex| 2.0 * re.hypot(im);
        let push = match self.drive {
            Drive::Absent => 0.0,
            Drive::Phase { push, .. } | Drive::Radius { push, .. } => push.abs() / a,
        };
        [self.drag[0] * self.drag[0], self.drag[1] * a, size(self.stiff), size(self.lossy), push]
    }

    /// Whether nothing adds energy to the swing or takes it away: then no time brings it to the support.
    pub(super) fn is_conservative(&self) -> bool {
        self.drag == [0.0; 2] && self.lossy == [0.0; 2] && self.drive == Drive::Absent
    }
}
