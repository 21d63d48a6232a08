//! The turning of a straight swing through all azimuths under damping that depends on the direction.
//!
//! ψ' = −Ω_z + (Δγ/2) sin 2(ψ−χd) where b = 0, whatever the amplitude; b = 0 stays. What uneven stiffness does is in
//! [`crate::plane::portrait`].

use std::f64::consts::PI;

/// Half a turn of the plane; rates in rad/s, counter-clockwise seen from above.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct HalfTurn {
    /// The slowest rate on the way; 0 where the plane comes to rest.
    pub slowest: f64,
    /// The fastest.
    pub fastest: f64,
    /// How long it takes, s; infinite where the plane comes to rest.
    pub duration: f64,
}

/// Of a ground that turns with Ω_z under a damping anisotropy Δγ in 1/s.
pub fn under_damping(rotation: f64, anisotropy: f64) -> HalfTurn {
    let (earth, half) = (rotation.abs(), 0.5 * anisotropy.abs());
    let way = if rotation > 0.0 { -1.0 } else { 1.0 };
    let fastest = way * (earth + half);
    if half >= earth {
        return HalfTurn { slowest: 0.0, fastest, duration: f64::INFINITY };
    }
    HalfTurn { slowest: way * (earth - half), fastest, duration: PI / ((earth - half) * (earth + half)).sqrt() }
}

/// The least |Δγ| in 1/s that brings the plane to rest: 2|Ω_z|.
pub fn critical_damping(rotation: f64) -> f64 {
    2.0 * rotation.abs()
}
