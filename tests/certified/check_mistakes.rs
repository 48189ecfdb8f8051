//! The usual mistakes, planted one by one: each is named.

use stellate::check::{GivenPoint, GivenRadius, Reference};
use stellate::exact::Rational;
use stellate::limits::Limits;
use stellate::poly::{Ring, SparsePolynomial};
use stellate::shape::{FourierRadius, ImplicitSurface};

use crate::common::float_program::{Terms, changed, checked, lopsided, names, polynomial, rounded};
use crate::common::forms::{plane, space};
use crate::common::power_of_two;

#[test]
fn every_usual_mistake_of_the_series_is_named() {
    let right = lopsided();
    let of = |f: &dyn Fn(usize, f64, f64) -> [f64; 2]| rounded(&changed(&right, f));
    let first = |n: usize, value: f64, other: f64| if n == 0 { value } else { other };
    let cases: Vec<(&str, Terms)> = vec![
        ("a0 halved", of(&|n, a, b| [first(n, a / 2.0, a), b])),
        ("a0 doubled", of(&|n, a, b| [first(n, a * 2.0, a), b])),
        ("all coefficients halved", of(&|_, a, b| [a / 2.0, b / 2.0])),
        (
            "all coefficients doubled",
            of(&|_, a, b| [a * 2.0, b * 2.0]),
        ),
        (
            "an and bn halved",
            of(&|n, a, b| [first(n, a, a / 2.0), b / 2.0]),
        ),
        (
            "an and bn doubled",
            of(&|n, a, b| [first(n, a, a * 2.0), b * 2.0]),
        ),
        ("sine sign flipped", of(&|_, a, b| [a, -b])),
        (
            "last harmonic dropped",
            of(&|n, a, b| if n < 3 { [a, b] } else { [0.0, 0.0] }),
        ),
    ];
    for (name, got) in cases {
        let found = checked(&right, &got);
        assert_eq!(names(&found), [name]);
        assert!(!found.passes(None) && !found.passes(Some(9)));
    }
}

#[test]
fn every_usual_mistake_of_the_polynomial_is_named() {
    let right = lopsided();
    let terms = rounded(&right);
    let signed = |sign: &dyn Fn([u32; 3]) -> bool| -> Terms {
        let term = |(e, c): &([u32; 3], f64)| (*e, if sign(*e) { -c } else { *c });
        terms.iter().map(term).collect()
    };
    let times_rho: Terms = terms
        .iter()
        .flat_map(|([i, j, _], c)| [([i + 2, *j, 0], *c), ([*i, j + 2, 0], *c)])
        .collect();
    let cases: Vec<(&str, Terms)> = vec![
        (
            "x and y swapped",
            terms
                .iter()
                .map(|([i, j, _], c)| ([*j, *i, 0], *c))
                .collect(),
        ),
        ("sine sign flipped", signed(&|[_, j, _]| j % 2 == 1)),
        ("x mirrored", signed(&|[i, _, _]| i % 2 == 1)),
        (
            "curve reflected in the origin",
            signed(&|[i, j, _]| (i + j) % 2 == 1),
        ),
        ("degree too high by two", times_rho),
    ];
    for (name, got) in cases {
        assert_eq!(names(&checked(&right, &got)), [name]);
    }
}

#[test]
fn the_unsquared_forms_and_the_square_are_named() {
    // N = 2, by hand: r (r² − odd) = even with odd = x/2, even = ρ + (x² − y²)/4.
    let right = FourierRadius::new(vec![1.into(), power_of_two(-1), power_of_two(-2)], vec![]);
    let left = plane("x^2 + y^2 - x/2");
    let even = plane("x^2 + y^2 + x^2/4 - y^2/4");
    // Both are made primitive: 2x² + 2y² − x and 5x² + 3y².
    let [left, even] = [left, even].map(|f| SparsePolynomial::from(&f));
    let half = power_of_two(-1);
    let quarter = power_of_two(-2);
    let (left, even) = (left.scaled(&half), even.scaled(&quarter));
    let reference = Reference::of_radius(&right).unwrap();
    let f = reference.polynomial().clone();
    assert_eq!(
        f,
        left.squared()
            .times(&SparsePolynomial::from(&plane("x^2 + y^2")))
            .minus(&even.squared()),
        "Eq. (7)"
    );
    for (got, name) in [
        (left.clone(), "unsquared form"),
        (left.minus(&even), "unsquared form"),
        (left.squared().minus(&even.squared()), "r^2 left out"),
        (f.squared(), "squared once too often"),
    ] {
        assert_eq!(names(&reference.check_coefficients(&got)), [name]);
    }
}

#[test]
fn a_degree_too_high_by_a_harmonic_of_the_contour_is_named() {
    let four = {
        let mut cos = lopsided().cosines().to_vec();
        cos.push(Rational::from(1) / Rational::from(17));
        FourierRadius::new(cos, lopsided().sines().to_vec())
    };
    let reference = Reference::of_radius(&lopsided())
        .unwrap()
        .with_next(four.clone());
    let found = reference.check_coefficients(&polynomial(&rounded(&four)));
    assert_eq!(names(&found), ["one harmonic more"]);
}

#[test]
fn mistakes_with_the_coordinates_of_a_surface_are_named() {
    let f = space("x^4 + 2y^2 + 3z^2*x + z + y = 5");
    let reference = Reference::of_surface(&ImplicitSurface::new(f));
    for (text, name) in [
        ("y^4 + 2x^2 + 3z^2*y + z + x = 5", "x and y swapped"),
        ("z^4 + 2y^2 + 3x^2*z + x + y = 5", "x and z swapped"),
        ("x^4 + 2z^2 + 3y^2*x + y + z = 5", "y and z swapped"),
        ("x^4 + 2y^2 - 3z^2*x + z + y = 5", "x mirrored"),
        ("x^4 + 2y^2 + 3z^2*x + z - y = 5", "y mirrored"),
        ("x^4 + 2y^2 + 3z^2*x - z + y = 5", "z mirrored"),
        ("x^4 + 2y^2 - 3z^2*x - z - y = 5", "reflected in the origin"),
        ("16x^4 + 8y^2 + 24z^2*x + 2z + 2y = 5", "half the size"),
        (
            "(x^4 + 2y^2 + 3z^2*x + z + y - 5)*(x^2 + y^2 + z^2)",
            "degree too high by two",
        ),
        (
            "(x^4 + 2y^2 + 3z^2*x + z + y - 5)^2",
            "squared once too often",
        ),
    ] {
        assert_eq!(
            names(&reference.check_coefficients(&space(text))),
            [name],
            "{text}"
        );
    }
}

#[test]
fn one_wrong_coefficient_is_no_usual_mistake() {
    let right = lopsided();
    let mut got = rounded(&right);
    got[7].1 *= 1.0 + 1e-5;
    let found = checked(&right, &got);
    assert_eq!(names(&found), Vec::<&str>::new());
    assert_eq!(found.below(9).len(), 1);
    assert!((found.worst(1)[0].deviation.digits() - 5.0).abs() < 1e-6);
    assert!(found.passes(Some(4)) && !found.passes(Some(6)));
}

#[test]
fn mistakes_in_radii_and_points_are_named() {
    let right = lopsided();
    let reference = Reference::of_radius(&right).unwrap();
    let limits = Limits::none();
    let angles = (0..90).map(|k| f64::from(k) * 0.07);
    let r = |theta: f64| right.approximate(theta);
    let cases: [(&str, &dyn Fn(f64) -> f64); 6] = [
        ("a0 halved", &|t| r(t) - 0.5),
        ("all coefficients halved", &|t| r(t) / 2.0),
        ("sine sign flipped", &|t| r(-t)),
        ("x and y swapped", &|t| r(std::f64::consts::FRAC_PI_2 - t)),
        ("curve reflected in the origin", &|t| {
            r(t + std::f64::consts::PI)
        }),
        ("reflected branch", &|t| -r(t + std::f64::consts::PI)),
    ];
    for (name, wrong) in cases {
        let given: Vec<GivenRadius> = angles
            .clone()
            .map(|theta| GivenRadius {
                line: 1,
                theta,
                r: wrong(theta),
            })
            .collect();
        let found = reference.check_radii(&given, &limits).unwrap();
        assert_eq!(names(&found), [name]);
        // The counts are those of the numbers with which the mistakes were tried, some of the 90.
        let diagnosis = &found.diagnoses[0];
        assert!(diagnosis.faults <= diagnosis.compared && diagnosis.compared < given.len());
        if name == "reflected branch" {
            // Its points are those of the curve.
            continue;
        }
        let points: Vec<GivenPoint> = given
            .iter()
            .map(|g| GivenPoint {
                line: 1,
                position: [g.r * g.theta.cos(), g.r * g.theta.sin(), 0.0],
            })
            .collect();
        assert_eq!(
            names(&reference.check_points(&points, &limits).unwrap()),
            [name]
        );
    }
}

/// r = 1 + cos(t)/4 + …, N = 3: the parts of F have degrees 8, 7 and 6.
#[test]
fn mistakes_with_a_part_or_one_coefficient_are_named() {
    let right = lopsided();
    let terms = rounded(&right);
    let part = |degree: u32, factor: f64| -> Terms {
        let term = |(e, c): &([u32; 3], f64)| {
            let is_part = e.iter().sum::<u32>() == degree;
            (*e, if is_part { c * factor } else { *c })
        };
        terms.iter().map(term).collect()
    };
    let of = |f: &dyn Fn(usize, f64, f64) -> [f64; 2]| rounded(&changed(&right, f));
    let zero_at = |k: usize, n: usize, v: f64| if n == k { 0.0 } else { v };
    let sign_at = |k: usize, n: usize, v: f64| if n == k { -v } else { v };
    let cases: [(&str, Terms); 6] = [
        ("cross term once", part(7, 0.5)),
        ("sign of the low part", part(6, -1.0)),
        ("last sine dropped", of(&|n, a, b| [a, zero_at(3, n, b)])),
        ("last cosine dropped", of(&|n, a, b| [zero_at(3, n, a), b])),
        ("sign of a2 flipped", of(&|n, a, b| [sign_at(2, n, a), b])),
        ("sign of b1 flipped", of(&|n, a, b| [a, sign_at(1, n, b)])),
    ];
    for (name, got) in cases {
        let found = checked(&right, &got);
        assert_eq!(names(&found), [name]);
        assert!(!found.passes(None), "{name}");
    }
}

#[test]
fn what_no_mistake_explains_is_said_by_kind() {
    let right = lopsided();
    let explained = |found: &stellate::check::Comparison, name: &str, text: &str| {
        assert_eq!(names(found), [name]);
        let said = &found.diagnoses[0].explanation;
        assert!(said.contains(text), "{said}");
        assert!(!found.passes(None));
    };
    let third: Terms = rounded(&right)
        .into_iter()
        .map(|(e, c)| {
            (
                e,
                if e.iter().sum::<u32>() == 7 {
                    c / 3.0
                } else {
                    c
                },
            )
        })
        .collect();
    let found = checked(&right, &third);
    explained(
        &found,
        "no correct digit",
        "8 of 20 have no correct digit: all 8 terms have degree 7; got/exact = 1/3",
    );
    #[expect(clippy::cast_possible_truncation, reason = "that is the mistake")]
    let single: Terms = rounded(&right)
        .into_iter()
        .map(|(e, c)| (e, f64::from(c as f32)))
        .collect();
    explained(&checked(&right, &single), "single precision", "float32");
    let garbage: Terms = rounded(&right)
        .into_iter()
        .zip(1i32..)
        .map(|((e, _), k)| (e, f64::from(k * k % 7 + 1)))
        .collect();
    explained(
        &checked(&right, &garbage),
        "no correct digit",
        "have no correct digit",
    );
}

#[test]
fn angles_in_degrees_and_a_forgotten_center_are_named() {
    let right = lopsided();
    let limits = Limits::none();
    let degrees: Vec<GivenRadius> = (0..90)
        .map(|k| {
            let theta = f64::from(k) * 4.0;
            GivenRadius {
                line: 1,
                theta,
                r: right.approximate(theta.to_radians()),
            }
        })
        .collect();
    for reference in [
        Reference::of_radius(&right).unwrap(),
        Reference::of_curve(
            &stellate::implicitize::SquaredForm::new(&right)
                .unwrap()
                .expand(),
        ),
    ] {
        let found = reference.check_radii(&degrees, &limits).unwrap();
        assert_eq!(names(&found), ["degrees for radians"]);
    }
    let centered = right
        .clone()
        .with_center([Rational::from(7), Rational::from(-3)]);
    let reference = Reference::of_radius(&centered).unwrap();
    let points = |[a, b]: [f64; 2]| -> Vec<GivenPoint> {
        let angles = (0..60).map(|k| f64::from(k) * 0.1);
        let point = |t: f64| {
            let r = right.approximate(t);
            let position = [a + r * t.cos(), b + r * t.sin(), 0.0];
            GivenPoint { line: 1, position }
        };
        angles.map(point).collect()
    };
    for (center, expected) in [
        ([0.0, 0.0], &[][..]),
        ([7.0, -3.0], &["center forgotten"]),
        ([-7.0, 3.0], &["center forgotten"]),
    ] {
        let found = reference.check_points(&points(center), &limits).unwrap();
        assert_eq!(names(&found), expected, "{center:?}");
    }
    let found = reference
        .check_points(&points([50.0, 0.0]), &limits)
        .unwrap();
    assert_eq!(names(&found), ["no correct digit"]);
}

/// Points in other units, and points of a radius that was taken at an angle in degrees.
#[test]
fn points_of_another_scale_and_points_of_degrees_are_named() {
    let right = lopsided();
    let reference = Reference::of_radius(&right).unwrap();
    let limits = Limits::none();
    let points = |radius: &dyn Fn(f64) -> f64| -> Vec<GivenPoint> {
        let angles = (0..60).map(|k| f64::from(k) * 0.1 - 3.0);
        let point = |(line, t): (usize, f64)| {
            let position = [radius(t) * t.cos(), radius(t) * t.sin(), 0.0];
            GivenPoint { line, position }
        };
        (1..).zip(angles).map(point).collect()
    };
    for factor in [10.0, 0.001, 25.4, 7.0 / 3.0, 1.5, 0.9] {
        let scaled = points(&|t| factor * right.approximate(t));
        let found = reference.check_points(&scaled, &limits).unwrap();
        // Twice the size is the mistake of all coefficients.
        assert_eq!(names(&found)[0], "scale", "{factor}");
        let said = &found.diagnoses[0].explanation;
        let number: f64 = said.split_whitespace().nth(3).unwrap().parse().unwrap();
        assert!((number / factor - 1.0).abs() < 1e-10, "{factor}: {said}");
    }
    // Points that are wrong in y alone have no common factor.
    let mut stretched = points(&|t| right.approximate(t));
    for point in &mut stretched {
        point.position[1] *= 1.001;
    }
    let found = reference.check_points(&stretched, &limits).unwrap();
    assert!(!names(&found).contains(&"scale"), "{:?}", names(&found));
    let of_degrees = points(&|t| right.approximate(t.to_degrees()));
    let found = reference.check_points(&of_degrees, &limits).unwrap();
    assert_eq!(names(&found), ["degrees for radians"]);
}

/// A matrix c[i][j] has the coefficients of rows i,j,value.
#[test]
fn coefficients_may_be_a_matrix() {
    use stellate::language::Numbers;
    use stellate::reading::read_coefficients;
    let right = lopsided();
    let terms = rounded(&right);
    let degree = terms.iter().map(|(e, _)| e[0] + e[1]).max().unwrap();
    let entry = |i: u32, j: u32| {
        let found = terms.iter().find(|(e, _)| *e == [i, j, 0]);
        found.map_or(0.0, |(_, c)| *c)
    };
    let row =
        |i: u32| -> Vec<String> { (0..=degree).map(|j| format!("{:?}", entry(i, j))).collect() };
    let rows: Vec<String> = (0..=degree).map(|i| row(i).join(",")).collect();
    let list: Vec<String> = rows.iter().map(|row| format!("[{row}]")).collect();
    let listed: Vec<String> = terms
        .iter()
        .map(|([i, j, _], c)| format!("{i},{j},{c:?}"))
        .collect();
    let read = |text: &str| read_coefficients(text, "c.csv", Numbers::F64).unwrap();
    let expected = read(&listed.join("\n"));
    assert_eq!(read(&rows.join("\n")), expected);
    assert_eq!(read(&format!("[{}]", list.join(",\n"))), expected);
    // Three columns that could be rows of terms, but for a term that comes twice.
    assert_eq!(read("0,0,1\n0,0,1\n1,0,0"), read("0,2,1\n1,2,1\n2,0,1"));
    for (text, part) in [
        ("1,0\n0,x", "c.csv, line 2"),
        ("[[1, 0], [0, true]]", "c.csv: [1]"),
        ("[1, 2]", "a list of lists of numbers, c[i][j]"),
        ("1,0\n0,0", "no point satisfies it"),
        ("1,2\n3", "expected 2 columns, found 1"),
        ("1,2", "i,j,coefficient"),
    ] {
        let error = read_coefficients(text, "c.csv", Numbers::F64)
            .unwrap_err()
            .to_string();
        assert!(error.contains(part), "{text}: {error}");
    }
}
