//! Ensembles and threads: the same numbers, whoever computes them and beside whom.

use kugelpendel::{Ensemble, ExactMotion, Launch, Pendulum, Quantity, Times};

fn case(index: usize) -> (Pendulum, Launch) {
    let x = (index as f64 * 0.618_034).fract();
    let pendulum = Pendulum { length: 1.0 + x, gravity: 9.8, mass: 1.0 };
    let launch = match index % 5 {
        0 => Launch::Ellipse { a: 0.9 * x, b: 0.4 - x, azimuth: x },
        1 => Launch::Apsides { a: 0.5, b: 0.5 * x, azimuth: 0.0 },
        2 => Launch::Angles { theta: 3.0 * x, phi: 0.0, theta_rate: 1.0, phi_rate: 4.0 * x },
        3 => Launch::Plane { x: 0.1, y: 0.2, vx: x, vy: -x },
        _ => Launch::Apsides { a: 0.3, b: 0.4, azimuth: 0.0 }, // |b| > a: a bad one
    };
    (pendulum, launch)
}

#[test]
fn an_ensemble_is_its_motions() {
    let ensemble = Ensemble::new(1000, case);
    assert_eq!((ensemble.len(), ensemble.is_empty()), (1000, false));
    let frequencies = ensemble.map(|motion| [motion.frequency(), motion.precession()]);
    let times: Vec<f64> = (0..10).map(|k| f64::from(k) * 1.7).collect();
    let mut rows = vec![0.0; 1000 * 30];
    ensemble.fill(0..1000, Quantity::Position, Times::Scattered(&times), &mut rows);
    let mut some = vec![0.0; 90];
    ensemble.fill(500..503, Quantity::Position, Times::Scattered(&times), &mut some);
    assert_eq!(
        rows[30 * 500..30 * 503].iter().map(|x| x.to_bits()).collect::<Vec<_>>(),
        some.iter().map(|x| x.to_bits()).collect::<Vec<_>>()
    );
    for index in 0..1000 {
        let (pendulum, launch) = case(index);
        let row = &rows[30 * index..30 * (index + 1)];
        match ExactMotion::new(pendulum, launch) {
            Ok(motion) => {
                assert_eq!(frequencies[2 * index..2 * index + 2], [motion.frequency(), motion.precession()]);
                let mut alone = [0.0; 30];
                motion.fill(Quantity::Position, Times::Scattered(&times), &mut alone);
                assert_eq!(row, alone);
            }
            Err(reason) => {
                assert_eq!(index % 5, 4);
                assert_eq!(ensemble.motion(index).as_ref().err(), Some(&reason));
                assert!(row.iter().all(|number| number.is_nan()));
            }
        }
    }
    assert_eq!(ensemble.problems().count(), 200);
}

#[cfg(feature = "threads")]
#[test]
fn the_number_of_threads_changes_nothing() {
    let (pendulum, launch) = case(1);
    let motion = ExactMotion::new(pendulum, launch).expect("a good case");
    let grid = Times::Grid { start: 3.0, step: 1e-3, first: 0 };
    let run = |threads: usize| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().expect("a pool");
        pool.install(|| {
            let mut samples = vec![0.0; 3 * 100_001];
            motion.fill(Quantity::Velocity, grid, &mut samples);
            (samples, Ensemble::new(5000, case).map(|motion| [motion.precession()]))
        })
    };
    let (one, three) = (run(1), run(3));
    assert!(one.0 == three.0);
    assert!(one.1.iter().zip(&three.1).all(|(a, b)| a.to_bits() == b.to_bits()));
}

#[test]
fn a_grid_is_its_times() {
    // 2⁻⁷ s: every start + step·k is a binary number, so both ways mean the same times. Long blocks and short swings:
    // within a block the motion goes through many of them.
    for index in [0, 1, 2, 3] {
        let (pendulum, launch) = case(index);
        let motion = ExactMotion::new(pendulum, launch).expect("a good case");
        for step in [0.007_812_5, 0.5, -64.0] {
            let times: Vec<f64> = (0..2000).map(|k| 3.0 + step * f64::from(k)).collect();
            for quantity in [Quantity::Position, Quantity::Velocity] {
                let (mut grid, mut scattered) = (vec![0.0; 6000], vec![0.0; 6000]);
                motion.fill(quantity, Times::Grid { start: 3.0, step, first: 0 }, &mut grid);
                motion.fill(quantity, Times::Scattered(&times), &mut scattered);
                let size = 2.0 * pendulum.length * (1.0 + motion.energy().sqrt());
                for (a, b) in grid.iter().zip(&scattered) {
                    assert!((a - b).abs() <= 1e-15 * size, "{quantity:?}, case {index}, step {step}: {a} and {b}");
                }
            }
        }
    }
}
