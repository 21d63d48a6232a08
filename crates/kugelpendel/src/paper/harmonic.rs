//! A turning figure of a few harmonics: what the linear, the Olsson and the series motion are.
//!
//! x + iy = e^{i(Ωt + …)} (cos ζ·P(sin² ζ) + i sin ζ·Q(sin² ζ)), ζ = π/2 at the first highest point, and z on the lower
//! half of the sphere.

use crate::exact::sampling::in_tasks;
use crate::exact::theta::shape::product;
use crate::given::times::{Quantity, Times};
use crate::numbers::arithmetic::{Arithmetic, Portable, dispatch, horner};
use crate::numbers::double_double::Dd;
use crate::sampling::blocks::{Form, Hands, blocks};
use crate::sampling::rotations::{Rotations, half, rotations};
use std::f64::consts::TAU;

/// Powers of sin² ζ beyond the first: harmonics up to the thirteenth.
pub const MAX_POWER: usize = 6;

/// Coefficients of P or of Q.
pub type Powers = [f64; MAX_POWER + 1];

/// A figure and its two rates.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct HarmonicMotion {
    /// m.
    pub length: f64,
    /// ω, rad/s.
    pub frequency: f64,
    /// Ω, rad/s, positive counter-clockwise seen from above.
    pub precession: f64,
    /// s, a time at the outer turning point.
    pub apsis_time: f64,
    /// rad, of that point.
    pub apsis_azimuth: f64,
    /// P in m: its constant is the inner semi-axis, signed.
    pub inner: Powers,
    /// Q in m: its sum is the outer semi-axis.
    pub outer: Powers,
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
        let hands = Hands {
            swing: half(swings),
            frame,
            start: [
                0.25 - 0.5 * swings.hi * self.apsis_time,
                self.apsis_azimuth / TAU - 0.25 - frame.hi * self.apsis_time,
            ],
        };
        let request = Request { motion: self, hands, table, quantity };
        in_tasks(times, out, |times, out| fill_part(&request, times, out));
    }

    fn degree(&self) -> usize {
        let is_used = |&n: &usize| self.inner[n] != 0.0 || self.outer[n] != 0.0;
        (0..=MAX_POWER).rev().find(is_used).unwrap_or(0)
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
            length: self.length,
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
    hands: Hands,
    table: Option<Box<Rotations>>,
    quantity: Quantity,
}

dispatch! {
    fn fill_part(request: &Request<'_>, times: Times<'_>, out: &mut [f64]) = fill_part_with
}

#[inline(always)]
fn fill_part_with<A: Arithmetic>(_: A, request: &Request<'_>, times: Times<'_>, out: &mut [f64]) {
    let Request { motion, hands, table, quantity } = request;
    macro_rules! fill {
        ($($degree:literal)+) => {
            match motion.degree() {
                $($degree => blocks::<A>(&motion.figure::<$degree>(), hands, table.as_deref(), *quantity, times, out),)+
                degree => unreachable!("{degree} is beyond {MAX_POWER}"),
            }
        };
    }
    fill!(0 1 2 3 4 5 6);
}
