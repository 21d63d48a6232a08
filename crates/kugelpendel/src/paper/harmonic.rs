//! A turning figure of a few harmonics: what the linear, the Olsson and the series motion are.
//!
//! x + iy = e^{i(Ωt + …)} (cos ζ·P(sin² ζ) + i sin ζ·Q(sin² ζ)), ζ = π/2 at the first highest point, and z on the lower
//! half of the sphere.

use crate::exact::motion::ExactMotion;
use crate::exact::sampling::in_tasks;
use crate::given::invalid::{Invalid, require};
use crate::given::launch::Launch;
use crate::given::pendulum::Pendulum;
use crate::given::times::{Quantity, Times};
use crate::meaning::azimuth::nearest;
use crate::meaning::events::events_on_a_grid;
use crate::meaning::olsson;
use crate::numbers::arithmetic::{Arithmetic, FEW_FORMS, Portable, dispatch, horner, product};
use crate::numbers::double_double::Dd;
use crate::sampling::blocks::{Form, SwingAndFrame, blocks};
use crate::sampling::blocks::{Rotations, half, rotations};
use crate::taylor::events::Event;
use crate::taylor::walk::{Halt, StateVector, Stop};
use std::f64::consts::{PI, TAU};

/// Powers of sin² ζ beyond the first: harmonics up to the thirteenth.
pub const MAX_POWER: usize = 6;

/// Coefficients of P or of Q.
pub type Powers = [f64; MAX_POWER + 1];

/// The law by which a figure moves: its two rates, and with them the equation of the paper.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum HarmonicLaw {
    /// The standing ellipse of infinitesimal swings, (16).
    Linear,
    /// The turning ellipse, (20), with its rates from (25) and (26).
    Olsson,
}

/// A figure of a few harmonics that turns, and its two rates.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct HarmonicMotion {
    /// The pendulum, of which the length makes the sphere.
    pub pendulum: Pendulum,
    /// The frequency ω of the swing in the turning frame, in rad/s.
    pub frequency: f64,
    /// The precession Ω of that frame, in rad/s, positive counter-clockwise seen from above.
    pub precession: f64,
    /// A time at an outer turning point, in s.
    pub apsis_time: f64,
    /// The azimuth of that point, in rad.
    pub apsis_azimuth: f64,
    /// The coefficients of P, in m: the first is the inner semi-axis, positive counter-clockwise seen from above.
    pub inner: Powers,
    /// The coefficients of Q, in m: their sum is the outer semi-axis.
    pub outer: Powers,
}

/// A launch that is past an outer turning point by no more of a radial period is meant to be at it.
const MEANT: f64 = 1e-9;

/// Time in s and azimuth in rad of the first outer turning point.
fn first_apsis(exact: &ExactMotion) -> [f64; 2] {
    let (time, azimuth, period) = (exact.apsis_time(), exact.apsis_azimuth(), exact.radial_period());
    if period - time < MEANT * period {
        return [time - period, nearest(azimuth - exact.apsidal_angle(), 0.0, TAU)];
    }
    [time, azimuth]
}

struct Figure<const DEGREE: usize> {
    length: f64,
    swing: f64,
    frame: f64,
    inner: Powers,
    outer: Powers,
    inner_rate: Powers,
    outer_rate: Powers,
}

impl<A: Arithmetic, const DEGREE: usize> Form<A> for Figure<DEGREE> {
    #[inline(always)]
    fn point<const RATES: bool>(&self, [c, s]: [f64; 2], direction: [f64; 2]) -> [f64; 3] {
        let square = s * s;
        let plan = [c * horner::<A, _>(&self.inner, DEGREE, square), s * horner::<A, _>(&self.outer, DEGREE, square)];
        let radius_squared = A::mul_add(plan[0], plan[0], plan[1] * plan[1]);
        let z = A::mul_add(self.length, self.length, -radius_squared).sqrt();
        if RATES {
            let (x, y) = (self.swing * s, self.swing * c);
            let rate = [
                A::mul_add(x, horner::<A, _>(&self.inner_rate, DEGREE, square), -(self.frame * plan[1])),
                A::mul_add(y, horner::<A, _>(&self.outer_rate, DEGREE, square), self.frame * plan[0]),
            ];
            let outward = A::mul_add(plan[0], rate[0], plan[1] * rate[1]);
            let [vx, vy] = product::<A>(direction, rate);
            [vx, vy, -outward / z]
        } else {
            let [x, y] = product::<A>(direction, plan);
            [x, y, z]
        }
    }
}

impl HarmonicMotion {
    /// The ellipse through the exact turning points of a launch, with the phase of its first outer one; of a launch at one,
    /// however its last digit is rounded, that is the launch itself.
    ///
    /// What differs from the exact motion is the law alone.
    ///
    /// # Errors
    /// What [`ExactMotion::new`] refuses, and a path that rises to the support or above it.
    pub fn new(pendulum: Pendulum, launch: Launch, law: HarmonicLaw) -> Result<Self, Invalid> {
        let exact = ExactMotion::new(pendulum, launch)?;
        let height = exact.turning_heights()[0];
        let length = pendulum.length;
        require(height < length, || Invalid::AboveSupport { height, length })?;
        let [a, b] = exact.turning_radii();
        let b = if exact.angular_momentum() < 0.0 { -b } else { b };
        let (frequency, precession) = match law {
            HarmonicLaw::Linear => (pendulum.angular_frequency(), 0.0),
            HarmonicLaw::Olsson => (olsson::frequency(a, b, &pendulum), olsson::precession(a, b, &pendulum)),
        };
        let [apsis_time, apsis_azimuth] = first_apsis(&exact);
        let powers = |first: f64| std::array::from_fn(|k| if k == 0 { first } else { 0.0 });
        Ok(Self { pendulum, frequency, precession, apsis_time, apsis_azimuth, inner: powers(b), outer: powers(a) })
    }

    /// The same turning points and phase under other rates in rad/s and another figure in m.
    pub fn with_figure(self, frequency: f64, precession: f64, inner: Powers, outer: Powers) -> Self {
        Self { frequency, precession, inner, outer, ..self }
    }

    /// The outer semi-axis and the inner one, in m, the latter positive counter-clockwise seen from above.
    pub fn semi_axes(&self) -> [f64; 2] {
        [self.outer.iter().sum(), self.inner[0]]
    }

    /// The times of an event from `start` to `end`, in s, at most `most` of them; none of a turning point on a circle.
    ///
    /// # Errors
    /// An interruption.
    pub fn events(&self, event: Event, between: [f64; 2], most: usize, stop: Stop<'_>) -> Result<Vec<f64>, Halt> {
        let states = |times: &[f64]| -> Result<Vec<StateVector>, Halt> {
            if stop() {
                return Err(Halt::Interrupted);
            }
            let [positions, velocities] = [Quantity::Position, Quantity::Velocity].map(|quantity| {
                let mut out = vec![0.0; 3 * times.len()];
                self.fill(quantity, Times::Scattered(times), &mut out);
                out
            });
            let triple = |numbers: &[f64], index: usize| std::array::from_fn(|k| numbers[3 * index + k]);
            let state =
                |index| StateVector { position: triple(&positions, index), velocity: triple(&velocities, index) };
            Ok((0..times.len()).map(state).collect())
        };
        if self.semi_axes()[0] == 0.0 {
            return Ok(Vec::new());
        }
        let step = PI / (24.0 * self.frequency);
        events_on_a_grid(event, between, [f64::NEG_INFINITY, f64::INFINITY], step, most, &self.pendulum, states)
    }

    /// Fills `out`, three numbers to a time.
    ///
    /// # Panics
    /// If scattered times and `out` do not have the same count.
    pub fn fill(&self, quantity: Quantity, times: Times<'_>, out: &mut [f64]) {
        if let Times::Scattered(times) = times {
            assert_eq!(3 * times.len(), out.len(), "three numbers to a time");
        }
        let per_second = |rate: f64| Dd::<Portable>::INV_PI * rate;
        let (swings, frame) = (per_second(self.frequency).pair(), per_second(self.precession).scale(0.5).pair());
        let table = match times {
            Times::Grid { step, .. } => Some(rotations(step, swings, frame)),
            Times::Scattered(_) => None,
        };
        let angles = SwingAndFrame {
            swing: half(swings),
            frame,
            start: [
                0.25 - 0.5 * swings.hi * self.apsis_time,
                self.apsis_azimuth / TAU - 0.25 - frame.hi * self.apsis_time,
            ],
        };
        let request = Request { motion: self, angles, table, quantity };
        in_tasks(times, out, |times, out| fill_part(&request, times, out));
    }

    fn degree(&self) -> usize {
        let is_used = |&n: &usize| self.inner[n] != 0.0 || self.outer[n] != 0.0;
        let degree = (0..=MAX_POWER).rev().find(is_used).unwrap_or(0);
        if FEW_FORMS && degree > 0 { MAX_POWER } else { degree }
    }

    fn figure<const DEGREE: usize>(&self) -> Figure<DEGREE> {
        // d/dζ cos ζ P(σ) = −sin ζ (P − 2(1 − σ)P'), d/dζ sin ζ Q(σ) = cos ζ (Q + 2σQ')
        let (mut inner_rate, mut outer_rate) = (Powers::default(), Powers::default());
        for n in 0..=MAX_POWER {
            let next = if n < MAX_POWER { 2.0 * (n + 1) as f64 * self.inner[n + 1] } else { 0.0 };
            inner_rate[n] = next - (2 * n + 1) as f64 * self.inner[n];
            outer_rate[n] = (2 * n + 1) as f64 * self.outer[n];
        }
        Figure {
            length: self.pendulum.length,
            swing: self.frequency,
            frame: self.precession,
            inner: self.inner,
            outer: self.outer,
            inner_rate,
            outer_rate,
        }
    }
}

/// What is the same for every time.
struct Request<'a> {
    motion: &'a HarmonicMotion,
    angles: SwingAndFrame,
    table: Option<Box<Rotations>>,
    quantity: Quantity,
}

dispatch! {
    fn fill_part(request: &Request<'_>, times: Times<'_>, out: &mut [f64]) = fill_part_with
}

#[inline(always)]
fn fill_part_with<A: Arithmetic>(_: A, request: &Request<'_>, times: Times<'_>, out: &mut [f64]) {
    let Request { motion, angles, table, quantity } = request;
    macro_rules! fill {
        ($($degree:literal)+) => {
            match motion.degree() {
                $($degree => blocks::<A>(&motion.figure::<$degree>(), angles, table.as_deref(), *quantity, times, out),)+
                degree => unreachable!("{degree} is beyond {MAX_POWER}"),
            }
        };
    }
    fill!(0 1 2 3 4 5 6);
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_launch_at_a_turning_point_is_its_own_first_one_however_it_is_rounded() {
        let pendulum = Pendulum { length: 1.0, gravity: 9.80665, mass: 1.0 };
        let start = |fill: &dyn Fn(&mut [f64])| {
            let mut place = [0.0; 3];
            fill(&mut place);
            place
        };
        let times = Times::Scattered(&[0.0]);
        for launched in 0..2000 {
            let radius = 0.4 + 0.005 * f64::from(launched % 21);
            let (sin, cos) = (0.01 * f64::from(launched)).sin_cos();
            for speed in [0.5, -0.5, 0.01] {
                let launch = Launch::Plane { x: radius * cos, y: radius * sin, vx: -speed * sin, vy: speed * cos };
                let exact = ExactMotion::new(pendulum, launch).unwrap();
                let exact = start(&|out| exact.fill(Quantity::Position, times, out));
                for law in [HarmonicLaw::Linear, HarmonicLaw::Olsson] {
                    let motion = HarmonicMotion::new(pendulum, launch, law).unwrap();
                    let place = start(&|out| motion.fill(Quantity::Position, times, out));
                    for (one, other) in place.iter().zip(exact) {
                        assert!((one - other).abs() < 1e-14, "{launch:?} {law:?}: {place:?} {exact:?}");
                    }
                }
            }
        }
    }
}
