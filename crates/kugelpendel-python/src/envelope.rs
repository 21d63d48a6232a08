//! Averaged motions: flat arrays in, flat arrays out.

use crate::columns::{Columns, Numbers, new_array};
use crate::given::{Problems, Told, bad, each_case, problems, tell};
use crate::signal::{Signal, lock};
use kugelpendel::{
    Drive, Envelope, EnvelopeMotion, EnvelopeWalks, Forces, Halt, Invalid, Pendulum, Quantity, Stop, Verdict,
    clamp_orbit, course, in_parallel, pace, settle,
};

use numpy::{IntoPyArray, PyReadonlyArray1};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use rayon::prelude::*;
use std::collections::HashMap;
use std::sync::Mutex;

/// Motions in a row, each with how far it has been integrated.
#[pyclass(frozen, module = "kugelpendel._core")]
pub(crate) struct EnvelopeMotions {
    motions: Vec<Result<EnvelopeMotion, Invalid>>,
    walks: Vec<Mutex<EnvelopeWalks>>,
}

#[pymethods]
impl EnvelopeMotions {
    /// Columns as for `RealMotions`.
    #[new]
    fn new(
        py: Python<'_>,
        count: usize,
        pendulum: Vec<PyReadonlyArray1<'_, f64>>,
        launch: (&str, Vec<PyReadonlyArray1<'_, f64>>),
        acting: HashMap<String, PyReadonlyArray1<'_, f64>>,
        exact: bool,
    ) -> PyResult<Self> {
        let motions = each_case(py, count, &pendulum, launch.0, &launch.1, &acting, |pendulum, launch, acting, _| {
            EnvelopeMotion::under(&acting, pendulum, launch, exact, 1.0)
        })?;
        let walks = (0..count).map(|_| Mutex::default()).collect();
        Ok(Self { motions, walks })
    }

    /// Index of each bad case and the number of its kind.
    fn problems<'py>(&self, py: Python<'py>) -> Problems<'py> {
        problems(py, bad(&self.motions))
    }

    /// What is wrong with one case.
    fn problem(&self, index: usize) -> Option<Told> {
        self.motions[index].as_ref().err().map(tell)
    }

    /// "position", "velocity", "semi_axes", "azimuth", "phase" or "rates", and when each motion has ended before one of
    /// the times, NaN where it has not.
    fn read<'py>(
        &self,
        py: Python<'py>,
        what: &str,
        times: PyReadonlyArray1<'py, f64>,
    ) -> PyResult<(Numbers<'py>, Numbers<'py>)> {
        let what = match what {
            "position" => Envelope::Point(Quantity::Position),
            "velocity" => Envelope::Point(Quantity::Velocity),
            "semi_axes" => Envelope::SemiAxes,
            "azimuth" => Envelope::Azimuth,
            "phase" => Envelope::Phase,
            "rates" => Envelope::Rates,
            _ => return Err(PyValueError::new_err(format!("an averaged motion has no {what:?}"))),
        };
        let times = times.as_slice()?;
        let signal = Signal::default();
        let mut ends = vec![f64::NAN; self.motions.len()];
        let size = what.width() * times.len();
        let row = |index: usize, row: &mut [f64], end: &mut f64, stop: Stop<'_>| {
            if stop() {
                return; // nobody sees the array, of which to touch the rest may take long
            }
            row.fill(f64::NAN);
            let Ok(motion) = &self.motions[index] else { return };
            let mut walks = lock(&self.walks[index]);
            if let Err(Halt::Ended(time, _)) = motion.fill(what, times, row, &mut walks, stop) {
                *end = time;
            }
        };
        let array = new_array(py, size * self.motions.len(), |out| {
            if size == 0 {
                return;
            }
            if let [end] = &mut ends[..] {
                return row(0, out, end, &|| signal.ends_work());
            }
            let rows = out.par_chunks_mut(size).zip(&mut ends).enumerate();
            let stop = || signal.has_arrived();
            signal.watch(|| in_parallel(|| rows.for_each(|(index, (out, end))| row(index, out, end, &stop))));
        });
        signal.raised()?;
        Ok((array, ends.into_pyarray(py)))
    }

    /// What each plane comes to, nine numbers to a motion: 0 where it goes round, 1 to and fro, 2 where it stands; from when
    /// and until when it was looked at; by how much it turned; two azimuths; the largest |b|, the amplitude at the end,
    /// whether the swing dies away. NaN where it cannot be told.
    fn settled<'py>(&self, py: Python<'py>) -> PyResult<Numbers<'py>> {
        self.each(py, |motion, stop| {
            let s = settle(motion, stop)?;
            let ([low, high], dies) = (s.azimuths, f64::from(s.dies));
            Some([number(s.verdict), s.from, s.until, s.turned, low, high, s.widest, s.amplitude, dies])
        })
    }

    /// The orbit of each launch on the portrait of its clamp, without drag and drive: the verdict as in `settled`, and the
    /// mean rate of the plane, rad/s.
    fn orbits<'py>(&self, py: Python<'py>) -> PyResult<Numbers<'py>> {
        self.each(py, |motion, stop| {
            let orbit = clamp_orbit(motion, stop).ok()?;
            Some([number(orbit.verdict), orbit.rate])
        })
    }

    /// Up to a time in s: the largest |b|, when the plane has turned by a quarter, and since when it stands, both infinite
    /// where it does not. NaN where the motion has ended before.
    fn course<'py>(&self, py: Python<'py>, until: f64) -> PyResult<Numbers<'py>> {
        self.each(py, |motion, stop| {
            let found = course(motion, until, stop).ok()?;
            Some([found.widest, found.quarter_turn, found.stands_since])
        })
    }

    /// The least and the largest rate of each plane between two times in s, in the sense in which the Earth turns it.
    fn pace<'py>(&self, py: Python<'py>, between: [f64; 2]) -> PyResult<Numbers<'py>> {
        self.each(py, |motion, stop| pace(motion, between, stop).ok())
    }

    /// The five strengths of the forces, each the largest of all motions, NaN not counted.
    fn strengths(&self) -> [f64; 5] {
        let all = self.motions.iter().flatten().map(EnvelopeMotion::strengths);
        all.fold([0.0; 5], |most, these| std::array::from_fn(|k| f64::max(most[k], these[k])))
    }

    /// The bound in rad of the azimuth's error within a time in s, the largest of all motions, NaN not counted.
    fn azimuth_error(&self, within: f64) -> f64 {
        self.motions.iter().flatten().map(|motion| motion.azimuth_error(within)).fold(0.0, f64::max)
    }

    /// The first motion's largest distance from the full equations within so many swings, as a share of a.
    fn measured_error(&self, py: Python<'_>, swings: u32) -> PyResult<f64> {
        let signal = Signal::default();
        let measure = |motion: &EnvelopeMotion| motion.measured_error(swings, &|| signal.ends_work());
        let error = py.detach(|| self.motions.iter().flatten().next().map(measure));
        signal.raised()?;
        Ok(error.and_then(Result::ok).unwrap_or(f64::NAN))
    }

    /// The times in s between which each motion holds, two to a motion, looked for within a time; NaN for the bad ones.
    fn span<'py>(&self, py: Python<'py>, within: f64) -> PyResult<Numbers<'py>> {
        let signal = Signal::default();
        let span = |motion: &Result<EnvelopeMotion, Invalid>, stop: Stop<'_>| {
            let span = motion.as_ref().ok().filter(|_| !stop()).and_then(|motion| motion.span(within, stop).ok());
            span.unwrap_or([f64::NAN; 2])
        };
        let spans: Vec<_> = py.detach(|| match &self.motions[..] {
            [motion] => span(motion, &|| signal.ends_work()).to_vec(),
            motions => signal.watch(|| {
                in_parallel(|| motions.par_iter().flat_map_iter(|one| span(one, &|| signal.has_arrived())).collect())
            }),
        });
        signal.raised()?;
        Ok(spans.into_pyarray(py))
    }
}

impl EnvelopeMotions {
    /// N numbers of each motion, on all processors; NaN for the bad ones and where there are none.
    fn each<'py, const N: usize>(
        &self,
        py: Python<'py>,
        numbers: impl Fn(&EnvelopeMotion, Stop<'_>) -> Option<[f64; N]> + Sync,
    ) -> PyResult<Numbers<'py>> {
        let signal = Signal::default();
        let row = |motion: &Result<EnvelopeMotion, Invalid>, out: &mut [f64], stop: Stop<'_>| {
            let motion = motion.as_ref().ok().filter(|_| !stop());
            out.copy_from_slice(&motion.and_then(|motion| numbers(motion, stop)).unwrap_or([f64::NAN; N]));
        };
        let array = new_array(py, N * self.motions.len(), |out| {
            if let [motion] = &self.motions[..] {
                return row(motion, out, &|| signal.ends_work());
            }
            let rows = self.motions.par_iter().zip(out.par_chunks_mut(N));
            let stop = || signal.has_arrived();
            signal.watch(|| in_parallel(|| rows.for_each(|(motion, out)| row(motion, out, &stop))));
        });
        signal.raised()?;
        Ok(array)
    }
}

/// The number of a verdict, as `settled` has it.
fn number(verdict: Verdict) -> f64 {
    match verdict {
        Verdict::Round => 0.0,
        Verdict::ToAndFro => 1.0,
        Verdict::Stands => 2.0,
    }
}

/// The fundamental's semi-axes a and b in m and azimuths in rad of averaged motions, three numbers to a time in s, NaN
/// where a motion has ended. Each begins at t = 0 as an ellipse: a column each of length, gravity; a, b, azimuth; γ, c,
/// Ω_z; δ, χ; Δγ, χd; and of what multiplies the intrinsic precession. Signs and sizes are free, as a search among them
/// needs it: drag may bring energy in, and the ground turn faster than the Earth.
#[pyfunction]
pub(crate) fn averaged_fundamentals<'py>(
    py: Python<'py>,
    count: usize,
    columns: Vec<PyReadonlyArray1<'py, f64>>,
    times: PyReadonlyArray1<'py, f64>,
) -> PyResult<Numbers<'py>> {
    let columns = Columns::checked(&columns, 13, count)?;
    let times = times.as_slice()?;
    let signal = Signal::default();
    let fill = |row: usize, out: &mut [f64]| {
        out.fill(f64::NAN);
        let [length, gravity, a, b, azimuth, damping, quadratic, turn, uneven @ .., factor] = columns.row::<13>(row);
        let [anisotropy, axis, damping_anisotropy, damping_axis] = uneven;
        let rotation = [0.0, turn];
        let forces = Forces { damping, quadratic, rotation, anisotropy, axis, damping_anisotropy, damping_axis };
        let pendulum = Pendulum { length, gravity, mass: 1.0 };
        let start = [a, b, azimuth];
        let stop = || signal.has_arrived();
        let Ok(motion) = EnvelopeMotion::at_apsis(pendulum, start, forces, Drive::Absent, factor) else { return };
        // What is beyond an end stays NaN.
        let _ = motion.fill(Envelope::Fundamental, times, out, &mut EnvelopeWalks::default(), &stop);
    };
    let size = 3 * times.len();
    let array = new_array(py, size * count, |out| {
        if size > 0 {
            let rows = out.par_chunks_mut(size).enumerate();
            signal.watch(|| {
                in_parallel(|| {
                    rows.for_each(|(row, out)| {
                        if !signal.has_arrived() {
                            fill(row, out)
                        }
                    })
                })
            });
        }
    });
    signal.raised()?;
    Ok(array)
}
