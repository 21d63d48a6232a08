//! What is given, as the tables of a job file say it: numbers in SI in fixed slots, NaN for a key that is missing.

use crate::exchange::{answer, received};
use kugelpendel::{
    AIR_DENSITY, Acting, Bob, Decay, Drag, ExactMotion, Invalid, Launch, Pendulum, STANDARD_GRAVITY, StillAir,
    Suspension, push,
};
use std::f64::consts::TAU;

/// Where the air's density stands in [`Acting::NAMES`].
const AIR: usize = 13;

/// What a page gives, settled and checked.
pub(crate) struct Given {
    /// As it was given.
    pub(crate) pendulum: Pendulum,
    /// The point mass that moves like its bob.
    pub(crate) effective: Pendulum,
    pub(crate) launch: Launch,
    pub(crate) acting: Acting,
}

impl Given {
    /// Out of the exchange: length, gravity, mass; the kind of the launch and its six numbers; the numbers of
    /// [`Acting::NAMES`]; quality, half life, 1 for an estimate from the bob, and the thread's diameter for it; periods
    /// along and across the axis of the suspension.
    ///
    /// # Errors
    /// What [`Acting::settle`] and the makers of its parts refuse.
    pub(crate) fn receive() -> Result<Self, Invalid> {
        let slots = received();
        let [length, gravity, mass, kind, launch @ ..] = slots;
        let [a, b, c, d, e, f, rest @ ..] = launch;
        let launch = match kind as u32 {
            0 => Launch::Ellipse { a, b, azimuth: c },
            1 => Launch::Apsides { a, b, azimuth: c },
            2 => Launch::Plane { x: a, y: b, vx: c, vy: d },
            3 => Launch::Angles { theta: a, phi: b, theta_rate: c, phi_rate: d },
            _ => Launch::State { position: [a, b, c], velocity: [d, e, f] },
        };
        let said = |value: f64| (!value.is_nan()).then_some(value);
        let mut acting = Acting::of(std::array::from_fn(|k| said(rest[k])));
        let [quality, half_life, from_bob, thread_diameter, along, across] =
            std::array::from_fn(|k| said(rest[Acting::NAMES.len() + k]));
        if let Some(bob) = &mut acting.bob {
            bob.air_density = said(rest[AIR]).unwrap_or(AIR_DENSITY);
        }
        let place = acting.site.map(|site| site.check().map(|()| site.gravity.unwrap_or(site.normal_gravity())));
        let here = place.transpose()?.unwrap_or(STANDARD_GRAVITY);
        let weight = acting.bob.as_ref().map_or(1.0, Bob::mass);
        let pendulum = Pendulum { length, gravity: said(gravity).unwrap_or(here), mass: said(mass).unwrap_or(weight) };
        pendulum.check()?;
        let derived = match (quality, half_life, from_bob, &acting.bob) {
            (Some(quality), ..) => Some(Drag::from_quality(quality, pendulum.angular_frequency())?),
            (None, Some(half_life), ..) => Some(Drag::from_half_life(half_life)?),
            (None, None, Some(_), Some(bob)) => {
                let air = StillAir { thread_diameter: thread_diameter.unwrap_or(0.0), ..Default::default() };
                Some(Drag::from_bob(bob, &pendulum, &air)?)
            }
            _ => None,
        };
        if let Some(derived) = derived {
            let quadratic = derived.quadratic + acting.drag.unwrap_or_default().quadratic;
            acting.drag = Some(Drag { quadratic, ..derived });
        }
        if let (Some(along), Some(across)) = (along, across) {
            let anisotropy = Suspension::anisotropy_from_periods(along, across)?;
            acting.suspension = Some(Suspension { anisotropy, ..acting.suspension.unwrap_or_default() });
        }
        let effective = acting.settle(&pendulum, &launch)?;
        Ok(Self { pendulum, effective, launch, acting })
    }

    /// The ideal motion that starts like this one.
    ///
    /// # Errors
    /// What [`ExactMotion::new`] refuses.
    pub(crate) fn ideal(&self) -> Result<ExactMotion, Invalid> {
        ExactMotion::new(self.effective, self.launch)
    }
}

/// Tells what swings and what acts: length, gravity, that which moves the bob, mass, ω0, 2π/ω0, √(gl); the rate at which the
/// Earth alone turns the plane and the time for a turn; whether anything acts; γ, c, δ, Δγ; the time in which drag takes half
/// of this amplitude, and push and phase of the drive that would hold it and turn no narrow ellipse.
#[unsafe(no_mangle)]
pub extern "C" fn settled() -> u32 {
    answer(Given::receive().and_then(|given| {
        let [a, _] = given.ideal()?.turning_radii();
        let Given { pendulum, effective, acting, .. } = given;
        let forces = acting.forces();
        let omega0 = effective.angular_frequency();
        let earth = -forces.rotation[1];
        let decay = Decay::new(forces.damping, forces.quadratic, omega0);
        let phase = push::best_phase(&effective, &decay, a);
        Ok([
            pendulum.length,
            pendulum.gravity,
            effective.gravity,
            pendulum.mass,
            omega0,
            TAU / omega0,
            effective.length * omega0,
            earth,
            TAU / earth.abs(),
            f64::from(acting.acts()),
            forces.damping,
            forces.quadratic,
            forces.anisotropy,
            forces.damping_anisotropy,
            if a > 0.0 { decay.until(a, 0.5 * a) } else { f64::INFINITY },
            push::holding(&decay, a, phase),
            phase,
        ])
    }))
}
