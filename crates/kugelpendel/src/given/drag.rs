//! What the air takes away: −2γv − c|v|v for each unit of mass.

use crate::given::bob::Bob;
use crate::given::invalid::{Invalid, not_negative, positive};
use crate::given::pendulum::Pendulum;
use std::f64::consts::{LN_2, PI};

/// The two terms of the drag (R. A. Nelson and M. G. Olsson, Am. J. Phys. 54, 112, 1986, section on damping).
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Drag {
    /// γ, 1/s: alone it makes the amplitude fall as e^(−γt).
    pub linear: f64,
    /// c, 1/m: alone it makes a plane swing's amplitude fall as a/(1 + (4/3π) c ω0 a t).
    pub quadratic: f64,
}

/// A ball and its thread in still air, for an estimate of the drag.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StillAir {
    /// The viscosity, η, Pa·s.
    pub viscosity: f64,
    /// The drag coefficient of the ball.
    pub drag_coefficient: f64,
    /// The thread diameter, m; 0 leaves the thread out.
    pub thread_diameter: f64,
    /// The drag coefficient of a cylinder across the wind.
    pub thread_drag_coefficient: f64,
}

impl Default for StillAir {
    /// A smooth ball in air of 15 to 20 °C, without its thread: 0.44 between Reynolds numbers of 750 and 2·10⁵, Newton's
    /// range, and 1.1 for a thread.
    fn default() -> Self {
        Self { viscosity: 1.81e-5, drag_coefficient: 0.44, thread_diameter: 0.0, thread_drag_coefficient: 1.1 }
    }
}

impl Drag {
    /// # Errors
    /// A term that is negative or not finite.
    pub fn check(&self) -> Result<(), Invalid> {
        not_negative(&[("drag.linear", self.linear, "1/s"), ("drag.quadratic", self.quadratic, "1/m")])
    }

    /// Linear drag from the quality factor: γ = ω0/(2Q).
    ///
    /// # Errors
    /// A quality that is not positive and finite.
    pub fn from_quality(quality: f64, angular_frequency: f64) -> Result<Self, Invalid> {
        positive(&[("drag.quality", quality, "")])?;
        Ok(Self { linear: angular_frequency / (2.0 * quality), quadratic: 0.0 })
    }

    /// Linear drag from the time, s, in which the amplitude falls to half: γ = ln 2/t.
    ///
    /// # Errors
    /// A half-life that is not positive and finite.
    pub fn from_half_life(half_life: f64) -> Result<Self, Invalid> {
        positive(&[("drag.half_life", half_life, "s")])?;
        Ok(Self { linear: LN_2 / half_life, quadratic: 0.0 })
    }

    /// With the bob's mass m and the air's density ρ: γ = 3πηr(1 + r/s)/m, s = √(2η/(ρω0)), which is Stokes (1851) as in
    /// Landau and Lifshitz, Fluid Mechanics, §24, problem 5; c = ρ(C π r² + C_t d l/4)/(2m), the thread's share by the
    /// power that it takes.
    ///
    /// # Errors
    /// What is not positive, a diameter that is negative, and a bob that does not fit the pendulum.
    pub fn from_bob(bob: &Bob, pendulum: &Pendulum, air: &StillAir) -> Result<Self, Invalid> {
        bob.check()?;
        bob.fits(pendulum.length)?;
        let StillAir { viscosity, drag_coefficient, thread_diameter, thread_drag_coefficient } = *air;
        positive(&[("drag.air_viscosity", viscosity, "Pa·s"), ("drag.drag_coefficient", drag_coefficient, "")])?;
        not_negative(&[("drag.thread_diameter", thread_diameter, "m")])?;
        positive(&[("drag.thread_drag_coefficient", thread_drag_coefficient, "")])?;
        let (r, m, density) = (bob.radius, bob.mass(), bob.air_density);
        let layer = (2.0 * viscosity / (density * pendulum.angular_frequency())).sqrt();
        let linear = 3.0 * PI * viscosity * r * (1.0 + r / layer) / m;
        let ball = drag_coefficient * PI * (r * r);
        let area = ball + thread_drag_coefficient * thread_diameter * pendulum.length / 4.0;
        Ok(Self { linear, quadratic: density * area / (2.0 * m) })
    }
}
