//! What acts on a pendulum, part by part as it is given, and the numbers that the equations of motion take of it.

use crate::given::bob::Bob;
use crate::given::drag::Drag;
use crate::given::forces::{Drive, Forces};
use crate::given::invalid::Invalid;
use crate::given::launch::Launch;
use crate::given::pendulum::Pendulum;
use crate::given::pumping::refuse_pumping;
use crate::given::site::Site;
use crate::given::suspension::Suspension;

/// The parts; `None` for what is not there.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Acting {
    /// For the rotation of the ground.
    pub site: Option<Site>,
    /// Of the air.
    pub drag: Option<Drag>,
    /// Where it is not perfect.
    pub suspension: Option<Suspension>,
    /// Where it is not a point.
    pub bob: Option<Bob>,
    /// A push in every half swing.
    pub drive: Drive,
}

impl Acting {
    /// # Errors
    /// A part that makes no sense by itself, or not with this pendulum; the first in the order of the fields.
    pub fn check(&self, pendulum: &Pendulum) -> Result<(), Invalid> {
        if let Some(site) = &self.site {
            site.check()?;
            site.agrees(pendulum)?;
        }
        self.drag.map_or(Ok(()), |drag| drag.check())?;
        self.suspension.map_or(Ok(()), |suspension| suspension.check())?;
        self.bob.map_or(Ok(()), |bob| bob.check().and_then(|()| bob.fits(pendulum.length)))?;
        self.drive.check()
    }

    /// The point mass that moves like this bob: its gravity takes in buoyancy and inertia, and its weight is that of the
    /// bob, so that the thread's pull is right but for buoyancy.
    ///
    /// # Errors
    /// A bob that does not fit the pendulum.
    pub fn effective_pendulum(&self, pendulum: &Pendulum) -> Result<Pendulum, Invalid> {
        let Some(bob) = self.bob else { return Ok(*pendulum) };
        let factor = bob.gravity_factor(pendulum.length)?;
        let Pendulum { length, gravity, mass } = *pendulum;
        Ok(Pendulum { length, gravity: gravity * factor, mass: mass / factor })
    }

    /// Per unit of mass, but for the drive.
    pub fn forces(&self) -> Forces {
        let drag = self.drag.unwrap_or_default();
        let suspension = self.suspension.unwrap_or_default();
        Forces {
            damping: drag.linear,
            quadratic: drag.quadratic,
            rotation: self.site.map_or([0.0; 2], |site| site.ground_rotation()),
            anisotropy: suspension.anisotropy,
            axis: suspension.axis,
            damping_anisotropy: suspension.damping_anisotropy,
            damping_axis: suspension.damping_axis,
        }
    }

    /// Whether anything acts that the ideal pendulum does without; a bob alone changes its gravity only.
    pub fn acts(&self) -> bool {
        self.forces() != Forces::default() || self.drive.push() != 0.0
    }

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
