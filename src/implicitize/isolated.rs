//! Isolated real points of a curve: those of two conjugate complex parameters.

use malachite::Integer;
use malachite::base::num::basic::traits::Zero;
use malachite::base::polynomial::Polynomial;

use super::tracing::difference;
use crate::error::Result;
use crate::exact::Rational;
use crate::limits::Limits;
use crate::poly::{
    IntegerPolynomial, RationalFunction, RealRoot, Ring, SparsePolynomial, divide_exactly,
    polynomial_gcd, real_roots, resultant,
};

/// Pairs of parameters with the same point, up to which they are looked for: about a second of work.
const MAX_PAIRS: usize = 64;

/// The isolated real points that were found.
#[derive(Clone, Debug, PartialEq)]
pub struct Isolated<const N: usize> {
    /// Exact where rational, else rounded.
    pub points: Vec<IsolatedPoint<N>>,
    /// Whether there are no others.
    pub complete: bool,
}

impl<const N: usize> Isolated<N> {
    fn add(&mut self, point: Option<IsolatedPoint<N>>) {
        let new = point.filter(|p| !self.points.contains(p));
        self.points.extend(new);
    }
}

/// An isolated real point.
#[derive(Clone, Debug, PartialEq)]
pub enum IsolatedPoint<const N: usize> {
    /// With rational coordinates.
    Exact([Rational; N]),
    /// Its coordinates, rounded.
    Near([f64; N]),
}

/// The isolated points of a curve that is run over once; incomplete if the degrees are large.
pub(super) fn isolated<const N: usize>(
    coordinates: &[RationalFunction; N],
    limits: &Limits,
) -> Result<Isolated<N>> {
    let none = Isolated {
        points: Vec::new(),
        complete: true,
    };
    let [Some(a), Some(b)] = [0, 1].map(|k| coordinates.get(k)) else {
        return Ok(none);
    };
    if a.degree() < 2 || b.degree() < 2 {
        // Different parameters have different points.
        return Ok(none);
    }
    if (a.degree() - 1) * (b.degree() - 1) > MAX_PAIRS {
        return Ok(Isolated {
            complete: false,
            ..none
        });
    }
    let [a, b] = [a, b].map(|f| in_sum_and_product(&divided_by_difference(&difference(f))));
    let eliminated = resultant(&a, &b, 1, limits)?;
    let mut found = none;
    let mut common: Option<CommonZero> = None;
    for sum in real_roots(&to_univariate(&eliminated, 0)) {
        limits.check()?;
        let Some(sum) = sum.as_rational() else {
            let common = common.get_or_insert_with(|| CommonZero::new(&a, &b));
            match irrational_pair(coordinates, &sum, common) {
                Some(point) => found.add(point),
                None => found.complete = false,
            }
            continue;
        };
        let [a, b] = [&a, &b].map(|f| at_sum(f, &sum));
        for product in real_roots(&polynomial_gcd(&a, &b)) {
            let quarter = &sum * &sum / Rational::from(4);
            // (s + σ)² < 4sσ
            if product.cmp_rational(&quarter).is_gt() {
                let is_zero = |f: &SparsePolynomial<3>| {
                    let f = at_sum(f, &sum);
                    f == IntegerPolynomial::ZERO || product.is_root_of(&f)
                };
                let near = [sum.clone(), middle(&product)];
                found.add(conjugate_point(coordinates, is_zero, near));
            }
        }
    }
    Ok(found)
}

/// f/(s − σ), for an f that vanishes at s = σ: by synthetic division in s.
fn divided_by_difference(f: &SparsePolynomial<2>) -> SparsePolynomial<2> {
    let degree = f.terms().map(|(e, _)| e[0]).max().unwrap_or(0);
    let mut quotient = SparsePolynomial::zero();
    let mut carried = SparsePolynomial::<2>::zero();
    let sigma = SparsePolynomial::variable(1);
    for k in (1..=degree).rev() {
        let here = f.terms().filter(|(e, _)| e[0] == k);
        let here = SparsePolynomial::from_terms(here.map(|(e, c)| ([0, e[1]], c.clone())));
        carried = carried.times(&sigma).plus(&here);
        for (e, c) in carried.terms() {
            quotient.add_term([k - 1, e[1]], c.clone());
        }
    }
    quotient
}

/// A symmetric polynomial in s and σ as a polynomial in S = s + σ and P = sσ, the first two of three variables.
///
/// `s^a σ^b + s^b σ^a = P^b (s^(a−b) + σ^(a−b))`, and Newton's `p_k = S p_(k−1) − P p_(k−2)` for these sums of powers.
fn in_sum_and_product(f: &SparsePolynomial<2>) -> SparsePolynomial<3> {
    let [sum, product] = [0, 1].map(SparsePolynomial::<3>::variable);
    let degree = f.terms().map(|(e, _)| e[0]).max().unwrap_or(0) as usize;
    let mut powers = vec![SparsePolynomial::constant(Rational::from(2)), sum.clone()];
    for k in 2..=degree {
        let next = sum
            .times(&powers[k - 1])
            .minus(&product.times(&powers[k - 2]));
        powers.push(next);
    }
    let mut result = SparsePolynomial::zero();
    for (&[a, b], c) in f.terms().filter(|(e, _)| e[0] >= e[1]) {
        let terms = powers[(a - b) as usize].terms();
        // The sum of powers 0 counts the one term s^a σ^a twice.
        let c = if a == b {
            c / &Rational::from(2)
        } else {
            c.clone()
        };
        for (e, power) in terms {
            result.add_term([e[0], e[1] + b, 0], power * &c);
        }
    }
    result
}

/// With a value of s + σ, as a polynomial in sσ.
fn at_sum(f: &SparsePolynomial<3>, sum: &Rational) -> IntegerPolynomial {
    let mut value = SparsePolynomial::zero();
    for (e, c) in f.terms() {
        let power = sum.pow(i64::from(e[0])).unwrap_or_default();
        value.add_term([0, e[1], 0], c * &power);
    }
    to_univariate(&value, 1)
}

fn to_univariate(f: &SparsePolynomial<3>, variable: usize) -> IntegerPolynomial {
    let f = f.primitive();
    to_univariate_as_is(f.terms().map(|(e, c)| (e[variable], c.numerator())))
}

pub(super) fn to_univariate_as_is(
    terms: impl Iterator<Item = (u32, Integer)>,
) -> IntegerPolynomial {
    let mut coefficients = Vec::new();
    for (k, c) in terms {
        let k = k as usize;
        if coefficients.len() <= k {
            coefficients.resize(k + 1, Integer::ZERO);
        }
        coefficients[k] = c;
    }
    IntegerPolynomial::from_coefficients_asc(coefficients)
}

/// The point of the two roots of s² − S s + P, where `is_zero` decides whether a polynomial in S and P is zero
/// there, and S and P are known to about 200 bits; `None` if they are poles.
fn conjugate_point<const N: usize>(
    coordinates: &[RationalFunction; N],
    is_zero: impl Fn(&SparsePolynomial<3>) -> bool,
    near: [Rational; 2],
) -> Option<IsolatedPoint<N>> {
    let [sum, product] = near;
    let place = [sum, product, Rational::zero()];
    let mut exact = std::array::from_fn(|_| None);
    let mut rounded = [0.0; N];
    for (k, f) in coordinates.iter().enumerate() {
        let [[a, b], [c, d]] = [f.numerator(), f.denominator()].map(modulo);
        // (a + b s)/(c + d s) is a real number x: a = x c, b = x d.
        let (above, below) = match (is_zero(&c), is_zero(&d)) {
            (true, true) => return None,
            (true, false) => (b, d),
            (false, _) => (a, c),
        };
        let value = above.evaluate(&place) * below.evaluate(&place).recip()?;
        // If it is rational it is the simplest number near by.
        let width = Rational::from_parts(Integer::from(1), -80);
        let simple = Rational::simplest_between(&(&value - &width), &(&value + &width));
        exact[k] = is_zero(&above.minus(&below.scaled(&simple))).then_some(simple);
        rounded[k] = value.to_f64();
    }
    Some(match exact.iter().all(Option::is_some) {
        true => IsolatedPoint::Exact(exact.map(Option::unwrap_or_default)),
        false => IsolatedPoint::Near(rounded),
    })
}

/// f modulo s² − S s + P as u + v s: polynomials in S and P, the first two of three variables.
fn modulo(f: &IntegerPolynomial) -> [SparsePolynomial<3>; 2] {
    let [sum, product] = [0, 1].map(SparsePolynomial::<3>::variable);
    let zero = SparsePolynomial::zero;
    let coefficients = f.coefficients_asc().iter().rev();
    coefficients.fold([zero(), zero()], |[u, v], c| {
        // (u + v s) s = −v P + (u + v S) s
        let constant = SparsePolynomial::constant(Rational::from(c));
        [constant.minus(&v.times(&product)), u.plus(&v.times(&sum))]
    })
}

/// The middle of an enclosure of about 200 bits.
fn middle(root: &RealRoot) -> Rational {
    let mut root = root.clone();
    root.refine(200);
    let (low, high) = root.bounds();
    (low.to_rational() + high.to_rational()) / Rational::from(2)
}

fn at_rational(f: &IntegerPolynomial, at: &Rational) -> Rational {
    let coefficients = f.coefficients_asc().iter().rev();
    coefficients.fold(Rational::zero(), |v, c| v * at + Rational::from(c))
}

/// above/below of two polynomials in s + σ.
type Fraction = [IntegerPolynomial; 2];

/// The common zero of a and b for a general zero s + σ of their resultant.
struct CommonZero {
    /// sσ
    product: Fraction,
    /// a and b there, cleared of denominators: the same polynomials for every zero s + σ.
    values: [IntegerPolynomial; 2],
}

impl CommonZero {
    fn new(a: &SparsePolynomial<3>, b: &SparsePolynomial<3>) -> Self {
        let product = last_linear_remainder(a, b);
        let values = [a, b].map(|f| at_product(f, &product));
        Self { product, values }
    }
}

/// `f(s + σ, above/below) below^degree`
fn at_product(f: &SparsePolynomial<3>, [above, below]: &Fraction) -> IntegerPolynomial {
    let degree = f.terms().map(|(e, _)| e[1]).max().unwrap_or(0);
    let f = f.primitive();
    let mut value = IntegerPolynomial::ZERO;
    let mut power = IntegerPolynomial::one();
    for k in (0..=degree).rev() {
        let row = f.terms().filter(|(e, _)| e[1] == k);
        let row = to_univariate_as_is(row.map(|(e, c)| (e[0], c.numerator())));
        value = value * above + row * &power;
        if k > 0 {
            power *= below;
        }
    }
    value
}

/// sσ where s + σ is a general zero of the resultant of a and b: from the last linear remainder of Euclid's
/// algorithm in sσ, contents left out.
fn last_linear_remainder(a: &SparsePolynomial<3>, b: &SparsePolynomial<3>) -> Fraction {
    let rows = |f: &SparsePolynomial<3>| -> Vec<IntegerPolynomial> {
        let f = f.primitive();
        let degree = f.terms().map(|(e, _)| e[1]).max().unwrap_or(0);
        let row = |k: u32| f.terms().filter(move |(e, _)| e[1] == k);
        let row = |k| to_univariate_as_is(row(k).map(|(e, c)| (e[0], c.numerator())));
        (0..=degree).map(row).collect()
    };
    let (mut f, mut g) = (rows(a), rows(b));
    if f.len() < g.len() {
        std::mem::swap(&mut f, &mut g);
    }
    while g.len() > 2 {
        let rest = remainder(f, &g);
        f = std::mem::replace(&mut g, rest);
    }
    match <[IntegerPolynomial; 2]>::try_from(g) {
        Ok([constant, linear]) => [IntegerPolynomial::ZERO - constant, linear],
        Err(_) => [IntegerPolynomial::ZERO, IntegerPolynomial::ZERO],
    }
}

/// A multiple of the remainder of f by g, polynomials with polynomial coefficients, without content.
fn remainder(mut f: Vec<IntegerPolynomial>, g: &[IntegerPolynomial]) -> Vec<IntegerPolynomial> {
    let Some(lead) = g.last() else {
        return Vec::new();
    };
    while f.len() >= g.len() {
        let top = f.pop().unwrap_or_default();
        let start = f.len() + 1 - g.len();
        for c in &mut f {
            *c *= lead;
        }
        for (c, other) in f[start..].iter_mut().zip(g) {
            *c -= &top * other;
        }
    }
    while f.last() == Some(&IntegerPolynomial::ZERO) {
        f.pop();
    }
    let content = f
        .iter()
        .fold(IntegerPolynomial::ZERO, |g, c| polynomial_gcd(&g, c));
    f.iter()
        .map(|c| divide_exactly(c, &content).unwrap_or_else(|| c.clone()))
        .collect()
}

/// The isolated point, if there is one, of the one common zero of a and b where s + σ is a simple irrational zero of
/// their resultant; `None` if that is not decided.
fn irrational_pair<const N: usize>(
    coordinates: &[RationalFunction; N],
    sum: &RealRoot,
    common: &CommonZero,
) -> Option<Option<IsolatedPoint<N>>> {
    let [above, below] = &common.product;
    let is_zero = |p: &IntegerPolynomial| *p == IntegerPolynomial::ZERO || sum.is_root_of(p);
    if sum.multiplicity() > 1 || is_zero(below) || !common.values.iter().all(is_zero) {
        return None;
    }
    // (s + σ)² < 4sσ
    let square = IntegerPolynomial::from_coefficients_asc(vec![0.into(), 0.into(), 1.into()]);
    let four = IntegerPolynomial::from_coefficients_asc(vec![4.into()]);
    let discriminant = square * below * below - four * above * below;
    if sum.sign_of(&discriminant) >= 0 {
        return Some(None);
    }
    let near = middle(sum);
    let product = at_rational(above, &near) * at_rational(below, &near).recip()?;
    let vanishes = |f: &SparsePolynomial<3>| is_zero(&at_product(f, &common.product));
    Some(conjugate_point(coordinates, vanishes, [near, product]))
}
