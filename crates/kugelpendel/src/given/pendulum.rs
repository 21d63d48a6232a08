//! The pendulum itself: a point mass on a massless thread.

use crate::given::invalid::{Invalid, all, positive};
use crate::numbers::arithmetic::Arithmetic;
use crate::numbers::double_double::Dd;

/// g, m/s², where nothing is said of the place: the third General Conference on Weights and Measures (1901).
pub const STANDARD_GRAVITY: f64 = 9.80665;

/// Its length, where it hangs, and what hangs on it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pendulum {
    /// The length, m, from the support to the bob's centre.
    pub length: f64,
    /// The gravity, m/s².
    pub gravity: f64,
    /// The mass, kg; scales the tension and nothing else.
    pub mass: f64,
}

/// The least and the most that length, gravity and mass may be, in their units: beyond them squares of speeds overflow,
/// or have no digits left.
pub const EXTREMES: [f64; 2] = [1e-50, 1e50];

impl Pendulum {
    /// # Errors
    /// A length, gravity or mass that is not positive and finite, or beyond what the numbers hold.
    pub fn check(&self) -> Result<(), Invalid> {
        let values = [
            ("pendulum.length", self.length, "m"),
            ("pendulum.gravity", self.gravity, "m/s²"),
            ("pendulum.mass", self.mass, "kg"),
        ];
        positive(&values)?;
        let [least, most] = EXTREMES;
        let inside = |value: f64| (least..=most).contains(&value);
        all(&values, inside, |value| Invalid::BeyondNumbers { value, least, most })
    }

    /// ω0 = √(g/l), rad/s: the frequency of infinitesimal swings.
    pub fn angular_frequency(&self) -> f64 {
        (self.gravity / self.length).sqrt()
    }

    /// The pull of the thread in N on a bob with this position from the support in m and this velocity in m/s.
    ///
    /// Negative where only a rod could hold it. Source: Olsson (1981), equation (5a), m(g cos θ + v²/l).
    pub fn pull(&self, position: [f64; 3], velocity: [f64; 3]) -> f64 {
        let square = velocity.iter().map(|v| v * v).sum::<f64>();
        self.mass * (self.gravity * position[2] + square) / self.length
    }

    #[inline(always)]
    pub(crate) fn precise_angular_frequency<A: Arithmetic>(&self) -> Dd<A> {
        (Dd::from(self.gravity) / Dd::from(self.length)).sqrt()
    }
}
