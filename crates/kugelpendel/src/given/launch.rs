//! How the motion begins, in the words of whoever launches, and the state that follows from it.

use crate::given::invalid::{Invalid, require};
use crate::given::pendulum::Pendulum;
use crate::numbers::arithmetic::Arithmetic;
use crate::numbers::double_double::Dd;

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
    /// A number that is not finite, or a launch that does not lie on the sphere of this pendulum.
    pub fn check(&self, pendulum: &Pendulum) -> Result<(), Invalid> {
        let length = pendulum.length;
        for (name, value, unit) in self.named_values() {
            require!(value.is_finite(), "The launch's {name} must be a finite number, but it is {value} {unit}.");
        }
        match *self {
            Self::Ellipse { a, .. } => {
                require!(
                    a >= 0.0,
                    "The launch's displacement a must not be negative, but it is {a} m; turn the launch with azimuth \
                     instead."
                );
                require!(
                    a < length,
                    "The launch's displacement a = {a} m does not fit on the lower half of a sphere of radius \
                     {length} m; use Launch.angles or Launch.state for launches from the support's level and above."
                );
            }
            Self::Apsides { a, b, .. } => {
                require!(
                    (0.0..length).contains(&a),
                    "The outer turning radius a must lie between 0 and the length {length} m, but it is {a} m; use \
                     Launch.angles or Launch.state for motions that rise above the support."
                );
                require!(
                    b.abs() <= a,
                    "The inner turning radius |b| = {} m must not exceed the outer one, a = {a} m; exchange them and \
                     turn the launch by 90° with azimuth.",
                    b.abs()
                );
            }
            Self::Plane { x, y, .. } => {
                let radius = x.hypot(y);
                require!(
                    radius < length,
                    "The launch point is not on the lower half of the sphere: √(x² + y²) = {radius} m, length = \
                     {length} m; use Launch.state or Launch.angles from the support's level up."
                );
            }
            Self::Angles { .. } => {}
            Self::State { position, velocity } => {
                let radius = norm(position);
                require!(
                    (radius - length).abs() <= TOLERANCE * length,
                    "The launch point is not on the sphere: |r| = {radius} m, length = {length} m; use \
                     Launch.plane(x, y, vx, vy) to let z follow."
                );
                let speed = norm(velocity);
                let radial = position.iter().zip(velocity).map(|(r, v)| r * v).sum::<f64>() / radius;
                require!(
                    radial.abs() <= TOLERANCE * speed,
                    "The launch velocity would stretch the thread: its component along the thread is {radial} m/s of \
                     {speed} m/s; take that component away, or use Launch.plane(x, y, vx, vy) to let vz follow."
                );
            }
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
