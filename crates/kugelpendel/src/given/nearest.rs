//! What is nearest on the sphere to what a hand points at.

use crate::given::launch::Launch;
use crate::given::pendulum::Pendulum;

impl Pendulum {
    /// Where a ray from `eye` along `direction` first meets the sphere, m from the support; where it passes by, the place
    /// that is nearest to it. The lowest point where there is no ray.
    pub fn nearest_place(&self, eye: [f64; 3], direction: [f64; 3]) -> [f64; 3] {
        let square = dot(direction, direction);
        // Of the ray, the place that is nearest to the support.
        let ahead = (-dot(eye, direction) / square).max(0.0);
        let foot = along(eye, ahead, direction);
        let deep = self.length * self.length - dot(foot, foot);
        if deep <= 0.0 {
            return self.onto_sphere(foot);
        }
        let half_chord = (deep / square).sqrt();
        // From within the sphere the ray meets it once only.
        let first = if ahead >= half_chord { ahead - half_chord } else { ahead + half_chord };
        self.onto_sphere(along(eye, first, direction))
    }

    /// The launch from the place on the sphere that is nearest to this one, m, with the part of the velocity, m/s, that is
    /// not along the thread.
    pub fn nearest_launch(&self, position: [f64; 3], velocity: [f64; 3]) -> Launch {
        let position = self.onto_sphere(position);
        let radial = dot(position, velocity) / dot(position, position);
        Launch::State { position, velocity: along(velocity, -radial, position) }
    }

    /// 1 − cos θ of a position in m, with all its digits near the lowest point.
    pub fn height(&self, [x, y, z]: [f64; 3]) -> f64 {
        let [x, y, z] = [x, y, z].map(|value| value / self.length);
        if z > 0.0 { (x * x + y * y) / (1.0 + z) } else { 1.0 - z }
    }

    fn onto_sphere(&self, place: [f64; 3]) -> [f64; 3] {
        let scale = self.length / dot(place, place).sqrt();
        if scale.is_finite() { place.map(|value| value * scale) } else { [0.0, 0.0, self.length] }
    }
}

fn dot(one: [f64; 3], other: [f64; 3]) -> f64 {
    one[0] * other[0] + one[1] * other[1] + one[2] * other[2]
}

/// one + share·other.
fn along(one: [f64; 3], share: f64, other: [f64; 3]) -> [f64; 3] {
    std::array::from_fn(|k| one[k] + share * other[k])
}

#[cfg(test)]
mod tests {
    use super::*;

    const PENDULUM: Pendulum = Pendulum { length: 2.0, gravity: 9.8, mass: 1.0 };

    fn apart(one: [f64; 3], other: [f64; 3]) -> f64 {
        let gap = along(one, -1.0, other);
        dot(gap, gap).sqrt()
    }

    #[test]
    fn a_ray_meets_the_sphere_on_the_near_side() {
        let place = PENDULUM.nearest_place([10.0, 0.0, 0.0], [-3.0, 0.0, 0.0]);
        assert!(apart(place, [2.0, 0.0, 0.0]) < 1e-15, "{place:?}");
        let within = PENDULUM.nearest_place([0.5, 0.0, 0.0], [-1.0, 0.0, 0.0]);
        assert!(apart(within, [-2.0, 0.0, 0.0]) < 1e-15, "{within:?}");
        // Away from the sphere, the eye itself is nearest.
        let away = PENDULUM.nearest_place([10.0, 0.0, 0.0], [1.0, 0.0, 0.0]);
        assert!(apart(away, [2.0, 0.0, 0.0]) < 1e-15, "{away:?}");
    }

    #[test]
    fn a_ray_that_misses_gives_the_nearest_place_and_none_the_lowest() {
        let place = PENDULUM.nearest_place([10.0, 0.0, 5.0], [-1.0, 0.0, 0.0]);
        assert!(apart(place, [0.0, 0.0, 2.0]) < 1e-15, "{place:?}");
        // Across the outline nothing jumps.
        let [in_sight, past] = [1.999_999, 2.000_001].map(|z| PENDULUM.nearest_place([10.0, 0.0, z], [-1.0, 0.0, 0.0]));
        assert!(apart(in_sight, past) < 5e-3, "{in_sight:?} {past:?}");
        assert_eq!(PENDULUM.nearest_place([0.0; 3], [0.0; 3]), [0.0, 0.0, 2.0]);
    }

    #[test]
    fn the_nearest_launch_can_be_launched() {
        for (position, velocity) in [
            ([0.3, -0.2, 0.9], [1.0, 2.0, 3.0]),
            ([1e-9, 0.0, 5.0], [0.0, 1e-9, 7.0]),
            ([0.0; 3], [0.0, 1.0, 1.0]),
            ([-3.0, 4.0, -5.0], [0.0; 3]),
        ] {
            let launch = PENDULUM.nearest_launch(position, velocity);
            assert_eq!(launch.check(&PENDULUM), Ok(()), "{launch:?}");
        }
        let Launch::State { velocity, .. } = PENDULUM.nearest_launch([0.0, 0.0, 1.0], [0.5, 0.0, 3.0]) else {
            unreachable!("it is a state")
        };
        assert_eq!(velocity, [0.5, 0.0, 0.0]);
    }

    #[test]
    fn the_height_keeps_its_digits() {
        let small = PENDULUM.height([2e-9, 0.0, 2.0]);
        assert!((small / 5e-19 - 1.0).abs() < 1e-15, "{small}");
        assert_eq!(PENDULUM.height([0.0, 0.0, -2.0]), 2.0);
        assert_eq!(PENDULUM.height([2.0, 0.0, 0.0]), 1.0);
    }
}
