//! The singular points of a surface: the curves and the single points at which its gradient vanishes.

use malachite::base::polynomial::Polynomial;

use super::intersection::{CommonPoint, parametrize_intersection, passes};
use crate::error::{Error, Result};
use crate::factor::{factor_space, greatest_common_divisor};
use crate::limits::Limits;
use crate::poly::{IntegerPolynomial, SparsePolynomial, polynomial_gcd};
use crate::roots::real_roots;
use crate::shape::{ImplicitSurface, SpaceCurve};

/// Two surfaces are intersected only if the product of their degrees is at most this.
const MAX_DEGREES: u64 = 16;
/// Larger surfaces are not examined.
const MAX_SURFACE_DEGREE: u64 = 12;
const MAX_TERMS: usize = 200;

/// The real singular points of a surface.
#[derive(Clone, Debug, Default)]
#[non_exhaustive]
pub struct SingularLocus {
    /// Curves of singular points, which are verified by substitution.
    pub curves: Vec<SpaceCurve>,
    /// Single singular points. The exact ones are verified, and on none of the curves.
    pub points: Vec<CommonPoint>,
    /// Whether these are all.
    pub complete: bool,
}

/// Finds the singular points of the surface f = 0, where f is irreducible over Q, as far as Theorem 7 gives curves.
///
/// The derivatives of f are factored, and factors of two of them are intersected. A curve in which they meet is a curve of singular
/// points if f and all derivatives vanish on it identically; else the roots of their common divisor along the curve are single
/// singular points.
///
/// ```
/// use stellate::language::{Numbers, parse_form};
/// use stellate::limits::Limits;
/// use stellate::parametrize::singular_locus;
/// use stellate::shape::Form;
///
/// // Whitney's umbrella has its stick, the z axis.
/// let Form::Surface(umbrella) = parse_form("x^2 = y^2*z", "<form>", Numbers::Exact)? else { panic!() };
/// let found = singular_locus(umbrella.polynomial(), &Limits::none())?;
/// assert!(found.complete && found.points.is_empty());
/// assert_eq!(found.curves.len(), 1);
/// # Ok::<(), stellate::error::Error>(())
/// ```
///
/// # Errors
/// Those of `limits` and of [`factor_space`].
pub fn singular_locus(f: &SparsePolynomial<3>, limits: &Limits) -> Result<SingularLocus> {
    if f.degree() > Some(MAX_SURFACE_DEGREE) || f.len() > MAX_TERMS {
        return Ok(SingularLocus::default());
    }
    let slopes = (0..3).map(|v| f.derivative(v));
    let mut conditions: Vec<_> = slopes.filter(|slope| !slope.is_empty()).collect();
    conditions.push(f.clone());
    conditions.sort_unstable_by_key(|g| (g.degree(), g.len()));
    let mut found = SingularLocus {
        complete: true,
        ..SingularLocus::default()
    };
    if conditions[0].degree() == Some(0) {
        return Ok(found);
    }
    for first in factor_space(&conditions[0], limits)?.factors {
        let first = first.polynomial;
        let mut other = None;
        for condition in &conditions[1..] {
            if greatest_common_divisor(&first, condition, limits)?.degree() == Some(0) {
                other = Some(condition);
                break;
            }
        }
        let Some(other) = other else {
            // The factor divides f, so f is a constant multiple of it and does not depend on the other variables.
            continue;
        };
        for second in factor_space(other, limits)?.factors {
            found.add_common(&first, &second.polynomial, &conditions, limits)?;
        }
    }
    let SingularLocus { curves, points, .. } = &mut found;
    points.retain(|point| match point {
        CommonPoint::Exact(point) => !curves.iter().any(|curve| passes(curve, point)),
        CommonPoint::Near(_) => true,
    });
    Ok(found)
}

impl SingularLocus {
    /// Adds the singular points among the common zeros of two irreducible polynomials.
    fn add_common(
        &mut self,
        first: &SparsePolynomial<3>,
        second: &SparsePolynomial<3>,
        conditions: &[SparsePolynomial<3>],
        limits: &Limits,
    ) -> Result<()> {
        let degrees = [first, second].map(|g| g.degree().unwrap_or(0));
        if degrees.iter().product::<u64>() > MAX_DEGREES {
            self.complete = false;
            return Ok(());
        }
        let pair = [first, second].map(|g| ImplicitSurface::new(g.clone()));
        let common = match parametrize_intersection(&pair, limits) {
            Err(Error::Limit { .. }) => {
                limits.check()?;
                self.complete = false;
                return Ok(());
            }
            other => other?,
        };
        self.complete &= common.others.is_empty() && common.notes.is_empty();
        for curve in common.curves {
            self.add_along(curve, conditions);
        }
        let isolated = common
            .unreached
            .into_iter()
            .map(|unreached| unreached.point);
        for point in common.points.into_iter().chain(isolated) {
            match &point {
                CommonPoint::Exact(at) => {
                    if conditions.iter().all(|g| g.evaluate(at).is_zero()) {
                        self.add_point(point);
                    }
                }
                CommonPoint::Near(_) => self.complete = false,
            }
        }
        Ok(())
    }

    /// Adds a curve if all conditions hold on it, or else the points of it at which they do.
    fn add_along(&mut self, curve: SpaceCurve, conditions: &[SparsePolynomial<3>]) {
        let values = conditions.iter().map(|g| along(g, &curve));
        let common = values.fold(IntegerPolynomial::default(), |a, b| polynomial_gcd(&a, &b));
        if common == IntegerPolynomial::default() {
            if !self.curves.contains(&curve) {
                self.curves.push(curve);
            }
            return;
        }
        let in_doubles = curve.in_doubles();
        for root in real_roots(&common) {
            match root.as_rational() {
                Some(s) => {
                    if let Some(point) = curve.point(&s) {
                        self.add_point(CommonPoint::Exact(point));
                    }
                }
                None => {
                    let near = in_doubles.at([root.to_f64(), 1.0]);
                    if near.iter().all(|x| x.is_finite()) {
                        self.add_point(CommonPoint::Near(near));
                    }
                }
            }
        }
        if let Some(end) = curve.point_at_infinity()
            && conditions.iter().all(|g| g.evaluate(&end).is_zero())
        {
            self.add_point(CommonPoint::Exact(end));
        }
    }

    fn add_point(&mut self, point: CommonPoint) {
        if !self.points.contains(&point) {
            self.points.push(point);
        }
    }
}

/// The polynomial g along a curve, as a polynomial in the parameter s, times powers of the denominators.
fn along(g: &SparsePolynomial<3>, curve: &SpaceCurve) -> IntegerPolynomial {
    let g = g.primitive();
    let mut degrees = [0usize; 3];
    for (e, _) in g.terms() {
        degrees = std::array::from_fn(|i| degrees[i].max(e[i] as usize));
    }
    // For every coordinate, the products numerator^i · denominator^(d − i) for i = 0 … d.
    let powers: [Vec<IntegerPolynomial>; 3] = std::array::from_fn(|axis| {
        let function = &curve.coordinates()[axis];
        let all = |base: &IntegerPolynomial| {
            let mut list = vec![IntegerPolynomial::from_coefficients_asc(vec![1.into()])];
            for k in 0..degrees[axis] {
                let next = &list[k] * base;
                list.push(next);
            }
            list
        };
        let (above, below) = (all(function.numerator()), all(function.denominator()));
        let pairs = above.iter().zip(below.iter().rev());
        pairs.map(|(a, b)| a * b).collect()
    });
    let mut sum = IntegerPolynomial::default();
    for (e, c) in g.terms() {
        let [x, y, z] = [0, 1, 2].map(|axis| &powers[axis][e[axis] as usize]);
        let scale = IntegerPolynomial::from_coefficients_asc(vec![c.numerator()]);
        sum += &(x * y) * z * scale;
    }
    sum
}
