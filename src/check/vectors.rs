//! Test vectors for float programs: inputs that are doubles, and certified results that follow from them.

use std::collections::BTreeMap;
use std::f64::consts::TAU;

use malachite::Integer;

use super::condition::{RootConditions, coefficient_conditions};
use super::reference::Reference;
use super::series::SeriesValues;
use crate::error::{Error, Invariant, Result};
use crate::exact::Rational;
use crate::limits::Limits;
use crate::parallel;
use crate::poly::{SpacePolynomial, SparsePolynomial};
use crate::sample::{Direction, IntegerVector, Ray, RaySolver, Sample, SpaceDirection};
use crate::shape::FourierRadius;

/// An input of a float program; it is a double.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum VectorInput {
    /// The coefficient a_n of the radius, with its n.
    Cosine(usize, f64),
    /// The coefficient b_n of the radius, with its n.
    Sine(usize, f64),
    /// The coefficient of a term, with its exponents, if the polynomial itself is given.
    Coefficient([u32; 3], f64),
}

/// A coefficient that follows from the inputs.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct CoefficientVector {
    /// The exponents of x, y and z.
    pub exponents: [u32; 3],
    /// The coefficient.
    pub exact: Rational,
    /// The double nearest to it.
    pub double: f64,
    /// Its condition with respect to the inputs; `None` if there are no inputs.
    pub condition: Option<Rational>,
}

/// The value r(θ) at an angle that is a double.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct RadiusVector {
    /// The angle, exactly this double.
    pub theta: f64,
    /// The double nearest to r(θ).
    pub r: f64,
    /// The condition of r(θ) with respect to the inputs.
    pub condition: f64,
}

/// A point of the zero set in an exact direction.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct PointVector {
    /// The direction, a unit vector; its third component is 0 in the plane.
    pub unit: [Rational; 3],
    /// The double nearest to the root r, which is the distance from the origin along the direction, or its negative on the
    /// opposite side.
    pub r: f64,
    /// The doubles nearest to x, y and z.
    pub position: [f64; 3],
    /// The multiplicity of the root.
    pub multiplicity: usize,
    /// The condition of the root with respect to the coefficients.
    pub condition: f64,
}

/// Inputs of a float program, and the results that follow from them.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct TestVectors {
    /// Whether the form is a surface.
    pub in_space: bool,
    /// The point of the original coordinates that is the origin here.
    pub center: Vec<Rational>,
    /// The inputs; none for a parametric form.
    pub inputs: Vec<VectorInput>,
    /// The number of given numbers that are not doubles, and so were rounded to doubles first.
    pub rounded: usize,
    /// The coefficients in canonical order; the first coefficient is 1 if the inputs are those of a radius.
    pub coefficients: Vec<CoefficientVector>,
    /// The radii at the angles 2πk/K, which are computed in doubles; none if the curve has no Fourier radius.
    pub radii: Vec<RadiusVector>,
    /// All points of the form in K directions.
    pub points: Vec<PointVector>,
}

/// The form whose coefficients are the inputs of a float program.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum InputsOf {
    /// The inputs are the coefficients of the radius if there is one, otherwise those of the polynomial.
    Form,
    /// There are no inputs, because the polynomial comes from a parametric form.
    Nothing,
}

/// The test vectors of a reference. Its numbers are rounded to doubles first, because only those can be given to a float
/// program; everything else follows exactly from these doubles.
///
/// ```
/// use stellate::check::{InputsOf, Reference, test_vectors};
/// use stellate::limits::Limits;
/// use stellate::shape::FourierRadius;
/// let fifth = stellate::exact::Rational::from(1) / stellate::exact::Rational::from(5);
/// let reference = Reference::of_radius(&FourierRadius::new(vec![1.into(), fifth], vec![]))?;
/// let vectors = test_vectors(&reference, InputsOf::Form, 4, &Limits::none())?;
/// assert_eq!(vectors.rounded, 1);
/// // r(0) = 1 + 0.2 of the doubles, correctly rounded.
/// assert_eq!(vectors.radii[0].r, 1.2);
/// # Ok::<(), stellate::error::Error>(())
/// ```
///
/// # Errors
/// [`Error::Hypothesis`] if a number is beyond the doubles; [`Error::Usage`] without directions; those of `limits`.
pub fn test_vectors(
    reference: &Reference,
    inputs_of: InputsOf,
    directions: usize,
    limits: &Limits,
) -> Result<TestVectors> {
    if directions == 0 {
        return Err(Error::Usage(
            "--directions 0: at least one is needed".into(),
        ));
    }
    let mut rounding = Rounding::default();
    let (polynomial, inputs, radius) = match (inputs_of, reference.radius()) {
        (InputsOf::Nothing, radius) => {
            (reference.polynomial().clone(), Vec::new(), radius.cloned())
        }
        (InputsOf::Form, Some(radius)) => {
            let radius = rounding.radius(radius)?;
            let polynomial = Reference::of_radius(&radius)?.polynomial().clone();
            (polynomial, inputs_of_radius(&radius), Some(radius))
        }
        (InputsOf::Form, None) => {
            let polynomial = rounding.polynomial(reference.polynomial())?;
            let terms = polynomial.terms();
            let inputs = terms.map(|(e, c)| VectorInput::Coefficient(*e, c.to_f64()));
            (polynomial.clone(), inputs.collect(), None)
        }
    };
    let given = radius.as_ref().filter(|_| inputs_of == InputsOf::Form);
    Ok(TestVectors {
        in_space: reference.in_space(),
        center: reference.center().to_vec(),
        coefficients: coefficients(&polynomial, given, inputs_of)?,
        radii: radius.map_or_else(Vec::new, |radius| radii(&radius, directions)),
        points: points(&polynomial, reference, directions, limits)?,
        rounded: rounding.count,
        inputs,
    })
}

/// Rounds numbers to doubles and counts those that change.
#[derive(Default)]
struct Rounding {
    count: usize,
}

impl Rounding {
    fn number(&mut self, exact: &Rational) -> Result<Rational> {
        let double = finite(exact)?;
        let rounded = Rational::try_from(double).invariant("a finite double is a number");
        self.count += usize::from(rounded != *exact);
        Ok(rounded)
    }

    fn radius(&mut self, radius: &FourierRadius) -> Result<FourierRadius> {
        let mut all = |numbers: &[Rational]| -> Result<Vec<Rational>> {
            numbers.iter().map(|c| self.number(c)).collect()
        };
        let (cos, sin) = (all(radius.cosines())?, all(radius.sines())?);
        Ok(FourierRadius::new(cos, sin).with_center(radius.center().clone()))
    }

    fn polynomial(&mut self, f: &SparsePolynomial<3>) -> Result<SparsePolynomial<3>> {
        let terms: Result<Vec<_>> = f.terms().map(|(e, c)| Ok((*e, self.number(c)?))).collect();
        Ok(SparsePolynomial::from_terms(terms?))
    }
}

/// The nearest double. It is an error if this is infinite, or if it is 0 for a number that is not 0.
fn finite(exact: &Rational) -> Result<f64> {
    let double = exact.to_f64();
    let beyond = if !double.is_finite() {
        "is beyond the largest double; scale the form down"
    } else if double == 0.0 && !exact.is_zero() {
        "is below the smallest double; scale the form up"
    } else {
        return Ok(double);
    };
    Err(Error::Hypothesis {
        statement: "the use of doubles",
        witness: format!("{} {beyond}", exact.to_significant(3)),
    })
}

fn inputs_of_radius(radius: &FourierRadius) -> Vec<VectorInput> {
    let pairs = radius.cosines().iter().zip(radius.sines()).enumerate();
    pairs
        .flat_map(|(n, (a, b))| {
            let cosine = VectorInput::Cosine(n, a.to_f64());
            let sine = (n > 0).then(|| VectorInput::Sine(n, b.to_f64()));
            std::iter::once(cosine).chain(sine)
        })
        .collect()
}

fn coefficients(
    polynomial: &SparsePolynomial<3>,
    radius: Option<&FourierRadius>,
    inputs_of: InputsOf,
) -> Result<Vec<CoefficientVector>> {
    let conditions = radius.map(coefficient_conditions);
    let conditions: Option<BTreeMap<[u32; 3], Rational>> =
        conditions.map(|f| f.terms().map(|(e, c)| (*e, c.clone())).collect());
    let condition = |exponents: &[u32; 3]| match (&conditions, inputs_of) {
        (Some(all), _) => Some(all.get(exponents).cloned().unwrap_or_default()),
        // The coefficient itself is an input.
        (None, InputsOf::Form) => Some(Rational::one()),
        (None, InputsOf::Nothing) => None,
    };
    polynomial
        .terms()
        .map(|(exponents, exact)| {
            Ok(CoefficientVector {
                exponents: *exponents,
                double: finite(exact)?,
                condition: condition(exponents),
                exact: exact.clone(),
            })
        })
        .collect()
}

#[expect(clippy::cast_precision_loss, reason = "any double is an angle")]
fn radii(radius: &FourierRadius, directions: usize) -> Vec<RadiusVector> {
    let values = SeriesValues::new(radius);
    parallel::map_numbers(directions, |k| {
        let theta = TAU * k as f64 / directions as f64;
        let exact = Rational::try_from(theta).invariant("a finite double is a number");
        RadiusVector {
            theta,
            r: values.nearest_double(&exact),
            condition: values.condition(&exact),
        }
    })
}

fn points(
    f: &SparsePolynomial<3>,
    reference: &Reference,
    count: usize,
    limits: &Limits,
) -> Result<Vec<PointVector>> {
    let conditions = RootConditions::new(f);
    if reference.in_space() {
        let surface = SpacePolynomial::from(f);
        let solver = RaySolver::new(&surface);
        let directions = SpaceDirection::fibonacci(count);
        return all_points(&directions, limits, |d| {
            let (vector, w) = d.over_common_denominator();
            on_ray(solver.solve(d), &vector, &w, &conditions)
        });
    }
    let Some(plane) = f.to_plane() else {
        return Ok(Vec::new());
    };
    let solver = RaySolver::new(&plane);
    all_points(&Direction::around(count), limits, |d| {
        let ([u, v], w) = d.over_common_denominator();
        let mut ray = solver.solve(d);
        if let (Ray::Points(samples), Some(parameters)) = (&mut ray, reference.parameters()) {
            let mut on_curve = parameters.have(samples, &solver, d).into_iter();
            samples.retain(|_| on_curve.next() == Some(true));
        }
        on_ray(ray, &[u, v, Integer::from(0)], &w, &conditions)
    })
}

fn all_points<D: Sync>(
    directions: &[D],
    limits: &Limits,
    solve: impl Fn(&D) -> Vec<PointVector> + Sync,
) -> Result<Vec<PointVector>> {
    let rays = parallel::try_map(directions, limits, |direction| Ok(solve(direction)))?;
    Ok(rays.into_iter().flatten().collect())
}

/// The points on one line through the origin. If the whole line belongs to the zero set, there are none to be checked.
fn on_ray<const V: usize>(
    ray: Ray<V>,
    vector: &[Integer; 3],
    w: &Integer,
    conditions: &RootConditions,
) -> Vec<PointVector> {
    let Ray::Points(samples) = ray else {
        return Vec::new();
    };
    let component = |v: &Integer| {
        Rational::from_integers(v.clone(), w.clone()).invariant("a unit vector has a denominator")
    };
    let point = |sample: Sample<V>| PointVector {
        unit: vector.each_ref().map(component),
        r: sample.r,
        // In the plane, z is 0.
        position: std::array::from_fn(|i| sample.position.get(i).copied().unwrap_or_default()),
        multiplicity: sample.multiplicity,
        condition: if sample.multiplicity > 1 {
            f64::INFINITY
        } else {
            conditions.at(vector, w, sample.r)
        },
    };
    samples.into_iter().map(point).collect()
}
