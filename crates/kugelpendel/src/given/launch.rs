//! How the motion begins, in the words of whoever launches, and the state that follows from it.

use crate::given::invalid::{Invalid, Seen, require};
use crate::given::pendulum::Pendulum;
use crate::numbers::arithmetic::Arithmetic;
use crate::numbers::double_double::Dd;
use std::f64::consts::TAU;

/// The ways to say it; `z` points down from the support, azimuths count counter-clockwise from x seen from above.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Launch {
    /// Displaced by a towards the azimuth and pushed sideways with b·ω0: Olsson's (16).
    Ellipse {
        /// m, on the lower half.
        a: f64,
        /// m, positive counter-clockwise.
        b: f64,
        /// rad.
        azimuth: f64,
    },
    /// Turning radii on the lower half; starts at the outer one.
    Apsides {
        /// m, the outer one.
        a: f64,
        /// m, |b| ≤ a; its sign is the sense, positive counter-clockwise.
        b: f64,
        /// rad, of the launch.
        azimuth: f64,
    },
    /// Plan view; the height follows, on the lower half.
    Plane {
        /// m.
        x: f64,
        /// m.
        y: f64,
        /// m/s.
        vx: f64,
        /// m/s.
        vy: f64,
    },
    /// Spherical angles and their rates.
    Angles {
        /// rad, from the downward vertical.
        theta: f64,
        /// rad, azimuth.
        phi: f64,
        /// rad/s.
        theta_rate: f64,
        /// rad/s.
        phi_rate: f64,
    },
    /// Projected onto the sphere and its tangent plane where it is off by no more than [`TOLERANCE`].
    State {
        /// m, from the support.
        position: [f64; 3],
        /// m/s.
        velocity: [f64; 3],
    },
}

/// How far, relatively, a given state may lie off the sphere or its tangent plane and still be taken for rounding.
pub const TOLERANCE: f64 = 1e-9;

/// The largest speed in lω0: beyond it the fourth power overflows, which the constants of the motion take.
pub const FASTEST: f64 = 1e77;

/// The smallest motion in l: below it the fourth power has no digits left to tell its turning points apart.
pub const SMALLEST: f64 = 1e-75;

pub(crate) const STATE_NUMBERS: usize = 10;

/// The launch without dimensions: lengths in l, times in 1/ω0. What a motion is computed from.
#[derive(Clone, Copy, Debug)]
pub(crate) struct LaunchState<A> {
    /// Height above the lowest point, 1 − cos θ, and depth below the highest, 1 + cos θ: each with all its digits.
    pub height: Dd<A>,
    pub depth: Dd<A>,
    /// Rate of the height.
    pub climb: Dd<A>,
    /// v².
    pub speed_squared: Dd<A>,
    /// x·vy − y·vx.
    pub angular_momentum: Dd<A>,
    pub plan: [f64; 2],
    pub plan_velocity: [f64; 2],
}

impl Launch {
    /// # Errors
    /// A number that is not finite, an angle beyond ±2π, or a launch that does not lie on the sphere of this pendulum.
    pub fn check(&self, pendulum: &Pendulum) -> Result<(), Invalid> {
        self.check_numbers()?;
        let length = pendulum.length;
        self.check_place(length)?;
        let [size, speed] = self.extent(pendulum);
        let (unit, most) = (length * pendulum.angular_frequency(), FASTEST * length * pendulum.angular_frequency());
        require(speed <= most, || Invalid::TooFast { speed, most })?;
        let size = size.hypot(speed / unit);
        require(size == 0.0 || size >= SMALLEST, || Invalid::TooSmall { size: size * length, least: SMALLEST * length })
    }

    fn check_place(&self, length: f64) -> Result<(), Invalid> {
        match *self {
            Self::Ellipse { a, .. } => {
                require(a >= 0.0, || Invalid::EllipseNegative { a })?;
                require(a < length, || Invalid::EllipseTooWide { a, length })
            }
            Self::Apsides { a, b, .. } => {
                require((0.0..length).contains(&a), || Invalid::ApsidesTooWide { a, length })?;
                require(b.abs() <= a, || Invalid::ApsidesExchanged { b: b.abs(), a })
            }
            Self::Plane { x, y, .. } => {
                let radius = x.hypot(y);
                require(radius < length, || Invalid::PlaneTooWide { radius, length })
            }
            Self::Angles { .. } => Ok(()),
            Self::State { position, velocity } => {
                let radius = norm(position);
                let on_it = (radius - length).abs() <= TOLERANCE * length;
                require(on_it, || Invalid::OffTheSphere { radius, length })?;
                let speed = norm(velocity);
                let radial = position.iter().zip(velocity).map(|(r, v)| r * v).sum::<f64>() / radius;
                require(radial.abs() <= TOLERANCE * speed, || Invalid::Stretching { radial, speed })
            }
        }
    }

    /// How far from the lowest point, roughly and in lengths, and how fast, m/s.
    fn extent(&self, pendulum: &Pendulum) -> [f64; 2] {
        let (length, omega0) = (pendulum.length, pendulum.angular_frequency());
        match *self {
            Self::Ellipse { a, b, .. } => [a / length, b.abs() * omega0],
            Self::Apsides { a, b, .. } => [a / length, b.abs() * omega0],
            Self::Plane { x, y, vx, vy } => {
                let (x, y) = (x / length, y / length);
                let depth = ((1.0 - x.hypot(y)) * (1.0 + x.hypot(y))).sqrt();
                [x.hypot(y), vx.hypot(vy).hypot((x * vx + y * vy) / depth)]
            }
            Self::Angles { theta, theta_rate, phi_rate, .. } => {
                [theta.abs(), length * theta_rate.hypot(theta.sin() * phi_rate)]
            }
            Self::State { position: [x, y, z], velocity } => {
                [(x / length).hypot(y / length).hypot(if z < 0.0 { 1.0 } else { 0.0 }), norm(velocity)]
            }
        }
    }

    /// What can be said without a pendulum.
    ///
    /// # Errors
    /// A number that is not finite, or an angle beyond ±2π.
    pub fn check_numbers(&self) -> Result<(), Invalid> {
        for (name, value, unit) in self.named_values() {
            require(value.is_finite(), || Invalid::LaunchNotFinite { value: Seen { name, value, unit } })?;
            // Beyond a whole turn either way degrees are meant, most likely.
            let sound = unit != "rad" || value.abs() <= TAU;
            require(sound, || Invalid::LaunchAngle { value: Seen { name, value, unit } })?;
        }
        Ok(())
    }

    /// Padded with zeros to one size, so that checking a launch allocates nothing.
    fn named_values(&self) -> [(&'static str, f64, &'static str); 6] {
        const NONE: (&str, f64, &str) = ("", 0.0, "");
        match *self {
            Self::Ellipse { a, b, azimuth } | Self::Apsides { a, b, azimuth } => {
                [("a", a, "m"), ("b", b, "m"), ("azimuth", azimuth, "rad"), NONE, NONE, NONE]
            }
            Self::Plane { x, y, vx, vy } => {
                [("x", x, "m"), ("y", y, "m"), ("vx", vx, "m/s"), ("vy", vy, "m/s"), NONE, NONE]
            }
            Self::Angles { theta, phi, theta_rate, phi_rate } => [
                ("theta", theta, "rad"),
                ("phi", phi, "rad"),
                ("theta_rate", theta_rate, "rad/s"),
                ("phi_rate", phi_rate, "rad/s"),
                NONE,
                NONE,
            ],
            Self::State { position: [x, y, z], velocity: [vx, vy, vz] } => {
                [("x", x, "m"), ("y", y, "m"), ("z", z, "m"), ("vx", vx, "m/s"), ("vy", vy, "m/s"), ("vz", vz, "m/s")]
            }
        }
    }

    /// The dimensionless state; the launch has been checked.
    #[inline(always)]
    pub(crate) fn state<A: Arithmetic>(&self, pendulum: &Pendulum, omega0: Dd<A>) -> LaunchState<A> {
        let length = Dd::<A>::from(pendulum.length);
        match *self {
            Self::Ellipse { a, b, azimuth } => {
                let (a, b) = (Dd::from(a) / length, Dd::from(b) / length);
                LaunchState::sideways(height_at(a.square()), a, b, azimuth)
            }
            Self::Apsides { a, b, azimuth } => {
                let sense = b;
                let (a, b) = (Dd::from(a) / length, Dd::from(b.abs()) / length);
                let (outer, inner) = (height_at(a.square()), height_at(b.square()));
                // s_c = 2 + s_a s_b/(2 − s_a − s_b), λ² = 2 s_a s_b s_c: physics of the cubic's roots.
                let two = Dd::from(2.0);
                let third = two + outer * inner / (two - outer - inner);
                // λ/ρ_a = √(2 s_b s_c/(2 − s_a)); √(s_b) = b/√(2 − s_b) keeps a tiny b's digits.
                let speed = b * (third.scale(2.0) / ((two - inner) * (two - outer))).sqrt();
                LaunchState::sideways(outer, a, if sense < 0.0 { -speed } else { speed }, azimuth)
            }
            Self::Plane { x, y, vx, vy } => {
                let speed_unit = length * omega0;
                let height = height_at((Dd::product(x, x) + Dd::product(y, y)) / length.square());
                let outward = (Dd::product(x, vx) + Dd::product(y, vy)) / (length * speed_unit);
                let climb = outward / (Dd::ONE - height);
                let plan_speed_squared = Dd::product(vx, vx) + Dd::product(vy, vy);
                LaunchState {
                    height,
                    depth: Dd::from(2.0) - height,
                    climb,
                    speed_squared: plan_speed_squared / speed_unit.square() + climb.square(),
                    // From the exact products: what lies in a vertical plane has angular momentum 0, not 1e-33.
                    angular_momentum: (Dd::product(x, vy) - Dd::product(y, vx)) / (length * speed_unit),
                    plan: [x / pendulum.length, y / pendulum.length],
                    plan_velocity: [vx / speed_unit.hi, vy / speed_unit.hi],
                }
            }
            Self::Angles { theta, phi, theta_rate, phi_rate } => {
                let (half_sine, half_cosine) = Dd::<A>::sin_cos(0.5 * theta);
                let (height, depth) = (half_sine.square().scale(2.0), half_cosine.square().scale(2.0));
                let sine = (half_sine * half_cosine).scale(2.0);
                let (polar, azimuthal) = (Dd::from(theta_rate) / omega0, sine * (Dd::from(phi_rate) / omega0));
                let (sin_phi, cos_phi) = phi.sin_cos();
                let outward = (Dd::ONE - height).hi * polar.hi;
                LaunchState {
                    height,
                    depth,
                    climb: sine * polar,
                    speed_squared: polar.square() + azimuthal.square(),
                    angular_momentum: sine * azimuthal,
                    plan: [sine.hi * cos_phi, sine.hi * sin_phi],
                    plan_velocity: [
                        outward * cos_phi - azimuthal.hi * sin_phi,
                        outward * sin_phi + azimuthal.hi * cos_phi,
                    ],
                }
            }
            Self::State { position: [x, y, z], velocity: [vx, vy, vz] } => {
                let speed_unit = length * omega0;
                let radius_squared = Dd::product(x, x) + Dd::product(y, y) + Dd::product(z, z);
                let radius = radius_squared.sqrt();
                let cosine = Dd::from(z) / radius;
                let farther = Dd::ONE + cosine.abs();
                let nearer = (Dd::product(x, x) + Dd::product(y, y)) / radius_squared / farther;
                let (height, depth) = if z >= 0.0 { (nearer, farther) } else { (farther, nearer) };
                let speed_squared = Dd::product(vx, vx) + Dd::product(vy, vy) + Dd::product(vz, vz);
                let radial = (Dd::product(x, vx) + Dd::product(y, vy) + Dd::product(z, vz)) / radius;
                // The radial part, which is rounding, is taken away; from x·vy − y·vx it drops out by itself.
                let share = (radial / radius).hi;
                LaunchState {
                    height,
                    depth,
                    climb: (radial * cosine - Dd::from(vz)) / speed_unit,
                    speed_squared: (speed_squared - radial.square()) / speed_unit.square(),
                    angular_momentum: (Dd::product(x, vy) - Dd::product(y, vx)) / (radius * speed_unit),
                    plan: [x / radius.hi, y / radius.hi],
                    plan_velocity: [(vx - share * x) / speed_unit.hi, (vy - share * y) / speed_unit.hi],
                }
            }
        }
    }
}

impl<A: Arithmetic> LaunchState<A> {
    pub(crate) const REST: Self = Self {
        height: Dd::ZERO,
        depth: Dd::raw(2.0, 0.0),
        climb: Dd::ZERO,
        speed_squared: Dd::ZERO,
        angular_momentum: Dd::ZERO,
        plan: [0.0; 2],
        plan_velocity: [0.0; 2],
    };

    /// All but the plan view.
    #[inline(always)]
    pub(crate) fn numbers(&self) -> [f64; STATE_NUMBERS] {
        let Self { height: s, depth: d, climb: c, speed_squared: v, angular_momentum: l, .. } = self;
        [s.hi, s.lo, d.hi, d.lo, c.hi, c.lo, v.hi, v.lo, l.hi, l.lo]
    }

    #[inline(always)]
    pub(crate) fn from_numbers(numbers: [f64; STATE_NUMBERS]) -> Self {
        Self {
            height: Dd::raw(numbers[0], numbers[1]),
            depth: Dd::raw(numbers[2], numbers[3]),
            climb: Dd::raw(numbers[4], numbers[5]),
            speed_squared: Dd::raw(numbers[6], numbers[7]),
            angular_momentum: Dd::raw(numbers[8], numbers[9]),
            ..Self::REST
        }
    }

    /// At a turning point: horizontal radius, and speed at right angles to it.
    #[inline(always)]
    fn sideways(height: Dd<A>, radius: Dd<A>, speed: Dd<A>, azimuth: f64) -> Self {
        let (sin, cos) = azimuth.sin_cos();
        Self {
            height,
            depth: Dd::from(2.0) - height,
            climb: Dd::ZERO,
            speed_squared: speed.square(),
            angular_momentum: radius * speed,
            plan: [radius.hi * cos, radius.hi * sin],
            plan_velocity: [-speed.hi * sin, speed.hi * cos],
        }
    }
}

/// s = ρ²/(1 + √(1 − ρ²)), the height on the lower half without cancellation.
#[inline(always)]
fn height_at<A: Arithmetic>(radius_squared: Dd<A>) -> Dd<A> {
    radius_squared / (Dd::ONE + (Dd::ONE - radius_squared).sqrt())
}

fn norm(v: [f64; 3]) -> f64 {
    v[0].hypot(v[1]).hypot(v[2])
}
