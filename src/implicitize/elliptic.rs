//! The equation of an elliptic Fourier series, by residues modulo many primes.
//!
//! With z = e^(it), 2D x(t) = Σ x_k z^k and 2E y(t) = Σ y_k z^k are Laurent polynomials with coefficients that are integers of
//! Q(i); D and E are common denominators. The resultant G(u, v) of z^N (Σ x_k z^k − u) and z^M (Σ y_k z^k − v) with respect to z has
//! integer coefficients and the degree 2M in u and 2N in v.

use malachite::Integer;
use malachite::base::num::arithmetic::traits::{Pow, Square};
use malachite::base::num::basic::traits::{One, Zero};
use malachite::base::num::logic::traits::SignificantBits;

use super::characteristic::{Characteristic, Interpolation, Pair};
use crate::bigint::Machine;
use crate::error::{Result, broken};
use crate::exact::Rational;
use crate::limits::Limits;
use crate::modular::{
    Four, FourFields, PrimeField, ShortRemainders, four_fields, fours_for, imaginary_unit,
    large_primes, multiplied,
};
use crate::parallel;
use crate::poly::PlanePolynomial;
use crate::shape::{EllipticSeries, FourierRadius};

/// A coordinate: twice its series over a common denominator.
struct Coordinate {
    /// Twice the common denominator.
    scale: Integer,
    /// The numbers [a_k, b_k] with coefficient a_k − i b_k of z^k and a_k + i b_k of z^(−k); for k = 0, a_0 alone.
    waves: Vec<[Integer; 2]>,
}

impl Coordinate {
    fn new(cos: &[Rational], sin: &[Rational]) -> Self {
        let (denominator, cos, sin) =
            FourierRadius::new(cos.to_vec(), sin.to_vec()).over_common_denominator();
        let mut waves: Vec<[Integer; 2]> = cos.into_iter().zip(sin).map(|(a, b)| [a, b]).collect();
        waves[0][0] <<= 1u64;
        Self {
            scale: denominator << 1u64,
            waves,
        }
    }

    /// The degree in z.
    fn degree(&self) -> usize {
        self.waves.len() - 1
    }

    /// The square of the length of the coefficients of the polynomial whose resultant is taken, for |u| ≤ 1.
    fn square_length(&self) -> Integer {
        let mut sum = Integer::ZERO;
        for (k, [a, b]) in self.waves.iter().enumerate() {
            sum += if k == 0 {
                let size = Integer::from(a.unsigned_abs_ref() + malachite::Natural::ONE);
                size.square()
            } else {
                (a.square() + b.square()) << 1u64
            };
        }
        sum
    }

    /// The coefficients from the lowest one on, modulo four primes with these square roots of −1.
    fn modulo(&self, field: &FourFields, unit: Four) -> Vec<Four> {
        let of = |value: &Integer| field.of(|field| field.reduce_integer(value));
        let pairs: Vec<[Four; 2]> = self
            .waves
            .iter()
            .map(|[a, b]| [of(a), field.times(of(b), unit)])
            .collect();
        let sum =
            |sign: f64| move |[a, ib]: &[Four; 2]| field.reduced(multiplied([sign; 4], *ib, *a));
        let below = pairs[1..].iter().rev().map(sum(1.0));
        let above = pairs[1..].iter().map(sum(-1.0));
        below.chain([pairs[0][0]]).chain(above).collect()
    }

    /// The value modulo a prime at the angle with tan(t/2) = 2, whose cosine is −3/5 and whose sine is 4/5.
    fn value(&self, field: &PrimeField) -> u64 {
        let fifth = field.inverse(5);
        let (cos, sin) = (field.mul(field.minus(0, 3), fifth), field.mul(4, fifth));
        let (mut c, mut s, mut sum) = (1, 0, 0);
        for (k, [a, b]) in self.waves.iter().enumerate() {
            // Twice the series, but a_0 is doubled already.
            let double = if k == 0 { 1 } else { 2 };
            let terms = field.sum(
                field.mul(field.reduce_integer(a), c),
                field.mul(field.reduce_integer(b), s),
            );
            sum = field.sum(sum, field.mul(double, terms));
            (c, s) = (
                field.minus(field.mul(c, cos), field.mul(s, sin)),
                field.sum(field.mul(c, sin), field.mul(s, cos)),
            );
        }
        field.mul(sum, field.inverse(field.reduce_integer(&self.scale)))
    }
}

/// The resultant G(2D X, 2E Y), a constant times the k-th power of the equation for the tracing index k. `None` if a coordinate is
/// constant, if this machine has no fused products, or if there are not enough short primes.
///
/// **Lemma.** Modulo a prime p that does not divide |y_M|², G(u, v) = |y_M|^(2N) times the characteristic polynomial of Σ x_k z^k
/// modulo z^M (Σ y_k z^k − v).
///
/// Proof. By the roots ρ of the second polynomial, G = y_M^(2N) ∏ ρ^N (x(ρ) − u). There are 2M of them, an even number, and their
/// product is y_(−M)/y_M; and y_(−M) is the conjugate of y_M.
///
/// **Lemma.** The coefficients of G are at most P^M Q^N, where P and Q are the squares of the lengths of the two polynomials'
/// coefficients, the largest for |u| = |v| = 1.
///
/// Proof. Hadamard's bound of Sylvester's determinant with 2M rows of the first and 2N rows of the second polynomial holds for all
/// such u and v, and by Cauchy a coefficient is at most the largest value there.
///
/// The coefficient of u^(2M−k) has at most the degree k N/M in v: the roots ρ grow at most as v^(1/M), and so do x(ρ) as v^(N/M).
///
/// Cost: for each of 2N + 1 values of v and each prime of 25 bits, 8√2 M^(5/2) … products of residues.
pub(super) fn resultant_of_series(
    series: &EllipticSeries,
    limits: &Limits,
) -> Result<Option<PlanePolynomial>> {
    let [x, y] = [
        Coordinate::new(series.x_cos(), series.x_sin()),
        Coordinate::new(series.y_cos(), series.y_sin()),
    ];
    let machine = Machine::this();
    let (half_u, half_v) = (y.degree(), x.degree());
    if half_u == 0 || half_v == 0 || !machine.has_fused_products() {
        return Ok(None);
    }
    let bound = x.square_length().pow(half_u as u64) * y.square_length().pow(half_v as u64);
    let bits = bound.significant_bits() + 1;
    let [a, b] = &y.waves[half_u];
    let norm = a.square() + b.square();
    let is_good = |field: PrimeField| field.reduce_integer(&norm) != 0;
    let Some(fields) = four_fields(fours_for(bits), is_good) else {
        return Ok(None);
    };
    let pairs = parallel::map(&fields, |field| {
        let unit = field.of(imaginary_unit);
        Pair::new(*field, x.modulo(field, unit), &y.modulo(field, unit))
    });
    let values = 2 * half_v + 1;
    let tasks: Vec<(usize, usize)> = (0..fields.len())
        .flat_map(|q| (0..values).map(move |v| (q, v)))
        .collect();
    let polynomials: Vec<Vec<Four>> = parallel::try_map(&tasks, limits, |&(q, v)| {
        #[expect(clippy::cast_precision_loss, reason = "a small count")]
        let value = v as f64;
        Ok(machine.dispatch_fused(Characteristic {
            pair: &pairs[q],
            value,
        }))
    })?;
    // The terms u^i v^j that can occur, by i.
    let most = |i: usize| (2 * half_u - i) * half_v / half_u;
    let terms: Vec<(usize, usize)> = (0..2 * half_u)
        .flat_map(|i| (0..=most(i)).map(move |j| (i, j)))
        .collect();
    let residues: Vec<Vec<[u64; 4]>> = parallel::try_map_numbers(fields.len(), limits, |q| {
        let (field, pair) = (&fields[q], &pairs[q]);
        let power = |field: PrimeField| field.power(field.reduce_integer(&norm), half_v as u64);
        let factor = field.of(power);
        let rows = &polynomials[q * values..(q + 1) * values];
        let mut all = Vec::with_capacity(terms.len());
        for i in 0..2 * half_u {
            let values = rows[..=most(i)].iter().map(|row| row[i]).collect();
            let found = machine.dispatch_fused(Interpolation { pair, values });
            let scaled = found.into_iter().map(|c| field.times(c, factor));
            all.extend(scaled.map(|c| field.representatives(c)));
        }
        Ok(all)
    })?;
    let remainders = ShortRemainders::new(&fields);
    let mut coefficients = parallel::map_numbers(terms.len(), |k| {
        let residues: Vec<u64> = residues.iter().flat_map(|all| all[k]).collect();
        remainders.integer(&residues)
    });
    coefficients.push(norm.pow(half_v as u64));
    let terms = terms.into_iter().chain([(2 * half_u, 0)]);
    let found = assemble(terms.zip(coefficients), [&x.scale, &y.scale]);
    check_a_value(&found, [&x, &y]);
    Ok(Some(found))
}

/// The polynomial with the terms c (sx X)^i (sy Y)^j.
fn assemble(
    terms: impl Iterator<Item = ((usize, usize), Integer)>,
    scales: [&Integer; 2],
) -> PlanePolynomial {
    let mut powers = scales.map(|_| vec![Integer::ONE]);
    let terms = terms.map(|((i, j), c)| {
        for ((powers, scale), exponent) in powers.iter_mut().zip(scales).zip([i, j]) {
            while powers.len() <= exponent {
                powers.push(&powers[powers.len() - 1] * scale);
            }
        }
        ((i, j), Rational::whole(c * &powers[0][i] * &powers[1][j]))
    });
    PlanePolynomial::from_terms(terms)
}

/// A check: stops the program if the equation does not vanish at one point of the curve modulo one more prime.
fn check_a_value(f: &PlanePolynomial, coordinates: [&Coordinate; 2]) {
    let fits = |field: &PrimeField| {
        coordinates
            .iter()
            .all(|c| field.reduce_integer(&c.scale) != 0)
    };
    let mut primes = large_primes();
    let field = loop {
        let field = PrimeField::new(primes.following());
        if fits(&field) {
            break field;
        }
    };
    let [x, y] = coordinates.map(|c| c.value(&field));
    let powers = |base: u64| field.powers(base, f.degree().map_or(1, |d| d + 1));
    let (x, y) = (powers(x), powers(y));
    let value = f.terms().fold(0, |sum, ((i, j), c)| {
        // The polynomial has whole coefficients.
        let c = field.reduce_integer(&c.numerator());
        field.sum(sum, field.mul(c, field.mul(x[i], y[j])))
    });
    if value != 0 {
        broken("the equation of an elliptic series vanishes on it modulo one more prime");
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::poly::eliminate;
    use proptest::prelude::*;

    /// A series with small coefficients, with these numbers of harmonics in x and y.
    fn series(numbers: &[i64], [in_x, in_y]: [usize; 2]) -> EllipticSeries {
        let mut numbers = numbers
            .iter()
            .map(|&c| Rational::from(c) / Rational::from(1 + c.abs() % 3));
        let mut list = |count: usize| -> Vec<Rational> {
            (0..=count)
                .map(|_| numbers.next().unwrap_or_else(Rational::one))
                .collect()
        };
        EllipticSeries::new([list(in_x), list(in_x), list(in_y), list(in_y)])
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(40))]
        /// The resultant is the one in tan(t/2), up to a constant, whatever the tracing index.
        #[test]
        fn it_is_the_resultant_in_the_tangent(
            numbers in prop::collection::vec(-9i64..9, 24),
            in_x in 1usize..5,
            in_y in 1usize..5,
        ) {
            let series = series(&numbers, [in_x, in_y]);
            let Some(found) = resultant_of_series(&series, &Limits::none()).unwrap() else {
                return Ok(());
            };
            let curve = series.to_plane_curve();
            let [x, y] = curve.coordinates();
            let slow = eliminate(x, y, &Limits::none(), |f| Ok(Some(f.clone())));
            // The slow method returns its first guess, which may be wrong before its primes suffice; a second proof is needed.
            let slow = slow.unwrap();
            let same = found.primitive() == slow.primitive();
            prop_assert!(same || !vanishes(&slow, &series));
            prop_assert!(vanishes(&found, &series));
        }
    }

    /// Whether a polynomial vanishes at several rational points of a curve, exactly.
    fn vanishes(f: &PlanePolynomial, series: &EllipticSeries) -> bool {
        let curve = series.to_plane_curve();
        (-6..6).all(|s| {
            let point = curve.point(&Rational::from(s)).expect("no poles");
            let value = f.terms().map(|((i, j), c)| {
                let power = |b: &Rational, e: usize| b.pow(e as i64).expect("not negative");
                c * power(&point[0], i) * power(&point[1], j)
            });
            value.sum::<Rational>().is_zero()
        })
    }
}
