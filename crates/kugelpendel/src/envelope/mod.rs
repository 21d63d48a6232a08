//! The averaged motion of a real pendulum: a turning ellipse whose size, form and plane change slowly.
//!
//! [`closed_form`] is one swing, [`swing`] finds it by its actions; [`equations`] say how these change, with the averages
//! in [`drag`] and [`push`]; [`limits`] say how far they hold; [`stepper`] integrates them with the coefficients in [`tableau`].

mod circles;
mod closed_form;
mod drag;
mod equations;
mod limits;
mod push;
mod start;
mod stepper;
mod swing;
mod tableau;
#[cfg(test)]
mod tests;

use crate::exact::motion::ExactMotion;
use crate::given::drive::Drive;
use crate::given::forces::{Acting, Forces};
use crate::given::invalid::{Invalid, Seen, require};
use crate::given::launch::Launch;
use crate::given::pendulum::Pendulum;
use crate::given::times::{Quantity, Times, both_ways};
use crate::taylor::step::Ending;
use crate::taylor::walk::{Halt, Stop};
use circles::Circles;
use equations::AveragedEquations;
pub(crate) use equations::CAUSES;
use num_complex::Complex64;
use start::mean;
use stepper::{AveragedStepper, Moment};
use swing::Swing;

/// Beyond this share of the length, swings are not averaged: turning radii no longer tell motions apart.
const LARGEST: f64 = 0.9999;

/// Rates of the forces beyond this share of ω0 are refused: the mean motion is off by a tenth of itself within 100
/// swings (benchmarks/envelope.py).
const MOST: f64 = 0.1;

/// Steps, or points, between two questions whether to go on: some milliseconds.
const PATIENCE: usize = 64;

/// Points of the ideal motion between two such questions.
const MANY: usize = 8192;

/// Steps in which an end of the motion is looked for.
const MOST_STEPS: usize = 5000;

/// From where, and under which forces.
#[derive(Clone, Debug)]
pub struct EnvelopeMotion {
    pendulum: Pendulum,
    given: (Launch, Forces, Drive),
    equations: AveragedEquations,
    start: Moment,
    omega0: f64,
    /// Where no force acts, the motion itself.
    ideal: Option<ExactMotion>,
}

/// What is asked of the averaged motion.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Envelope {
    /// x, y, z in m or their rates in m/s.
    Point(Quantity),
    /// a and b, m: turning radii, b with the sign of the sense.
    SemiAxes,
    /// ψ of the major axis, rad, continuous.
    Azimuth,
    /// a, b and ψ, as above.
    Ellipse,
    /// The same of the fundamental alone, which is what a fit of one frequency finds: its a is (3/64)(a² − b²)/l² more
    /// than the turning radius, and its b as much less, on small swings.
    Fundamental,
    /// Θ since the outer turning point that was nearest at the launch, rad, continuous.
    Phase,
    /// Of the plane, rad/s, by their causes: the Earth, the ideal motion, the suspension's stiffness, its damping, the
    /// drive; then of a and of b, m/s.
    Rates,
}

impl Envelope {
    /// How many numbers it takes for each time.
    pub fn width(self) -> usize {
        match self {
            Self::Point(_) | Self::Ellipse | Self::Fundamental => 3,
            Self::SemiAxes => 2,
            Self::Azimuth | Self::Phase => 1,
            Self::Rates => 7,
        }
    }
}

/// How far the motion has been integrated, forwards and backwards. A request that begins no earlier goes on from there,
/// with the same steps as from the launch.
#[derive(Clone, Debug, Default)]
pub struct EnvelopeWalks([Option<Box<AveragedStepper>>; 2]);

impl EnvelopeMotion {
    /// Under everything that acts; the pendulum is as given, without the bob's corrections. `exact` as in [`Self::new`].
    ///
    /// `intrinsic` multiplies the intrinsic precession Ω, 1 for an ideal pendulum: it is what a support that stiffens with
    /// amplitude, or a magnet below the bob, makes of κ in Ω = κ ω0 ab/l², where κ is 3/8 by itself.
    ///
    /// # Errors
    /// What [`Acting::settle`] and [`Self::new`] refuse.
    pub fn under(
        acting: &Acting,
        pendulum: Pendulum,
        launch: Launch,
        exact: bool,
        intrinsic: f64,
    ) -> Result<Self, Invalid> {
        let effective = acting.settle(&pendulum, &launch)?;
        Self::turning(effective, launch, acting.forces(), acting.drive, exact, intrinsic)
    }

    /// The averaged motion of this launch. With `exact`, everything is averaged over the closed form at any amplitude;
    /// otherwise over harmonic swings with Olsson's (25) and (26).
    ///
    /// # Errors
    /// A pendulum or launch that makes no sense, one that rises to the support's level, and forces that change a swing
    /// too much to be averaged.
    pub fn new(pendulum: Pendulum, launch: Launch, forces: Forces, drive: Drive, exact: bool) -> Result<Self, Invalid> {
        Self::turning(pendulum, launch, forces, drive, exact, 1.0)
    }

    fn turning(
        pendulum: Pendulum,
        launch: Launch,
        forces: Forces,
        drive: Drive,
        exact: bool,
        intrinsic: f64,
    ) -> Result<Self, Invalid> {
        let motion = ExactMotion::new(pendulum, launch)?;
        let omega0 = pendulum.angular_frequency();
        forces.check()?;
        drive.check()?;
        for (name, value, unit, most) in [
            ("suspension.anisotropy", forces.anisotropy, "rad/s", MOST),
            ("suspension.damping_anisotropy", forces.damping_anisotropy, "1/s", MOST),
            ("drag.linear", forces.damping, "1/s", 0.5),
        ] {
            let share = value.abs() / omega0;
            require(value.abs() <= most * omega0, || Invalid::TooStrong {
                value: Seen { name, value, unit },
                share,
                frequency: omega0,
                most,
            })?;
        }
        let mut equations = AveragedEquations::new(&forces, drive, pendulum.length, omega0, exact);
        equations.intrinsic = intrinsic;
        let [mut place, mut rate] = [[0.0; 3]; 2];
        motion.fill(Quantity::Position, Times::Scattered(&[0.0]), &mut place);
        motion.fill(Quantity::Velocity, Times::Scattered(&[0.0]), &mut rate);
        let [x, y, z] = place;
        let start = if z > 0.0 { mean(&pendulum, &equations, [x, y], [rate[0], rate[1]]) } else { None };
        let height = motion.turning_heights()[0];
        let start = start.ok_or(Invalid::RisesToSupport { height, length: pendulum.length })?;
        let ideal = (exact && equations.is_ideal()).then_some(motion);
        Ok(Self { pendulum, given: (launch, forces, drive), equations, start, omega0, ideal })
    }

    /// At an outer turning point of the mean motion itself: turning radii a and b in m, b with the sign of the sense, and the
    /// azimuth of the major axis in rad. A launch would be such an ellipse and what the forces add to its velocity.
    ///
    /// Averaged over the exact swing; `intrinsic` as in [`Self::under`].
    ///
    /// # Errors
    /// As [`Self::new`].
    pub fn at_apsis(
        pendulum: Pendulum,
        [a, b, azimuth]: [f64; 3],
        forces: Forces,
        drive: Drive,
        intrinsic: f64,
    ) -> Result<Self, Invalid> {
        let launch = Launch::Apsides { a, b, azimuth };
        let mut motion = Self::turning(pendulum, launch, forces, drive, true, intrinsic)?;
        let mut sizes = motion.equations.amplitudes([a / pendulum.length, b.abs() / pendulum.length]);
        if b < 0.0 {
            sizes.reverse();
        }
        motion.start = Moment::of(sizes, [azimuth; 2]);
        Ok(motion)
    }

    /// The point mass that moves like the bob, and what acts on it.
    pub(crate) fn given(&self) -> (&Pendulum, &Forces, &Drive) {
        (&self.pendulum, &self.given.1, &self.given.2)
    }

    /// Fills `out`, [`Envelope::width`] numbers to a time; beyond an end it is left as it was.
    ///
    /// # Errors
    /// The time in s at which the bob comes level with the support, or the wish of `stop`, which is asked every few
    /// milliseconds.
    ///
    /// # Panics
    /// If times and `out` do not have the same count.
    pub fn fill(
        &self,
        what: Envelope,
        times: &[f64],
        out: &mut [f64],
        walks: &mut EnvelopeWalks,
        stop: Stop<'_>,
    ) -> Result<(), Halt> {
        assert_eq!(what.width() * times.len(), out.len(), "so many numbers to a time");
        if let (Envelope::Point(quantity), Some(ideal)) = (what, &self.ideal) {
            for (times, out) in times.chunks(MANY).zip(out.chunks_mut(3 * MANY)) {
                ideal.fill(quantity, Times::Scattered(times), out);
                if stop() {
                    return Err(Halt::Interrupted);
                }
            }
            return Ok(());
        }
        both_ways(times, |side, order| self.sweep(side, order, what, times, out, walks, stop))
    }

    /// The times in s between which the motion holds, looked for up to `within` s and some thousand steps to both sides.
    ///
    /// # Errors
    /// Only the wish of `stop`.
    pub fn span(&self, within: f64, stop: Stop<'_>) -> Result<[f64; 2], Halt> {
        let mut span = [f64::NEG_INFINITY, f64::INFINITY];
        if self.equations.is_conservative() {
            return Ok(span);
        }
        for (direction, end) in [-1.0, 1.0].into_iter().zip(&mut span) {
            let mut walk = AveragedStepper::new(&self.equations, &self.start, direction);
            for step in 1..=MOST_STEPS {
                if walk.ended || walk.until().abs() >= within * self.omega0 {
                    break;
                }
                walk.advance(&self.equations);
                if step % PATIENCE == 0 && stop() {
                    return Err(Halt::Interrupted);
                }
            }
            if walk.ended {
                *end = walk.until() / self.omega0;
            }
        }
        Ok(span)
    }

    #[expect(clippy::too_many_arguments)]
    fn sweep(
        &self,
        side: usize,
        order: &mut dyn Iterator<Item = usize>,
        what: Envelope,
        times: &[f64],
        out: &mut [f64],
        walks: &mut EnvelopeWalks,
        stop: Stop<'_>,
    ) -> Result<(), Halt> {
        let width = what.width();
        if self.equations.is_free() {
            return self.sweep_free(order, what, times, out, stop);
        }
        let slot = &mut walks.0[side];
        let mut done = 0;
        let mut is_unwanted = || {
            done += 1;
            done % PATIENCE == 0 && stop()
        };
        for index in order {
            let time = times[index] * self.omega0;
            if slot.as_ref().is_some_and(|walk| walk.is_past(time)) {
                *slot = None;
            }
            let fresh = || Box::new(AveragedStepper::new(&self.equations, &self.start, [1.0, -1.0][side]));
            let walk = slot.get_or_insert_with(fresh);
            while !walk.reaches(time) {
                if walk.ended {
                    return Err(Halt::Ended(walk.until() / self.omega0, Ending::Level));
                }
                walk.advance(&self.equations);
                if is_unwanted() {
                    return Err(Halt::Interrupted);
                }
            }
            self.write(what, time, &walk.at(time), None, &mut out[width * index..width * (index + 1)]);
            if is_unwanted() {
                return Err(Halt::Interrupted);
            }
        }
        Ok(())
    }

    /// Without forces, or on a turning ground, nothing has to be integrated, and the swing stays what it is.
    fn sweep_free(
        &self,
        order: &mut dyn Iterator<Item = usize>,
        what: Envelope,
        times: &[f64],
        out: &mut [f64],
        stop: Stop<'_>,
    ) -> Result<(), Halt> {
        let width = what.width();
        let slope = self.equations.slope(&self.start.state);
        let swing = self.equations.swing(&Circles::of(&self.start.state));
        for (done, index) in order.enumerate() {
            let time = times[index] * self.omega0;
            let moment = self.start.after(time, &slope);
            self.write(what, time, &moment, swing.as_ref(), &mut out[width * index..width * (index + 1)]);
            if done % PATIENCE == PATIENCE - 1 && stop() {
                return Err(Halt::Interrupted);
            }
        }
        Ok(())
    }

    /// `known` is the swing of that moment, where it need not be looked for.
    fn write(&self, what: Envelope, time: f64, moment: &Moment, known: Option<&Swing>, out: &mut [f64]) {
        let Moment { state, angles: [ahead, behind] } = moment;
        let azimuth = 0.5 * (ahead + behind);
        let phase = time + state[4] + 0.5 * (ahead - behind);
        match what {
            Envelope::Azimuth => return out[0] = azimuth,
            Envelope::Phase => return out[0] = phase,
            _ => {}
        }
        let circles = Circles::of(state);
        let found = if known.is_none() { self.equations.swing(&circles) } else { None };
        let Some(swing) = known.or(found.as_ref()) else { return out.fill(f64::NAN) };
        let length = self.pendulum.length;
        match what {
            Envelope::Azimuth | Envelope::Phase => {}
            Envelope::SemiAxes => out.copy_from_slice(&swing.radii().map(|radius| length * radius)),
            Envelope::Ellipse => {
                let [a, b] = swing.radii().map(|radius| length * radius);
                out.copy_from_slice(&[a, b, azimuth]);
            }
            Envelope::Fundamental => {
                let [a, b] = swing.form.fundamental().map(|radius| length * radius);
                out.copy_from_slice(&[a, b, azimuth]);
            }
            Envelope::Rates => {
                for (out, share) in out.iter_mut().zip(self.equations.shares(&circles)) {
                    *out = share * self.omega0;
                }
                let rates = swing.radii_rates(self.equations.growth(&circles, swing));
                out[CAUSES..].copy_from_slice(&rates.map(|rate| rate * self.omega0 * length));
            }
            Envelope::Point(quantity) => {
                let point = self.point(quantity, [azimuth, phase], &circles, swing);
                out.copy_from_slice(&point);
            }
        }
    }

    /// On the ideal motion between the two turning radii, with the rates that the forces add.
    fn point(&self, quantity: Quantity, [azimuth, phase]: [f64; 2], circles: &Circles, swing: &Swing) -> [f64; 3] {
        let length = self.pendulum.length;
        let placed = self.equations.in_place(circles, swing);
        let turned = placed.map_or([0.0; 2], |placed| placed.turned_from(circles));
        let (azimuth, phase) = (azimuth + 0.5 * (turned[0] + turned[1]), phase + 0.5 * (turned[0] - turned[1]));
        let (direction, turn) = (Complex64::cis(azimuth), Complex64::cis(phase));
        let depth = |place: Complex64| (1.0 - place.norm_sqr()).sqrt();
        match quantity {
            Quantity::Position => {
                let moved = placed.and_then(|placed| swing.place_after(circles.sizes(), placed.sizes(), turn));
                let place = direction * moved.unwrap_or_else(|| swing.form.place(turn, |harmonic| harmonic.value));
                [length * place.re, length * place.im, length * depth(place)]
            }
            Quantity::Velocity => {
                let moved = placed.and_then(|placed| swing.moved(circles.actions(), placed.actions()));
                let (circles, swing) = (placed.as_ref().unwrap_or(circles), moved.as_ref().unwrap_or(swing));
                let form = swing.form.values();
                let place = direction * form.place(turn, |harmonic| harmonic);
                let rate = direction * (form.velocity(turn) + self.equations.drift(circles, swing, phase));
                let sinking = -(place.conj() * rate).re / depth(place);
                [rate.re, rate.im, sinking].map(|v| v * length * self.omega0)
            }
        }
    }
}
