//! Compares points of a float program with the exact curve or surface.

use malachite::Integer;
use malachite::base::num::arithmetic::traits::{Lcm, Pow};
use malachite::base::num::basic::traits::One;

use super::comparison::{Comparison, GivenNumber, Residual, Row};
use super::deviation::{Deviation, close_root, nearest_root, unit_in_the_last_place};
use super::mistakes::{Mistaken, diagnose};
use super::nearest::{OnCurve, nearest_to_one};
use super::reference::Reference;
use super::unexplained::unexplained;
use crate::error::{Error, Invariant, Result};
use crate::exact::Rational;
use crate::limits::Limits;
use crate::parallel;
use crate::poly::{SpacePolynomial, SparsePolynomial};
use crate::sample::{RealParameters, along};

/// The largest number of rows, evenly chosen, in which usual mistakes are looked for.
pub(super) const ROWS_FOR_DIAGNOSIS: usize = 24;

/// A point of a float program, and the line of the file that it comes from.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct GivenPoint {
    /// The line, counted from 1.
    pub line: usize,
    /// The coordinates x, y and z; z is 0 in the plane.
    pub position: [f64; 3],
}

/// Checks that the numbers of a line are finite.
///
/// # Errors
/// [`Error::Usage`] with the line if one of them is not.
pub(super) fn check_finite<const N: usize>(line: usize, numbers: [(&str, f64); N]) -> Result<()> {
    match numbers.iter().find(|(_, number)| !number.is_finite()) {
        Some((name, number)) => Err(Error::Usage(format!(
            "line {line}: {name} is {number}; expected a finite number"
        ))),
        None => Ok(()),
    }
}

/// A polynomial f and its gradient, ready for exact values.
struct Surface<'a> {
    f: SpacePolynomial,
    gradient: [SpacePolynomial; 3],
    /// Which zeros of f are points of the reference, if it was given by functions of a parameter.
    parameters: Option<&'a RealParameters>,
}

impl Reference {
    /// Compares points of a float program, relative to [`Reference::center`], with the zero set.
    ///
    /// A point p lies on a rational line through the origin, on which f(λp) is a polynomial in λ. Its real root λ nearest to 1
    /// gives the nearest point of the zero set on this line, and |λ − 1|/|λ| is the distance of p from it relative to the exact
    /// radius. The residual f(p) and the first-order distance |f|/|∇f| are computed exactly and then rounded. Cost: for each
    /// point, the values of all homogeneous parts of f and of its gradient, and the real roots of one polynomial.
    ///
    /// ```
    /// use stellate::check::{GivenPoint, Reference};
    /// use stellate::limits::Limits;
    /// use stellate::shape::FourierRadius;
    /// let circle = Reference::of_radius(&FourierRadius::new(vec![5.into()], vec![]))?;
    /// let points = [[3.0, 4.0, 0.0], [6.0, 8.0, 0.0]].map(|position| GivenPoint { line: 1, position });
    /// let found = circle.check_points(&points, &Limits::none())?;
    /// assert_eq!(found.rows[0].deviation.relative(), Some(&0.into()));
    /// assert_eq!(found.rows[1].residual.unwrap().value, 75.0);
    /// # Ok::<(), stellate::error::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Error::Usage`] for a coordinate that is not finite; those of `limits`.
    pub fn check_points(&self, points: &[GivenPoint], limits: &Limits) -> Result<Comparison> {
        for point in points {
            let [x, y, z] = point.position;
            check_finite(point.line, [("x", x), ("y", y), ("z", z)])?;
        }
        let on = self.parameters();
        let mut found = compare(points, self.polynomial(), on, limits)?;
        found.in_space = self.in_space();
        let step = points.len().div_ceil(ROWS_FOR_DIAGNOSIS).max(1);
        let some: Vec<GivenPoint> = points.iter().step_by(step).copied().collect();
        let compared = compare(&some, self.polynomial(), on, limits)?;
        let with = |polynomial: &_| compare(&some, polynomial, None, limits).ok();
        found.diagnoses = diagnose(&compared, on.map(|_| self.beyond_the_curve()), with);
        if found.diagnoses.is_empty() {
            found.diagnoses = diagnose(&compared, self.mistaken(), with);
        }
        if found.diagnoses.is_empty() {
            found.diagnoses = diagnose(&compared, self.misplaced(&compared, &some), |points| {
                compare(points, self.polynomial(), on, limits).ok()
            });
        }
        if found.diagnoses.is_empty() {
            found.diagnoses = unexplained(&found, |_| Rational::one());
        }
        Ok(found)
    }

    /// All zeros of the equation instead of the points of the curve.
    fn beyond_the_curve(&self) -> Mistaken<SparsePolynomial<3>> {
        Mistaken {
            name: "beyond the curve".into(),
            explanation:
                "the points are near zeros of the equation that no real parameter of the curve has"
                    .into(),
            form: self.polynomial().clone(),
        }
    }
}

fn compare(
    points: &[GivenPoint],
    polynomial: &SparsePolynomial<3>,
    parameters: Option<&RealParameters>,
    limits: &Limits,
) -> Result<Comparison> {
    let surface = Surface::new(polynomial, parameters);
    Ok(Comparison {
        rows: parallel::try_map(points, limits, |point| Ok(surface.row(point)))?,
        ..Comparison::default()
    })
}

impl<'a> Surface<'a> {
    fn new(f: &SparsePolynomial<3>, parameters: Option<&'a RealParameters>) -> Self {
        Self {
            f: SpacePolynomial::from(f),
            gradient: [0, 1, 2].map(|axis| SpacePolynomial::from(&f.derivative(axis))),
            parameters,
        }
    }

    fn row(&self, point: &GivenPoint) -> Row {
        let p = point
            .position
            .map(|v| Rational::try_from(v).invariant("coordinates are finite"));
        let w = p.iter().fold(Integer::ONE, |w, v| {
            let other = v.denominator();
            Integer::from(w.unsigned_abs_ref().lcm(other.unsigned_abs_ref()))
        });
        let scale = Rational::whole(&w);
        let vector = p.each_ref().map(|v| (v * &scale).numerator());
        let terms = along(&self.f, &vector, &w);
        let value = value(&terms, &self.f, &w);
        let square = p.iter().fold(Rational::zero(), |sum, v| sum + v * v);
        let radius = (!square.is_zero()).then(|| close_root(&square));
        let [u, v, _] = &vector;
        let on = self.parameters.map(|parameters| OnCurve {
            parameters,
            vector: [u, v],
            w: &w,
        });
        let is_on = value.is_zero()
            && on
                .as_ref()
                .is_none_or(|on| on.parameters.have_point(on.vector, on.w));
        let (exact, deviation) = match (radius, is_on) {
            (Some(radius), true) => (Some(radius), Deviation::exact()),
            (Some(radius), false) => distance(&terms, &radius, on.as_ref()),
            // The point is the origin.
            (None, true) => (Some(Rational::zero()), Deviation::exact()),
            (None, false) => (None, Deviation::infinite()),
        };
        let gradient = self.gradient.each_ref().map(|g| {
            let terms = along(g, &vector, &w);
            self::value(&terms, g, &w)
        });
        Row {
            place: GivenNumber::Point {
                line: point.line,
                position: point.position,
            },
            got: nearest_root(&square),
            exact,
            deviation,
            residual: Some(residual(&value, &gradient)),
        }
    }
}

/// For a point at this distance from the origin: the radius of the nearest point of the zero set on its line, and the deviation
/// of the point from that.
fn distance(
    terms: &[(usize, Integer)],
    radius: &Rational,
    on: Option<&OnCurve<'_>>,
) -> (Option<Rational>, Deviation) {
    let nearest = nearest_to_one(terms, on);
    let Some((offset, relative)) = nearest.and_then(|o| o.relative().map(|r| (o, r))) else {
        return (None, Deviation::infinite());
    };
    let exact = (Rational::one() + &offset.high) * radius;
    let unit = unit_in_the_last_place(exact.to_f64());
    let ulps = (offset.high.abs() * radius / unit).to_f64();
    (Some(exact), Deviation::bounded(relative, ulps))
}

/// The value of f at the vector divided by w, from the terms (d, c_d) on its line: Σ c_d / (w^top · D), where top is the degree
/// of f and D is its denominator.
fn value(terms: &[(usize, Integer)], f: &SpacePolynomial, w: &Integer) -> Rational {
    let sum: Integer = terms.iter().map(|(_, c)| c.clone()).sum();
    let top = f.degree().unwrap_or(0) as u64;
    let below = w.pow(top) * f.denominator();
    Rational::from_integers(sum, below).invariant("a power of a denominator is not 0")
}

fn residual(value: &Rational, gradient: &[Rational; 3]) -> Residual {
    let steepness = gradient.iter().fold(Rational::zero(), |sum, g| sum + g * g);
    let first_order = match steepness.recip() {
        Some(inverse) => nearest_root(&(value * value * inverse)),
        None if value.is_zero() => 0.0,
        None => f64::INFINITY,
    };
    Residual {
        value: value.to_f64(),
        first_order,
    }
}
