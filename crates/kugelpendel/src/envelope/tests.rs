//! Each average against its definition.

use super::drag::Quadratic;
use super::ideal::Ideal;
use super::tableau::{ALL, DENSE, ERROR, STAGE, STAGES};
use crate::{ExactMotion, Launch, Pendulum};
use std::f64::consts::TAU;

const UNIT: Pendulum = Pendulum { length: 1.0, gravity: 1.0, mass: 1.0 };

fn close(found: f64, expected: f64, relative: f64) {
    assert!((found - expected).abs() <= relative * expected.abs() + 1e-300, "{found} is not {expected}");
}

#[test]
fn rates_are_those_of_the_closed_form() {
    for a in [1e-6, 1e-3, 0.045, 0.3, 0.7, 0.95] {
        for share in [-1.0, -0.999, -0.5, -1e-6, 0.0, 1e-3, 0.3, 0.9, 1.0] {
            let b: f64 = a * share;
            let motion = ExactMotion::new(UNIT, Launch::Apsides { a, b, azimuth: 0.0 });
            let Ok(motion) = motion else { unreachable!("{a}, {b}") };
            let (p, q) = (0.5 * (a + b), 0.5 * (a - b));
            let ideal = Ideal::exact::<true>(p, q);
            close(ideal.frequency, motion.frequency(), 4e-15);
            // b, of which Ω has the relative error, is a difference here: an ulp of a.
            let error = (ideal.precession - motion.precession()).abs();
            assert!(error <= 1e-13 * motion.precession().abs() + 1e-15 * a * a, "{a}, {b}: {error}");
        }
    }
}

#[test]
fn brackets_are_their_beginning() {
    let (p, q) = (2e-3, 1.5e-3);
    let (exact, bracketed) = (Ideal::exact::<false>(p, q), Ideal::bracketed(p, q));
    close(bracketed.frequency, exact.frequency, 1e-10);
    close(bracketed.precession, exact.precession, 1e-5);
}

/// Energy and angular momentum of the radii p + q, p − q.
fn constants(p: f64, q: f64) -> [f64; 2] {
    let height = |r: f64| r * r / (1.0 + (1.0 - r * r).sqrt());
    let (high, low) = (height(p + q), height((p - q).abs()));
    let excess = high * low / (2.0 - high - low);
    [high + low + excess, (2.0 * high * low * (2.0 + excess)).sqrt()]
}

#[test]
fn linear_drag_takes_its_share_of_energy_and_angular_momentum() {
    for a in [1e-3, 0.1, 0.5, 0.9] {
        for share in [0.01_f64, 0.2, 0.7, 0.99] {
            let b = a * share;
            let (p, q) = (0.5 * (a + b), 0.5 * (a - b));
            let Ok(motion) = ExactMotion::new(UNIT, Launch::Apsides { a, b, azimuth: 0.0 }) else { unreachable!() };
            // ⟨v²⟩ over a swing, in which the trapezoidal rule converges geometrically.
            let (count, period) = (200, motion.radial_period());
            let mut mean_square = 0.0;
            for k in 0..count {
                let mut v = [0.0; 3];
                let time = [period * f64::from(k) / f64::from(count)];
                motion.fill(crate::Quantity::Velocity, crate::Times::Scattered(&time), &mut v);
                mean_square += v.iter().map(|v| v * v).sum::<f64>() / f64::from(count);
            }
            let [d, e] = Ideal::exact::<true>(p, q).decay;
            let h = 1e-5;
            let ([after, spin_after], [before, spin_before]) =
                (constants(p * (1.0 + h * d), q * (1.0 + h * e)), constants(p * (1.0 - h * d), q * (1.0 - h * e)));
            close((after - before) / (2.0 * h), -2.0 * mean_square, 1e-8);
            close((spin_after - spin_before) / (2.0 * h), -2.0 * constants(p, q)[1], 1e-8);
        }
    }
}

#[test]
fn linear_drag_is_regular_on_the_circle_and_in_the_plane() {
    for a in [1e-3, 0.3, 0.8] {
        let near = Ideal::exact::<true>(a, 1e-7 * a).decay;
        let on = Ideal::exact::<true>(a, 0.0).decay;
        let below = Ideal::exact::<true>(0.0, a).decay;
        for k in 0..2 {
            close(on[k], near[k], 1e-12);
            close(below[1 - k], on[k], 1e-15);
        }
        let [p, q] = Ideal::exact::<true>(0.5 * a, 0.5 * a).decay;
        close(p, q, 1e-14);
    }
}

#[test]
fn quadratic_drag_is_the_average_of_the_textbook() {
    for (a, b) in [(1.0, 0.3), (0.7, -0.65), (0.2, 0.2), (0.5, 0.499_999), (0.4, 0.01)] {
        let (p, q) = (0.5 * (a + b), 0.5 * (a - b));
        let [dp, dq] = Quadratic::of(p, q).decay;
        let count = 20_000;
        let (mut with_sin, mut with_cos) = (0.0, 0.0);
        for k in 0..count {
            let (s, c) = (TAU * (f64::from(k) + 0.5) / f64::from(count)).sin_cos();
            let speed = (a * s).hypot(b * c);
            with_sin += speed * s * s / f64::from(count);
            with_cos += speed * c * c / f64::from(count);
        }
        let (da, db) = (-a * with_sin, -b * with_cos);
        close(p * dp + q * dq, da, 1e-12);
        close(p * dp - q * dq, db, 1e-12);
    }
}

#[test]
fn quadratic_drag_in_the_plane() {
    // −(4/3π)cω0 a² and −(2/3π)cω0 ab, docs/conventions.md.
    for b in [0.0, 1e-9] {
        let (a, pi) = (0.3, std::f64::consts::PI);
        let (p, q) = (0.5 * (a + b), 0.5 * (a - b));
        let [dp, dq] = Quadratic::of(p, q).decay;
        close(p * dp + q * dq, -4.0 / (3.0 * pi) * a * a, 1e-12);
        assert!((p * dp - q * dq + 2.0 / (3.0 * pi) * a * b).abs() < 1e-13);
    }
}

#[test]
fn the_method_has_the_order_it_should() {
    // Sums of each row give the nodes; the weights integrate the powers of the nodes up to the seventh.
    let nodes: Vec<f64> = std::iter::once(0.0).chain(STAGE.iter().map(|row| row.iter().sum())).collect();
    assert_eq!(nodes.len(), ALL);
    for power in 0..8 {
        let sum: f64 = STAGE[STAGES - 1].iter().zip(&nodes).map(|(weight, node)| weight * node.powi(power)).sum();
        close(sum, 1.0 / f64::from(power + 1), 1e-13);
    }
    for weights in ERROR {
        assert!(weights.iter().sum::<f64>().abs() < 1e-14);
    }
    for weights in DENSE {
        assert!(weights.iter().sum::<f64>().abs() < 1e-12);
    }
}
