//! The criterion of Theorem 8, exactly: the sphere (or circle) of radius d about p, by stereographic projection.

use malachite::Integer;
use malachite::base::num::basic::traits::Zero;
use malachite::base::polynomial::Polynomial;

use crate::error::{Invariant, Result};
use crate::exact::Rational;
use crate::limits::Limits;
use crate::parametrize::{AngleRange, ExactAngle, Parametrization, parametrize};
use crate::poly::{IntegerPolynomial, PlanePolynomial, Ring, SparsePolynomial};
use crate::roots::real_roots;
use crate::shape::ImplicitCurve;

/// The intersection of a surface and a sphere, as a plane curve.
///
/// With s = tan(φ/2) cos θ, t = tan(φ/2) sin θ and W = 1 + s² + t² the point of the sphere in the direction (θ, φ) is
/// p + d (2s, 2t, 1 − s² − t²)/W. So W^n f is a polynomial in s and t, whose polar coordinates are tan(φ/2) and θ: its exact
/// angle ranges are those of Theorem 8's space curve.
#[derive(Clone, Debug)]
pub struct SphereSection {
    polynomial: PlanePolynomial,
    /// Whether the poles φ = 0 and φ = π of the sphere belong to the surface.
    poles: [bool; 2],
}

impl SphereSection {
    /// The section of `f` = 0 by the sphere of radius `d` about `p`.
    ///
    /// Cost: a product of bivariate polynomials of degree 2n for every term of f, of degree n.
    #[must_use]
    pub fn new(f: &SparsePolynomial<3>, p: &[Rational; 3], d: &Rational) -> Self {
        let [s, t] = [0, 1].map(SparsePolynomial::<2>::variable);
        let one = SparsePolynomial::constant(Rational::one());
        let squares = s.squared().plus(&t.squared());
        let weight = one.plus(&squares);
        let twice = Rational::from(2);
        let unit = [s.scaled(&twice), t.scaled(&twice), one.minus(&squares)];
        let along = [0, 1, 2].map(|i| weight.scaled(&p[i]).plus(&unit[i].scaled(d)));
        let polynomial = composed(f, &along, &weight);
        let pole = |sign: i32| {
            let z = &p[2] + &(d * &Rational::from(sign));
            f.evaluate(&[p[0].clone(), p[1].clone(), z]).is_zero()
        };
        let terms = polynomial
            .terms()
            .map(|(e, c)| ((e[0] as usize, e[1] as usize), c.clone()));
        Self {
            polynomial: PlanePolynomial::from_terms(terms),
            poles: [pole(1), pole(-1)],
        }
    }

    /// The polynomial in s = tan(φ/2) cos θ and t = tan(φ/2) sin θ.
    #[must_use]
    pub fn polynomial(&self) -> &PlanePolynomial {
        &self.polynomial
    }

    /// A rough measure of the work for the exact angles: the bits of the coefficients times the eighth power of the degree.
    /// 10¹⁰ took a second, 3·10¹¹ took half a minute (quartics and sextics with coordinates of 17 digits).
    #[must_use]
    #[expect(clippy::cast_precision_loss, reason = "an estimate")]
    pub fn work(&self) -> f64 {
        // For the polynomial 0 there is no work: all angles belong to the answer.
        let degree = self.polynomial.degree().map_or(0.0, |degree| degree as f64);
        self.polynomial.primitive().coefficient_bits() as f64 * degree.powi(8)
    }

    /// Whether surface and sphere have a real point in common, exactly.
    ///
    /// # Errors
    /// Those of [`parametrize`].
    pub fn has_points(&self, limits: &Limits) -> Result<bool> {
        if self.poles.contains(&true) || self.polynomial.is_zero() || self.changes_sign() {
            return Ok(true);
        }
        if self.polynomial.degree() == Some(0) {
            return Ok(false);
        }
        let polar = self.polar(limits)?;
        Ok(!polar.lines.is_empty() || polar.branches.iter().any(|b| !b.real.is_empty()))
    }

    /// The angles θ (within [0, 2π], about p) at which the space curve of Theorem 8 is real: at least one common point is in
    /// the plane through the z axis of p that has this angle.
    ///
    /// # Errors
    /// Those of [`parametrize`].
    pub fn theta_ranges(&self, limits: &Limits) -> Result<Vec<AngleRange>> {
        if self.polynomial.is_zero() {
            return Ok(vec![AngleRange::full_circle()]);
        }
        if self.polynomial.degree() == Some(0) {
            return Ok(Vec::new());
        }
        let polar = self.polar(limits)?;
        let real = polar.branches.into_iter().flat_map(|b| b.real);
        let lines = polar
            .lines
            .into_iter()
            .flat_map(|angle| [angle.plus_pi(), angle]);
        Ok(union(real.chain(lines.map(AngleRange::point)).collect()))
    }

    fn polar(&self, limits: &Limits) -> Result<Parametrization> {
        parametrize(&ImplicitCurve::new(self.polynomial.clone()), limits)
    }

    /// A cheap test at a few points: opposite signs prove that there is a common point.
    fn changes_sign(&self) -> bool {
        let at = |n: i32| Rational::from(n) / Rational::from(3);
        let points = (-4..5).flat_map(|i| (-4..5).map(move |j| (at(i), at(j))));
        let mut signs = points.map(|(s, t)| self.polynomial.evaluate(&s, &t).signum());
        let first = signs.next();
        signs.any(|sign| Some(sign) != first)
    }
}

/// The intersection of a plane curve and a circle. With t = tan(θ/2) the point of the circle in the direction θ is p + d (1 −
/// t², 2t)/(1 + t²), so (1 + t²)^n f is a polynomial in t.
#[derive(Clone, Debug)]
pub struct CircleSection {
    /// (1 + t²)^n f, which is 0 if the whole circle belongs to the curve.
    polynomial: IntegerPolynomial,
    /// Whether the point at θ = π belongs to the curve.
    at_pi: bool,
}

impl CircleSection {
    /// The section of `f` = 0, a polynomial in x and y, by the circle of radius `d` about `p`.
    #[must_use]
    pub fn new(f: &SparsePolynomial<3>, p: &[Rational; 3], d: &Rational) -> Self {
        let t = SparsePolynomial::<1>::variable(0);
        let one = SparsePolynomial::constant(Rational::one());
        let square = t.squared();
        let weight = one.plus(&square);
        let unit = [
            one.minus(&square),
            t.scaled(&Rational::from(2)),
            SparsePolynomial::zero(),
        ];
        let along = [0, 1, 2].map(|i| weight.scaled(&p[i]).plus(&unit[i].scaled(d)));
        let found = composed(f, &along, &weight).primitive();
        let mut coefficients = Vec::new();
        for (e, c) in found.terms() {
            let place = e[0] as usize;
            if coefficients.len() <= place {
                coefficients.resize(place + 1, Integer::ZERO);
            }
            coefficients[place] = c.numerator();
        }
        let opposite = [&p[0] - d, p[1].clone(), p[2].clone()];
        Self {
            polynomial: IntegerPolynomial::from_coefficients_asc(coefficients),
            at_pi: f.evaluate(&opposite).is_zero(),
        }
    }

    /// Whether curve and circle have a real point in common, exactly.
    #[must_use]
    pub fn has_points(&self) -> bool {
        self.at_pi
            || self.polynomial == IntegerPolynomial::ZERO
            || !real_roots(&self.polynomial).is_empty()
    }

    /// The directions θ about p of the common points, within [0, 2π].
    #[must_use]
    pub fn theta_ranges(&self) -> Vec<AngleRange> {
        if self.polynomial == IntegerPolynomial::ZERO {
            return vec![AngleRange::full_circle()];
        }
        let roots = real_roots(&self.polynomial).into_iter();
        let angles = roots.map(ExactAngle::of_half_tangent);
        let at_pi = self.at_pi.then(ExactAngle::pi);
        union(angles.chain(at_pi).map(AngleRange::point).collect())
    }
}

/// The polynomial d² − |x − p|², which is positive inside the sphere of radius d about p.
#[must_use]
pub(crate) fn sphere_about(p: &[Rational; 3], d: &Rational) -> SparsePolynomial<3> {
    let mut terms = vec![([0; 3], d * d)];
    for (i, c) in p.iter().enumerate() {
        let power = |k: u32| std::array::from_fn(|j| if i == j { k } else { 0 });
        terms.push((power(2), Rational::from(-1)));
        terms.push((power(1), c * &Rational::from(2)));
        terms.push((power(0), -(c * c)));
    }
    SparsePolynomial::from_terms(terms)
}

/// `weight^n f(along/weight)` for f of degree n.
fn composed<const V: usize>(
    f: &SparsePolynomial<3>,
    along: &[SparsePolynomial<V>; 3],
    weight: &SparsePolynomial<V>,
) -> SparsePolynomial<V> {
    // The polynomial 0 has no terms.
    let Some(degree) = f.degree() else {
        return SparsePolynomial::zero();
    };
    let degree = usize::try_from(degree).invariant("powers of this degree fit into memory");
    let powers = |g: &SparsePolynomial<V>| -> Vec<SparsePolynomial<V>> {
        let first = SparsePolynomial::constant(Rational::one());
        let all = std::iter::successors(Some(first), |power| Some(power.times(g)));
        all.take(degree + 1).collect()
    };
    let [x, y, z] = along.each_ref().map(powers);
    let weights = powers(weight);
    let mut sum = SparsePolynomial::zero();
    for (e, c) in f.terms() {
        let [i, j, k] = e.map(|k| k as usize);
        let product = x[i].times(&y[j]).times(&z[k]);
        sum.add_multiple(&product.times(&weights[degree - i - j - k]), c);
    }
    sum
}

/// The union of ranges, ascending; ranges that overlap or touch become one. The zero set is closed, so every end belongs to its
/// range.
fn union(mut ranges: Vec<AngleRange>) -> Vec<AngleRange> {
    ranges.sort_unstable_by(|a, b| a.from.compare(&b.from).then_with(|| b.to.compare(&a.to)));
    let mut merged: Vec<AngleRange> = Vec::new();
    for mut range in ranges {
        range.closed = [true; 2];
        match merged.last_mut() {
            Some(last) if range.from.compare(&last.to).is_le() => {
                if range.to.compare(&last.to).is_gt() {
                    last.to = range.to;
                }
            }
            _ => merged.push(range),
        }
    }
    merged
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The plane z = ±1 touches the unit sphere in a pole alone; the chart has this pole as its origin or not at all.
    #[test]
    fn a_plane_that_touches_at_a_pole_has_a_point() {
        let origin = [0; 3].map(Rational::from);
        let plane = |z: i64| {
            SparsePolynomial::<3>::variable(2).minus(&SparsePolynomial::constant(Rational::from(z)))
        };
        for (z, meets) in [(1, true), (-1, true), (0, true), (2, false), (-2, false)] {
            let section = SphereSection::new(&plane(z), &origin, &Rational::one());
            assert_eq!(
                section.has_points(&Limits::none()).unwrap(),
                meets,
                "z = {z}"
            );
        }
    }
}
