//! The laws of the isolated points of elliptic series.

use nalgebra::Complex;
use proptest::prelude::*;

use super::expansion::{Expansion, Powers, Wave};
use super::isolated_of_series;
use crate::exact::Rational;
use crate::implicitize::isolated::isolated_by_resultants;
use crate::implicitize::isolated_point::{Isolated, IsolatedPoint, SHORT_BITS};
use crate::implicitize::reached::is_reached;
use crate::implicitize::tracing::tracing_index_bound;
use crate::limits::Limits;
use crate::shape::EllipticSeries;

/// A complex number with rational parts.
#[derive(Clone, Debug)]
struct Exact(Rational, Rational);

impl Exact {
    fn one() -> Self {
        Self(Rational::one(), Rational::zero())
    }

    fn times(&self, other: &Self) -> Self {
        Self(
            &self.0 * &other.0 - &self.1 * &other.1,
            &self.0 * &other.1 + &self.1 * &other.0,
        )
    }

    fn plus(&self, other: &Self) -> Self {
        Self(&self.0 + &other.0, &self.1 + &other.1)
    }

    fn conjugate(&self) -> Self {
        Self(self.0.clone(), -self.1.clone())
    }

    fn scaled(&self, by: &Rational) -> Self {
        Self(&self.0 * by, &self.1 * by)
    }

    fn inverse(&self) -> Self {
        let square = &self.0 * &self.0 + &self.1 * &self.1;
        self.conjugate().scaled(&square.recip().unwrap())
    }

    fn power(&self, exponent: usize) -> Self {
        (0..exponent).fold(Self::one(), |power, _| power.times(self))
    }
}

/// The coefficient of ζ^j in twice Σ (a_k cos kt + b_k sin kt) at z e^ζ.
fn exactly(cos: &[Rational], sin: &[Rational], z: &Exact, j: usize) -> Exact {
    let mut sum = Exact(Rational::zero(), Rational::zero());
    for (k, (a, b)) in cos.iter().zip(sin).enumerate() {
        let c = Exact(a.clone(), -b.clone());
        let above = c.times(&z.power(k));
        let below = c.conjugate().times(&z.inverse().power(k));
        let below = below.scaled(&Rational::from(if j.is_multiple_of(2) { 1 } else { -1 }));
        let weight = (1..=j).fold(Rational::one(), |w, i| {
            w * Rational::from(k as i64) / Rational::from(i as i64)
        });
        sum = sum.plus(&above.plus(&below).scaled(&weight));
    }
    sum
}

fn rational(x: f64) -> Rational {
    Rational::try_from(x).unwrap()
}

/// Fractions of absolute value up to 1.
fn coefficients(len: usize) -> impl Strategy<Value = Vec<Rational>> {
    let fraction = (-60i64..61).prop_map(|p| Rational::from(p) / Rational::from(60));
    prop::collection::vec(fraction, len)
}

fn found(series: &EllipticSeries) -> Option<Isolated> {
    let curve = series.to_plane_curve();
    isolated_of_series(series, curve.coordinates().each_ref(), &Limits::none()).unwrap()
}

fn has_index_one(series: &EllipticSeries) -> bool {
    tracing_index_bound(series.to_plane_curve().coordinates()) == 1
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]
    /// Lemma 1, at z and, on the circle, at z/|z|.
    #[test]
    fn expansions_hold_the_exact_values(
        cos in coefficients(7), sin in coefficients(7),
        turn in 0.0f64..1.0, radius in prop_oneof![Just(1.0), 1.0f64..4.0],
    ) {
        let wave = Wave::new(&cos, &sin);
        let (im, re) = (std::f64::consts::TAU * turn).sin_cos();
        let z = Complex::new(re, im) * radius;
        let expansion = Expansion::new(&wave, &Powers::new(z, wave.degree()));
        let mut exact = Exact(rational(z.re), rational(z.im));
        if radius <= 1.0 {
            // Newton's step for the square root, which is about 1, has an error of about 2^(−100).
            let square = &exact.0 * &exact.0 + &exact.1 * &exact.1;
            let length = (square + Rational::one()) / Rational::from(2);
            exact = exact.scaled(&length.recip().unwrap());
        }
        let negligible = Rational::from(2).pow(-90).unwrap();
        let errors = expansion.errors_of_terms();
        for (j, (term, error)) in errors.into_iter().enumerate() {
            let expected = exactly(&cos, &sin, &exact, j);
            let off = [rational(term.re) - expected.0, rational(term.im) - expected.1];
            let off = off.map(|d| (&d * &d).to_f64()).iter().sum::<f64>().sqrt();
            prop_assert!(rational(off) <= rational(error * 1.000_001) + &negligible, "{} {} {}", j, off, error);
            prop_assert!(error < 1e-9 * 5f64.powi(8));
        }
    }

    /// Lemma 3 and the bounds of boxes: where a coordinate is excluded, its imaginary part has one sign.
    #[test]
    fn numbers_beside_the_circle_are_excluded_rightly(
        cos in coefficients(5), sin in coefficients(5), turn in 0.0f64..1.0, radius in 0.001f64..0.24,
        off in prop::collection::vec((-1.0f64..1.0, 0.01f64..1.0), 8), out in 0.0f64..0.5,
    ) {
        let wave = Wave::new(&cos, &sin);
        let at = |z| Expansion::new(&wave, &Powers::new(z, wave.degree()));
        let (im, re) = (std::f64::consts::TAU * turn).sin_cos();
        let z = Complex::new(re, im);
        let (beside, away) = (at(z), at(z * (1.0 + out)));
        for (around, outward) in off {
            let scale = radius / around.hypot(outward).max(1.0);
            let zeta = Complex::new(outward, around) * scale;
            if beside.is_never_real_beside_circle(radius) {
                let there = at(z * zeta.exp());
                let sign = beside.derivative().im.signum() * there.value().im;
                prop_assert!(sign > -there.error());
            }
            let zeta = Complex::new(2.0 * outward - 1.0, around) * (radius / 2.0);
            if away.is_never_real(radius / 2.0, radius / 2.0) {
                let there = at(z * (1.0 + out) * zeta.exp());
                prop_assert!(away.value().im.signum() * there.value().im > -there.error());
            }
        }
    }

    /// Both coordinates are made real at a rational z by their first wave, and then turned by a rational rotation.
    #[test]
    fn zeros_that_were_built_in_are_found(
        lists in prop::collection::vec(coefficients(6), 4), len in 3usize..6, shorter in 0usize..2,
        (p, q) in (5i64..12, 2i64..5), (m, n) in (1i64..5, 5i64..7),
    ) {
        let z = Rational::from(p) / Rational::from(q);
        let at = Exact(z, Rational::zero());
        let (m, n) = (Rational::from(m), Rational::from(n));
        let square = &m * &m + &n * &n;
        let rotation = Exact((&n * &n - &m * &m) / &square, Rational::from(2) * &m * &n / &square);
        let mut point = Vec::new();
        let mut turned = Vec::new();
        for (i, both) in lists.chunks(2).enumerate() {
            let len = if i == 0 { len } else { (len - shorter).max(3) };
            let (cos, mut sin) = (both[0][..len].to_vec(), both[1][..len].to_vec());
            sin[0] = Rational::zero();
            sin[1] = Rational::zero();
            // The imaginary part is −Σ b_k (z^k − z^(−k)).
            let rest = exactly(&cos, &sin, &at, 0).1;
            let wave = &at.0 - at.inverse().0;
            sin[1] = rest / wave;
            let value = exactly(&cos, &sin, &at, 0);
            prop_assert!(value.1.is_zero());
            point.push(value.0 / Rational::from(2));
            let waves = cos.iter().zip(&sin).enumerate();
            let waves = waves.map(|(k, (a, b))| Exact(a.clone(), -b.clone()).times(&rotation.power(k)));
            let (cos, sin): (Vec<Rational>, Vec<Rational>) = waves.map(|c| (c.0, -c.1)).unzip();
            turned.extend([cos, sin]);
        }
        let series = EllipticSeries::new(turned.try_into().unwrap());
        prop_assume!(has_index_one(&series));
        let found = found(&series);
        prop_assume!(found.is_some());
        let found = found.unwrap();
        let point: [Rational; 2] = point.try_into().unwrap();
        let is_short = point.iter().all(|c| c.bits() <= SHORT_BITS);
        let curve = series.to_plane_curve();
        let is_isolated = !is_reached(curve.coordinates().each_ref(), &point);
        let near = point.each_ref().map(Rational::to_f64);
        let is_there = found.points.iter().any(|other| match other {
            IsolatedPoint::Exact(other) => *other == point,
            IsolatedPoint::Near(other) => !is_short && (0..2).all(|i| (near[i] - other[i]).abs() <= 1e-12 * near[i].abs()),
        });
        prop_assert_eq!(is_there, is_isolated, "{:?} {:?}", point, found);
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(40))]
    /// Resultants find the same points.
    #[test]
    fn the_points_are_those_of_resultants(lists in prop::collection::vec(coefficients(4), 4), lens in prop::array::uniform2(2usize..5)) {
        let cut = lists.iter().enumerate().map(|(i, list)| list[..lens[i / 2]].to_vec());
        let lists: Vec<Vec<Rational>> = cut.collect();
        let series = EllipticSeries::new(lists.try_into().unwrap());
        let curve = series.to_plane_curve();
        let coordinates = curve.coordinates().each_ref();
        prop_assume!(coordinates.iter().all(|f| f.degree() > 1) && has_index_one(&series));
        let found = found(&series);
        prop_assume!(found.is_some());
        let slow = isolated_by_resultants(coordinates, &Limits::none()).unwrap();
        prop_assume!(slow.complete);
        prop_assert_eq!(found, Some(slow));
    }
}

/// General curves of many harmonics need no other search.
#[test]
fn general_curves_are_decided() {
    let mut random = crate::modular::SplitMix(7);
    for harmonics in [3, 8, 20] {
        let lists = std::array::from_fn(|_| {
            let number = |k: i64| {
                let p = i64::try_from(random.next() % 2001).unwrap() - 1000;
                Rational::from(p) / Rational::from(1000 * (k + 1))
            };
            (0..=harmonics).map(number).collect()
        });
        let found = found(&EllipticSeries::new(lists));
        assert!(found.is_some_and(|found| found.complete && !found.points.is_empty()));
    }
}

/// Curves that the doubles cannot decide: a constant coordinate, and cusps on the real curve.
#[test]
fn special_curves_are_left_to_resultants() {
    let q = |v: &[i64]| v.iter().map(|&c| Rational::from(c)).collect::<Vec<_>>();
    let zero = || vec![Rational::zero(); 3];
    let special = [
        [q(&[0, 0, 1]), zero(), q(&[1]), zero()],
        // The deltoid has three cusps.
        [q(&[0, 2, 1]), zero(), zero(), q(&[0, 2, -1])],
    ];
    for lists in special {
        assert_eq!(found(&EllipticSeries::new(lists)), None);
    }
}
