//! One swing in closed form: its rates, its harmonics and its two actions, as functions of the two half-angle amplitudes.
//!
//! With s_a, s_b the heights of the turning points, √(2s_a) = √x + √y and ±√(2s_b) = √x − √y, the sign being the sense:
//! x and y are squares of circular amplitudes, regular on the circle (y = 0) and in the plane (x = y). All that follows
//! is made of sums of one sign, so that it keeps its relative accuracy there.
//! Source: [`crate::exact::invariants`] for the rates, [`crate::exact::spectrum`] for the harmonics. From an outer turning
//! point on, in the turning frame, x + iy = Σ (−1)^k (ahead_k e^{i(2k+1)Θ} + behind_k e^{−i(2k+1)Θ}).

use crate::numbers::dual::{Dual, Real};
use crate::numbers::landen::{Landen, Mean};
use num_complex::Complex64;
use std::f64::consts::FRAC_1_SQRT_2;

/// Pairs of harmonics: the nome stays below 0.05 up to the support, and 0.05^13 is below a rounding.
const PAIRS: usize = 13;

/// What a swing is made of; lengths in l, rates in ω0.
#[derive(Clone, Copy, Debug)]
pub(super) struct ClosedForm<T> {
    /// ω of the swing in the turning frame.
    pub(super) frequency: T,
    /// Ω of that frame, positive counter-clockwise.
    pub(super) precession: T,
    /// Without their alternating signs, all of them positive.
    ahead: [T; PAIRS],
    behind: [T; PAIRS],
    /// The nome q = exp(−πK'/K); and how many pairs are not lost in rounding, of the harmonics and of their squares.
    nome: T,
    pairs: usize,
    square_pairs: usize,
}

/// A sum over pairs of harmonics, weighted by their order: see [`ClosedForm::sum`].
pub(super) type Pair<T> = (f64, T, T);

impl<T: Real + Mean> ClosedForm<T> {
    /// From x > 0 and y > 0, for swings below the support.
    #[inline(always)]
    pub(super) fn of(x: T, y: T) -> Self {
        let ahead = x.value() >= y.value();
        let (larger, smaller) = if ahead { (x, y) } else { (y, x) };
        let sum = larger + smaller; // s_a + s_b
        let product = (larger - smaller) * (larger - smaller) * 0.25; // s_a s_b
        let squared_range = larger * smaller * 4.0; // (s_a − s_b)²
        let rest = -sum + 2.0;
        let third = product / rest + 2.0; // s_c
        let depths = product - sum * 2.0 + 4.0; // (2 − s_a)(2 − s_b)
        let lambda = (larger - smaller) * (product / rest * 0.5 + 1.0).sqrt();
        // First terms of the two zeta sums, the upper one over the range.
        let eighth = lambda * (0.5 * FRAC_1_SQRT_2);
        let mut lower = eighth / third;
        let mut upper = eighth / depths;
        let mut sums = lower + upper * (rest + 2.0);
        let joint = (third * third - third * sum + product).sqrt(); // √((s_c − s_a)(s_c − s_b))
        // a_1, b_1 and c_1 over the range.
        let first = (third * 2.0 - sum + joint * 2.0).sqrt() * 0.5;
        let mut mean = Landen { a: first, b: joint.sqrt(), c: (first * 4.0).recip() };
        // The range to the power 2^n.
        let mut squared = squared_range;
        let mut steps = 1;
        loop {
            let Landen { a, c, .. } = mean;
            let own = squared * c * c;
            lower = lower * ((own + lower * lower) / (a * a + lower * lower)).sqrt() * 0.5;
            upper = upper * ((c * c + upper * upper) / (a * a + squared * upper * upper)).sqrt() * 0.5;
            mean = mean.next();
            let power = squared;
            squared = power * power;
            sums = sums + lower - power * upper;
            steps += 1;
            let largest = (power.value() * mean.c.value().max(upper.value())).max(lower.value());
            if largest < 1e-9 || steps > 7 {
                break;
            }
        }
        let Landen { a, c, .. } = mean;
        let root = |value: T| (1..steps).fold(value, |value, _| value.sqrt());
        // q e^{2η0}, q over the range and e^{2η2}; of the first and the last the amplitudes' u = √(q e^{2η0}) e^{−η2}.
        let lowest = root((lower + (lower * lower + squared * c * c).sqrt()) / (a * 4.0));
        let over_range = root(c / (a * 4.0));
        let ratio = upper / c;
        let highest = root(ratio + (ratio * ratio + 1.0).sqrt());
        let first = (lowest / highest).sqrt();
        let nome = over_range * squared_range.sqrt();
        let second = nome / first;
        let (frequency, precession) = (a * FRAC_1_SQRT_2, sums * FRAC_1_SQRT_2);
        let mut form = Self {
            frequency,
            precession: if ahead { precession } else { -precession },
            ahead: [frequency * 0.0; PAIRS],
            behind: [frequency * 0.0; PAIRS],
            nome,
            pairs: PAIRS,
            square_pairs: PAIRS,
        };
        let (mut own, mut other) = (first, second);
        let floor = 1e-17;
        let mut fade = 1.0;
        for k in 0..PAIRS {
            let order = frequency * (2 * k + 1) as f64;
            form.ahead[k] = frequency * 4.0 * (order + precession) * own / (own * own + 1.0);
            form.behind[k] = frequency * 4.0 * (order - precession) * other / (other * other + 1.0);
            (own, other) = (own * nome, other * nome);
            fade *= nome.value();
            if fade * fade < floor && form.square_pairs == PAIRS {
                form.square_pairs = k + 1;
            }
            if fade < floor {
                form.pairs = k + 1;
                break;
            }
        }
        if !ahead {
            (form.ahead, form.behind) = (form.behind, form.ahead);
        }
        form
    }

    /// Σ of a term of each pair: its order 2k + 1 and the two harmonics. The term must be of second order in these.
    #[inline(always)]
    pub(super) fn sum(&self, term: impl Fn(Pair<T>) -> T) -> T {
        let mut sum = term((1.0, self.ahead[0], self.behind[0]));
        for k in 1..self.square_pairs {
            sum = sum + term(((2 * k + 1) as f64, self.ahead[k], self.behind[k]));
        }
        sum
    }

    /// The actions ½(J_Θ ± J_ψ): J_ψ is the angular momentum, J_Θ the action of the swing. ⟨v·∂r/∂Θ⟩ and ⟨v·∂r/∂ψ⟩ term
    /// by term, with the heights' harmonics 16ω²k q^k/(1 − q^2k).
    #[inline(always)]
    pub(super) fn actions(&self) -> [T; 2] {
        let Self { frequency, precession, nome, .. } = *self;
        let squared = nome * nome;
        let (mut power, mut heights) = (squared, frequency * 0.0);
        for k in 1..self.square_pairs.max(2) {
            let beyond = -power + 1.0;
            heights = heights + power / (beyond * beyond) * (k * k * k * k) as f64;
            power = power * squared;
        }
        let squared = frequency * frequency;
        let heights = squared * squared * frequency * heights * 512.0;
        let sum = |more: f64, less: f64| {
            let pairs = self.sum(|(order, ahead, behind)| {
                (frequency * order + precession) * ahead * ahead * (order + more)
                    + (frequency * order - precession) * behind * behind * (order + less)
            });
            (pairs + heights) * 0.5
        };
        [sum(1.0, -1.0), sum(-1.0, 1.0)]
    }

    /// All harmonics with their signs: order, ahead, behind.
    #[inline(always)]
    pub(super) fn harmonics(&self) -> impl Iterator<Item = Pair<T>> + '_ {
        (0..self.pairs).map(|k| {
            let sign = if k % 2 == 0 { 1.0 } else { -1.0 };
            ((2 * k + 1) as f64, self.ahead[k] * sign, self.behind[k] * sign)
        })
    }

    /// x + iy in the turning frame, where e^{iΘ} is given, of harmonics that `plain` makes of these.
    #[inline(always)]
    pub(super) fn place(&self, turn: Complex64, plain: impl Fn(T) -> f64) -> Complex64 {
        let square = turn * turn;
        let mut turn = turn;
        let mut place = Complex64::ZERO;
        for (_, ahead, behind) in self.harmonics() {
            let (ahead, behind) = (plain(ahead), plain(behind));
            place += Complex64::new((ahead + behind) * turn.re, (ahead - behind) * turn.im);
            turn *= square;
        }
        place
    }

    /// The same with each number mapped.
    #[inline(always)]
    pub(super) fn map<U: Copy>(&self, f: impl Fn(T) -> U) -> ClosedForm<U> {
        ClosedForm {
            frequency: f(self.frequency),
            precession: f(self.precession),
            ahead: self.ahead.map(&f),
            behind: self.behind.map(&f),
            nome: f(self.nome),
            pairs: self.pairs,
            square_pairs: self.square_pairs,
        }
    }
}

impl ClosedForm<f64> {
    /// The zero-mean integral of 2(x + iy)z' over time, where e^{iΘ} is given and z counts downwards: what a horizontal
    /// rotation takes from the angular momentum in a swing and gives back.
    pub(super) fn swayed(&self, turn: Complex64) -> Complex64 {
        let Self { frequency, precession, nome, .. } = *self;
        let mut sum = Complex64::ZERO;
        let mut height = 16.0 * frequency * frequency * nome;
        for k in 1..=self.pairs {
            // z = … + Σ (−1)^k h_k cos 2kΘ with h_k = 16ω²k q^k/(1 − q^2k), so that z' has −(−1)^k 2kω h_k sin 2kΘ.
            let even = 2.0 * k as f64;
            let sign = if k % 2 == 0 { -1.0 } else { 1.0 };
            let rate = sign * even * frequency * height * k as f64 / (1.0 - nome.powi(2 * k as i32));
            for (order, ahead, behind) in self.harmonics() {
                for (n, harmonic) in [(order, ahead), (-order, behind)] {
                    for half in [1.0, -1.0] {
                        // 2 sin 2kΘ e^{inΘ} = −i(e^{i(n + 2k)Θ} − e^{i(n − 2k)Θ}), and the integral divides by i(nω + Ω).
                        let n = n + half * even;
                        sum -= half * rate * harmonic / (n * frequency + precession) * turn.powf(n);
                    }
                }
            }
            height *= nome;
        }
        sum
    }

    /// Its rate, seen from outside that frame.
    pub(super) fn velocity(&self, turn: Complex64) -> Complex64 {
        let square = turn * turn;
        let mut turn = turn;
        let mut rate = Complex64::ZERO;
        for (order, ahead, behind) in self.harmonics() {
            let swing = order * self.frequency;
            let (ahead, behind) = ((swing + self.precession) * ahead, (swing - self.precession) * behind);
            rate += Complex64::new(-(ahead + behind) * turn.im, (ahead - behind) * turn.re);
            turn *= square;
        }
        rate
    }
}

impl ClosedForm<Dual> {
    /// Semi-axes of the ellipse of the first pair of harmonics, the second with the sign of the sense.
    pub(super) fn fundamental(&self) -> [f64; 2] {
        let (ahead, behind) = (self.ahead[0].value, self.behind[0].value);
        [ahead + behind, ahead - behind]
    }

    /// The same without derivatives.
    pub(super) fn values(&self) -> ClosedForm<f64> {
        self.map(|number| number.value)
    }

    /// Swings of first order: rates given, one pair of harmonics.
    pub(super) fn first_order([frequency, precession]: [Dual; 2], [ahead, behind]: [Dual; 2]) -> Self {
        let none = Dual::default();
        let mut form = Self {
            frequency,
            precession,
            ahead: [none; PAIRS],
            behind: [none; PAIRS],
            nome: none,
            pairs: 1,
            square_pairs: 1,
        };
        (form.ahead[0], form.behind[0]) = (ahead, behind);
        form
    }
}
