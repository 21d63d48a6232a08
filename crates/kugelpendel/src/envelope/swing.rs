//! The swing that has given actions: the closed form inverted, with everything's derivatives along the actions.
//!
//! The averaged equations are written in the two actions X = ½(J_Θ + J_ψ), Y = ½(J_Θ − J_ψ), of which √X and √Y are the
//! circular amplitudes of small swings: linear drag takes them away like e^{−2γt} at any amplitude, and what does work
//! changes actions and angles by derivatives along each other.

use super::closed_form::ClosedForm;
use crate::numbers::dual::Dual;
use num_complex::Complex64;

/// Below this size a swing has no amplitude to speak of, and squares of its nome underflow.
pub(super) const SMALLEST: f64 = 1e-18;

/// The smaller of the two amplitudes is taken to be no smaller than this share of the larger one (of their squares).
pub(super) const ROUNDEST: f64 = 1e-32;

/// Relative corrections below this are applied to first order; the second is then lost in rounding.
const SMALL: f64 = 5e-8;

/// What may be left out of a place, in l, where a swing is followed along its derivatives.
const ROUNDING: f64 = 1e-16;

/// Higher swings, of which derivatives grow without bound, are not followed along these.
const NEAR_SUPPORT: f64 = 0.99;

#[derive(Clone, Copy, Debug)]
pub(super) struct Swing {
    /// Slopes are those along ln x, ln y; see [`Self::along_actions`].
    pub(super) form: ClosedForm<Dual>,
    /// Squares of the half-angle amplitudes.
    pub(super) x: f64,
    pub(super) y: f64,
    /// Whether it is one of first order, whose amplitudes are radii.
    pub(super) is_harmonic: bool,
    /// Derivatives of ln x, ln y along ln X, ln Y.
    inverse: [[f64; 2]; 2],
}

impl Swing {
    /// None where the bob would come level with the support.
    pub(super) fn of(actions: [f64; 2]) -> Option<Self> {
        let floor = ROUNDEST * (actions[0] + actions[1]);
        let [first, second] = actions.map(|action| action.max(floor));
        if first + second < SMALLEST {
            return Some(Self::first_order(actions));
        }
        // X = x(1 + y/8 + x²/32 − 5xy/128 + 7y²/128 + …).
        let (x, y) = (first / (1.0 + 0.125 * second), second / (1.0 + 0.125 * first));
        let series = |x: f64, y: f64| 1.0 + 0.125 * y + (4.0 * x * x - 5.0 * x * y + 7.0 * y * y) / 128.0;
        let (x, y) = (first / series(x, y), second / series(y, x));
        Self::near([first, second], [first / series(x, y), second / series(y, x)])
    }

    /// The swing of slightly other actions than these.
    pub(super) fn moved(&self, from: [f64; 2], to: [f64; 2]) -> Option<Self> {
        let floor = ROUNDEST * (from[0] + from[1]);
        let [from, to] = [from, to].map(|actions| actions.map(|action| action.max(floor)));
        if self.is_harmonic || from[0] + from[1] < SMALLEST {
            return Some(Self::first_order(to));
        }
        let grown = [to[0] / from[0] - 1.0, to[1] / from[1] - 1.0];
        let factor = |[first, second]: [f64; 2]| (1.0 + first * grown[0] + second * grown[1]).clamp(0.1, 10.0);
        Self::near(to, [self.x * factor(self.inverse[0]), self.y * factor(self.inverse[1])])
    }

    /// Where the bob is on the swing of slightly other circular amplitudes √X, √Y than these: x + iy in the turning frame,
    /// where e^{iΘ} is given. None where it would come level with the support.
    ///
    /// Along the swing's own derivatives as far as these go, as places are read by the hundred thousand. Harmonics are
    /// linear in the amplitudes but for a share of their squares, x + y, so that a relative step leaves out its square
    /// times (x + y)^{3/2}.
    pub(super) fn place_after(&self, from: [f64; 2], to: [f64; 2], turn: Complex64) -> Option<Complex64> {
        let grown: [f64; 2] = std::array::from_fn(|k| 2.0 * (to[k] / from[k] - 1.0));
        let step = self.inverse.map(|[first, second]| first * grown[0] + second * grown[1]);
        let largest = step[0].abs().max(step[1].abs());
        let size = self.x + self.y;
        if largest * largest * size * size.sqrt() < ROUNDING && top(self.x, self.y) < NEAR_SUPPORT {
            return Some(self.form.place(turn, |harmonic| harmonic.after(step)));
        }
        let squares = |sizes: [f64; 2]| sizes.map(|size| size * size);
        Some(self.moved(squares(from), squares(to))?.form.place(turn, |harmonic| harmonic.value))
    }

    /// By Newton's method from a guess of x and y.
    fn near([first, second]: [f64; 2], [mut x, mut y]: [f64; 2]) -> Option<Self> {
        for _ in 0..40 {
            (x, y) = below_support(x, y);
            let along = |value: f64, k: usize| {
                let mut slope = [0.0; 2];
                slope[k] = value;
                Dual { value, slope }
            };
            let form = ClosedForm::of(along(x, 0), along(y, 1));
            let [found_first, found_second] = form.actions();
            let relative = |action: Dual| action.slope.map(|slope| slope / action.value);
            let [[a, b], [c, d]] = [relative(found_first), relative(found_second)];
            let determinant = a * d - b * c;
            let inverse = [[d / determinant, -b / determinant], [-c / determinant, a / determinant]];
            let missing = [first / found_first.value - 1.0, second / found_second.value - 1.0];
            let mut step = inverse.map(|[to_first, to_second]| to_first * missing[0] + to_second * missing[1]);
            if x == y && first == second {
                step[1] = step[0]; // in a plane to the last bit
            }
            let largest = step[0].abs().max(step[1].abs());
            if largest < SMALL {
                let form = form.map(|number| Dual { value: number.after(step), ..number });
                (x, y) = (x * (1.0 + step[0]), y * (1.0 + step[1]));
                return (top(x, y) < 1.0).then_some(Self { form, x, y, is_harmonic: false, inverse });
            }
            let [first, second] = step.map(|step| step.clamp(-0.7, 0.7).exp());
            (x, y) = (x * first, y * second);
        }
        None
    }

    /// Small swings, with Olsson's (25) and (26) for the rates.
    pub(super) fn first_order(actions: [f64; 2]) -> Self {
        let floor = ROUNDEST * (actions[0] + actions[1]);
        let [x, y] = actions.map(|action| action.max(floor));
        let frequency = Dual { value: 1.0 - 0.125 * (x + y), slope: [-0.125 * x, -0.125 * y] };
        let precession = Dual { value: 0.375 * (x - y), slope: [0.375 * x, -0.375 * y] };
        let amplitude = |square: f64, k: usize| {
            let value = square.sqrt();
            let mut slope = [0.0; 2];
            slope[k] = 0.5 * value;
            Dual { value, slope }
        };
        let form = ClosedForm::first_order([frequency, precession], [amplitude(x, 0), amplitude(y, 1)]);
        Self { form, x, y, is_harmonic: true, inverse: [[1.0, 0.0], [0.0, 1.0]] }
    }

    /// Turning radii a and b, b with the sign of the sense.
    pub(super) fn radii(&self) -> [f64; 2] {
        let [p, q] = [self.x.sqrt(), self.y.sqrt()];
        if self.is_harmonic { [p + q, p - q] } else { [p + q, p - q].map(radius) }
    }

    /// Their rates, from those of ln X and ln Y.
    pub(super) fn radii_rates(&self, [first, second]: [f64; 2]) -> [f64; 2] {
        let [[a, b], [c, d]] = self.inverse;
        let [p, q] = [self.x.sqrt(), self.y.sqrt()];
        let (p_rate, q_rate) = (0.5 * p * (a * first + b * second), 0.5 * q * (c * first + d * second));
        let rates = [p_rate + q_rate, p_rate - q_rate];
        if self.is_harmonic {
            return rates;
        }
        let slope = |chord: f64| (1.0 - 0.5 * chord * chord) / (1.0 - 0.25 * chord * chord).sqrt();
        [rates[0] * slope(p + q), rates[1] * slope(p - q)]
    }

    /// Derivatives along ln X and ln Y.
    #[inline(always)]
    pub(super) fn along_actions(&self, number: Dual) -> [f64; 2] {
        let [first, second] = number.slope;
        let [[a, b], [c, d]] = self.inverse;
        [first * a + second * c, first * b + second * d]
    }
}

/// Height of the highest point.
fn top(x: f64, y: f64) -> f64 {
    0.5 * (x + y) + (x * y).sqrt()
}

/// A guess so near the support that the closed form's numbers would leave their domain is brought back.
fn below_support(x: f64, y: f64) -> (f64, f64) {
    let share = (1.99 / (x + y)).min(1.0);
    (share * x, share * y)
}

/// Distance from the axis at the end of a chord from the lowest point, √(2s); with its sign.
fn radius(chord: f64) -> f64 {
    chord * (1.0 - 0.25 * chord * chord).sqrt()
}

/// x and y of the turning radii a ≥ b ≥ 0.
pub(super) fn half_angle([a, b]: [f64; 2]) -> [f64; 2] {
    let chord = |radius: f64| radius * (2.0 / (1.0 + (1.0 - radius * radius).sqrt())).sqrt();
    let (outer, inner) = (chord(a), chord(b));
    [0.25 * (outer + inner) * (outer + inner), 0.25 * (outer - inner) * (outer - inner)]
}
