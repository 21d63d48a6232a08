//! What acts, settled before anything moves: checked, with the pendulum that swings, and no drive that lifts the bob to its
//! support for want of drag.

use crate::exact::motion::ExactMotion;
use crate::given::decay::Decay;
use crate::given::drag::Drag;
use crate::given::drive::Drive;
use crate::given::forces::Acting;
use crate::given::invalid::Invalid;
use crate::given::launch::Launch;
use crate::given::pendulum::Pendulum;
use std::f64::consts::PI;

/// Amplitudes at which gain and loss are compared.
const LOOKS: usize = 400;

/// Refuses a drive that gives more than the drag takes at every amplitude up to the support.
///
/// Gain and loss are those of small straight swings: in each half swing the push p gives Δa = p cos φ/ω0, φ the phase after
/// the closest approach, and drag takes
/// (π/ω0)(γa + ka²), see [`Decay`]. A launch that rises to the support by itself passes.
///
/// # Errors
/// The pumping, with the push that keeps the amplitude of the launch where there is one.
fn refuse_pumping(pendulum: &Pendulum, launch: &Launch, drag: &Drag, drive: &Drive) -> Result<(), Invalid> {
    if *drive == Drive::Absent {
        return Ok(());
    }
    let exact = ExactMotion::new(*pendulum, *launch)?;
    if exact.turning_heights()[0] >= pendulum.length {
        return Ok(());
    }
    let (length, omega0, push) = (pendulum.length, pendulum.angular_frequency(), drive.push());
    let first = exact.turning_radii()[0];
    let decay = Decay::new(drag.linear, drag.quadratic, omega0);
    let loss = |a: f64| PI * decay.rate(a) * a;
    let step = (length - first) / (LOOKS - 1) as f64;
    let amplitude = |k: usize| if k == LOOKS - 1 { length } else { first + step * k as f64 };
    if (0..LOOKS).map(amplitude).any(|a| push * drive.leverage(a) <= loss(a)) {
        return Ok(());
    }
    if loss(first) > 0.0 {
        let keeps = loss(first) / drive.leverage(first);
        return Err(Invalid::PumpingTooHard { push, amplitude: first, length, keeps });
    }
    Err(Invalid::Pumping { push, amplitude: first, length })
}

impl Acting {
    /// The effective pendulum, once everything is checked and no drive pumps without end.
    ///
    /// # Errors
    /// A pendulum, launch or part that makes no sense, and a drive that pumps without end.
    pub fn settle(&self, pendulum: &Pendulum, launch: &Launch) -> Result<Pendulum, Invalid> {
        pendulum.check()?;
        launch.check(pendulum)?;
        self.check(pendulum)?;
        let effective = self.effective_pendulum(pendulum)?;
        refuse_pumping(&effective, launch, &self.drag.unwrap_or_default(), &self.drive)?;
        Ok(effective)
    }
}

impl Drive {
    /// Gain of amplitude in half a swing times ω0, for each unit of the push: the phase's cosine.
    fn leverage(&self, amplitude: f64) -> f64 {
        match *self {
            Self::Absent => 0.0,
            Self::Phase { phase, .. } => phase.cos(),
            Self::Radius { radius, .. } => {
                let share = if amplitude > 0.0 { radius / amplitude } else { 1.0 };
                (1.0 - share * share).clamp(0.0, f64::INFINITY).sqrt()
            }
        }
    }
}
