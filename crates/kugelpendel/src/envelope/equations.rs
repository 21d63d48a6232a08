//! The averaged equations at any amplitude, in variables without singularities.
//!
//! The slow variables are circular amplitudes A± with |A₊|² = X, |A₋|² = Y, the actions of [`super::swing`], and the angles
//! ψ ± Θ as their arguments: for small swings x + iy = A₊ + A₋. A force F changes them at the rates
//!
//! ```text
//! J_i' = ⟨F·∂r/∂φ_i⟩,   φ_i' = ω_i − ⟨F·∂r/∂J_i⟩,
//! ```
//!
//! averaged over the exact swing (variation of constants for canonical variables; Goldstein, Classical Mechanics, ch. 12).
//! What is common to both amplitudes is a quadrature of its own, A± = C± e^{−Γ + iΨ ± iΦ}, so that C± do not change at
//! all for the ideal motion under linear drag on a turning ground. Dimensionless: lengths in l, time in 1/ω0.
//! In the singular a, b, ψ of small swings the same equations are in docs/conventions.md; drag is that of air which turns
//! with the ground.

use super::circles::{Circles, NUMBERS, SlowState};
use super::closed_form::ClosedForm;
use super::drag::{Speeds, Wind};
use super::push::Push;
use super::swing::{self, Swing};
use crate::given::drive::Drive;
use crate::given::forces::Forces;
use crate::numbers::dual::Dual;
use num_complex::Complex64;
use std::f64::consts::PI;

/// How many shares the plane's rate has; see [`AveragedEquations::shares`].
pub(crate) const CAUSES: usize = 5;

/// Rates of A± in units of the directions they point to: the real parts are those of their sizes.
type Changes = [Complex64; 2];

#[derive(Clone, Copy, Debug)]
pub(super) struct AveragedEquations {
    exact: bool,
    /// Ω_z and Ω_h.
    pub(super) turn: f64,
    pub(super) sway: f64,
    /// γ, c.
    drag: [f64; 2],
    /// δ, the true difference of the two frequencies, and Δγ.
    stiff: f64,
    lossy: f64,
    /// e^{−2iχ} and e^{−2iχd}.
    stiff_axis: Complex64,
    lossy_axis: Complex64,
    /// Of the phase's rate, in second order.
    shift: f64,
    drive: Drive,
    /// By how much more or less than in the closed form the ellipse turns by itself.
    pub(super) intrinsic: f64,
}

/// What everything but the swing itself and the drive does.
#[derive(Clone, Copy, Debug, Default)]
struct Gentle {
    /// A±'/A± by drag, without the phase.
    fading: [f64; 2],
    /// Of Φ and of Ψ.
    phase: f64,
    turned: f64,
    /// The part of the phase's rate that the suspension adds, of both A±.
    stiffened: [f64; 2],
    /// By the suspension.
    coupled: Option<Changes>,
}

impl AveragedEquations {
    pub(super) fn new(forces: &Forces, drive: Drive, length: f64, omega0: f64, exact: bool) -> Self {
        // The frequency along the axis is √(ω0² + 2ω0δ).
        let split = (1.0 + 2.0 * forces.anisotropy / omega0).sqrt() - 1.0;
        let (damping, turn) = (forces.damping / omega0, forces.rotation[1] / omega0);
        Self {
            exact,
            turn,
            sway: forces.rotation[0] / omega0,
            drag: [damping, forces.quadratic * length],
            stiff: split,
            lossy: forces.damping_anisotropy / omega0,
            stiff_axis: Complex64::cis(-2.0 * forces.axis),
            lossy_axis: Complex64::cis(-2.0 * forces.damping_axis),
            // √(ω0² − γ² + Ω_z²).
            shift: 0.5 * (turn * turn - damping * damping),
            drive: match drive {
                Drive::Absent => drive,
                Drive::Phase { push, phase } => Drive::Phase { push: push / (length * omega0), phase },
                Drive::Radius { push, radius } => {
                    Drive::Radius { push: push / (length * omega0), radius: radius / length }
                }
            },
            intrinsic: 1.0,
        }
    }

    /// None where the bob would be level with the support.
    pub(super) fn swing(&self, circles: &Circles) -> Option<Swing> {
        if self.exact { Swing::of(circles.actions()) } else { Some(Swing::first_order(circles.actions())) }
    }

    /// √X and √Y of the turning radii a ≥ b ≥ 0.
    pub(super) fn amplitudes(&self, [a, b]: [f64; 2]) -> [f64; 2] {
        if !self.exact {
            return [0.5 * (a + b), 0.5 * (a - b)];
        }
        let [x, y] = swing::half_angle([a, b]);
        let size = x + y;
        if size < swing::SMALLEST {
            return [x.sqrt(), y.sqrt()];
        }
        let [first, second] = ClosedForm::of(x, y.max(swing::ROUNDEST * size)).actions();
        match (b == 0.0, y > 0.0) {
            (true, _) => [first.sqrt(); 2], // in a plane to the last bit
            (_, true) => [first.sqrt(), second.sqrt()],
            _ => [first.sqrt(), 0.0],
        }
    }

    /// The mean actions of a swing that has these at this azimuth and phase: without what the horizontal rotation adds for
    /// a part of the swing, and without the half of a push by which the actions lie above their mean after it, and below
    /// it before the next. The rotation does no work, so that ωδJ_Θ + ΩδJ_ψ = 0.
    pub(super) fn settled(&self, actions: [f64; 2], azimuth: f64, phase: f64) -> [f64; 2] {
        let Some(swing) = Swing::of(actions).filter(|_| self.exact) else { return actions };
        let form = swing.form.values();
        let mut added = [0.0; 2];
        if self.sway != 0.0 {
            let swayed = Complex64::cis(azimuth) * form.swayed(Complex64::cis(phase));
            let spin = -self.sway * swayed.im;
            let ratio = form.precession / form.frequency;
            added = [0.5 * (1.0 - ratio) * spin, -0.5 * (1.0 + ratio) * spin];
        }
        if let Some(push) = Push::of(&self.drive, &swing) {
            let since = ((phase - push.phase) / PI).rem_euclid(1.0);
            let more = 0.5 * push.action * PI / form.frequency * (0.5 - since);
            added = added.map(|added| added + more);
        }
        [actions[0] - added[0], actions[1] - added[1]]
    }

    /// Rates of the state; NaN where the bob would be level with the support.
    pub(super) fn slope(&self, state: &SlowState) -> SlowState {
        let circles = Circles::of(state);
        let Some(swing) = self.swing(&circles) else { return [f64::NAN; NUMBERS] };
        let gentle = self.gentle(&circles, &swing);
        let common = 0.5 * (gentle.fading[0] + gentle.fading[1]);
        let apart = 0.5 * (gentle.fading[0] - gentle.fading[1]);
        let [x, y, u, v, _, turned, faded] = *state;
        let mut rates = [
            apart * x,
            apart * y,
            -apart * u,
            -apart * v,
            (swing.form.frequency.value - 1.0) + gentle.phase,
            self.intrinsic * swing.form.precession.value + gentle.turned,
            -common,
        ];
        let pushed = self.pushed(&circles, &swing);
        if gentle.coupled.is_some() || pushed.is_some() {
            let back = Complex64::from_polar(faded.exp(), -turned);
            let directions = [back * circles.ahead, back * circles.behind];
            for added in [gentle.coupled, pushed].into_iter().flatten() {
                for (k, (direction, part)) in directions.into_iter().zip(added).enumerate() {
                    let part = direction * part;
                    rates[2 * k] += part.re;
                    rates[2 * k + 1] += part.im;
                }
            }
        }
        rates
    }

    fn gentle(&self, circles: &Circles, swing: &Swing) -> Gentle {
        let mut gentle = Gentle { phase: self.shift, turned: -self.turn, ..Gentle::default() };
        let form = &swing.form;
        let [linear, square] = self.drag;
        if linear != 0.0 {
            // Against the ground the air of the swing blows with iΩ_z(x + iy).
            let blown = |action: f64, more: f64, less: f64| {
                let values = form
                    .sum(|(order, ahead, behind)| ahead * ahead * (order + more) + behind * behind * -(order + less));
                if action > 0.0 { 0.5 * values.value / action } else { more }
            };
            let [first, second] = circles.actions();
            let [floor_first, floor_second] = [first, second].map(|action| action.max(1e-32 * (first + second)));
            gentle.fading = [
                -linear * (1.0 - self.turn * blown(floor_first, 1.0, -1.0)),
                -linear * (1.0 - self.turn * blown(floor_second, -1.0, 1.0)),
            ];
        }
        if square != 0.0 {
            let Speeds { mean, covariance } =
                if self.exact { Speeds::of(swing.x, swing.y) } else { Speeds::of_small(circles.p, circles.q) };
            let Wind([ahead, behind]) = Wind::of(circles.p, circles.q);
            let share = |x: f64, action: f64| if action > 0.0 { x / action } else { 1.0 };
            let [first, second] = circles.actions();
            let frequency = if self.exact { form.frequency.value } else { 1.0 };
            let more = covariance / frequency;
            gentle.fading[0] -= square * (0.5 * mean + more * swing.y * share(swing.x, first) - self.turn * ahead);
            gentle.fading[1] -= square * (0.5 * mean + more * swing.x * share(swing.y, second) + self.turn * behind);
        }
        self.suspend(circles, swing, &mut gentle);
        gentle
    }

    /// The uneven suspension. Of its stiffness the averaged potential is (δ/2)(⟨ρ²⟩ + M cos 2(ψ − χ)) with
    /// M = ⟨(x + iy)²⟩ in the frame of ψ; of its damping ⟨F·∂r⟩ with F = −Δγ e^{2iχd} (x − iy)'.
    fn suspend(&self, circles: &Circles, swing: &Swing, gentle: &mut Gentle) {
        if self.stiff == 0.0 && self.lossy == 0.0 {
            return;
        }
        let form = &swing.form;
        let &Circles { p, q, ahead, behind } = circles;
        let [x, y] = circles.actions().map(|action| action.max(1e-32 * (p * p + q * q)));
        if x == 0.0 {
            return;
        }
        let scale = 1.0 / (x * y).sqrt();
        let m = form.sum(|(_, ahead, behind)| ahead * behind * 2.0);
        let [m_first, m_second] = swing.along_actions(m).map(|slope| scale * slope);
        let m = scale * m.value;
        let mut coupled = [Complex64::ZERO; 2];
        if self.stiff != 0.0 {
            let square = form.sum(|(_, ahead, behind)| ahead * ahead + behind * behind);
            let [first, second] = swing.along_actions(square);
            let (first, second) = (first / x, second / y);
            gentle.stiffened = [0.5 * self.stiff * first, 0.5 * self.stiff * second];
            gentle.phase += 0.25 * self.stiff * (first + second);
            gentle.turned += 0.25 * self.stiff * (first - second);
            let Complex64 { re: cos, im: sin } = ahead * behind * self.stiff_axis;
            let half = 0.5 * self.stiff;
            coupled[0] += half * q * Complex64::new(0.5 * m * sin, m_first * cos);
            coupled[1] -= half * p * Complex64::new(0.5 * m * sin, m_second * cos);
        }
        if self.lossy != 0.0 {
            let frequency = form.frequency.value;
            let turning = self.intrinsic * form.precession.value - self.turn;
            let squared = scale * form.sum(|(order, ahead, behind)| ahead * behind * (2.0 * order * order)).value;
            // Σ n(c_n ∂c_{−n} − c_{−n} ∂c_n).
            let weighted = |k: usize| {
                let slopes = form.sum(|(order, ahead, behind)| {
                    let (one, other) = (swing.along_actions(behind)[k], swing.along_actions(ahead)[k]);
                    Dual { value: order * (ahead.value * one - behind.value * other), slope: [0.0; 2] }
                });
                scale * slopes.value
            };
            let Complex64 { re: cos, im: sin } = ahead * behind * self.lossy_axis;
            let turned = |k: usize, slope: f64| self.lossy * sin * (0.5 * turning * slope + frequency * weighted(k));
            let faded = |sign: f64| -0.25 * self.lossy * cos * (frequency * squared - sign * turning * m);
            coupled[0] += q * Complex64::new(faded(1.0), -turned(0, m_first));
            coupled[1] += p * Complex64::new(faded(-1.0), turned(1, m_second));
        }
        gentle.coupled = Some(coupled);
    }

    /// A± of the swing on which the bob is found. An uneven suspension pulls with the place: the actions and angles that
    /// change as the averages say belong to place and velocity together, a_± = A± ∓ (i/2)A±', and not to the place alone.
    pub(super) fn in_place(&self, circles: &Circles, swing: &Swing) -> Option<Circles> {
        let mut gentle = Gentle::default();
        self.suspend(circles, swing, &mut gentle);
        let [ahead, behind] = gentle.coupled?;
        let [first, second] = gentle.stiffened;
        let half = Complex64::new(0.0, 0.5);
        let moved = |size: f64, direction: Complex64, more: Complex64| {
            let moved = size + more;
            let norm = moved.norm();
            (norm, if norm > 0.0 { direction * moved / norm } else { direction })
        };
        let (p, ahead) = moved(circles.p, circles.ahead, half * (ahead + Complex64::I * first * circles.p));
        let (q, behind) = moved(circles.q, circles.behind, -half * (behind - Complex64::I * second * circles.q));
        Some(Circles { p, q, ahead, behind })
    }

    fn pushed(&self, circles: &Circles, swing: &Swing) -> Option<Changes> {
        let Push { action, along, .. } = Push::of(&self.drive, swing)?;
        let &Circles { p, q, .. } = circles;
        let floor = 1e-16 * (p + q);
        let (p, q) = (p.max(floor), q.max(floor));
        Some([Complex64::new(0.25 * action / p, -along[0] / p), Complex64::new(0.25 * action / q, along[1] / q)])
    }

    /// What all but the ideal motion with its own Ω and the drive adds to the velocity of a swing at the phase Θ in the frame of ψ.
    pub(super) fn drift(&self, circles: &Circles, swing: &Swing, phase: f64) -> Complex64 {
        let gentle = self.gentle(circles, swing);
        let [ahead, behind] = gentle.coupled.unwrap_or_default();
        let floor = 1e-16 * (circles.p + circles.q);
        let [p, q] = [circles.p, circles.q].map(|size| size.max(floor));
        if p == 0.0 {
            return Complex64::ZERO;
        }
        // Rates of ln X, ln Y, of ψ and of Θ.
        let sizes = [2.0 * (gentle.fading[0] + ahead.re / p), 2.0 * (gentle.fading[1] + behind.re / q)];
        let (first, second) = (ahead.im / p, behind.im / q);
        let more = (self.intrinsic - 1.0) * swing.form.precession.value;
        let (turned, phased) = (more + gentle.turned + 0.5 * (first + second), gentle.phase + 0.5 * (first - second));
        let changed = |harmonic: Dual| {
            let [first, second] = swing.along_actions(harmonic);
            first * sizes[0] + second * sizes[1]
        };
        swing
            .form
            .harmonics()
            .map(|(order, ahead, behind)| {
                let turn = Complex64::cis(order * phase);
                turn * Complex64::new(changed(ahead), ahead.value * (turned + order * phased))
                    + turn.conj() * Complex64::new(changed(behind), behind.value * (turned - order * phased))
            })
            .sum()
    }

    /// The plane's rate by its causes: the Earth, the ideal motion, the suspension's stiffness, its damping, the drive.
    pub(super) fn shares(&self, circles: &Circles) -> [f64; CAUSES] {
        let Some(swing) = self.swing(circles) else { return [f64::NAN; CAUSES] };
        let &Circles { p, q, .. } = circles;
        let of = |changes: Option<Changes>| {
            let times = |size: f64, change: f64| if change == 0.0 { 0.0 } else { change / size };
            changes.map_or(0.0, |[ahead, behind]| 0.5 * (times(p, ahead.im) + times(q, behind.im)))
        };
        let alone = |stiff: f64, lossy: f64| {
            let mut gentle = Gentle::default();
            Self { stiff, lossy, ..*self }.suspend(circles, &swing, &mut gentle);
            gentle.turned + of(gentle.coupled)
        };
        let intrinsic = self.intrinsic * swing.form.precession.value;
        let pushed = of(self.pushed(circles, &swing));
        [-self.turn, intrinsic, alone(self.stiff, 0.0), alone(0.0, self.lossy), pushed]
    }

    /// Rates of ln X and ln Y, everything together.
    pub(super) fn growth(&self, circles: &Circles, swing: &Swing) -> [f64; 2] {
        let gentle = self.gentle(circles, swing);
        let mut rates = gentle.fading;
        for [ahead, behind] in [gentle.coupled, self.pushed(circles, swing)].into_iter().flatten() {
            let floor = 1e-16 * (circles.p + circles.q);
            rates[0] += ahead.re / circles.p.max(floor);
            rates[1] += behind.re / circles.q.max(floor);
        }
        rates.map(|rate| 2.0 * rate)
    }

    /// By which share of itself a swing of amplitude a changes while its phase grows by 1: under linear drag (of which the
    /// first order is exact: the square), quadratic drag, the suspension's stiffness, its damping, and the drive.
    pub(super) fn strengths(&self, a: f64) -> [f64; CAUSES] {
        let push = match self.drive {
            Drive::Absent => 0.0,
            Drive::Phase { push, .. } | Drive::Radius { push, .. } => push.abs() / a,
        };
        [self.drag[0] * self.drag[0], self.drag[1] * a, self.stiff.abs(), self.lossy.abs(), push]
    }

    /// Whether nothing but a turning ground acts, so that the motion is known in closed form.
    pub(super) fn is_free(&self) -> bool {
        self.is_conservative() && self.stiff == 0.0
    }

    /// Whether nothing acts at all.
    pub(super) fn is_ideal(&self) -> bool {
        self.is_free() && self.turn == 0.0 && self.intrinsic == 1.0
    }

    /// Whether nothing adds energy to the swing or takes it away: then no time brings it to the support.
    pub(super) fn is_conservative(&self) -> bool {
        self.drag == [0.0; 2] && self.lossy == 0.0 && self.drive == Drive::Absent
    }
}
