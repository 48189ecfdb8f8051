//! Straight lines parallel to the axis of projection: the components of an intersection that a projection shows as points.

use malachite::base::polynomial::Polynomial;

use super::real::{at, univariate};
use super::{AXES, UnparametrizedComponent, linear, others};
use crate::error::Result;
use crate::exact::Rational;
use crate::factor::factor_univariate;
use crate::limits::Limits;
use crate::poly::{IntegerPolynomial, SparsePolynomial, polynomial_gcd, resultant};
use crate::roots::{RealRoot, real_roots};
use crate::shape::{Parameter, SpaceCurve};

/// The lines that are on both surfaces.
#[derive(Debug, Default)]
pub(super) struct Lines {
    /// Those through rational points.
    pub(super) curves: Vec<SpaceCurve>,
    /// The others.
    pub(super) others: Vec<UnparametrizedComponent>,
    /// What is not decided.
    pub(super) notes: Vec<String>,
}

/// Multipliers for two combinations of the coefficients; they are tried until the combinations have no common factor.
const MULTIPLIERS: [[i64; 2]; 4] = [[1, -1], [2, -3], [5, 7], [-11, 13]];

/// Finds the lines parallel to an axis on both surfaces, which have no surface in common.
///
/// Lemma 2. The line over (u, w) is on the surface f = 0 if and only if all coefficients of f, as a polynomial in the third
/// coordinate, vanish at (u, w). The coefficients of two polynomials without a common factor have finitely many common zeros.
/// Law: `lines_parallel_to_an_axis_come_back`.
///
/// # Errors
/// Those of `limits`.
pub(super) fn lines(
    axis: usize,
    pair: [&SparsePolynomial<3>; 2],
    limits: &Limits,
) -> Result<Lines> {
    let coefficients: Vec<SparsePolynomial<3>> =
        pair.iter().flat_map(|f| coefficients(f, axis)).collect();
    let mut found = Lines::default();
    if coefficients.iter().any(|c| c.degree() == Some(0)) {
        return Ok(found);
    }
    let [u, w] = others(axis);
    let over = [[u, w], [w, u]].map(|plane| eliminant(&coefficients, plane, limits));
    let [over_u, over_w] = over;
    let (Some(over_u), Some(over_w)) = (over_u?, over_w?) else {
        found.notes.push(format!(
            "straight lines parallel to the {} axis are not looked for",
            AXES[axis]
        ));
        return Ok(found);
    };
    let (rational_u, other_u) = roots(&over_u, limits)?;
    let (rational_w, other_w) = roots(&over_w, limits)?;
    for value in &rational_u {
        let common = common(&coefficients, u, value, w);
        let (rational, irrational) = roots(&common, limits)?;
        for other in rational {
            found.curves.push(line(axis, [value, &other]));
        }
        found.add_irrational(axis, [u, w], value, &irrational);
    }
    for value in &rational_w {
        let common = common(&coefficients, w, value, u);
        let (_, irrational) = roots(&common, limits)?;
        found.add_irrational(axis, [w, u], value, &irrational);
    }
    let is_real = |f: &IntegerPolynomial| !real_roots(f).is_empty();
    if other_u.iter().any(is_real) && other_w.iter().any(is_real) {
        found.notes.push(format!(
            "straight lines parallel to the {} axis through points with two irrational coordinates are not looked for",
            AXES[axis]
        ));
    }
    Ok(found)
}

impl Lines {
    /// Adds the lines over the points where the first of two coordinates is rational and the second one is a root.
    fn add_irrational(
        &mut self,
        axis: usize,
        [u, w]: [usize; 2],
        value: &Rational,
        factors: &[IntegerPolynomial],
    ) {
        for factor in factors {
            let all: Vec<String> = real_roots(factor).iter().map(decimal).collect();
            if all.is_empty() {
                continue;
            }
            let projection =
                SparsePolynomial::from_terms((0..).zip(factor.coefficients_asc()).map(|(k, c)| {
                    let mut e = [0; 3];
                    e[w] = k;
                    (e, Rational::whole(c))
                }));
            self.others.push(UnparametrizedComponent {
                projection,
                reason: format!(
                    "straight lines parallel to the {} axis with {} = {value} and {} ≈ {}, which is irrational",
                    AXES[axis],
                    AXES[u],
                    AXES[w],
                    all.join(", ")
                ),
            });
        }
    }
}

fn decimal(root: &RealRoot) -> String {
    root.to_decimal(6)
}

/// The line over a rational point.
fn line(axis: usize, [a, b]: [&Rational; 2]) -> SpaceCurve {
    let constant = |c: &Rational| linear(&Rational::zero(), c);
    let [u, w] = others(axis);
    let mut coordinates = [0, 1, 2].map(|_| linear(&Rational::one(), &Rational::zero()));
    coordinates[u] = constant(a);
    coordinates[w] = constant(b);
    SpaceCurve::new(Parameter::number("t"), coordinates)
}

/// The coefficients of the powers of one variable, without those that are 0.
fn coefficients(f: &SparsePolynomial<3>, axis: usize) -> Vec<SparsePolynomial<3>> {
    let mut all = vec![SparsePolynomial::zero(); f.degree_in(axis) as usize + 1];
    for (e, c) in f.terms() {
        let mut rest = *e;
        rest[axis] = 0;
        all[e[axis] as usize].add_term(rest, c.clone());
    }
    all.retain(|c| !c.is_empty());
    all
}

/// A polynomial in u, not 0, that vanishes at all common zeros of polynomials in u and w; `None` if no two combinations of them
/// without a common factor were found.
fn eliminant(
    polynomials: &[SparsePolynomial<3>],
    [u, w]: [usize; 2],
    limits: &Limits,
) -> Result<Option<IntegerPolynomial>> {
    if let Some(free) = polynomials.iter().find(|f| f.degree_in(w) == 0) {
        return Ok(Some(univariate(free, u)));
    }
    for multipliers in MULTIPLIERS {
        let [first, second] = multipliers.map(|m| {
            let mut sum = SparsePolynomial::zero();
            let mut factor = Rational::one();
            for f in polynomials {
                sum.add_multiple(f, &factor);
                factor = factor * Rational::from(m);
            }
            sum
        });
        let eliminated = univariate(&resultant(&first, &second, w, limits)?, u);
        if eliminated != IntegerPolynomial::default() {
            return Ok(Some(eliminated));
        }
    }
    Ok(None)
}

/// The polynomial in w whose roots are the common zeros with this value of u.
fn common(
    polynomials: &[SparsePolynomial<3>],
    u: usize,
    value: &Rational,
    w: usize,
) -> IntegerPolynomial {
    let all = polynomials.iter().map(|f| univariate(&at(f, u, value), w));
    all.reduce(|a, b| polynomial_gcd(&a, &b))
        .unwrap_or_default()
}

/// The rational roots of a polynomial, and its irreducible factors of higher degree.
fn roots(
    f: &IntegerPolynomial,
    limits: &Limits,
) -> Result<(Vec<Rational>, Vec<IntegerPolynomial>)> {
    let (mut rational, mut others) = (Vec::new(), Vec::new());
    if f.degree().is_none_or(|degree| degree == 0) {
        return Ok((rational, others));
    }
    let coefficients: Vec<Rational> = f.coefficients_asc().iter().map(Rational::whole).collect();
    for factor in factor_univariate(&coefficients, limits)?.factors {
        match &factor.polynomial[..] {
            [b, a] => rational.push(-b.clone() / a.clone()),
            all => {
                let numerators = all.iter().map(Rational::numerator).collect();
                others.push(IntegerPolynomial::from_coefficients_asc(numerators));
            }
        }
    }
    Ok((rational, others))
}
