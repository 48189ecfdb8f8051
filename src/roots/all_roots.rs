//! All real roots of a polynomial. Bounded arithmetic finds them if it can prove them, exact arithmetic otherwise.

use std::cmp::Ordering;
use std::sync::Arc;

use malachite::base::polynomial::DivPowerOfXAssign;

use super::RealRoot;
use super::bounded::{Unproved, bounded_roots};
use super::isolate::isolate;
use crate::exact::{Dyadic, Rational};
use crate::poly::{IntegerPolynomial, sign_at, squarefree_decomposition, with_integers};

impl RealRoot {
    /// All distinct real roots of the polynomial with these coefficients (ascending), ascending, with their multiplicities; none
    /// for a constant.
    ///
    /// Every root is certified and the number of roots is exact. Descartes' rule proves it, either in numbers of 128 to 768 bits
    /// with bounds of their errors, or on the squarefree parts with as many bits as necessary.
    ///
    /// ```
    /// use stellate::roots::RealRoot;
    /// let f = [0, 0, 0, -2, 0, 1].map(stellate::exact::Rational::from); // x³ (x² − 2)
    /// let roots = RealRoot::all_of(&f);
    /// let shown: Vec<_> = roots.iter().map(|r| (r.to_f64(), r.multiplicity())).collect();
    /// assert_eq!(shown, [(-2f64.sqrt(), 1), (0.0, 3), (2f64.sqrt(), 1)]);
    /// ```
    #[must_use]
    pub fn all_of(coefficients: &[Rational]) -> Vec<Self> {
        real_roots(&with_integers(coefficients).0)
    }
}

/// [`RealRoot::all_of`] a polynomial with integer coefficients.
pub(crate) fn real_roots(f: &IntegerPolynomial) -> Vec<RealRoot> {
    let mut roots = match simple_roots(f, 1) {
        // These roots are proved to be simple, so no gcd was needed.
        Ok(roots) => roots,
        Err(_) => squarefree_roots(f),
    };
    sort_distinct(&mut roots);
    roots
}

/// The real roots of the squarefree parts, in no order.
fn squarefree_roots(f: &IntegerPolynomial) -> Vec<RealRoot> {
    let parts = squarefree_decomposition(f);
    let is_new = parts.len() > 1 || parts.iter().any(|(multiplicity, _)| *multiplicity > 1);
    let mut roots = Vec::new();
    for (multiplicity, mut part) in parts {
        let starts_at_0 = part.coefficients_asc()[0] == 0;
        if starts_at_0 {
            let zero = RealRoot::exact(&Arc::new(part.clone()), Dyadic::zero(), multiplicity);
            roots.push(zero);
            part.div_power_of_x_assign(1);
        }
        // The polynomial is its own squarefree part, and bounded arithmetic has failed for it already.
        let bounded = (is_new || starts_at_0).then(|| simple_roots(&part, multiplicity).ok());
        let found = bounded.flatten();
        roots.extend(found.unwrap_or_else(|| exact_roots(&part, multiplicity)));
    }
    roots
}

/// All real roots in bounded arithmetic, if it proves that they are simple; in no order.
fn simple_roots(f: &IntegerPolynomial, multiplicity: usize) -> Result<Vec<RealRoot>, Unproved> {
    let found = bounded_roots::<2>(f)
        .or_else(|why| why.with_more_bits(|| bounded_roots::<4>(f)))
        .or_else(|why| why.with_more_bits(|| bounded_roots::<6>(f)))
        .or_else(|why| why.with_more_bits(|| bounded_roots::<8>(f)))
        .or_else(|why| why.with_more_bits(|| bounded_roots::<12>(f)))?;
    let f = Arc::new(f.clone());
    let root = |(low, high, sign)| RealRoot::between(&f, (low, high), sign, multiplicity);
    Ok(found.into_iter().map(root).collect())
}

/// The real roots of a squarefree polynomial in exact arithmetic, in no order.
fn exact_roots(part: &IntegerPolynomial, multiplicity: usize) -> Vec<RealRoot> {
    let isolated = isolate(part);
    let polynomial = Arc::new(isolated.rest);
    let exact = isolated.exact.into_iter();
    let exact = exact.map(|point| RealRoot::exact(&polynomial, point, multiplicity));
    let intervals = isolated.intervals.into_iter().map(|(low, high)| {
        let sign_low = sign_at(&polynomial, &low);
        RealRoot::between(&polynomial, (low, high), sign_low, multiplicity)
    });
    exact.chain(intervals).collect()
}

/// Sorts roots by insertion. The roots must be distinct: overlapping enclosures are refined until they are disjoint.
pub(crate) fn sort_distinct(roots: &mut [RealRoot]) {
    for i in 1..roots.len() {
        let mut j = i;
        while j > 0 {
            let (before, after) = roots.split_at_mut(j);
            if before[j - 1].cmp_distinct(&mut after[0]) != Ordering::Greater {
                break;
            }
            roots.swap(j - 1, j);
            j -= 1;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use malachite::Integer;
    use malachite::base::num::basic::traits::One;
    use malachite::base::num::logic::traits::SignificantBits;
    use malachite::base::polynomial::Polynomial;
    use proptest::prelude::*;

    /// The same roots by exact arithmetic alone, as a slow twin.
    fn exact_real_roots(f: &IntegerPolynomial) -> Vec<RealRoot> {
        let parts = squarefree_decomposition(f).into_iter();
        let mut roots: Vec<RealRoot> = parts
            .flat_map(|(multiplicity, part)| exact_roots(&part, multiplicity))
            .collect();
        sort_distinct(&mut roots);
        roots
    }

    /// Every precision that gives an answer gives the roots that exact arithmetic finds.
    fn agrees<const W: usize>(f: &IntegerPolynomial, exact: &[RealRoot]) -> bool {
        let Ok(mut found) = bounded_roots::<W>(f) else {
            return false;
        };
        found.sort_by(|a, b| a.0.cmp(&b.0));
        assert_eq!(found.len(), exact.len());
        for ((low, high, sign_low), root) in found.iter().zip(exact) {
            assert_eq!(root.multiplicity(), 1);
            assert!(root.cmp_dyadic(low).is_gt() && root.cmp_dyadic(high).is_lt());
            assert_eq!(sign_at(f, low), *sign_low);
            assert_eq!(sign_at(f, high), -sign_low);
            let (width, size) = (high.minus(low).log2(), low.log2().max(high.log2()));
            assert!(width.unwrap() < size.unwrap() - 10, "{width:?} {size:?}");
        }
        true
    }

    fn polynomial() -> impl Strategy<Value = IntegerPolynomial> {
        let integers = |c: Vec<i64>| -> Vec<Integer> { c.into_iter().map(Integer::from).collect() };
        let dense = prop::collection::vec(any::<i64>(), 2..40).prop_map(integers);
        let roots = (
            prop::collection::vec((-99i64..99, 1i64..99), 1..9),
            -40i64..40,
        );
        // Known roots, times a power of two.
        let backwards = roots.prop_map(|(roots, scale)| {
            let mut f = IntegerPolynomial::from_coefficients_asc(vec![Integer::ONE]);
            for (p, q) in roots {
                f *= IntegerPolynomial::from_coefficients_asc(vec![
                    Integer::from(-p) << u64::try_from(scale.max(0)).unwrap_or(0),
                    Integer::from(q) << scale.min(0).unsigned_abs(),
                ]);
            }
            f.into_coefficients_asc()
        });
        // Coefficients of very different sizes, of any sign.
        let wild = prop::collection::vec((any::<i32>(), 0u64..400), 2..20);
        let wild = wild.prop_map(|c| c.into_iter().map(|(m, e)| Integer::from(m) << e).collect());
        prop_oneof![dense, backwards, wild].prop_map(IntegerPolynomial::from_coefficients_asc)
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(1000))]
        #[test]
        fn bounded_roots_are_the_exact_ones(f in polynomial()) {
            prop_assume!(f.coefficients_asc().len() > 1);
            let exact = exact_real_roots(&f);
            let all = real_roots(&f);
            prop_assert_eq!(all.len(), exact.len());
            for (root, expected) in all.iter().zip(&exact) {
                prop_assert!(root.is_same(expected) && root.multiplicity() == expected.multiplicity());
            }
            let said = [agrees::<2>(&f, &exact), agrees::<4>(&f, &exact), agrees::<6>(&f, &exact), agrees::<8>(&f, &exact), agrees::<12>(&f, &exact)];
            // Bounded arithmetic must succeed here: the roots are simple and are no points of bisection.
            let is_plain = exact.iter().all(|r| r.multiplicity() == 1 && r.as_rational().is_none());
            let c = f.coefficients_asc();
            if is_plain && c[0] != 0 && c.iter().all(|c| c.significant_bits() <= 64) {
                prop_assert!(said[3], "512 bits do not suffice for {}", f);
            }
        }
    }
}
