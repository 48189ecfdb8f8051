//! The asymptotes of a plane curve.

use super::extent::{CriticalValues, exchanged};
use super::fibre::narrow;
use crate::error::Invariant;
use crate::exact::Rational;
use crate::poly::{IntegerPolynomial, PlanePolynomial, coefficients};
use crate::roots::{RealRoot, real_roots};
use malachite::base::num::basic::traits::Zero;
use malachite::base::polynomial::Derivative;

/// A straight line that a real branch of the curve approaches far away from the origin.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub struct Asymptote {
    /// The slope dy/dx; `None` for a vertical line.
    pub slope: Option<RealRoot>,
    /// y at x = 0, or x for a vertical line, within bounds; both are equal if it is known exactly.
    pub intercept: [Rational; 2],
}

/// The directions in which the curve goes to infinity, and its asymptotes there.
#[derive(Clone, Debug, Default)]
#[non_exhaustive]
pub struct AtInfinity {
    /// The asymptotes, by ascending slopes; vertical ones are last.
    pub asymptotes: Vec<Asymptote>,
    /// The irrational slopes of real points at infinity at which the asymptotes are not decided, because the line at infinity
    /// touches the curve there or the point is singular.
    pub undecided: Vec<RealRoot>,
}

/// The width of the enclosures of irrational intercepts, as a power of two.
const INTERCEPT_BITS: i64 = -64;

/// The asymptotes of the curve f = 0, where f is squarefree.
///
/// With f = Σ f_d: at a simple zero τ of f_n(1, t), the branch approaches y = τx + c with c = −f_(n−1)(1, τ)/f_n′(1, τ). At a multiple
/// rational zero, f(x, τx + c) is a polynomial in x whose first coefficient that is not 0 is a polynomial q in c. Branches approach
/// the lines of the zeros c of q; if q is constant, the branches are parabolic. A branch at a real c is real if, for all large x, some
/// real y is near τx + c: beyond all critical values of x and all x at which the curve crosses the lines through both ends of an
/// interval around c, the number of real y between these lines is constant.
pub(super) fn at_infinity(f: &PlanePolynomial, critical: &[CriticalValues; 2]) -> AtInfinity {
    let mut found = AtInfinity::default();
    let degree = f.degree().invariant("the polynomial is not 0");
    let empty = IntegerPolynomial::ZERO;
    let part = |d: Option<usize>| {
        d.and_then(|d| f.part(d))
            .map_or(&empty, |form| form.dehomogenized())
    };
    let top = part(Some(degree));
    let next = part(degree.checked_sub(1));
    for slope in real_roots(top) {
        if slope.multiplicity() == 1 {
            let intercept = quotient(next, &top.derivative(), &slope);
            found.asymptotes.push(Asymptote {
                slope: Some(slope),
                intercept,
            });
        } else {
            match slope.as_rational() {
                Some(rational) => {
                    found.add(f, Some(&slope), &rational, &critical[0]);
                }
                None => found.undecided.push(slope),
            }
        }
    }
    // The vertical direction is a zero of f_n(0, 1).
    let lost = degree + 1 - top.coefficients_asc().len();
    if lost > 0 {
        found.add(&exchanged(f), None, &Rational::zero(), &critical[1]);
    }
    found
}

impl AtInfinity {
    /// Adds the asymptotes of a rational slope.
    fn add(
        &mut self,
        f: &PlanePolynomial,
        slope: Option<&RealRoot>,
        tangent: &Rational,
        critical: &CriticalValues,
    ) {
        let rows = parallel(f, tangent);
        let intercepts = zeros_of_first(&rows);
        for mut c in intercepts.clone() {
            if c.multiplicity() > 1 && !has_real_branch(&rows, &c, &intercepts, critical) {
                continue;
            }
            let bounds = match c.as_rational() {
                Some(c) => [c.clone(), c],
                None => {
                    c.refine_to_width(INTERCEPT_BITS);
                    let (low, high) = c.bounds();
                    [low, high]
                }
            };
            self.asymptotes.push(Asymptote {
                slope: slope.cloned(),
                intercept: bounds,
            });
        }
    }
}

/// f(x, τx + c), as a list of polynomials in c for the powers of x.
fn parallel(f: &PlanePolynomial, slope: &Rational) -> Vec<Vec<Rational>> {
    let degree = f.degree().invariant("the polynomial is not 0");
    let mut rows: Vec<Vec<Rational>> = vec![Vec::new(); degree + 1];
    for ((i, j), coefficient) in f.terms() {
        let mut binomial = Rational::one();
        for k in 0..=j {
            // C(j, k) (τx)^(j−k) c^k x^i
            let power = slope.pow(i64::try_from(j - k).invariant("a degree is small"));
            let power = power.invariant("a natural power exists");
            let row = &mut rows[i + j - k];
            if row.len() <= k {
                row.resize(k + 1, Rational::zero());
            }
            row[k] = &row[k] + &(&coefficient * &(&binomial * &power));
            binomial = binomial * Rational::from(i64::try_from(j - k).invariant("small"))
                / Rational::from(i64::try_from(k + 1).invariant("small"));
        }
    }
    rows
}

/// The real zeros of the coefficient of the highest power of x.
fn zeros_of_first(rows: &[Vec<Rational>]) -> Vec<RealRoot> {
    let first = rows.iter().rfind(|row| row.iter().any(|c| !c.is_zero()));
    first.map_or_else(Vec::new, |row| RealRoot::all_of(row))
}

/// Whether a real branch of Σ rows_j(c) x^j = 0 approaches the line of this c, one of the zeros of the first coefficient, as x goes
/// to ∞ or to −∞.
fn has_real_branch(
    rows: &[Vec<Rational>],
    c: &RealRoot,
    zeros: &[RealRoot],
    critical: &CriticalValues,
) -> bool {
    // An interval with c inside and no other zero of the first coefficient, whose ends are no zeros.
    let (low, high) = match c.as_rational() {
        None => {
            // No end may be another zero.
            let mut c = c.clone();
            loop {
                let (low, high) = c.bounds();
                let is_end =
                    |r: &RealRoot| r.cmp_rational(&low).is_eq() || r.cmp_rational(&high).is_eq();
                if !zeros.iter().any(is_end) {
                    break (low, high);
                }
                narrow(&mut c, 4);
            }
        }
        Some(exact) => {
            let (mut low, mut high) = (&exact - &Rational::one(), &exact + &Rational::one());
            let quarter = Rational::one() / Rational::from(4);
            while zeros
                .iter()
                .filter(|r| r.cmp_rational(&low).is_ge() && r.cmp_rational(&high).is_le())
                .count()
                > 1
            {
                low = &exact + &((&low - &exact) * &quarter);
                high = &exact + &((&high - &exact) * &quarter);
            }
            (low, high)
        }
    };
    let value = |row: &Vec<Rational>, c: &Rational| {
        row.iter().rev().fold(Rational::zero(), |v, a| v * c + a)
    };
    let crossings = [&low, &high]
        .map(|c| RealRoot::all_of(&rows.iter().map(|row| value(row, c)).collect::<Vec<_>>()));
    let all = crossings.iter().flatten().chain(&critical.values);
    let far = all
        .map(|root| {
            let (a, b) = root.bounds();
            a.abs().max(b.abs())
        })
        .max()
        .unwrap_or_else(Rational::zero);
    let far = far.floor() + Rational::from(2);
    [far.clone(), -far].iter().any(|x| {
        let degree = rows.iter().map(Vec::len).max().unwrap_or(0);
        // Σ_j rows_j(c) x^j as a polynomial in c
        let mut at_x = vec![Rational::zero(); degree];
        for row in rows.iter().rev() {
            for (k, sum) in at_x.iter_mut().enumerate() {
                *sum = &*sum * x;
                if let Some(a) = row.get(k) {
                    *sum = &*sum + a;
                }
            }
        }
        let roots = RealRoot::all_of(&at_x);
        roots
            .iter()
            .any(|r| r.cmp_rational(&low).is_gt() && r.cmp_rational(&high).is_lt())
    })
}

/// −g(τ)/h(τ) within bounds, for h(τ) ≠ 0.
fn quotient(g: &IntegerPolynomial, h: &IntegerPolynomial, at: &RealRoot) -> [Rational; 2] {
    if let Some(t) = at.as_rational() {
        let value = |f: &IntegerPolynomial| {
            let terms = coefficients(f);
            terms.iter().rev().fold(Rational::zero(), |v, c| v * &t + c)
        };
        let c = -(value(g) / value(h));
        return [c.clone(), c];
    }
    let mut root = at.clone();
    let width = Rational::one() / Rational::from(2).pow(-INTERCEPT_BITS).invariant("small");
    let mut bits = 64;
    loop {
        root.refine_to_width(-bits);
        let (low, high) = root.bounds();
        let above = super::strip::range(g, &low, &high);
        let below = super::strip::range(h, &low, &high);
        if below.0.signum() * below.1.signum() > 0 {
            let mut ends: Vec<Rational> = [&above.0, &above.1]
                .into_iter()
                .flat_map(|a| [&below.0, &below.1].map(|b| -(a / b)))
                .collect();
            ends.sort_unstable();
            let (first, last) = (ends[0].clone(), ends[3].clone());
            if &last - &first < width {
                return [first, last];
            }
        }
        bits *= 2;
    }
}

#[cfg(test)]
mod tests {
    use super::super::extent::Axis;
    use super::*;
    use crate::limits::Limits;

    fn found(terms: &[((usize, usize), i64)]) -> AtInfinity {
        let terms = terms.iter().map(|&(e, c)| (e, Rational::from(c)));
        let f = PlanePolynomial::from_terms(terms);
        let critical =
            [Axis::X, Axis::Y].map(|axis| CriticalValues::new(&f, axis, &Limits::none()).unwrap());
        at_infinity(&f, &critical)
    }

    #[test]
    fn hyperbolas_and_parabolas() {
        // x y = 1: both axes
        let lines = found(&[((1, 1), 1), ((0, 0), -1)]).asymptotes;
        assert_eq!(lines.len(), 2);
        assert!(lines[1].slope.is_none());
        // y = x²: none
        assert!(found(&[((2, 0), 1), ((0, 1), -1)]).asymptotes.is_empty());
        // The folium x³ + y³ = 3xy approaches x + y + 1 = 0.
        let folium = found(&[((3, 0), 1), ((0, 3), 1), ((1, 1), -3)]);
        assert_eq!(folium.asymptotes[0].intercept[0], Rational::from(-1));
        // x² (y² + 1) = 1 has y = ±i as complex asymptotes, and x = 0 twice; no real branch goes to infinity along x.
        let bell = found(&[((2, 2), 1), ((2, 0), 1), ((0, 0), -1)]);
        let slopes: Vec<bool> = bell.asymptotes.iter().map(|a| a.slope.is_none()).collect();
        assert_eq!(slopes, [true]);
        // x² y² + x² + y² = 0 has no real branch at all.
        let point = found(&[((2, 2), 1), ((2, 0), 1), ((0, 2), 1)]);
        assert!(point.asymptotes.is_empty());
    }
}
