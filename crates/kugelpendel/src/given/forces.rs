//! What acts on the bob of a real pendulum beside gravity and the thread: part by part as it is given, and in the numbers
//! that its equations of motion take.

use crate::given::bob::Bob;
use crate::given::drag::Drag;
use crate::given::drive::Drive;
use crate::given::invalid::{Invalid, finite};
use crate::given::pendulum::Pendulum;
use crate::given::site::{ROTATION, Site};
use crate::given::suspension::Suspension;

/// Per unit of mass; all zero for the ideal pendulum.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Forces {
    /// γ in −2γv, 1/s: amplitudes fade like e^{−γt}.
    pub damping: f64,
    /// c in −c|v|v, 1/m.
    pub quadratic: f64,
    /// Of the ground: its horizontal part, northwards (along y), and its upward part, rad/s.
    pub rotation: [f64; 2],
    /// δ, rad/s: by how much the frequency along `axis` is higher than across it.
    pub anisotropy: f64,
    /// Azimuth of the stiff axis, rad.
    pub axis: f64,
    /// Δγ, 1/s: by how much amplitudes fade faster along `damping_axis` than across it.
    pub damping_anisotropy: f64,
    /// The damping axis, rad.
    pub damping_axis: f64,
}

impl Forces {
    /// # Errors
    /// What is not finite.
    pub fn check(&self) -> Result<(), Invalid> {
        let [horizontal, vertical] = self.rotation;
        finite(&[
            ("drag.linear", self.damping, "1/s"),
            ("drag.quadratic", self.quadratic, "1/m"),
            ("site.horizontal_rotation", horizontal, "rad/s"),
            ("site.vertical_rotation", vertical, "rad/s"),
            ("suspension.anisotropy", self.anisotropy, "rad/s"),
            ("suspension.axis", self.axis, "rad"),
            ("suspension.damping_anisotropy", self.damping_anisotropy, "1/s"),
            ("suspension.damping_axis", self.damping_axis, "rad"),
        ])
    }
}

/// What a thread does when its tension is used up.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Thread {
    /// The motion ends there.
    #[default]
    Ends,
    /// The bob flies until the thread is taut again, which takes away the speed along it.
    Flies,
    /// It is a rod, and can push.
    Rod,
}

/// What acts, part by part; `None` for what is not there.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Acting {
    /// For the rotation of the ground.
    pub site: Option<Site>,
    /// The drag of the air.
    pub drag: Option<Drag>,
    /// The suspension, where it is not perfect.
    pub suspension: Option<Suspension>,
    /// The bob, where it is not a point.
    pub bob: Option<Bob>,
    /// A push in every half swing.
    pub drive: Drive,
}

impl Acting {
    /// The names of the numbers of [`Acting::of`], in their order.
    pub const NAMES: [&'static str; 17] = [
        "site.latitude",
        "site.gravity",
        "site.height",
        "site.rotation",
        "drag.linear",
        "drag.quadratic",
        "suspension.anisotropy",
        "suspension.axis",
        "suspension.damping_anisotropy",
        "suspension.damping_axis",
        "bob.radius",
        "bob.density",
        "bob.thread_mass",
        "bob.air_density",
        "drive.push",
        "drive.phase",
        "drive.radius",
    ];

    /// From the numbers of [`Acting::NAMES`], SI. A part is there if one of its numbers is; what is missing of it is 0,
    /// and the rotation that of the Earth.
    pub fn of(numbers: [Option<f64>; 17]) -> Self {
        let [
            latitude,
            gravity,
            height,
            rotation,
            linear,
            quadratic,
            anisotropy,
            axis,
            damping_anisotropy,
            damping_axis,
            radius,
            density,
            thread_mass,
            air_density,
            push,
            phase,
            distance,
        ] = numbers;
        let value = |number: Option<f64>| number.unwrap_or(0.0);
        let any = |numbers: &[Option<f64>]| numbers.iter().any(Option::is_some);
        let site =
            Site { latitude: value(latitude), gravity, height: value(height), rotation: rotation.unwrap_or(ROTATION) };
        let drag = Drag { linear: value(linear), quadratic: value(quadratic) };
        let suspension = Suspension {
            anisotropy: value(anisotropy),
            axis: value(axis),
            damping_anisotropy: value(damping_anisotropy),
            damping_axis: value(damping_axis),
        };
        let bob = Bob {
            radius: value(radius),
            density: value(density),
            thread_mass: value(thread_mass),
            air_density: value(air_density),
        };
        Self {
            site: any(&[latitude, gravity, height, rotation]).then_some(site),
            drag: any(&[linear, quadratic]).then_some(drag),
            suspension: any(&[anisotropy, axis, damping_anisotropy, damping_axis]).then_some(suspension),
            bob: any(&[radius, density, thread_mass, air_density]).then_some(bob),
            drive: match (push, phase, distance) {
                (Some(push), Some(phase), _) => Drive::Phase { push, phase },
                (Some(push), None, Some(radius)) => Drive::Radius { push, radius },
                _ => Drive::Absent,
            },
        }
    }

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
}
