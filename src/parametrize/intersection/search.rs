//! The search for the components above the factors of a projection.

use malachite::Integer;
use malachite::base::num::basic::traits::Zero;
use malachite::base::polynomial::Polynomial;

use super::real::{RealPart, at, real_part, univariate};
use super::{
    AXES, CommonPoint, FiniteComponent, HEIGHT, IntersectionParametrization, PARAMETER,
    UnparametrizedComponent, in_space, lifted, others, projected,
};
use crate::error::{Invariant, Result};
use crate::exact::Rational;
use crate::implicitize::lies_on;
use crate::limits::Limits;
use crate::poly::{
    IntegerPolynomial, PlanePolynomial, RationalFunction, SparsePolynomial, polynomial_gcd,
};
use crate::roots::{RealRoot, real_roots};
use crate::shape::{ImplicitSurface, PlaneCurve, SpaceCurve};

/// The search for the components above the factors of a projection.
pub(super) struct Search<'a> {
    pub(super) surfaces: &'a [ImplicitSurface],
    pub(super) pair: [&'a SparsePolynomial<3>; 2],
    pub(super) limits: &'a Limits,
    pub(super) result: IntersectionParametrization,
}

impl Search<'_> {
    /// Adds what is above one irreducible factor of the projection.
    pub(super) fn add_component(&mut self, factor: &PlanePolynomial) -> Result<()> {
        let [u, w] = others(self.result.axis);
        let projection = SparsePolynomial::from_terms(factor.terms().map(|((i, j), c)| {
            let mut exponents = [0; 3];
            exponents[u] = u32::try_from(i).invariant("a degree is below 2^32");
            exponents[w] = u32::try_from(j).invariant("a degree is below 2^32");
            (exponents, c)
        }));
        let below = match projected(factor) {
            Ok(below) => below,
            Err(reason) => {
                match real_part(&projection, [u, w], self.limits)? {
                    RealPart::Curve => self.add_other(projection, reason),
                    RealPart::Points { known, possible } => {
                        self.add_above(&projection, &known, &possible);
                    }
                }
                return Ok(());
            }
        };
        let lifted = lifted(&below, self.result.axis, self.pair, self.limits)?;
        self.add(lifted.curves);
        for relation in lifted.relations {
            self.add_relation(&below, &projection, &relation)?;
        }
        Ok(())
    }

    /// Adds what is above a parametrized projection where the third coordinate satisfies an irreducible equation of degree at
    /// least 2 over the functions of the parameter.
    fn add_relation(
        &mut self,
        below: &PlaneCurve,
        projection: &SparsePolynomial<3>,
        relation: &SparsePolynomial<3>,
    ) -> Result<()> {
        let (known, possible) = match real_part(relation, [PARAMETER, HEIGHT], self.limits)? {
            RealPart::Curve => {
                let reason = format!(
                    "its projection is rational, and above every point of it there are {} points, whose {} is no rational function of the parameter",
                    relation.degree_in(HEIGHT),
                    AXES[self.result.axis]
                );
                self.add_other(projection.clone(), reason);
                return Ok(());
            }
            RealPart::Points { known, possible } => (known, possible),
        };
        let in_doubles = below.in_doubles();
        let at_infinity = below.point_at_infinity();
        let at_end = at_infinity.iter().flat_map(|end| {
            let heights = real_roots(&leading(relation)).into_iter();
            heights.map(|height| {
                (
                    Some(end.clone()),
                    end.each_ref().map(Rational::to_f64),
                    height,
                )
            })
        });
        let at_others = known.into_iter().map(|[s, height]| {
            let exact = s.as_rational().and_then(|s| below.point(&s));
            (exact, in_doubles.at([s.to_f64(), 1.0]), height)
        });
        let all: Vec<_> = at_others.chain(at_end).collect();
        self.add_finite(projection, all.len());
        for (exact, near, height) in all {
            self.add_point(exact, near, &height);
        }
        for [s, height] in possible {
            self.note_possible(in_doubles.at([s, 1.0]), Some(height));
        }
        Ok(())
    }

    /// Adds what is above the finitely many real points of a component of the projection.
    fn add_above(
        &mut self,
        projection: &SparsePolynomial<3>,
        known: &[[RealRoot; 2]],
        possible: &[[f64; 2]],
    ) {
        let mut found = 0;
        let mut undecided = possible.to_vec();
        for place in known {
            let near = place.each_ref().map(RealRoot::to_f64);
            let [Some(a), Some(b)] = place.each_ref().map(RealRoot::as_rational) else {
                undecided.push(near);
                continue;
            };
            let [u, w] = others(self.result.axis);
            let [f, g] = self
                .pair
                .map(|f| univariate(&at(&at(f, u, &a), w, &b), self.result.axis));
            for height in real_roots(&polynomial_gcd(&f, &g)) {
                found += 1;
                self.add_point(Some([a.clone(), b.clone()]), near, &height);
            }
        }
        self.add_finite(projection, found);
        for near in undecided {
            self.note_possible(near, None);
        }
    }

    fn add_point(&mut self, exact: Option<[Rational; 2]>, near: [f64; 2], height: &RealRoot) {
        let point = match exact.zip(height.as_rational()) {
            Some(([a, b], height)) => {
                CommonPoint::Exact(in_space(self.result.axis, [a, b, height]))
            }
            None => {
                let [a, b] = near;
                CommonPoint::Near(in_space(self.result.axis, [a, b, height.to_f64()]))
            }
        };
        let is_on_all = |rest: &ImplicitSurface| match &point {
            CommonPoint::Exact(point) => rest.polynomial().evaluate(point).is_zero(),
            CommonPoint::Near(_) => true,
        };
        let is_on_curve = |curve: &SpaceCurve| match &point {
            CommonPoint::Exact(point) => passes(curve, point),
            CommonPoint::Near(_) => false,
        };
        if self.surfaces[2..].iter().all(is_on_all)
            && !self.result.points.contains(&point)
            && !self.result.curves.iter().any(is_on_curve)
        {
            self.result.points.push(point);
        }
    }

    fn add_other(&mut self, projection: SparsePolynomial<3>, reason: String) {
        self.result
            .others
            .push(UnparametrizedComponent { projection, reason });
    }

    fn add_finite(&mut self, projection: &SparsePolynomial<3>, points: usize) {
        self.result.finite.push(FiniteComponent {
            projection: projection.clone(),
            points,
        });
    }

    fn note_possible(&mut self, [a, b]: [f64; 2], height: Option<f64>) {
        let [u, w] = others(self.result.axis).map(|v| AXES[v]);
        let height = height.map_or_else(String::new, |h| {
            format!(", {} ≈ {h}", AXES[self.result.axis])
        });
        self.result.notes.push(format!(
            "it is not decided whether there is a common point at {u} ≈ {a}, {w} ≈ {b}{height}"
        ));
    }

    /// Adds those curves that are on all surfaces and not known.
    pub(super) fn add(&mut self, curves: Vec<SpaceCurve>) {
        let rest = &self.surfaces[2..];
        let on_all = curves
            .into_iter()
            .filter(|curve| rest.iter().all(|s| lies_on(curve, s.polynomial())));
        for curve in on_all {
            let is_known = |known: &SpaceCurve| {
                known.coordinates() == curve.coordinates()
                    || half_a_turn_on(known).as_ref() == Some(curve.coordinates())
            };
            if !self.result.curves.iter().any(is_known) {
                self.result.curves.push(curve);
            }
        }
    }
}

/// Whether a curve passes through a point, for a parameter or at infinity.
pub(crate) fn passes(curve: &SpaceCurve, point: &[Rational; 3]) -> bool {
    curve.point_at_infinity().as_ref() == Some(point) || reaches(curve, point)
}

/// Whether a curve passes through a point for a real value of its parameter.
pub(super) fn reaches(curve: &SpaceCurve, point: &[Rational; 3]) -> bool {
    if curve.parameter().is_angle() && curve.point_at_infinity().as_ref() == Some(point) {
        return true;
    }
    // The parameters at which a coordinate f has the value c are the roots of the numerator of f − c.
    let common = curve.coordinates().iter().zip(point).map(|(f, c)| {
        let difference = f.plus_constant(&-c);
        difference.numerator().clone()
    });
    let common = common.reduce(|a, b| polynomial_gcd(&a, &b));
    common.is_some_and(|common| !real_roots(&common).is_empty())
}

/// The coefficient of the highest power of the parameter in a relation, as a polynomial in the third coordinate.
fn leading(relation: &SparsePolynomial<3>) -> IntegerPolynomial {
    let degree = relation.degree_in(PARAMETER);
    let terms = relation.terms().filter(|(e, _)| e[PARAMETER] == degree);
    let leading = SparsePolynomial::from_terms(terms.map(|(e, c)| ([0, e[HEIGHT], 0], c.clone())));
    univariate(&leading, HEIGHT)
}

/// A curve whose parameter is an angle t, as a function of t + π/g instead of t: s = tan(g t/2) becomes −1/s.
fn half_a_turn_on(curve: &SpaceCurve) -> Option<[RationalFunction; 3]> {
    let turned = |f: &RationalFunction| {
        let degree = f.degree();
        let reversed = |p: &IntegerPolynomial| {
            let mut coefficients = p.coefficients_asc().to_vec();
            coefficients.resize(degree + 1, Integer::ZERO);
            for c in coefficients.iter_mut().skip(1).step_by(2) {
                *c = -std::mem::take(c);
            }
            coefficients.reverse();
            IntegerPolynomial::from_coefficients_asc(coefficients)
        };
        RationalFunction::from_integers(reversed(f.numerator()), reversed(f.denominator()))
    };
    if !curve.parameter().is_angle() {
        return None;
    }
    let [x, y, z] = curve.coordinates().each_ref().map(turned);
    Some([x?, y?, z?])
}
