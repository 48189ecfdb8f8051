//! Forms that are compared with columns of coordinates.

use numpy::ndarray::ArrayView1;
use numpy::{IntoPyArray, PyArray1, PyReadonlyArray1};
use pyo3::prelude::*;
use rayon::prelude::*;

use super::exceptions::{InputError, exception};
use super::options::{Options, reading};
use super::run::given;
use super::watch::{Wait, Watch, guarded, pool, with_options};
use crate::error::{Error, Result};
use crate::inspect::{Foot, Inspection, Verdict};
use crate::intervals::rationals;
use crate::limits::Limits;
use crate::verb::{self, InspectionTask, Watcher, Work};

/// The number of points between two reports of progress.
const CHUNK: usize = 1 << 15;
/// The number of points that one thread takes at a time, at least.
const SHARE: usize = 64;
/// This many points are answered at once: to hand them to another thread would take longer.
const FEW: usize = 4;

/// The codes of verdicts: their places in the list of names in the package.
fn code(verdict: Verdict) -> i8 {
    match verdict {
        Verdict::Inside => 0,
        Verdict::Outside => 1,
        Verdict::Undecided => 2,
        Verdict::Uncertain => 3,
    }
}

/// What stands for an answer that there is not, in columns of −1, 0 and 1.
const NONE: i8 = 2;

/// A form and a tolerance, ready to be compared with any number of points.
#[pyclass(frozen, module = "stellate._native")]
#[derive(Debug)]
pub(super) struct Inspector {
    task: InspectionTask,
    limits: Limits,
    threads: Option<usize>,
    notes: Vec<String>,
}

/// The coordinates of points, one column for each axis.
struct Columns<'a> {
    axes: Vec<ArrayView1<'a, f64>>,
}

impl Columns<'_> {
    fn len(&self) -> usize {
        self.axes[0].len()
    }

    /// A point; in the plane z is 0.
    fn point(&self, k: usize) -> Result<[f64; 3]> {
        let mut point = [0.0; 3];
        for (coordinate, axis) in point.iter_mut().zip(&self.axes) {
            *coordinate = axis[k];
        }
        match point.iter().all(|x| x.is_finite()) {
            true => Ok(point),
            false => Err(Error::Data {
                place: format!("points, row {k}"),
                message: "coordinates are finite numbers; rows are counted from 0".into(),
            }),
        }
    }
}

/// The columns of inspections.
#[derive(Default)]
struct Found {
    verdict: Vec<i8>,
    curve: Vec<i8>,
    low: Vec<f64>,
    high: Vec<f64>,
    sign: Vec<i8>,
}

impl Found {
    fn add(&mut self, found: &Inspection) {
        self.verdict.push(code(found.verdict));
        self.curve.push(found.curve.map_or(NONE, i8::from));
        self.low.push(found.distance.low);
        self.high.push(found.distance.high);
        self.sign.push(found.sign.unwrap_or(NONE));
    }
}

impl Found {
    fn into_arrays(self, python: Python<'_>) -> Answer<'_> {
        (
            self.verdict.into_pyarray(python),
            self.curve.into_pyarray(python),
            self.low.into_pyarray(python),
            self.high.into_pyarray(python),
            self.sign.into_pyarray(python),
        )
    }
}

type Answer<'py> = (
    Bound<'py, PyArray1<i8>>,
    Bound<'py, PyArray1<i8>>,
    Bound<'py, PyArray1<f64>>,
    Bound<'py, PyArray1<f64>>,
    Bound<'py, PyArray1<i8>>,
);

/// The columns of feet: the coordinates of the points and the normals, one after the other, and the bounds of the signed distances.
/// What there is not is NaN.
#[derive(Default)]
struct FoundFeet {
    point: Vec<f64>,
    normal: Vec<f64>,
    low: Vec<f64>,
    high: Vec<f64>,
}

impl FoundFeet {
    fn add(&mut self, inspection: &Inspection, foot: Option<Foot>, dimension: usize) {
        let none = [f64::NAN; 3];
        let point = foot.map_or(none, |foot| foot.point);
        let normal = foot.and_then(|foot| foot.normal).unwrap_or(none);
        self.point.extend(&point[..dimension]);
        self.normal.extend(&normal[..dimension]);
        let [low, high] = inspection.signed_distance().unwrap_or([f64::NAN; 2]);
        self.low.push(low);
        self.high.push(high);
    }
}

type Feet<'py> = (
    Bound<'py, PyArray1<f64>>,
    Bound<'py, PyArray1<f64>>,
    Bound<'py, PyArray1<f64>>,
    Bound<'py, PyArray1<f64>>,
);

#[pymethods]
impl Inspector {
    /// The inspector of a form, given as for `call`, for points with two or three coordinates.
    #[new]
    fn new(
        python: Python<'_>,
        form: (String, Option<String>, String),
        options: &str,
        dimension: usize,
        progress: Option<&Bound<'_, PyAny>>,
    ) -> PyResult<Self> {
        let made = move |options: Options, work: Work| {
            let given = given(&form, &reading(&form.2)?, &work)?;
            let task = verb::inspect(given, dimension, &options.inspection()?, &work)?;
            Ok((task, work.bounds().clone(), options.threads))
        };
        let ((task, limits, threads), notes) = with_options(python, progress, options, made)?;
        Ok(Self {
            task,
            limits,
            threads,
            notes,
        })
    }

    /// The remarks about the form.
    #[getter]
    fn notes(&self) -> Vec<String> {
        self.notes.clone()
    }

    /// Whether this can be asked no more, because its work was interrupted.
    #[getter]
    fn is_over(&self) -> bool {
        self.limits.check().is_err()
    }

    /// The verdicts (0 inside, 1 outside, 2 undecided, 3 uncertain), the criterion of Theorem 8 (1 true, 0 false, 2 undecided), the bounds of the
    /// distances, and the signs (2 for none) of points with these columns of coordinates.
    fn inspect<'py>(
        &self,
        python: Python<'py>,
        columns: Vec<PyReadonlyArray1<'py, f64>>,
        progress: Option<&Bound<'py, PyAny>>,
    ) -> PyResult<Answer<'py>> {
        let columns = self.columns(&columns)?;
        let mut found = Found::default();
        self.each(
            python,
            progress,
            &columns,
            |point| self.task.of_doubles(point),
            |inspection| found.add(&inspection),
        )?;
        Ok(found.into_arrays(python))
    }

    /// The same, and the feet, the normals and the bounds of the signed distances; NaN stands for what there is not.
    fn inspect_with_feet<'py>(
        &self,
        python: Python<'py>,
        columns: Vec<PyReadonlyArray1<'py, f64>>,
        progress: Option<&Bound<'py, PyAny>>,
    ) -> PyResult<(Answer<'py>, Feet<'py>)> {
        let columns = self.columns(&columns)?;
        let dimension = self.task.dimension();
        let mut found = Found::default();
        let mut feet = FoundFeet::default();
        self.each(
            python,
            progress,
            &columns,
            |point| {
                let inspection = self.task.of_doubles(point);
                let foot = self.task.foot(&rationals(point), &inspection);
                (inspection, foot)
            },
            |(inspection, foot)| {
                found.add(&inspection);
                feet.add(&inspection, foot, dimension);
            },
        )?;
        let feet = (
            feet.point.into_pyarray(python),
            feet.normal.into_pyarray(python),
            feet.low.into_pyarray(python),
            feet.high.into_pyarray(python),
        );
        Ok((found.into_arrays(python), feet))
    }

    /// The sides of points with these columns of coordinates: −1, 0, 1, or 2 where there is none.
    fn sign<'py>(
        &self,
        python: Python<'py>,
        columns: Vec<PyReadonlyArray1<'py, f64>>,
        progress: Option<&Bound<'py, PyAny>>,
    ) -> PyResult<Bound<'py, PyArray1<i8>>> {
        let columns = self.columns(&columns)?;
        let mut signs = Vec::with_capacity(columns.len());
        self.each(
            python,
            progress,
            &columns,
            |point| self.task.side_of_doubles(point),
            |sign| signs.push(sign.unwrap_or(NONE)),
        )?;
        Ok(signs.into_pyarray(python))
    }
}

impl Inspector {
    fn columns<'a>(&self, columns: &'a [PyReadonlyArray1<'_, f64>]) -> PyResult<Columns<'a>> {
        let axes: Vec<_> = columns.iter().map(PyReadonlyArray1::as_array).collect();
        let is_right = axes.len() == self.task.dimension()
            && axes.iter().all(|axis| axis.len() == axes[0].len());
        match is_right {
            true => Ok(Columns { axes }),
            false => Err(InputError::new_err(format!(
                "points: {} columns of one length are expected",
                self.task.dimension()
            ))),
        }
    }

    /// Answers for every point, in their order. The answers are handed over some thousands at a time.
    fn each<T: Send>(
        &self,
        python: Python<'_>,
        progress: Option<&Bound<'_, PyAny>>,
        columns: &Columns<'_>,
        answer: impl Fn([f64; 3]) -> T + Sync,
        mut take: impl FnMut(T) + Send,
    ) -> PyResult<()> {
        let one = |k: usize| {
            let point = columns.point(k)?;
            self.limits.check()?;
            let found = answer(point);
            // An answer that a limit has ended is none.
            self.limits.check()?;
            Ok(found)
        };
        let count = columns.len();
        if count <= FEW {
            let found =
                python.detach(|| guarded(|| (0..count).map(one).collect::<Result<Vec<_>>>()));
            let found = found.map_err(|error| exception(&error))?;
            found.into_iter().for_each(take);
            return Ok(());
        }
        let watch = Watch::default();
        let pool = pool(self.threads).map_err(|error| exception(&error))?;
        let wait = Wait {
            python,
            progress,
            limits: &self.limits,
            watch: &watch,
        };
        wait.for_borrowed(&pool, || {
            for start in (0..count).step_by(CHUNK) {
                watch.progress("inspecting", start as u64, count as u64);
                let end = count.min(start + CHUNK);
                let found: Result<Vec<T>> = (start..end)
                    .into_par_iter()
                    .with_min_len(SHARE)
                    .map(one)
                    .collect();
                found?.into_iter().for_each(&mut take);
            }
            watch.progress("inspecting", count as u64, count as u64);
            Ok(())
        })
    }
}
