//! What is given and what follows from it: columns in, numbers or problems out.

use crate::columns::{Columns, Numbers, known_launcher};
use crate::signal::Signal;
use kugelpendel::{Acting, Bob, Drag, Invalid, Launch, Pendulum, Site, StillAir, Suspension, Wire, in_parallel};
use numpy::{IntoPyArray, PyArray1, PyReadonlyArray1};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use rayon::prelude::*;
use std::collections::HashMap;

/// A problem on its way to Python: the kind's word, and name, value and unit of what was seen.
pub(crate) type Told = (&'static str, Vec<(&'static str, f64, &'static str)>);

/// Indices of the bad cases, and the number of each one's kind.
pub(crate) type Problems<'py> = (Bound<'py, PyArray1<i64>>, Bound<'py, PyArray1<u8>>);

pub(crate) fn tell(invalid: &Invalid) -> Told {
    (invalid.word(), invalid.seen().iter().map(|seen| (seen.name, seen.value, seen.unit)).collect())
}

pub(crate) fn problems<'py, 'a>(py: Python<'py>, bad: impl Iterator<Item = (usize, &'a Invalid)>) -> Problems<'py> {
    let (indices, numbers): (Vec<_>, Vec<_>) = bad.map(|(index, invalid)| (index as i64, invalid.number())).unzip();
    (indices.into_pyarray(py), numbers.into_pyarray(py))
}

pub(crate) fn bad<M>(motions: &[Result<M, Invalid>]) -> impl Iterator<Item = (usize, &Invalid)> {
    motions.iter().enumerate().filter_map(|(index, motion)| Some((index, motion.as_ref().err()?)))
}

/// Makes a motion of each case, of which it also gets the index, on all processors and without the interpreter, unless a signal arrives.
pub(crate) fn each_case<M: Send>(
    py: Python<'_>,
    count: usize,
    pendulums: &[PyReadonlyArray1<'_, f64>],
    kind: &str,
    launches: &[PyReadonlyArray1<'_, f64>],
    acting: &Columned<'_>,
    make: impl Fn(Pendulum, Launch, Acting, usize) -> Result<M, Invalid> + Sync,
) -> PyResult<Vec<Result<M, Invalid>>> {
    let (width, launch) = known_launcher(kind)?;
    let pendulums = Columns::checked(pendulums, PENDULUM.len(), count)?;
    let launches = Columns::checked(launches, width, count)?;
    let acting = Named::checked(acting, count)?.acting()?;
    let one = |row: usize| make(pendulum(pendulums.row(row)), launch(&launches, row), acting(row), row);
    if count <= FEW {
        return Ok(py.detach(|| (0..count).map(one).collect()));
    }
    let signal = Signal::default();
    let one = |row: usize| (!signal.has_arrived()).then(|| one(row));
    let all = || (0..count).into_par_iter().with_min_len(FEW).map(one).while_some().collect();
    let motions = py.detach(|| signal.watch(|| in_parallel(all)));
    signal.raised()?;
    Ok(motions)
}

/// So many motions are made faster than a second thread wakes.
const FEW: usize = 64;

/// Number and word of every kind of problem.
#[pyfunction]
pub(crate) fn problem_kinds() -> Vec<(u8, &'static str)> {
    Invalid::KINDS.to_vec()
}

pub(crate) type Columned<'py> = HashMap<String, PyReadonlyArray1<'py, f64>>;

/// What is wrong with one set of numbers, named as in "drag.linear", if anything is.
#[pyfunction]
pub(crate) fn problem(given: HashMap<String, f64>) -> PyResult<Option<Told>> {
    let columns: HashMap<_, _> =
        given.iter().map(|(name, value)| (name.as_str(), std::slice::from_ref(value))).collect();
    let columns = Named::of(columns, 1);
    let verdict = if let Some(rows) = columns.part("wire", ["diameter", "young", "expansion"])? {
        let [diameter, young, expansion] = rows.row(0);
        Wire { diameter, young, expansion }.check()
    } else {
        // Without a pendulum there is nothing for the parts to disagree with.
        let acting = columns.acting()?(0);
        let site = acting.site.map_or(Ok(()), |site| site.check());
        let bob = acting.bob.map_or(Ok(()), |bob| bob.check());
        site.and(bob).and_then(|()| {
            Acting { site: None, bob: None, ..acting }.check(&Pendulum { length: 1.0, gravity: 1.0, mass: 1.0 })
        })
    };
    Ok(verdict.err().as_ref().map(tell))
}

/// What is wrong with one pendulum, if anything is.
#[pyfunction]
pub(crate) fn pendulum_problem(length: f64, gravity: f64, mass: f64) -> Option<Told> {
    Pendulum { length, gravity, mass }.check().err().as_ref().map(tell)
}

/// What is wrong with a launch whatever the pendulum, if anything is.
#[pyfunction]
pub(crate) fn launch_problem(kind: &str, values: Vec<f64>) -> PyResult<Option<Told>> {
    let (width, launch) = known_launcher(kind)?;
    let columns = Columns::of(values.iter().map(std::slice::from_ref).collect(), width, 1)?;
    Ok(launch(&columns, 0).check_numbers().err().as_ref().map(tell))
}

/// A number that follows from others, row after row, NaN where it does not; and what is wrong with the first row.
#[pyfunction]
pub(crate) fn derived<'py>(
    py: Python<'py>,
    what: &str,
    given: Columned<'py>,
    rows: usize,
) -> PyResult<(Numbers<'py>, Option<Told>)> {
    let columns = Named::checked(&given, rows)?;
    let mut first = None;
    let mut numbers = Vec::with_capacity(rows);
    for row in 0..rows {
        let value = derive(what, &columns, row)?;
        if row == 0 {
            first = value.as_ref().err().map(tell);
        }
        numbers.push(value.unwrap_or(f64::NAN));
    }
    Ok((numbers.into_pyarray(py), first))
}

fn derive(what: &str, columns: &Named<'_>, row: usize) -> PyResult<Result<f64, Invalid>> {
    let one = |name: &str| Ok::<_, PyErr>(columns.needed("", [name])?.row::<1>(row)[0]);
    let site = || {
        Ok::<_, PyErr>(Site {
            latitude: one("site.latitude")?,
            gravity: None,
            height: 0.0,
            rotation: one("site.rotation")?,
        })
    };
    let ball = || Ok::<_, PyErr>(bob(columns.needed("bob", BOB)?.row(row)));
    let estimate = || {
        let [viscosity, drag_coefficient, thread_diameter, thread_drag_coefficient] = columns
            .needed("drag", ["air_viscosity", "drag_coefficient", "thread_diameter", "thread_drag_coefficient"])?
            .row(row);
        let air = StillAir { viscosity, drag_coefficient, thread_diameter, thread_drag_coefficient };
        Ok::<_, PyErr>(Drag::from_bob(&ball()?, &pendulum(columns.needed("pendulum", PENDULUM)?.row(row)), &air))
    };
    Ok(match what {
        "normal_gravity" => {
            let site = Site { height: one("site.height")?, ..site()? };
            site.check().map(|()| site.normal_gravity())
        }
        "horizontal_rotation" => site().map(|site| site.check().map(|()| site.ground_rotation()[0]))?,
        "vertical_rotation" => site().map(|site| site.check().map(|()| site.ground_rotation()[1]))?,
        "linear_from_quality" => {
            Drag::from_quality(one("drag.quality")?, one("pendulum.angular_frequency")?).map(|drag| drag.linear)
        }
        "linear_from_half_life" => Drag::from_half_life(one("drag.half_life")?).map(|drag| drag.linear),
        "linear_from_bob" => estimate()?.map(|drag| drag.linear),
        "quadratic_from_bob" => estimate()?.map(|drag| drag.quadratic),
        "anisotropy_from_periods" => {
            Suspension::anisotropy_from_periods(one("suspension.period_along")?, one("suspension.period_across")?)
        }
        "bob_mass" => ball().map(|bob| bob.check().map(|()| bob.mass()))?,
        "gravity_factor" => ball()?.gravity_factor(one("pendulum.length")?),
        "cross_section" => {
            let wire = Wire { diameter: one("wire.diameter")?, young: 1.0, expansion: 0.0 };
            wire.check().map(|()| wire.cross_section())
        }
        _ => return Err(PyValueError::new_err(format!("nothing called {what:?} is derived"))),
    })
}

const PENDULUM: [&str; 3] = ["length", "gravity", "mass"];
const BOB: [&str; 4] = ["radius", "density", "thread_mass", "air_density"];

fn pendulum([length, gravity, mass]: [f64; 3]) -> Pendulum {
    Pendulum { length, gravity, mass }
}

fn bob([radius, density, thread_mass, air_density]: [f64; 4]) -> Bob {
    Bob { radius, density, thread_mass, air_density }
}

/// Columns by the names of what they hold, such as "drag.linear"; each has one number for all rows or one for each.
pub(crate) struct Named<'a> {
    columns: HashMap<&'a str, &'a [f64]>,
    rows: usize,
}

impl<'a> Named<'a> {
    fn of(columns: HashMap<&'a str, &'a [f64]>, rows: usize) -> Self {
        Self { columns, rows }
    }

    /// # Errors
    /// Columns that are not contiguous.
    pub(crate) fn checked(columns: &'a Columned<'_>, rows: usize) -> PyResult<Self> {
        let slices = columns.iter().map(|(name, column)| Ok((name.as_str(), column.as_slice()?)));
        Ok(Self { columns: slices.collect::<PyResult<_>>()?, rows })
    }

    /// The columns of one part, where it has any.
    ///
    /// # Errors
    /// A part that has some of its columns only, and columns of another length.
    fn part<const N: usize>(&self, part: &str, fields: [&str; N]) -> PyResult<Option<Columns<'a>>> {
        let name = |field: &str| if part.is_empty() { field.to_owned() } else { format!("{part}.{field}") };
        let found: Vec<_> = fields.iter().filter_map(|field| self.columns.get(&*name(field)).copied()).collect();
        if found.is_empty() {
            return Ok(None);
        }
        Columns::of(found, N, self.rows).map(Some)
    }

    fn needed<const N: usize>(&self, part: &str, fields: [&str; N]) -> PyResult<Columns<'a>> {
        let missing = || PyValueError::new_err(format!("columns {part:?} {fields:?} are needed"));
        self.part(part, fields)?.ok_or_else(missing)
    }

    /// What acts, row by row.
    ///
    /// # Errors
    /// Columns of another length, and names that nothing has.
    pub(crate) fn acting(&self) -> PyResult<impl Fn(usize) -> Acting + Sync + use<'a>> {
        for (name, column) in &self.columns {
            if !Acting::NAMES.contains(name) || (column.len() != 1 && column.len() != self.rows) {
                return Err(PyValueError::new_err(format!(
                    "{name:?} with {} rows is not among what acts",
                    column.len()
                )));
            }
        }
        let columns = Acting::NAMES.map(|name| self.columns.get(name).copied());
        let one = |column: &'a [f64], row: usize| if column.len() == 1 { column[0] } else { column[row] };
        Ok(move |row| Acting::of(columns.map(|column| column.map(|column| one(column, row)))))
    }
}
