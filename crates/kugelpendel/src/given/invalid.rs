//! What is wrong with what was given: a kind and the values seen. A face makes the sentence of it.

use std::fmt;

/// A value that was seen.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Seen {
    /// What it is of, such as "drag.linear".
    pub name: &'static str,
    /// The number, in its unit.
    pub value: f64,
    /// SI, as in "m/s²"; "" for what has none.
    pub unit: &'static str,
}

/// What a kind keeps of a value: the number, where the kind says by itself what it is of, or all of it.
trait Kept {
    fn seen(self, name: &'static str, unit: &'static str) -> Seen;
}

impl Kept for f64 {
    fn seen(self, name: &'static str, unit: &'static str) -> Seen {
        Seen { name, value: self, unit }
    }
}

impl Kept for Seen {
    fn seen(self, _: &'static str, _: &'static str) -> Seen {
        self
    }
}

/// Writes each kind once: its number, its word, and the values that go with it.
macro_rules! kinds {
    ($($(#[$about:meta])* $number:literal $kind:ident $word:literal { $($field:ident: $kept:ty = $unit:literal),* })*) => {
        /// What is wrong with a pendulum, a launch, what acts on it, or a request. Numbers and words of the kinds stay
        /// what they are from one version to the next.
        #[derive(Clone, Copy, Debug, PartialEq)]
        #[non_exhaustive]
        pub enum Invalid {
            $($(#[$about])* $kind {
                $(#[doc = concat!("In ", $unit, ", or as its own unit says.")] $field: $kept),*
            },)*
        }

        impl Invalid {
            /// Number and word of every kind, in order of the numbers.
            pub const KINDS: &'static [(u8, &'static str)] = &[$(($number, $word)),*];

            /// The number of this kind, at least 1.
            pub fn number(&self) -> u8 {
                match self { $(Self::$kind { .. } => $number),* }
            }

            /// The word for this kind, such as "not_positive".
            pub fn word(&self) -> &'static str {
                match self { $(Self::$kind { .. } => $word),* }
            }

            /// The values that were seen.
            pub fn seen(&self) -> Vec<Seen> {
                match *self { $(Self::$kind { $($field),* } => vec![$($field.seen(stringify!($field), $unit)),*]),* }
            }
        }
    };
}

kinds! {
    /// It must be a finite number.
    1 NotFinite "not_finite" { value: Seen = "" }
    /// It must be positive and finite.
    2 NotPositive "not_positive" { value: Seen = "" }
    /// It must be finite and not negative.
    3 Negative "negative" { value: Seen = "" }
    /// It lies beyond what the numbers hold.
    4 BeyondNumbers "beyond_numbers" { value: Seen = "", least: f64 = "", most: f64 = "" }

    /// A number of the launch must be finite.
    10 LaunchNotFinite "launch_not_finite" { value: Seen = "" }
    /// An angle of the launch lies beyond ±2π: most likely it was meant in degrees.
    11 LaunchAngle "launch_angle" { value: Seen = "" }
    /// The displacement is negative.
    12 EllipseNegative "ellipse_negative" { a: f64 = "m" }
    /// The displacement does not fit on the lower half of the sphere.
    13 EllipseTooWide "ellipse_too_wide" { a: f64 = "m", length: f64 = "m" }
    /// The outer turning radius lies outside of 0 to the length.
    14 ApsidesTooWide "apsides_too_wide" { a: f64 = "m", length: f64 = "m" }
    /// The inner turning radius, without its sign, exceeds the outer one.
    15 ApsidesExchanged "apsides_exchanged" { b: f64 = "m", a: f64 = "m" }
    /// The launch point lies at the distance of the length from the axis, or farther.
    16 PlaneTooWide "plane_too_wide" { radius: f64 = "m", length: f64 = "m" }
    /// The launch point is not on the sphere.
    17 OffTheSphere "off_the_sphere" { radius: f64 = "m", length: f64 = "m" }
    /// The launch velocity has a component along the thread.
    18 Stretching "stretching" { radial: f64 = "m/s", speed: f64 = "m/s" }
    /// The launch's speed is beyond what the numbers hold.
    19 TooFast "too_fast" { speed: f64 = "m/s", most: f64 = "m/s" }
    /// The launch is too close to rest for the numbers.
    20 TooSmall "too_small" { size: f64 = "m", least: f64 = "m" }
    /// The motion lies on the separatrix and has no harmonics.
    25 Separatrix "separatrix" { energy: f64 = "J/kg" }

    /// The latitude lies beyond a pole, and would not if it were in degrees.
    30 Latitude "latitude" { latitude: f64 = "rad" }
    /// The height is beyond that of the formula for normal gravity.
    31 Height "height" { height: f64 = "m" }
    /// The gravity given for the site is not the pendulum's.
    32 TwoGravities "two_gravities" { site: f64 = "m/s²", pendulum: f64 = "m/s²" }
    /// The latitude lies beyond a pole, even in degrees.
    33 BeyondPole "beyond_pole" { latitude: f64 = "rad" }
    /// The bob is not heavier than the air.
    40 LighterThanAir "lighter_than_air" { density: f64 = "kg/m³", air_density: f64 = "kg/m³" }
    /// The bob reaches to the support.
    41 BobTooLarge "bob_too_large" { radius: f64 = "m", length: f64 = "m" }
    /// The phase of the push lies outside of 0 to π.
    50 DrivePhase "drive_phase" { phase: f64 = "rad" }
    /// The drive gives more than the drag takes, up to the support.
    51 Pumping "pumping" { push: f64 = "m/s", amplitude: f64 = "m", length: f64 = "m" }
    /// As before, and a smaller push would keep the amplitude.
    52 PumpingTooHard "pumping_too_hard" { push: f64 = "m/s", amplitude: f64 = "m", length: f64 = "m", keeps: f64 = "m/s" }

    /// A force changes a swing too much to be averaged.
    60 TooStrong "too_strong" { value: Seen = "", share: f64 = "", frequency: f64 = "rad/s", most: f64 = "" }
    /// The averaged motion does not rise to the support.
    61 RisesToSupport "rises_to_support" { height: f64 = "m", length: f64 = "m" }
    /// The approximation holds below the support, and the path rises above it.
    70 AboveSupport "above_support" { height: f64 = "m", length: f64 = "m" }
    /// The equation in the plan view holds on the lower half of the sphere, and the launch lies above it.
    71 StartsAbove "starts_above" { above: f64 = "m" }
}

impl fmt::Display for Invalid {
    /// For whoever reads Rust: the kind and the values, such as "bob_too_large: radius = 2 m, length = 1 m".
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.word())?;
        for (index, Seen { name, value, unit }) in self.seen().into_iter().enumerate() {
            let before = if index == 0 { ": " } else { ", " };
            let space = if unit.is_empty() { "" } else { " " };
            write!(f, "{before}{name} = {value}{space}{unit}")?;
        }
        Ok(())
    }
}

impl std::error::Error for Invalid {}

/// # Errors
/// The kind, unless the condition holds, as it does not for NaN.
#[inline]
pub(crate) fn require(holds: bool, otherwise: impl FnOnce() -> Invalid) -> Result<(), Invalid> {
    if holds { Ok(()) } else { Err(otherwise()) }
}

/// # Errors
/// The first of the values that is not finite.
pub(crate) fn finite(values: &[(&'static str, f64, &'static str)]) -> Result<(), Invalid> {
    all(values, f64::is_finite, |value| Invalid::NotFinite { value })
}

/// # Errors
/// The first of the values that is not positive and finite.
pub(crate) fn positive(values: &[(&'static str, f64, &'static str)]) -> Result<(), Invalid> {
    all(values, |value| value > 0.0 && value.is_finite(), |value| Invalid::NotPositive { value })
}

/// # Errors
/// The first of the values that is negative or not finite.
pub(crate) fn not_negative(values: &[(&'static str, f64, &'static str)]) -> Result<(), Invalid> {
    all(values, |value| value >= 0.0 && value.is_finite(), |value| Invalid::Negative { value })
}

/// # Errors
/// The first of the values that is not sound, told by `otherwise`.
pub(crate) fn all(
    values: &[(&'static str, f64, &'static str)],
    sound: impl Fn(f64) -> bool,
    otherwise: impl Fn(Seen) -> Invalid,
) -> Result<(), Invalid> {
    let bad = values.iter().find(|(_, value, _)| !sound(*value));
    bad.map_or(Ok(()), |&(name, value, unit)| Err(otherwise(Seen { name, value, unit })))
}
