//! Laws of the topology of curves.

use proptest::prelude::*;

use super::places::{Place, types_above_zero};
use super::{ComponentKind, Coordinate, Genus, Topology};
use crate::exact::Rational;
use crate::implicitize::SquaredForm;
use crate::limits::Limits;
use crate::modular::PrimeField;
use crate::poly::PlanePolynomial;
use crate::shape::FourierRadius;

fn whole(n: i64) -> Rational {
    Rational::from(n)
}

fn curve(terms: &[((usize, usize), i64)]) -> PlanePolynomial {
    PlanePolynomial::from_terms(terms.iter().map(|&(e, c)| (e, whole(c))))
}

fn topology(f: &PlanePolynomial) -> Topology {
    Topology::of(f, &Limits::none()).unwrap()
}

/// (x − a)² + (y − b)² − s
fn circle(a: &Rational, b: &Rational, s: &Rational) -> PlanePolynomial {
    let two = whole(-2);
    PlanePolynomial::from_terms([
        ((2, 0), Rational::one()),
        ((0, 2), Rational::one()),
        ((1, 0), a * &two),
        ((0, 1), b * &two),
        ((0, 0), a * a + b * b - s),
    ])
}

/// f(px + qy, rx + sy)
fn turned(f: &PlanePolynomial, [p, q, r, s]: [i64; 4]) -> PlanePolynomial {
    let linear = |a: i64, b: i64| curve(&[((1, 0), a), ((0, 1), b)]);
    let (x, y) = (linear(p, q), linear(r, s));
    let power = |g: &PlanePolynomial, n: usize| {
        (0..n).fold(curve(&[((0, 0), 1)]), |product, _| &product * g)
    };
    f.terms().fold(curve(&[]), |sum, ((i, j), c)| {
        let constant = PlanePolynomial::from_terms([((0, 0), c)]);
        &sum + &(&(&power(&x, i) * &power(&y, j)) * &constant)
    })
}

type Invariants = (
    Vec<(&'static str, usize)>,
    Vec<(&'static str, usize, Option<usize>)>,
);

/// Kinds and numbers of components inside, and kinds, multiplicities and Milnor numbers: all that an affine map keeps.
fn invariants(f: &PlanePolynomial) -> Invariants {
    let found = topology(f);
    let mut components: Vec<_> = found
        .components
        .iter()
        .map(|c| (c.kind.name(), c.contains.len()))
        .collect();
    components.sort_unstable();
    let mut points: Vec<_> = found
        .singular_points
        .iter()
        .map(|p| &p.singularity)
        .map(|s| (s.kind().name(), s.multiplicity, s.milnor))
        .collect();
    points.sort_unstable();
    (components, points)
}

fn middle(c: &Option<Coordinate>) -> f64 {
    c.as_ref().map_or(f64::INFINITY, Coordinate::to_f64)
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(24))]

    /// Circles that do not meet, and points: everything is known beforehand.
    #[test]
    fn circles_and_points_are_all_found(
        parts in prop::collection::vec((-12i64..12, -12i64..12, 0i64..5), 1..4),
    ) {
        // Two of them meet or touch unless they are apart or one is inside the other.
        let apart = |a: &(i64, i64, i64), b: &(i64, i64, i64)| {
            let d = (a.0 - b.0).pow(2) + (a.1 - b.1).pow(2);
            d > (a.2 + b.2).pow(2) || d < (a.2 - b.2).pow(2)
        };
        for (i, a) in parts.iter().enumerate() {
            prop_assume!(parts[..i].iter().all(|b| apart(a, b)));
        }
        let f = parts.iter().fold(curve(&[((0, 0), 1)]), |f, &(a, b, r)| {
            &f * &circle(&whole(a), &whole(b), &whole(r * r))
        });
        let found = topology(&f);
        prop_assert_eq!(found.components.len(), parts.len());
        let index_of = |&(a, b, r): &(i64, i64, i64)| {
            found.components.iter().position(|c| {
                let ends = c.extent.each_ref().map(|ends| ends.each_ref().map(|e| e.as_ref().unwrap().exact().cloned()));
                ends == [[Some(whole(a - r)), Some(whole(a + r))], [Some(whole(b - r)), Some(whole(b + r))]]
            })
        };
        for part in &parts {
            let component = &found.components[index_of(part).unwrap()];
            prop_assert_eq!(component.kind == ComponentKind::Point, part.2 == 0);
            let around = |a: &(i64, i64, i64), b: &(i64, i64, i64)| {
                (a.0 - b.0).pow(2) + (a.1 - b.1).pow(2) < (a.2 - b.2).pow(2) && a.2 > b.2
            };
            let mut directly: Vec<usize> = parts
                .iter()
                .filter(|b| around(part, b) && !parts.iter().any(|c| around(part, c) && around(c, b)))
                .map(|b| index_of(b).unwrap())
                .collect();
            directly.sort_unstable();
            let mut contains = component.contains.clone();
            contains.sort_unstable();
            prop_assert_eq!(contains, directly);
        }
        prop_assert_eq!(found.singular_points.len(), parts.iter().filter(|p| p.2 == 0).count());
    }

    /// An affine map keeps everything but the extents; it changes the projection, and so the whole computation.
    #[test]
    fn affine_maps_keep_the_topology(
        coefficients in prop::collection::vec(-4i64..5, 15),
        second in prop::collection::vec(-2i64..3, 6),
        matrix in [-2i64..3, -2i64..3, -2i64..3, -2i64..3],
    ) {
        prop_assume!(matrix[0] * matrix[3] != matrix[1] * matrix[2]);
        let monomials = |degree: usize| (0..=degree).flat_map(move |i| (0..=degree - i).map(move |j| (i, j)));
        let make = |degree, list: &[i64]| {
            curve(&monomials(degree).zip(list).map(|(e, &c)| (e, c)).collect::<Vec<_>>())
        };
        // The product of a quartic and a conic has up to 8 nodes.
        let f = &make(4, &coefficients) * &make(2, &second);
        prop_assume!(!f.is_zero() && f.degree() > Some(0));
        prop_assert_eq!(invariants(&f), invariants(&turned(&f, matrix)));
    }

    /// The series of a radius and the sweep of its equation agree.
    #[test]
    fn a_radius_and_its_equation_have_one_topology(
        cos in prop::collection::vec(-5i64..6, 1..4),
        sin in prop::collection::vec(-3i64..4, 1..4),
    ) {
        let exact = |list: &[i64]| list.iter().map(|&c| whole(c)).collect::<Vec<_>>();
        let radius = FourierRadius::new(exact(&cos), exact(&sin));
        prop_assume!(!radius.is_zero());
        let squared = SquaredForm::new(&radius).unwrap();
        let equation = squared.expand();
        let f = equation.polynomial();
        let of_series = Topology::of_radius(&radius, f.lowest_degree().unwrap(), &Limits::none()).unwrap();
        let swept = topology(f);
        let kinds = |t: &Topology| {
            let mut kinds: Vec<_> = t.components.iter().map(|c| (c.kind.name(), c.contains.len())).collect();
            kinds.sort_unstable();
            kinds
        };
        prop_assert_eq!(kinds(&of_series), kinds(&swept));
        let points = |t: &Topology| {
            let mut points: Vec<_> = t
                .singular_points
                .iter()
                .map(|p| {
                    let at = p.at.each_ref().map(|c| format!("{}", (c.to_f64() * 1e6).round() + 0.0));
                    (at, p.singularity.multiplicity, p.singularity.real_half_branches)
                })
                .collect();
            points.sort_unstable();
            points
        };
        prop_assert_eq!(points(&of_series), points(&swept));
        let find = |t: &Topology| {
            let bounded = t.components.iter().find(|c| c.kind == ComponentKind::Oval);
            bounded.map(|c| c.extent.each_ref().map(|ends| ends.each_ref().map(middle)))
        };
        for (a, b) in find(&of_series).iter().flatten().flatten().zip(find(&swept).iter().flatten().flatten()) {
            prop_assert!((a - b).abs() <= 1e-12 * (1.0 + a.abs()), "{a} {b}");
        }
    }

    /// y^a = x^b has δ = ((a − 1)(b − 1) + gcd − 1)/2 and gcd(a, b) branches.
    #[test]
    fn the_places_of_a_quasihomogeneous_point(a in 2usize..9, b in 1usize..9) {
        let field = PrimeField::new(2_147_483_647);
        let gcd = (1..=a.min(b)).rev().find(|d| a % d == 0 && b % d == 0).unwrap();
        let mut rows = vec![vec![0]; a + 1];
        rows[0] = vec![0; b + 1];
        rows[0][b] = field.prime() - 1;
        rows[a] = vec![1];
        let types = types_above_zero(&field, &rows, (a - 1) * b + 1).unwrap();
        prop_assert_eq!(types.len(), 1);
        let place = Place { ramification: a / gcd, multiplicity: a.min(b) / gcd };
        prop_assert_eq!(&types[0].places, &vec![place; gcd]);
        prop_assert_eq!(types[0].intersection, (a - 1) * b);
        prop_assert_eq!(types[0].milnor(), (a - 1) * (b - 1));
        prop_assert_eq!(2 * types[0].delta(), (a - 1) * (b - 1) + gcd - 1);
    }
}

#[test]
fn the_genus_of_a_smooth_curve_and_of_conjugate_ones() {
    for d in 1..7usize {
        let f = curve(&[
            ((d, 0), 1),
            ((0, d), 1),
            ((0, 0), -2),
            ((1, 0), i64::from(d > 1)),
        ]);
        let genus = Genus::of(&f, &Limits::none()).unwrap().unwrap();
        assert_eq!(
            (genus.genus, genus.components),
            ((d - 1) * d.saturating_sub(2) / 2, 1)
        );
    }
    // (x² + y³)² − 2 y² is the product of two conjugate cubics x² ± √2 y + y³, which are smooth.
    let inner = curve(&[((2, 0), 1), ((0, 3), 1)]);
    let f = &(&inner * &inner) + &curve(&[((0, 2), -2)]);
    let genus = Genus::of(&f, &Limits::none()).unwrap().unwrap();
    assert_eq!((genus.genus, genus.components), (1, 2));
}

#[test]
fn points_one_above_the_other_are_told_apart() {
    // A node and a vertical tangent on one vertical line, for which the first projection is of no use.
    let node = curve(&[((2, 0), 1), ((3, 0), 1), ((0, 2), -1)]);
    let f = &node * &circle(&whole(1), &whole(5), &whole(1));
    let found = topology(&f);
    assert_eq!(found.singular_points.len(), 1);
    assert_eq!(found.singular_points[0].singularity.kind().name(), "node");
    assert_eq!(found.components.len(), 2);
    // Two isolated points with irrational coordinates inside a circle.
    let square = curve(&[((4, 0), 1), ((2, 0), -4), ((0, 0), 4), ((0, 2), 1)]);
    let found = topology(&(&square * &circle(&whole(0), &whole(0), &whole(9))));
    let outer = found
        .components
        .iter()
        .find(|c| c.kind == ComponentKind::Oval);
    assert_eq!(outer.unwrap().contains.len(), 2);
}

#[test]
fn factors_without_x_and_bounded_loops_are_not_lost() {
    let ring = circle(&whole(0), &whole(0), &whole(1));
    let line = curve(&[((0, 1), 1)]);
    // y² (x² + y² − 1): the line is found once, with both nodes.
    let found = topology(&(&(&line * &line) * &ring));
    assert_eq!(found.components.len(), 1);
    assert_eq!(found.singular_points.len(), 2);
    // The loop of an unbounded curve contains a circle.
    let crossed = curve(&[((3, 0), 1), ((2, 0), 1), ((0, 2), -1)]);
    let half = Rational::one() / whole(2);
    let small = circle(&-half, &whole(0), &(Rational::one() / whole(100)));
    let found = topology(&(&crossed * &small));
    let outer = found
        .components
        .iter()
        .find(|c| c.kind == ComponentKind::Unbounded);
    assert_eq!(outer.unwrap().contains.len(), 1);
}

/// Above an irrational critical value all points may be at R = 0, where the coefficients of the polynomial are exactly 0. The curve
/// is compared with itself, moved so that these points are elsewhere.
#[test]
fn points_at_0_above_irrational_values_are_found() {
    let parsed = |text: &str| {
        let form = crate::language::parse_form(text, "a test", crate::language::Numbers::Exact);
        let Ok(crate::shape::Form::Curve(curve)) = form else {
            panic!("{text} is a plane curve");
        };
        curve.polynomial().clone()
    };
    for text in [
        "y*(x^2+y^2-2)",
        "y*((x+1)^2+y^2-3)",
        "y*(2*x^2+y^2-1)",
        "y*(x^2+x-1+y^2)",
        "y*(x^2+x-1+y^3)",
        "y*(y^2-x^2+2)",
        "y*(x^2-2*y^2-2)",
        "y*(x^4+y^4-2)",
        "y*(x^3+y^2-2)",
        "y^2*(x^2-2)+y^4",
        "(x^2+y^2-2)*(x^2+2*y^2-2)",
        "y*(x^2+y^2-2)*(y-3)*(y+x)",
    ] {
        let moved = text.replace('y', "(y-1)");
        assert_eq!(
            invariants(&parsed(text)),
            invariants(&parsed(&moved)),
            "{text}"
        );
    }
    let (components, points) = invariants(&parsed("y*(x^2+y^2-2)"));
    assert_eq!(components.len(), 1);
    assert_eq!(points, [("node", 2, Some(1)), ("node", 2, Some(1))]);
}

/// Real points at infinity to which no real branch goes.
#[test]
fn bounded_curves_have_no_asymptotes() {
    let irrational = curve(&[((0, 4), 1), ((2, 2), -4), ((4, 0), 4), ((0, 0), 1)]);
    let found = topology(&irrational);
    assert!(found.components.is_empty());
    assert!(found.at_infinity.asymptotes.is_empty() && found.at_infinity.undecided.is_empty());
    // With 1 on the other side these are two hyperbolas, whose asymptotes are not decided.
    let real = curve(&[((0, 4), 1), ((2, 2), -4), ((4, 0), 4), ((0, 0), -1)]);
    assert_eq!(topology(&real).at_infinity.undecided.len(), 2);
}
