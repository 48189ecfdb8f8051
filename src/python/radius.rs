//! Radii of forms at columns of angles.

use std::f64::consts::FRAC_PI_2;

use numpy::{IntoPyArray, PyArray1, PyReadonlyArray1};
use pyo3::prelude::*;
use rayon::prelude::*;

use super::exceptions::{InputError, exception};
use super::options::reading;
use super::run::given;
use super::watch::{Wait, Watch, pool};
use crate::error::{Error, Result};
use crate::limits::Limits;
use crate::sample::{Direction, Ray, RaySolver, SpaceDirection, UnitVector, solve_radial};
use crate::shape::{
    Form, HarmonicPair, ImplicitCurve, ImplicitSurface, SpaceSuperquadric, Superquadric, series,
};
use crate::verb::{Content, Work};

/// The number of directions that one thread takes at a time, at least.
const SHARE: usize = 16;

/// What radii are measured of, from the origin of its own coordinates.
#[derive(Debug)]
enum Measured {
    /// The coefficients of a Fourier radius, in doubles.
    Series([Vec<f64>; 2]),
    Curve(ImplicitCurve),
    Superquadric(Superquadric),
    Surface(ImplicitSurface),
    SpaceSuperquadric(SpaceSuperquadric),
    Harmonic(HarmonicPair),
}

/// The radii of a form in any number of directions.
#[pyclass(frozen, module = "stellate._native")]
#[derive(Debug)]
pub(super) struct Radius {
    measured: Measured,
}

#[pymethods]
impl Radius {
    /// The radii of a form, given as for `call`.
    #[new]
    fn new(form: (String, Option<String>, String)) -> PyResult<Self> {
        measured(&form)
            .map(|measured| Self { measured })
            .map_err(|error| exception(&error))
    }

    /// Whether a direction has two angles.
    #[getter]
    fn is_in_space(&self) -> bool {
        match self.measured {
            Measured::Series(_) | Measured::Curve(_) | Measured::Superquadric(_) => false,
            Measured::Surface(_) | Measured::SpaceSuperquadric(_) | Measured::Harmonic(_) => true,
        }
    }

    /// The radii at columns of angles, θ and in space φ. Where an equation has no point with r > 0, the radius is NaN.
    fn at<'py>(
        &self,
        python: Python<'py>,
        theta: PyReadonlyArray1<'py, f64>,
        phi: Option<PyReadonlyArray1<'py, f64>>,
    ) -> PyResult<Bound<'py, PyArray1<f64>>> {
        let theta = theta.as_array();
        let phi = phi.as_ref().map(PyReadonlyArray1::as_array);
        if self.is_in_space() != phi.is_some() || phi.is_some_and(|phi| phi.len() != theta.len()) {
            return Err(InputError::new_err(match self.is_in_space() {
                true => "a surface has a radius at (theta, phi), two arrays of one shape",
                false => "a plane curve has a radius at theta alone",
            }));
        }
        let mut angles = theta.iter().chain(phi.iter().flatten());
        if !angles.all(|angle| angle.abs() <= Direction::LARGEST_RADIANS) {
            return Err(InputError::new_err(
                "angles are numbers of radians up to 1e9",
            ));
        }
        let (limits, watch) = (Limits::none(), Watch::default());
        let pool = pool(None).map_err(|error| exception(&error))?;
        let wait = Wait {
            python,
            progress: None,
            limits: &limits,
            watch: &watch,
        };
        // The angle φ of the plane.
        let phi_of = |k: usize| phi.map_or(FRAC_PI_2, |phi| phi[k]);
        let radius = self.measured.solver();
        let radii: Vec<f64> = wait.for_borrowed(&pool, || {
            let each = (0..theta.len()).into_par_iter().with_min_len(SHARE);
            let each = each.map(|k| {
                limits.check()?;
                radius(theta[k], phi_of(k))
            });
            each.collect()
        })?;
        Ok(radii.into_pyarray(python))
    }
}

fn measured(form: &(String, Option<String>, String)) -> Result<Measured> {
    let given = given(form, &reading(&form.2)?, &Work::default())?;
    Ok(match given.into_content() {
        Content::Exact(Form::Fourier(radius)) => {
            let (cos, sin) = radius.to_doubles();
            Measured::Series([cos, sin])
        }
        Content::Exact(Form::Curve(curve)) => Measured::Curve(curve),
        Content::Exact(Form::Superquadric(shape)) => Measured::Superquadric(shape),
        Content::Exact(Form::Surface(surface)) => Measured::Surface(surface),
        Content::Exact(Form::SpaceSuperquadric(shape)) => Measured::SpaceSuperquadric(shape),
        Content::Exact(Form::Harmonic(surface)) => Measured::Harmonic(HarmonicPair::new(&surface)),
        _ => {
            let message = "radii are those of Fourier radii, superquadrics, harmonic surfaces and equations; fit an outline, and implicitize a parametric form";
            return Err(Error::Usage(message.into()));
        }
    })
}

/// The direction with the angles θ and φ.
fn space(theta: f64, phi: f64) -> SpaceDirection {
    let [theta, phi] = [theta, phi].map(Direction::from_radians);
    SpaceDirection::new(theta, phi)
}

/// The radius at θ and φ; in the plane φ is not used.
type Solver<'a> = Box<dyn Fn(f64, f64) -> Result<f64> + Sync + 'a>;

impl Measured {
    /// The radii at any number of angles: what the angles have in common is computed once.
    fn solver(&self) -> Solver<'_> {
        match self {
            Self::Series([cos, sin]) => Box::new(|theta, _| Ok(series(cos, sin, theta))),
            Self::Curve(curve) => {
                let solver = RaySolver::new(curve.polynomial());
                Box::new(move |theta, _| {
                    Ok(outermost(&solver.solve(&Direction::from_radians(theta))))
                })
            }
            Self::Superquadric(shape) => Box::new(move |theta, _| {
                Ok(outermost(&solve_radial(
                    shape,
                    &Direction::from_radians(theta),
                )?))
            }),
            Self::Surface(surface) => {
                let solver = RaySolver::new(surface.by_degree());
                Box::new(move |theta, phi| Ok(outermost(&solver.solve(&space(theta, phi)))))
            }
            Self::SpaceSuperquadric(shape) => {
                Box::new(move |theta, phi| Ok(outermost(&solve_radial(shape, &space(theta, phi))?)))
            }
            Self::Harmonic(pair) => {
                Box::new(move |theta, phi| Ok(pair.value(&space(theta, phi).components()).to_f64()))
            }
        }
    }
}

/// The largest radius of the points on a ray: NaN if there is none with r > 0, and ∞ if the whole ray belongs to the form.
fn outermost<const V: usize>(ray: &Ray<V>) -> f64 {
    match ray {
        Ray::Points(points) => {
            let positive = points.iter().map(|point| point.r).filter(|r| *r > 0.0);
            positive.fold(f64::NAN, f64::max)
        }
        Ray::Line => f64::INFINITY,
    }
}
