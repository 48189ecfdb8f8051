//! The lemmas of the arcs against exact arithmetic.

#![expect(
    clippy::cast_precision_loss,
    clippy::float_cmp,
    reason = "the counts are small, and places are compared with themselves"
)]

use proptest::prelude::*;

use super::super::DistanceBounds;
use super::ArcTree;
use super::polynomials::{Expansion, Polynomials};
use super::scaled::{Scaled, Waveform};
use super::waves::{BITS, Waves};
use crate::error::Invariant;
use crate::exact::{Rational, cosine_and_sine, pi};

fn rational(x: f64) -> Rational {
    Rational::try_from(x).invariant("the test uses finite doubles")
}

fn ratio(p: i64, q: i64) -> Rational {
    Rational::from(p) / Rational::from(q)
}

/// N series with these numbers as coefficients; some harmonics are missing.
pub(in crate::inspect) fn series<const N: usize>(numbers: &[i64]) -> [Waveform; N] {
    let count = numbers.len().div_ceil(2 * N);
    let at = |k: usize| match numbers.get(k) {
        Some(c) if c % 3 != 0 => ratio(*c, 7 + (k as i64) * (k as i64)),
        _ => Rational::zero(),
    };
    std::array::from_fn(|i| {
        [0, 1].map(|kind| {
            (0..count)
                .map(|n| match (n, kind) {
                    (0, 1) => Rational::zero(),
                    _ => at((2 * i + kind) * count + n),
                })
                .collect()
        })
    })
}

/// The point of the curve at the parameter τπ, within 2^(−120) of its size.
fn point_at<const N: usize>(series: &[Waveform; N], turn: &Rational) -> [Rational; N] {
    let angle = &pi(200).0 * turn;
    let mut point = std::array::from_fn(|_| Rational::zero());
    for (x, [cos, sin]) in point.iter_mut().zip(series) {
        for (n, (a, b)) in cos.iter().zip(sin).enumerate() {
            let [c, s] = cosine_and_sine(&(&angle * &Rational::from(n as i64)), 160);
            *x = &*x + a * &c + b * &s;
        }
    }
    point
}

fn square<const N: usize>(v: &[Rational; N]) -> Rational {
    v.iter().map(|x| x * x).sum()
}

#[test]
fn waves_are_near() {
    let two = Rational::from_dyadic(2.into(), -i64::from(BITS));
    for arcs in [4, 64, 1 << 12] {
        let waves = Waves::new(arcs);
        for k in (0..2 * arcs).step_by(1.max(arcs / 50)) {
            let angle = &pi(200).0 * &ratio(k as i64, arcs as i64);
            let exact = cosine_and_sine(&angle, 160);
            for (found, exact) in waves.at(k).iter().zip(exact) {
                let found = Rational::from_dyadic((*found).into(), -i64::from(BITS));
                assert!((found - exact).abs() <= two, "{k} of {arcs}");
            }
        }
    }
}

fn norm<const N: usize>(v: &[Rational; N]) -> Rational {
    v.iter().map(Rational::abs).sum()
}

/// Lemma 2, and Lemma 3 for the expansion at u, which is compared with the curve at w.
fn check_polynomials<const N: usize>(
    series: &[Waveform; N],
    p: [f64; N],
    places: &[(usize, f64, f64)],
) {
    let scaled = Scaled::new(series).invariant("the coefficients are moderate");
    let unit = Rational::from_dyadic(1.into(), scaled.exponent().into());
    let arcs = Polynomials::new(&scaled);
    let error = rational(arcs.error());
    for &(arc, u, w) in places {
        let arc = arc % arcs.len();
        let at = Rational::from(2 * arc as i64 + 1) + rational(w);
        let truth = point_at(series, &(at / Rational::from(arcs.len() as i64)));
        let truth = truth.map(|x| x / &unit);
        let exact = arcs.exactly_at(arc, &rational(w));
        let off: [Rational; N] = std::array::from_fn(|i| &truth[i] - &exact[i]);
        assert!(square(&off) <= &error * &error, "arc {arc}, w = {w}");

        let v = rational(w) - rational(u);
        let middle = arcs.at_middle(arc, &p);
        for expansion in [arcs.at(arc, u, &p), middle] {
            let v = if expansion.at == u {
                v.clone()
            } else {
                rational(w)
            };
            let off: [Rational; N] = std::array::from_fn(|i| {
                let [d, t, b] = [expansion.value, expansion.slope, expansion.bend]
                    .map(|vector| rational(vector[i]));
                &truth[i] - rational(p[i]) - (d + t * &v + b * &v * &v)
            });
            let relative = norm(&expansion.value.map(rational)) * rational(2.0 * f64::EPSILON);
            let cubic = rational(arcs.third(arc)) * (&v * &v * &v).abs();
            let allowed = &error + relative + cubic;
            assert!(
                square(&off) <= &allowed * &allowed,
                "arc {arc}, u = {u}, w = {w}"
            );
        }
    }
}

/// The distances of the vertices of a polyline on the curve, of which neighbours are `gap` apart at most.
fn of_polyline(series: &[Waveform; 2], p: [f64; 2]) -> [f64; 2] {
    const VERTICES: i64 = 3000;
    let doubles = series.each_ref().map(|pair| {
        pair.each_ref()
            .map(|list| list.iter().map(Rational::to_f64).collect::<Vec<_>>())
    });
    let mut speed = 0.0;
    for [cos, sin] in &doubles {
        for (n, (a, b)) in cos.iter().zip(sin).enumerate() {
            speed += n as f64 * (a.abs() + b.abs());
        }
    }
    let step = std::f64::consts::TAU / VERTICES as f64;
    let distances = (0..VERTICES).map(|k| {
        let t = k as f64 * step;
        let [x, y] = doubles.each_ref().map(|[cos, sin]| {
            let terms = cos.iter().zip(sin).enumerate();
            terms
                .map(|(n, (a, b))| a * (n as f64 * t).cos() + b * (n as f64 * t).sin())
                .sum::<f64>()
        });
        (x - p[0]).hypot(y - p[1])
    });
    [distances.fold(f64::INFINITY, f64::min), speed * step / 2.0]
}

proptest! {
    #[test]
    fn polynomials_are_near_the_curve(
        numbers in prop::collection::vec(-1000i64..1000, 1..80),
        p in prop::array::uniform3(-2.0f64..2.0),
        places in prop::collection::vec((any::<usize>(), -1.0f64..=1.0, -1.0f64..=1.0), 1..4),
    ) {
        let [x, y, _] = p;
        check_polynomials(&series::<2>(&numbers), [x, y], &places);
        check_polynomials(&series::<3>(&numbers), p, &places);
    }

    #[test]
    fn pieces_are_not_nearer(
        value in [-1.0f64..1.0, -1.0..1.0],
        slope in [-1.0f64..1.0, -1.0..1.0],
        bend in [-1.0f64..1.0, -1.0..1.0],
        exponents in [-45..5, -20..0, -30..0, -40..0],
        [a, b, at, part, turn] in prop::array::uniform5(-1.0f64..1.0),
    ) {
        let scale = exponents.map(|e| f64::from(e).exp2());
        let expansion = Expansion {
            at: 0.5 * (a.min(b) + a.max(b)) + 0.5 * at * (a - b).abs(),
            value: value.map(|x| x * scale[0]),
            slope: slope.map(|x| x * scale[1]),
            bend: bend.map(|x| x * scale[2]),
        };
        let ends = [a.min(b).min(expansion.at), a.max(b).max(expansion.at)];
        let third = scale[3];
        let least = expansion.least_distance(ends, third);
        // The place of the smallest value of the quadratic polynomial, and another one.
        let best = expansion.newton_step().map_or(0.0, |step| step + expansion.at);
        for place in [ends[0], ends[1], best, ends[0] + (ends[1] - ends[0]) * (0.5 + 0.5 * part)] {
            let v = rational(place.clamp(ends[0], ends[1])) - rational(expansion.at);
            let cube = (&v * &v * &v).abs() * rational(third);
            // A rational direction.
            let t = rational(turn);
            let below = (Rational::one() + &t * &t).recip().invariant("the number is positive");
            let kappa = [
                (Rational::one() - &t * &t) * &below * &cube,
                Rational::from(2) * &t * &below * &cube,
            ];
            for sign in [1, -1].map(Rational::from) {
                let point: [Rational; 2] = std::array::from_fn(|i| {
                    rational(expansion.value[i])
                        + rational(expansion.slope[i]) * &v
                        + rational(expansion.bend[i]) * &v * &v
                        + &kappa[i] * &sign
                });
                if least > 0.0 {
                    prop_assert!(rational(least) * rational(least) <= square(&point));
                }
            }
        }
    }

    #[test]
    fn bounds_hold_the_distance_of_a_polyline(
        numbers in prop::collection::vec(-1000i64..1000, 1..200),
        p in [-300.0f64..300.0, -300.0..300.0],
        digits in 0i32..14,
    ) {
        let series = series::<2>(&numbers);
        let tree = ArcTree::new(&series).invariant("the coefficients are moderate");
        let found = tree.nearest(p, 0.0, 0.1f64.powi(digits)).invariant("the point is near");
        let DistanceBounds { low, high } = found.distance;
        let [vertex, gap] = of_polyline(&series, p);
        let slack = 1e-12 * (1.0 + vertex);
        prop_assert!(low <= vertex + slack);
        prop_assert!(vertex - gap - slack <= high);
        prop_assert!(low <= high && high - low <= 1.01 * 0.1f64.powi(digits) * high + slack);
        // The foot is where the upper bound says.
        let [x, y] = found.point;
        prop_assert!(((x - p[0]).hypot(y - p[1]) - high).abs() <= slack);
        // The greatest distance.
        for tolerance in [0.5 * vertex, vertex + 0.5, 900.0] {
            let tolerance = tolerance.max(1e-3);
            if tree.goes_beyond(p, 0.0, tolerance.into()) == Some(false) {
                prop_assert!(vertex <= tolerance + slack);
            }
        }
    }
}

impl<const N: usize> Polynomials<N> {
    /// The exact value of the polynomials of an arc.
    fn exactly_at(&self, arc: usize, u: &Rational) -> [Rational; N] {
        let [high, low, rest @ ..] = self.of(arc) else {
            unreachable!("the middle of an arc is two points")
        };
        std::array::from_fn(|i| {
            let zero = Rational::zero();
            let tail = rest
                .iter()
                .rev()
                .fold(zero, |sum, c| (sum + rational(c[i])) * u);
            rational(high[i]) + rational(low[i]) + tail
        })
    }
}
