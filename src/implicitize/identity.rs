//! A proof modulo primes whether a polynomial vanishes identically on a rational map.

use malachite::base::num::arithmetic::traits::{CeilingLogBase2, FloorLogBase2, Pow};
use malachite::base::num::basic::traits::One;
use malachite::{Integer, Natural};
use rayon::prelude::*;

use super::map::RationalMap;
use crate::error::{Invariant, Result};
use crate::limits::Limits;
use crate::modular::{PrimeField, large_primes};
use crate::poly::{IntegerTerms, SparsePolynomial};
use crate::shape::SpaceCurve;

/// Binary logarithms are multiplied by this before they are rounded to integers.
const UNIT: u64 = 16;

/// The number of primes by whose product the long coefficients are divided at once.
const GROUP: usize = 16;

impl RationalMap {
    /// Whether f vanishes identically on the map.
    ///
    /// With x = p1/q1 and so on, `N = f q1^a q2^b q3^c` (a, b, c the degrees; equal denominators are multiplied by
    /// once) is a polynomial in s1 and s2 with integer coefficients, and 0 exactly if f vanishes on the map.
    ///
    /// Lemma 1 (size). No coefficient of N is larger than `Σ |c_ijk| ‖p1‖^i ‖q1‖^(a−i) …`, with sums of absolute values as
    /// norms; so N = 0 if it is 0 modulo primes whose product is larger than that.
    /// Proof. This norm of a product is at most the product of the norms, and that of a sum the sum. [`Cleared::bound`] is the
    /// logarithm of the number of terms times the largest of them, rounded up; those of the primes are rounded down.
    /// Law: `a_product_of_primes_is_not_taken_for_zero`, with an N that is the bound itself, up to 1.
    ///
    /// Lemma 2 (stride). Modulo a prime, let k be larger than the degrees in s1 of N and of every denominator. Then N is 0 if
    /// `N(s, s^k)` is at more numbers s than its degree in s, at most deg_1 N + k deg_2 N; and no denominator is 0 on the
    /// whole curve `s2 = s1^k`, so that there are as many numbers as the prime is larger than all the degrees.
    /// Proof. Exponents below k in s1 are digits: different terms s1^i s2^j go to different powers of s, so a polynomial
    /// other than 0 does not become 0.
    /// Law: `the_stride_tells_all_terms_apart`, with N and with a denominator of degree k − 1 that are 0 on `s2 = s1^(k−1)`.
    ///
    /// Cost: (degree of N) · (number of terms of f) products of residues for each 31 bits of the bound. If f does not vanish,
    /// the first prime shows it.
    ///
    /// # Errors
    /// Those of `limits`.
    pub(super) fn annihilates(&self, f: &SparsePolynomial<3>, limits: &Limits) -> Result<bool> {
        let f = IntegerTerms::of_numerators(&f.primitive());
        let cleared = Cleared::new(self, &f);
        let mut usable = large_primes().filter(|&p| self.is_defined_modulo(p));
        let Some(first) = usable.next() else {
            return Ok(false);
        };
        limits.check()?;
        if !vanishes_modulo(self, &f, &cleared, first) {
            return Ok(false);
        }
        let mut known = floor_log(first);
        let rest = usable.take_while(|&p| {
            let more = known <= cleared.bound;
            known += floor_log(p);
            more
        });
        let rest: Vec<u64> = rest.collect();
        let failure = rest.par_chunks(GROUP).find_map_any(|primes| {
            let product = primes
                .iter()
                .fold(Integer::ONE, |m, &p| m * Integer::from(p));
            let f = f.modulo(&product);
            let vanishes = primes.iter().try_fold(true, |vanishes, &p| {
                limits.check()?;
                Ok(vanishes && vanishes_modulo(self, &f, &cleared, p))
            });
            (!matches!(vanishes, Ok(true))).then_some(vanishes)
        });
        failure.unwrap_or(Ok(true))
    }
}

/// Whether f vanishes identically on a space curve.
pub(crate) fn lies_on(curve: &SpaceCurve, f: &SparsePolynomial<3>) -> bool {
    let map = RationalMap::of_curve(curve);
    map.annihilates(f, &Limits::none())
        .is_ok_and(|it_does| it_does)
}

/// Bounds for the polynomial N.
struct Cleared {
    /// Upper bounds of the degrees of N in s1 and s2.
    degrees: [u64; 2],
    /// The stride k of Lemma 2: no denominator is 0 on the whole curve `s2 = s1^k`.
    stride: u64,
    /// No coefficient is larger than 2^(bound/[`UNIT`]).
    bound: u64,
}

impl Cleared {
    fn new(map: &RationalMap, f: &IntegerTerms<3>) -> Self {
        let coordinates = &map.coordinates[..map.coordinates.len().min(3)];
        // Each different denominator, with the coordinates that have it.
        let mut below: Vec<(&IntegerTerms<2>, Vec<usize>)> = Vec::new();
        for (v, [_, q]) in coordinates.iter().enumerate() {
            match below.iter_mut().find(|(known, _)| *known == q) {
                Some((_, shared)) => shared.push(v),
                None => below.push((q, vec![v])),
            }
        }
        let together = |e: &[u32; 3], shared: &[usize]| -> u64 {
            shared.iter().map(|&v| u64::from(e[v])).sum()
        };
        let above: Vec<Size> = coordinates.iter().map(|[p, _]| Size::of(p)).collect();
        let below: Vec<(Size, u64, Vec<usize>)> = below
            .into_iter()
            .map(|(q, shared)| {
                // The polynomial 0 has no terms.
                let power = f.iter().map(|(e, _)| together(e, &shared)).max();
                (Size::of(q), power.unwrap_or(0), shared)
            })
            .collect();
        let all = map
            .coordinates
            .iter()
            .flatten()
            .flat_map(IntegerTerms::iter);
        let in_s1 = all.map(|(e, _)| u64::from(e[0])).max();
        let in_s1 = in_s1.invariant("a denominator has a term");
        let mut cleared = Self {
            degrees: [0; 2],
            stride: 0,
            bound: 0,
        };
        for (e, c) in f.iter() {
            let factors = above.iter().zip(e).map(|(size, &k)| (size, u64::from(k)));
            let missing = below
                .iter()
                .map(|(size, power, shared)| (size, power - together(e, shared)));
            let (mut degrees, mut bound) = ([0; 2], ceiling_log(c));
            for (size, k) in factors.chain(missing) {
                degrees = std::array::from_fn(|v| degrees[v] + k * size.degrees[v]);
                bound += k * size.norm;
            }
            cleared.degrees = std::array::from_fn(|v| cleared.degrees[v].max(degrees[v]));
            cleared.bound = cleared.bound.max(bound);
        }
        cleared.stride = 1 + cleared.degrees[0].max(in_s1);
        // The bound is the largest term times the number of terms.
        cleared.bound += ceiling_log(&Integer::from(f.len()));
        cleared
    }
}

/// The degrees of a polynomial and the logarithm of the sum of its absolute coefficients.
struct Size {
    degrees: [u64; 2],
    norm: u64,
}

impl Size {
    fn of(terms: &IntegerTerms<2>) -> Self {
        Self {
            degrees: terms.degrees().map(u64::from),
            norm: ceiling_log(&Integer::from(terms.norm())),
        }
    }
}

/// ⌈16 log₂ |c|⌉, 0 for 0.
fn ceiling_log(c: &Integer) -> u64 {
    if *c == 0 {
        return 0;
    }
    c.unsigned_abs_ref().pow(UNIT).ceiling_log_base_2()
}

/// ⌊16 log₂ p⌋
fn floor_log(p: u64) -> u64 {
    Natural::from(p).pow(UNIT).floor_log_base_2()
}

/// Whether N is 0 modulo a prime that keeps every denominator.
fn vanishes_modulo(map: &RationalMap, f: &IntegerTerms<3>, cleared: &Cleared, prime: u64) -> bool {
    let field = PrimeField::new(prime);
    let (map, f) = (map.modulo(prime), EquationModulo::new(f, field));
    let [in_s1, in_s2] = cleared.degrees;
    let degree = in_s1 + cleared.stride * in_s2;
    let points = (0..prime).filter_map(|s1| map.at([s1, field.power(s1, cleared.stride)]));
    let mut count = 0;
    for point in points {
        if f.value(&point) != 0 {
            return false;
        }
        count += 1;
        if count > degree {
            return true;
        }
    }
    // Modulo this prime there are too few numbers s.
    false
}

/// Exponents of x with their coefficients.
type Row = Vec<(usize, u64)>;

/// An equation modulo a prime.
struct EquationModulo {
    field: PrimeField,
    /// For each pair of exponents of y and z, the coefficients of the powers of x.
    rows: Vec<([u32; 2], Row)>,
    degrees: [u32; 3],
}

impl EquationModulo {
    fn new(f: &IntegerTerms<3>, field: PrimeField) -> Self {
        let mut rows = std::collections::BTreeMap::<[u32; 2], Row>::new();
        let mut degrees = [0; 3];
        for (e, c) in f.iter() {
            let [x, y, z] = *e;
            let row = rows.entry([y, z]).or_default();
            row.push((x as usize, field.reduce_integer(c)));
            degrees = std::array::from_fn(|v| e[v].max(degrees[v]));
        }
        Self {
            field,
            rows: rows.into_iter().collect(),
            degrees,
        }
    }

    /// The value of the equation at a point. The point may lack coordinates that do not occur in the equation.
    fn value(&self, point: &[u64]) -> u64 {
        let p = self.field.prime();
        let square = p * p;
        let [x, y, z] = [0, 1, 2].map(|v| {
            // A coordinate that the curve does not have does not occur in f.
            let value = point.get(v).copied().unwrap_or(0);
            self.field.powers(value, self.degrees[v] as usize + 1)
        });
        let mut sum = 0;
        for ([j, k], row) in &self.rows {
            // Sums of products stay below p², here and in all other sums.
            let mut in_x = 0;
            for (i, c) in row {
                in_x += c * x[*i];
                if in_x >= square {
                    in_x -= square;
                }
            }
            let monomial = y[*j as usize] * z[*k as usize] % p;
            sum = (sum + in_x % p * monomial) % p;
        }
        sum
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::exact::Rational;
    use crate::poly::Ring;
    use proptest::prelude::*;

    /// The slow twin over Q: all terms are multiplied by the numerators and denominators.
    fn annihilates_exactly(map: &RationalMap, f: &SparsePolynomial<3>) -> bool {
        let polynomial = IntegerTerms::<2>::to_sparse;
        let degrees = f.terms().fold([0; 3], |d: [u32; 3], (e, _)| {
            std::array::from_fn(|v| d[v].max(e[v]))
        });
        let mut sum = SparsePolynomial::zero();
        for (e, c) in f.terms() {
            let mut term = SparsePolynomial::constant(c.clone());
            for (v, [p, q]) in map.coordinates.iter().enumerate() {
                term = term
                    .times(&polynomial(p).pow(e[v]))
                    .times(&polynomial(q).pow(degrees[v] - e[v]));
            }
            sum = sum.plus(&term);
        }
        sum.is_empty()
    }

    fn polynomial<const V: usize>() -> impl Strategy<Value = SparsePolynomial<V>> {
        let term = (prop::array::uniform::<_, V>(0u32..3), -9i64..10);
        let sum = |terms: Vec<([u32; V], i64)>| {
            SparsePolynomial::from_terms(terms.into_iter().map(|(e, c)| (e, Rational::from(c))))
        };
        prop::collection::vec(term, 1..4).prop_map(sum)
    }

    fn terms(f: &SparsePolynomial<2>) -> IntegerTerms<2> {
        IntegerTerms::of_numerators(f)
    }

    /// The value of many terms that are as large as possible is that of exact arithmetic.
    #[test]
    fn long_sums_are_reduced() {
        let prime = (1 << 31) - 1;
        let largest = prime - 1;
        let f = EquationModulo {
            field: PrimeField::new(prime),
            rows: vec![
                ([0, 0], (0..40).map(|i| (i, largest)).collect()),
                ([2, 1], (0..40).map(|i| (i, largest)).collect()),
            ],
            degrees: [39, 2, 1],
        };
        for point in [[largest, largest, largest], [1, 1, 1], [largest, 12_345, 3]] {
            let [x, y, z] = point.map(u128::from);
            let p = u128::from(prime);
            let row = (0..40).fold(0, |sum, _| (sum * x + u128::from(largest)) % p);
            let expected = (row + row * (y * y % p) % p * z) % p;
            assert_eq!(u128::from(f.value(&point)), expected);
        }
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(60))]
        #[test]
        fn what_vanishes_modulo_primes_vanishes(
            [a, b, y] in prop::array::uniform3(polynomial::<2>()),
            [g, h, rest] in prop::array::uniform3(polynomial::<3>()),
            [c, d] in prop::array::uniform2(-9i64..10),
            shared in prop::bool::ANY,
            scale in 0u64..200,
        ) {
            // x = a/b, y = y/b or y/1, z = (c x² + d)/y with a long coefficient now and then.
            let below = if shared { b.clone() } else { SparsePolynomial::constant(Rational::one()) };
            let c = Rational::from(c) * Rational::whole(Integer::from(1) << scale);
            let [long, short] = [c, Rational::from(d)];
            let above = a.squared().scaled(&long).plus(&b.squared().scaled(&short)).times(&below);
            let z_below = b.squared().times(&y);
            prop_assume!(!b.is_empty() && !y.is_empty());
            let map = RationalMap {
                coordinates: vec![
                    [terms(&a), terms(&b)],
                    [terms(&y), terms(&below)],
                    [terms(&above), terms(&z_below)],
                ],
            };
            let [x, y, z] = [0, 1, 2].map(SparsePolynomial::<3>::variable);
            let relation = y.times(&z).minus(&x.squared().scaled(&long)).minus(&SparsePolynomial::constant(short));
            let limits = Limits::none();
            for (f, expected) in [
                (relation.clone(), Some(true)),
                (relation.times(&g), Some(true)),
                (relation.times(&g).plus(&rest), None),
                (h, None),
            ] {
                let found = map.annihilates(&f, &limits).unwrap();
                prop_assert_eq!(found, annihilates_exactly(&map, &f));
                prop_assert!(expected.is_none_or(|e| e == found));
            }
        }
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(32))]
        /// The equation x + y on (m s, n s), where m + n is a product of primes: the only coefficient of N is m + n, and it is
        /// its own bound.
        #[test]
        fn a_product_of_primes_is_not_taken_for_zero(count in 1usize..9, skipped in 0usize..3, share in 1u64..1000) {
            let primes = large_primes().skip(skipped).take(count);
            let product = primes.fold(Integer::ONE, |m, p| m * Integer::from(p));
            // Two halves reach the bound; other shares are below it by less than a bit.
            let m = &product * Integer::from(share) / Integer::from(1000u64);
            let linear = |c: Integer| IntegerTerms::new(vec![([1, 0], c)]);
            let constant = || IntegerTerms::new(vec![([0, 0], Integer::ONE)]);
            let [x, y] = [0, 1].map(SparsePolynomial::<3>::variable);
            let sum = x.plus(&y);
            for m in [m, &product >> 1u64] {
                prop_assume!(m != 0 && m != product);
                let coordinates = vec![
                    [linear(m.clone()), constant()],
                    [linear(&product - &m), constant()],
                ];
                let map = RationalMap { coordinates };
                prop_assert!(!map.annihilates(&sum, &Limits::none()).unwrap());
            }
        }

        /// The polynomial f·g with f = y − x^d on (s1, s2), which is 0 on s2 = s1^d and has degree d in s1.
        #[test]
        fn the_stride_tells_all_terms_apart(d in 1u32..7, a in 1i64..9, b in 1i64..9) {
            let [s1, s2] = [0, 1].map(SparsePolynomial::<2>::variable);
            let one = SparsePolynomial::constant(Rational::one());
            let zero_there = s2.scaled(&Rational::from(a)).minus(&s1.pow(d).scaled(&Rational::from(a)));
            let [x, y, z] = [0, 1, 2].map(SparsePolynomial::<3>::variable);
            let limits = Limits::none();
            let plane = RationalMap { coordinates: vec![[terms(&s1), terms(&one)], [terms(&s2), terms(&one)]] };
            let f = y.minus(&x.pow(d));
            for multiple in [f.clone(), f.times(&y), f.times(&f), f.scaled(&Rational::from(b))] {
                prop_assert!(!plane.annihilates(&multiple, &limits).unwrap());
            }
            // z has its poles on that curve, and N, of a smaller degree, does not show it.
            let map = RationalMap { coordinates: vec![
                [terms(&s1), terms(&one)],
                [terms(&s1.squared().scaled(&Rational::from(b))), terms(&one)],
                [terms(&one), terms(&zero_there)],
            ] };
            let identity = y.minus(&x.squared().scaled(&Rational::from(b)));
            prop_assert!(map.annihilates(&identity, &limits).unwrap());
            prop_assert!(!map.annihilates(&identity.times(&z).plus(&x), &limits).unwrap());
        }
    }

    #[test]
    fn a_multiple_of_the_first_prime_is_not_taken_for_zero() {
        let prime = large_primes().next().unwrap();
        let constant = |c: u64| IntegerTerms::new(vec![([0, 0], Integer::from(c))]);
        let s = |c: u64| IntegerTerms::new(vec![([1, 0], Integer::from(c))]);
        let [x, y] = [0, 1].map(SparsePolynomial::<3>::variable);
        let multiple = x.scaled(&Rational::whole(Integer::from(prime)));
        // (s, p s), and (s/p, s), whose denominator is 0 modulo p.
        for ([first, second], f) in [
            (
                [[s(1), constant(1)], [s(prime), constant(1)]],
                y.minus(&multiple),
            ),
            (
                [[s(1), constant(prime)], [s(1), constant(1)]],
                y.minus(&multiple),
            ),
        ] {
            let map = RationalMap {
                coordinates: vec![first, second],
            };
            let limits = Limits::none();
            assert!(map.annihilates(&f, &limits).unwrap());
            assert!(!map.annihilates(&y.minus(&x), &limits).unwrap());
            assert!(!map.annihilates(&y, &limits).unwrap());
            assert!(!map.annihilates(&multiple, &limits).unwrap());
        }
    }
}
