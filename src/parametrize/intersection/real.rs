//! The real points of an irreducible plane curve: a curve, finitely many points, or none.

use crate::error::Result;
use crate::exact::Rational;
use crate::intervals::Field;
use crate::limits::Limits;
use crate::poly::{IntegerPolynomial, IntegerTerms, SparsePolynomial, resultant, resultant_work};
use crate::roots::{RealRoot, between, disjoint, real_roots};

/// The largest number of operations of the discriminant; that many take some tenths of a second.
const MAX_WORK: f64 = 2e8;
/// Signs are compared at the points of a grid with this many steps to either side.
const STEPS: i64 = 3;
/// The number of bits to which irrational coordinates are enclosed.
const BITS: i64 = 80;

/// The real points of an irreducible curve.
#[derive(Debug)]
pub(super) enum RealPart {
    /// Infinitely many, or it was not decided whether there are only finitely many.
    Curve,
    /// Exactly these, and no others but possibly some of those near the other points.
    Points {
        known: Vec<[RealRoot; 2]>,
        possible: Vec<[f64; 2]>,
    },
}

/// Determines the real points of the curve f = 0 in two of the three variables, where f is irreducible over Q.
///
/// Lemma 1. Let D(u) be the product of the discriminant and the leading coefficient of f in w. Between two neighbouring real roots
/// of D the number of real w with f(u, w) = 0 is constant. So if it is 0 at one rational u in each of these intervals, then all
/// real points are above real roots of D, and there are finitely many of them.
/// Law: `a_sum_of_squares_has_its_points`.
///
/// # Errors
/// Those of `limits`.
pub(super) fn real_part(
    f: &SparsePolynomial<3>,
    variables: [usize; 2],
    limits: &Limits,
) -> Result<RealPart> {
    let degrees = variables.map(|v| f.degree_in(v));
    for (v, other) in [(0, 1), (1, 0)] {
        if degrees[other] == 0 {
            // Parallel lines.
            let roots = real_roots(&univariate(f, variables[v]));
            return Ok(if roots.is_empty() {
                none()
            } else {
                RealPart::Curve
            });
        }
    }
    if changes_sign(f, variables) {
        return Ok(RealPart::Curve);
    }
    let [u, w] = variables;
    let Some(above_u) = exceptional(f, [u, w], limits)?.map(disjoint) else {
        return Ok(RealPart::Curve);
    };
    for sample in between(&above_u) {
        limits.check()?;
        if !real_roots(&univariate(&at(f, u, &sample), w)).is_empty() {
            return Ok(RealPart::Curve);
        }
    }
    // All real points are singular, so both coordinates are exceptional ones.
    let Some(above_w) = exceptional(f, [w, u], limits)? else {
        return Ok(RealPart::Curve);
    };
    let mut known: Vec<[RealRoot; 2]> = Vec::new();
    let rational = |roots: &[RealRoot]| -> Vec<(RealRoot, Option<Rational>)> {
        roots.iter().map(|r| (r.clone(), r.as_rational())).collect()
    };
    let (of_u, of_w) = (rational(&above_u), rational(&above_w));
    for (root, value) in &of_u {
        let Some(value) = value else { continue };
        let others = real_roots(&univariate(&at(f, u, value), w));
        known.extend(others.into_iter().map(|other| [root.clone(), other]));
    }
    let irrational = |(_, value): &&(RealRoot, Option<Rational>)| value.is_none();
    for (root, value) in &of_w {
        let Some(value) = value else { continue };
        let others = real_roots(&univariate(&at(f, w, value), u));
        let new = others.into_iter().filter(|r| r.as_rational().is_none());
        known.extend(new.map(|other| [other, root.clone()]));
    }
    let field = Field::new(f);
    let mut possible = Vec::new();
    for (a, _) in of_u.iter().filter(irrational) {
        for (b, _) in of_w.iter().filter(irrational) {
            let near = [a, b].map(|root| {
                let mut root = root.clone();
                root.refine(BITS);
                root.to_f64()
            });
            let (mut middle, mut halves) = ([0.0; 3], [0.0; 3]);
            for (v, x) in variables.into_iter().zip(near) {
                middle[v] = x;
                // A correctly rounded number is off by less than its distance to the next one.
                halves[v] = x.abs().next_up() - x.abs();
            }
            if !field.on_box(middle, halves).is_empty() {
                possible.push(near);
            }
        }
    }
    Ok(RealPart::Points { known, possible })
}

/// No real point.
fn none() -> RealPart {
    RealPart::Points {
        known: Vec::new(),
        possible: Vec::new(),
    }
}

/// Whether f has both signs. Then its real points separate the plane, so there are infinitely many.
fn changes_sign(f: &SparsePolynomial<3>, [u, w]: [usize; 2]) -> bool {
    let mut signs = (-STEPS..=STEPS).flat_map(|i| (-STEPS..=STEPS).map(move |j| [i, j]));
    let mut seen = [false; 2];
    signs.any(|[i, j]| {
        let mut point = [0, 1, 2].map(|_| Rational::zero());
        point[u] = Rational::from(i);
        point[w] = Rational::from(j);
        match f.evaluate(&point).signum() {
            0 => {}
            sign => seen[usize::from(sign > 0)] = true,
        }
        seen == [true; 2]
    })
}

/// The real roots of the discriminant and of the leading coefficient in w; `None` if these take too much work.
fn exceptional(
    f: &SparsePolynomial<3>,
    [u, w]: [usize; 2],
    limits: &Limits,
) -> Result<Option<Vec<RealRoot>>> {
    let slope = f.derivative(w);
    if resultant_work(f, &slope, w) > MAX_WORK {
        return Ok(None);
    }
    // The resultant has the leading coefficient as a factor.
    let product = univariate(&resultant(f, &slope, w, limits)?, u);
    if product == IntegerPolynomial::default() {
        return Ok(None);
    }
    Ok(Some(real_roots(&product)))
}

/// The polynomial with a number for one of its variables.
pub(super) fn at(f: &SparsePolynomial<3>, v: usize, value: &Rational) -> SparsePolynomial<3> {
    let powers: Vec<Rational> = {
        let degree = f.degree_in(v) as usize;
        let all = std::iter::successors(Some(Rational::one()), |power| Some(power * value));
        all.take(degree + 1).collect()
    };
    SparsePolynomial::from_terms(f.terms().map(|(e, c)| {
        let mut rest = *e;
        rest[v] = 0;
        (rest, c * &powers[e[v] as usize])
    }))
}

/// A positive or negative multiple of a polynomial in one variable, with integer coefficients.
pub(super) fn univariate(f: &SparsePolynomial<3>, v: usize) -> IntegerPolynomial {
    if f.is_empty() {
        return IntegerPolynomial::default();
    }
    IntegerTerms::of_numerators(&f.primitive()).to_univariate(v)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::poly::Ring;
    use proptest::prelude::*;

    fn of(f: &SparsePolynomial<3>) -> RealPart {
        real_part(f, [0, 1], &Limits::none()).expect("no limit")
    }

    fn plane(terms: &[(u32, u32, i64)]) -> SparsePolynomial<3> {
        let terms = terms.iter();
        SparsePolynomial::from_terms(terms.map(|&(i, j, c)| ([i, j, 0], Rational::from(c))))
    }

    #[test]
    fn curves_points_and_nothing_are_told_apart() {
        // Circles: real, without real points, and very small.
        assert!(matches!(
            of(&plane(&[(2, 0, 1), (0, 2, 1), (0, 0, -1)])),
            RealPart::Curve
        ));
        let complex = of(&plane(&[(2, 0, 1), (0, 2, 1), (0, 0, 1)]));
        assert!(
            matches!(complex, RealPart::Points { known, possible } if known.is_empty() && possible.is_empty())
        );
        let small = plane(&[(2, 0, 49), (1, 0, -7), (0, 2, 49), (0, 1, -7)]);
        let circle = small
            .scaled(&Rational::from(100))
            .plus(&plane(&[(0, 0, 49)]));
        assert!(matches!(of(&circle), RealPart::Curve));
        // x² − 2 and y with both signs of the root: two points with an irrational coordinate.
        let square = plane(&[(2, 0, 1), (0, 0, -2)]).squared();
        let two = of(&square.plus(&plane(&[(0, 2, 1)])));
        let RealPart::Points { known, possible } = two else {
            panic!("these are points");
        };
        assert_eq!((known.len(), possible.len()), (2, 0));
    }

    proptest! {
        #![proptest_config(ProptestConfig { cases: 32, ..ProptestConfig::default() })]

        /// Lemma 1: the real points of p² + 3 q² are the common zeros of p and q, here of a parabola and a line.
        #[test]
        fn a_sum_of_squares_has_its_points(a in -3i64..4, b in -3i64..4, c in -3i64..4) {
            let p = plane(&[(0, 1, 1), (2, 0, -1)]);
            let q = plane(&[(1, 0, a), (0, 1, 1), (0, 0, b * c)]);
            let f = p.squared().plus(&q.squared().scaled(&Rational::from(3)));
            let RealPart::Points { known, possible } = of(&f) else {
                return Err(TestCaseError::fail("there are finitely many points"));
            };
            // x² + a x + b c = 0
            let discriminant = a * a - 4 * b * c;
            let expected = match discriminant.signum() { -1 => 0, 0 => 1, _ => 2 };
            prop_assert!(known.len() <= expected && known.len() + possible.len() >= expected);
            let rational = |d: i64| (0..=d).any(|r| r * r == d);
            if rational(discriminant) {
                prop_assert_eq!((known.len(), possible.len()), (expected, 0));
            }
        }
    }
}
