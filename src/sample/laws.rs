//! The laws of rays for extreme inputs: forms that nearly vanish in a direction, with coefficients whose low bits are chosen so
//! that cutting them does the most harm; and polynomials built from known roots, which are close to one another and close to
//! the points where rounding to a double changes.

use malachite::Integer;
use malachite::base::num::arithmetic::traits::Pow;

use super::{Direction, IntegerVector, Ray, RaySolver, Sample, UnitVector};
use crate::error::Invariant;
use crate::exact::Rational;
use crate::poly::PlanePolynomial;
use crate::roots::Draw;

impl Draw {
    fn sign(&mut self) -> i64 {
        if self.below(2) == 0 { 1 } else { -1 }
    }

    /// A positive integer of this many bits of which long runs are all ones or all zeros.
    fn positive(&mut self, bits: u64) -> Integer {
        let mut value = Integer::from(1);
        for _ in 0..bits / 64 + 1 {
            value = (value << 64u64) + Integer::from(self.limb());
        }
        let surplus = 64 * (bits / 64 + 1) + 1 - bits;
        value >> surplus
    }

    fn direction(&mut self) -> Direction {
        if self.below(2) == 0 {
            Direction::from_degrees(&Rational::from(self.below(360) as i64))
        } else {
            let bits = self.word() >> 12 | 1.0f64.to_bits();
            Direction::from_radians(4.0 * (f64::from_bits(bits) - 1.0))
        }
    }

    /// A positive normal double whose mantissa is random, all zeros or all ones.
    fn double(&mut self) -> f64 {
        let mantissa = match self.below(4) {
            0 => 0,
            1 => (1 << 52) - 1,
            _ => self.word() >> 12,
        };
        f64::from_bits((1023 - 30 + self.word() % 60) << 52 | mantissa)
    }
}

fn polynomial(terms: impl IntoIterator<Item = ((usize, usize), Integer)>) -> PlanePolynomial {
    PlanePolynomial::from_terms(terms.into_iter().map(|(e, c)| (e, Rational::whole(c))))
}

fn power_of_two(k: i64) -> Rational {
    Rational::from_dyadic(Integer::from(1), k)
}

/// The form k (V x − U y) + ε x. Its value in the direction (U, V) is ε U, which is smaller than its coefficients by as many
/// bits as k has.
fn nearly_vanishing(draw: &mut Draw, direction: &Direction, bits: u64) -> PlanePolynomial {
    let ([u, v], _) = direction.over_common_denominator();
    let k = draw.positive(bits);
    let small = Integer::from(draw.below(5) as i64 - 2);
    polynomial([((1, 0), &k * v + small), ((0, 1), -(k * u))])
}

/// Bounded arithmetic never contradicts exact arithmetic, in a thousand directions in which the lowest form or the middle one
/// nearly vanishes, with coefficients of 60 to 2000 bits.
#[test]
fn forms_that_nearly_vanish_are_not_misjudged() {
    let mut draw = Draw(20);
    let mut bounded = 0;
    for _ in 0..1000 {
        let direction = draw.direction();
        let bits = if draw.below(4) == 0 {
            60 + draw.word() % 2000
        } else {
            60 + draw.word() % 400
        };
        let mut form = nearly_vanishing(&mut draw, &direction, bits);
        for _ in 0..draw.below(3) {
            let bits = 1 + draw.word() % 200;
            let [a, b] = [0, 0].map(|_: i32| draw.positive(bits) * Integer::from(draw.sign()));
            form = &form * &polynomial([((1, 0), a), ((0, 1), b)]);
        }
        let low = form.degree().expect("not 0");
        let high = low + 1 + draw.below(8);
        let shift = draw.below(400) as i64 - 200;
        let top = ((high, 0), power_of_two(shift) * Rational::from(draw.sign()));
        let next = ((0, low + 1), Rational::from(draw.sign()));
        let first = (
            (0, 0),
            Rational::from(if draw.below(3) == 0 { draw.sign() } else { 0 }),
        );
        let f = PlanePolynomial::from_terms(form.terms().chain([top, next, first]));
        let solver = RaySolver::new(&f);
        assert_eq!(
            solver.solve(&direction),
            solver.solve_exactly(&direction),
            "{f:?}"
        );
        bounded += solver.stage_counts().bounded.iter().sum::<u64>();
    }
    // Bounded arithmetic decides most of them.
    assert!(bounded > 500, "{bounded}");
}

/// A root p/q > 0 with its nearest double, or with both if it is halfway between two doubles.
struct Known {
    root: Rational,
    nearest: [f64; 2],
}

/// A double, or a number a few units in the last place away; or the middle between two doubles, or a number that differs from
/// it by 2^(−60) or 2^(−200) of it.
fn known_root(draw: &mut Draw, start: f64) -> Known {
    let exact = |value: f64| Rational::try_from(value).expect("a finite double");
    let at = match draw.below(3) {
        0 => start,
        1 => start.next_up(),
        _ => start.next_up().next_up(),
    };
    let up = at.next_up();
    let halfway = (exact(at) + exact(up)) * power_of_two(-1);
    let beside = power_of_two(if draw.below(2) == 0 { -60 } else { -200 });
    match draw.below(4) {
        0 => Known {
            root: exact(at),
            nearest: [at, at],
        },
        1 => Known {
            root: halfway,
            nearest: [at, up],
        },
        2 => Known {
            root: &halfway - &halfway * &beside,
            nearest: [at, at],
        },
        _ => Known {
            root: &halfway + &halfway * &beside,
            nearest: [up, up],
        },
    }
}

/// Known roots in one direction, ascending and distinct, with their multiplicities; some are close to one another.
fn known_roots(draw: &mut Draw) -> Vec<(Known, usize)> {
    let count = 1 + draw.below(5);
    let mut start = draw.double();
    let mut roots: Vec<Known> = Vec::new();
    for _ in 0..count {
        if draw.below(2) == 0 {
            start = draw.double();
        }
        roots.push(known_root(draw, start));
    }
    roots.sort_by(|a, b| a.root.cmp(&b.root));
    let mut distinct: Vec<(Known, usize)> = Vec::new();
    for known in roots {
        match distinct.last_mut() {
            Some((last, multiplicity)) if last.root == known.root => *multiplicity += 1,
            _ => distinct.push((known, 1)),
        }
    }
    distinct
}

/// The found points are the known roots, the largest first; roots with the same nearest double may be in any order.
fn assert_found(found: &[&Sample], expected: &[(Known, usize)], f: &PlanePolynomial) {
    let mut expected: Vec<&(Known, usize)> = expected.iter().rev().collect();
    assert_eq!(found.len(), expected.len(), "{f:?}");
    for sample in found {
        let fits = |(known, multiplicity): &(Known, usize)| {
            known.nearest.contains(&sample.r) && sample.multiplicity == *multiplicity
        };
        let place = expected.iter().position(|known| fits(known));
        expected.remove(place.unwrap_or_else(|| panic!("{sample:?} is not expected of {f:?}")));
    }
    assert!(found.is_sorted_by(|a, b| a.r >= b.r));
}

/// A polynomial A (x² + y²) + B with long coefficients and without a real root.
fn definite(draw: &mut Draw) -> PlanePolynomial {
    let bits = 100 + draw.word() % 1900;
    let (a, b) = (draw.positive(bits), draw.positive(bits));
    polynomial([((2, 0), a.clone()), ((0, 2), a), ((0, 0), b)])
}

#[test]
fn roots_built_backwards_are_found_and_rounded() {
    let mut draw = Draw(21);
    for _ in 0..400 {
        let direction = draw.direction();
        let ([u, v], w) = direction.over_common_denominator();
        let expected = known_roots(&mut draw);
        let mut f = definite(&mut draw);
        for (known, multiplicity) in &expected {
            // q (U x + V y) − p W: on the ray x U + y V is r W.
            let (p, q) = (known.root.numerator(), known.root.denominator());
            let line = polynomial([((1, 0), &q * &u), ((0, 1), q * &v), ((0, 0), -(p * &w))]);
            for _ in 0..*multiplicity {
                f = &f * &line;
            }
        }
        let Ray::Points(found) = RaySolver::new(&f).solve(&direction) else {
            panic!("{f:?} does not vanish on a line");
        };
        assert_found(&found.iter().collect::<Vec<_>>(), &expected, &f);
    }
}

#[test]
fn roots_of_powers_are_found_and_rounded() {
    let mut draw = Draw(22);
    for _ in 0..200 {
        let direction = draw.direction();
        let expected = known_roots(&mut draw);
        let half = 1 + draw.word() % 4;
        let rho = polynomial([((2, 0), Integer::from(1)), ((0, 2), Integer::from(1))]);
        let power = (1..half).fold(rho.clone(), |power, _| &power * &rho);
        let mut f = polynomial([((0, 0), draw.positive(300))]);
        for (known, multiplicity) in &expected {
            // q^g (x² + y²)^(g/2) − p^g
            let [p, q] =
                [known.root.numerator(), known.root.denominator()].map(|n| n.pow(2 * half));
            let scaled = power.terms().map(|(e, c)| (e, c * Rational::whole(&q)));
            let circle = PlanePolynomial::from_terms(scaled.chain([((0, 0), -Rational::whole(p))]));
            for _ in 0..*multiplicity {
                f = &f * &circle;
            }
        }
        let Ray::Points(found) = RaySolver::new(&f).solve(&direction) else {
            panic!("{f:?} does not vanish on a line");
        };
        let positive: Vec<_> = found.iter().filter(|sample| sample.r > 0.0).collect();
        assert_found(&positive, &expected, &f);
        assert_eq!(found.len(), 2 * positive.len());
    }
}

/// Just below a power of two, doubles are twice as close as above it. Bounded arithmetic rounds roots there and nearby.
#[test]
fn powers_of_two_need_no_exact_arithmetic() {
    let east = Direction::from_degrees(&Rational::zero());
    for k in -9..10i64 {
        for eighths in [-7, -5, -3, -1, 0, 1, 3] {
            // The steps are eighths of the distance to the next double below.
            let root =
                power_of_two(k) * (Rational::one() + Rational::from(eighths) * power_of_two(-56));
            let (p, q) = (root.numerator(), root.denominator());
            // A factor without a real root changes the mean size of the roots.
            let definite = PlanePolynomial::from_terms([
                ((2, 0), Rational::one()),
                ((0, 2), Rational::one()),
                ((0, 0), power_of_two(2 * k + 6)),
            ]);
            let f = &polynomial([((1, 0), q), ((0, 0), -p)]) * &definite;
            let solver = RaySolver::new(&f);
            let Ray::Points(found) = solver.solve(&east) else {
                panic!("{f:?} does not vanish on a line");
            };
            let radii: Vec<u64> = found.iter().map(|point| point.r.to_bits()).collect();
            assert_eq!(radii, [root.to_f64().to_bits()], "{root}");
            assert_eq!(solver.stage_counts().exact, 0, "{root}");
        }
    }
}

/// Points at the ends of the range of normal doubles, and subnormal ones, on a line and on a circle.
#[test]
fn points_at_the_ends_of_the_doubles_are_rounded() {
    let east = Direction::from_degrees(&Rational::zero());
    let least = f64::MIN_POSITIVE;
    let subnormal = [f64::from_bits(1), f64::from_bits(3), least / 2.0];
    let normal = [least.next_down(), least, least.next_up(), 2.0 * least];
    let top = [f64::MAX.next_down(), f64::MAX / 2.0];
    for start in [subnormal.as_slice(), &normal, &top].concat() {
        let exact = |value: f64| Rational::try_from(value).expect("a finite double");
        let gap = exact(start.next_up()) - exact(start);
        for eighths in 0..8 {
            let root = exact(start) + &gap * &Rational::from(eighths) * power_of_two(-3);
            let (p, q) = (root.numerator(), root.denominator());
            let (pp, qq) = (&p * &p, &q * &q);
            let line = polynomial([((1, 0), q), ((0, 0), -p)]);
            let circle = polynomial([((2, 0), qq.clone()), ((0, 2), qq), ((0, 0), -pp)]);
            for (f, count) in [(line, 1), (circle, 2)] {
                let Ray::Points(found) = RaySolver::new(&f).solve(&east) else {
                    panic!("{f:?} does not vanish on a line");
                };
                assert_eq!(found.len(), count);
                let nearest = [root.to_f64(), -root.to_f64()];
                let radii = found.iter().map(|point| point.r.to_bits());
                assert!(
                    radii.eq(nearest[..count].iter().map(|r| r.to_bits())),
                    "{root}"
                );
            }
        }
    }
}

/// An input that once had a wrong count: its linear part of −1/4 ulp was rounded to +15 ulps.
#[test]
fn a_linear_part_that_nearly_vanishes_has_two_points() {
    let number = |text: &str| text.parse::<Rational>().expect("a number");
    let f = PlanePolynomial::from_terms([
        ((9, 0), number("9671406556917033397649408")),
        ((2, 0), Rational::one()),
        (
            (1, 0),
            number("1545740262929933485628654903467243752277406906279780977475584"),
        ),
        (
            (0, 1),
            number("-1600660899510551534245218416770981541785682820269886452793343"),
        ),
    ]);
    let direction = Direction::from_degrees(&Rational::from(44));
    let Ray::Points(points) = RaySolver::new(&f).solve(&direction) else {
        panic!("no line");
    };
    let radii: Vec<f64> = points.iter().map(|point| point.r).collect();
    assert_eq!(radii.len(), 2, "{radii:?}");
    assert_eq!(radii[0].to_bits(), (-radii[1]).to_bits());
    assert!((radii[0] - 0.637_392_816_839_1).abs() < 1e-12, "{radii:?}");
}

/// A center that is as far away as the points, farther, or much nearer, with a denominator that doubles do not have.
fn center(draw: &mut Draw) -> [Rational; 2] {
    [(), ()].map(|()| {
        let k = Rational::from(draw.below(2001) as i64 - 1000);
        let shift = draw.below(60) as i64 - 50;
        k / Rational::from(3 * (draw.below(9) as i64 + 1)) * power_of_two(shift)
    })
}

/// Whether a root of f along the line gives a c + u λ within half an ulp of the double: f changes its sign between the two
/// midpoints next to the double.
fn is_nearest(
    f: &PlanePolynomial,
    unit: &[Rational; 2],
    axis: usize,
    c: &Rational,
    value: f64,
) -> bool {
    let signs = [value.next_down(), value.next_up()].map(|neighbour| {
        let exact = |double: f64| Rational::try_from(double).invariant("doubles here are finite");
        let midpoint = (exact(value) + exact(neighbour)) / Rational::from(2);
        let lambda = (midpoint - c) / &unit[axis];
        let value: Rational = f
            .terms()
            .map(|((i, j), a)| {
                let power =
                    |u: &Rational, e: usize| (u * &lambda).pow(e as i64).invariant("e is natural");
                a * power(&unit[0], i) * power(&unit[1], j)
            })
            .fold(Rational::zero(), |sum, term| sum + term);
        value.signum()
    });
    signs[0] * signs[1] <= 0
}

/// Coordinates from another origin are rounded once, by bounded and by exact arithmetic. Everything else remains the same.
#[test]
fn points_about_a_center_are_the_nearest_doubles() {
    let mut draw = Draw(20261128);
    let mut decided = 0;
    for _ in 0..400 {
        let degrees = 1 + draw.below(5);
        let terms = (0..=degrees).flat_map(|d| (0..=d).map(move |j| (d - j, j)));
        let terms: Vec<_> = terms.collect();
        let f = polynomial(terms.into_iter().map(|e| {
            let k = draw.below(2001) as i64 - 1000;
            (e, Integer::from(k))
        }));
        if f.degree().is_none_or(|degree| degree == 0) {
            continue;
        }
        let (direction, center) = (draw.direction(), center(&mut draw));
        let solver = RaySolver::new(&f).about(center.clone());
        let found = solver.solve(&direction);
        assert_eq!(
            found,
            solver.solve_exactly(&direction),
            "{f} {direction:?} {center:?}"
        );
        let relative = RaySolver::new(&f).solve(&direction);
        let (Ray::Points(found), Ray::Points(relative)) = (found, relative) else {
            continue;
        };
        let unit = direction.components();
        for (point, relative) in found.iter().zip(&relative) {
            assert_eq!(
                (point.branch, point.r, point.multiplicity),
                (relative.branch, relative.r, relative.multiplicity)
            );
            for axis in 0..2 {
                if unit[axis].is_zero() {
                    assert_eq!(
                        point.position[axis].to_bits(),
                        center[axis].to_f64().to_bits()
                    );
                } else if point.multiplicity == 1 {
                    decided += 1;
                    assert!(
                        is_nearest(&f, &unit, axis, &center[axis], point.position[axis]),
                        "{f} {direction:?} {center:?}"
                    );
                }
            }
        }
    }
    assert!(decided > 800, "{decided} coordinates were checked");
}
