//! The paper's theorems, examples and appendices, by their numbers.
#![expect(clippy::unwrap_used, reason = "a test fails by panicking")]

use std::path::Path;

use stellate::exact::Rational;
use stellate::fit::{FitOptions, FitSize, fit, fourier_coefficients, read_contour};
use stellate::implicitize::{SquaredForm, parity_sums, square_away};
use stellate::language::{Numbers, parse_form};
use stellate::limits::Limits;
use stellate::parametrize::{
    AngleRange, Branch, BranchFitOptions, BranchRadius, Parametrization, PolarMethod, fit_branch,
    fourier_branches, parametrize,
};
use stellate::poly::{BinaryForm, PlanePolynomial, Ring, SparsePolynomial};
use stellate::roots::RealRoot;
use stellate::sample::{Direction, Ray, RaySolver};
use stellate::shape::{Form, FourierRadius, ImplicitCurve};

fn radius(cos: &[&str], sin: &[&str]) -> FourierRadius {
    let parse = |v: &[&str]| v.iter().map(|t| t.parse().unwrap()).collect();
    FourierRadius::new(parse(cos), parse(sin))
}

fn implicit(r: &FourierRadius) -> PlanePolynomial {
    SquaredForm::new(r).unwrap().expand().polynomial().clone()
}

#[test]
fn theorem_2_of_a_limacon() {
    let f = implicit(&radius(&["1", "1/5"], &["0", "0.1"]));
    let shown: Vec<String> = f
        .terms()
        .map(|((i, j), c)| format!("{c}:{i},{j}"))
        .collect();
    assert_eq!(
        shown,
        [
            "100:4,0", "200:2,2", "100:0,4", "-40:3,0", "-20:2,1", "-40:1,2", "-20:0,3", "-96:2,0",
            "4:1,1", "-99:0,2"
        ]
    );
}

#[test]
fn theorem_2_without_harmonics_is_a_circle() {
    let f = implicit(&radius(&["3/2"], &[]));
    let shown: Vec<String> = f
        .terms()
        .map(|((i, j), c)| format!("{c}:{i},{j}"))
        .collect();
    assert_eq!(shown, ["4:2,0", "4:0,2", "-9:0,0"]);
}

#[test]
fn theorem_2_needs_a_radius_that_is_not_zero() {
    let error = SquaredForm::new(&radius(&["0", "0"], &["0", "0"])).unwrap_err();
    assert!(error.to_string().contains("single point"), "{error}");
}

#[test]
fn theorem_2_of_odd_harmonics_alone_is_a_perfect_square() {
    let form = SquaredForm::new(&radius(&["0", "1", "0", "1/3"], &["0", "2", "0", "-1"])).unwrap();
    assert!(form.is_perfect_square());
    let (reduced, full) = (form.expand(), form.expand_unreduced());
    let g = reduced.polynomial();
    assert_eq!(g.degree(), Some(4));
    assert_eq!(&(g * g).primitive(), full.polynomial());
}

/// Appendix B: N = 3 with symbolic coefficients, through the code that builds (7) and (8).
#[test]
fn appendix_b_with_symbols() {
    type Symbolic = SparsePolynomial<5>;
    // Variables: K0, K1, K2, K3 and ρ = r².
    let k: Vec<Symbolic> = (0..4).map(Symbolic::variable).collect();
    let rho = Symbolic::variable(4);
    let one = Symbolic::constant(Rational::one());
    let (odd, even) = parity_sums(&k, &rho);
    let exponent = |e: usize| u32::try_from(e).unwrap();
    let parts = square_away(3, &one, |e| rho.pow(exponent(e)), odd.as_ref(), &even);
    let f = parts.top.minus(&parts.middle.unwrap()).plus(&parts.low);
    // ((r²)² − K1 r² − K3)² − r² (K0 r² + K2)²
    let left = rho.squared().minus(&k[1].times(&rho)).minus(&k[3]);
    let right = k[0].times(&rho).plus(&k[2]);
    let printed = left.squared().minus(&rho.times(&right.squared()));
    assert_eq!(f, printed);
    assert_eq!(f.len(), 9);
}

/// The even case of Eq. (7) with symbols: N = 4.
#[test]
fn equation_7_with_symbols() {
    type Symbolic = SparsePolynomial<6>;
    let k: Vec<Symbolic> = (0..5).map(Symbolic::variable).collect();
    let rho = Symbolic::variable(5);
    let one = Symbolic::constant(Rational::one());
    let (odd, even) = parity_sums(&k, &rho);
    let exponent = |e: usize| u32::try_from(e).unwrap();
    let parts = square_away(4, &one, |e| rho.pow(exponent(e)), odd.as_ref(), &even);
    let f = parts.top.minus(&parts.middle.unwrap()).plus(&parts.low);
    // r² (r⁴ − K1 r² − K3)² − (K0 r⁴ + K2 r² + K4)²
    let left = rho.squared().minus(&k[1].times(&rho)).minus(&k[3]);
    let right = k[0].times(&rho).plus(&k[2]).times(&rho).plus(&k[4]);
    assert_eq!(f, rho.times(&left.squared()).minus(&right.squared()));
}

#[test]
fn lemma_3_takes_two_hundred_harmonics_back() {
    let coefficient = |n: i64, k: i64| {
        Rational::from((n * 7919 + k * 104_729) % 1999 - 1000) / Rational::from(1 + n * n)
    };
    for harmonics in [40, 199, 200] {
        let cos = (0..=harmonics).map(|n| coefficient(n, 1).abs()).collect();
        let sin = (0..=harmonics).map(|n| coefficient(n, 2)).collect();
        let r = FourierRadius::new(cos, sin);
        let branches = fourier_branches(&SquaredForm::new(&r).unwrap().expand()).unwrap();
        assert_eq!((branches.lemma, branches.step), (3, 1));
        assert_eq!(branches.radii[0], r);
    }
}

/// Definition 1 as printed has half the right normalisation: a circle of radius 1 comes back with
/// radius 1/2. (Erratum "Definition 1".)
#[test]
fn definition_1_as_printed_loses_a_factor_of_two() {
    let samples = [1.0; 16];
    let count = 16.0;
    let printed_a0 = samples.iter().sum::<f64>() / (2.0 * count);
    let (cos, _) = fourier_coefficients(&samples, 3).unwrap();
    assert!((cos[0] - 1.0).abs() < 1e-15);
    assert!((printed_a0 - cos[0] / 2.0).abs() < 1e-15);
}

/// Example 2: a contour with N = 39 becomes a polynomial of degree 80 in three parts.
#[test]
fn example_2_has_degree_80_and_gives_its_harmonics_back() {
    for name in ["e02-butterfly/butterfly.csv", "e02-jet/jet.csv"] {
        let path = Path::new(env!("CARGO_MANIFEST_DIR"))
            .join("paper-examples")
            .join(name);
        let contour = read_contour(&path).unwrap();
        let fit = fit(&contour, &FitOptions::new(FitSize::Harmonics(39))).unwrap();
        let curve = SquaredForm::new(&fit.radius).unwrap().expand();
        assert_eq!(curve.polynomial().homogeneous_degrees(), [80, 79, 78]);
        assert_eq!(curve.polynomial().lowest_degree(), Some(78));
        assert_eq!(fourier_branches(&curve).unwrap().radii[0], fit.radius);
    }
}

/// Example 5 (Lemma 2): r² = (c² − s²)/c⁴, real only where cos 2θ ≥ 0. (Erratum: printed for all θ.)
#[test]
fn example_5_is_real_on_two_arcs_only() {
    let curve = polar("x^4 - x^2 + y^2");
    assert_eq!(
        (curve.method, curve.step, curve.branches.len()),
        (PolarMethod::Lemma(2), 2, 2)
    );
    assert!(curve.lines.is_empty());
    for branch in &curve.branches {
        assert_eq!(
            ranges(&branch.real),
            ["[0, pi/4]", "[3*pi/4, 5*pi/4]", "[7*pi/4, 2*pi]"]
        );
    }
    let at = |k: usize, theta: f64| curve.branches[k].radius.approximate(theta);
    let expected = (0.6f64.cos().powi(2) - 0.6f64.sin().powi(2)).sqrt() / 0.6f64.cos().powi(2);
    assert!((at(0, 0.6) - expected).abs() < 1e-14);
    assert!((at(1, 0.6) + expected).abs() < 1e-14);
}

/// Example 7 (Lemma 3): r = c + s ∓ √(sin 2θ), real on [0, π/2] and, with r < 0, on [π, 3π/2].
#[test]
fn example_7_has_two_branches_on_two_quarters() {
    let curve = polar("x^2 + y^2 - 2x - 2y + 1");
    assert_eq!(
        (curve.method, curve.step, curve.branches.len()),
        (PolarMethod::Lemma(3), 1, 2)
    );
    for (branch, sign) in curve.branches.iter().zip([1.0, -1.0]) {
        assert_eq!(ranges(&branch.real), ["[0, pi/2]", "[pi, 3*pi/2]"]);
        assert_eq!(ranges(&branch.positive), ["[0, pi/2]"]);
        let expected = 0.3f64.cos() + 0.3f64.sin() + sign * 0.6f64.sin().sqrt();
        assert!((branch.radius.approximate(0.3) - expected).abs() < 1e-14);
    }
}

fn polar(text: &str) -> Parametrization {
    match parse_form(text, "example", Numbers::Exact).unwrap() {
        Form::Curve(curve) => parametrize(&curve, &Limits::none()).unwrap(),
        other => panic!("{other:?}"),
    }
}

fn ranges(list: &[AngleRange]) -> Vec<String> {
    let text = |r: &AngleRange| {
        let [a, b] = r.closed.map(|closed| if closed { "[]" } else { "()" });
        format!(
            "{}{}, {}{}",
            &a[..1],
            r.from.describe(),
            r.to.describe(),
            &b[1..]
        )
    };
    list.iter().map(text).collect()
}

fn example_9() -> ImplicitCurve {
    let path = concat!(
        env!("CARGO_MANIFEST_DIR"),
        "/paper-examples/e09-sixth-degree/curve.txt"
    );
    let text = std::fs::read_to_string(path).unwrap();
    let Form::Curve(curve) = parse_form(&text, path, Numbers::Exact).unwrap() else {
        panic!("a plane curve")
    };
    curve
}

/// The polar form as printed, the coefficient of each r^d with c for cos θ and s for sin θ.
const EXAMPLE_9_PRINTED: [(usize, &str); 7] = [
    (
        6,
        "408c*s + 57s*c^5 + 807c^2 - 478c^4 + 52c^6 - 500 - 467c^3*s",
    ),
    (
        5,
        "31700s - 25461s*c^2 + 2434c^4*s - 4156c^5 - 16672c + 27845c^3",
    ),
    (
        4,
        "1253127c^4 + 2646954c^3*s - 4326891c^2 - 3285437c*s + 4495262",
    ),
    (3, "-96384404c^3 - 276518665s + 45302709c + 117382579s*c^2"),
    (2, "-18536463436 + 5603905960c*s + 8788031666c^2"),
    (1, "72289297932c + 622833383233s"),
    (0, "30547238788903"),
];

/// A polynomial in c and s as a form of degree d, with c² + s² = 1.
fn on_the_circle(text: &str, d: usize) -> BinaryForm {
    let mut sum = BinaryForm::new(vec![0; d + 1]);
    let squared_length = BinaryForm::new([1, 0, 1]);
    let plane = if text.contains(['c', 's']) {
        let Form::Curve(curve) = parse_form(
            &text.replace('c', "x").replace('s', "y"),
            "printed",
            Numbers::Exact,
        )
        .unwrap() else {
            panic!("a polynomial in c and s")
        };
        curve.polynomial().clone()
    } else {
        PlanePolynomial::from_terms([((0, 0), text.parse().unwrap())])
    };
    for part in plane.parts() {
        let rho = (part.degree()..d)
            .step_by(2)
            .fold(part.clone(), |form, _| &form * &squared_length);
        sum = &sum + &rho;
    }
    sum
}

#[test]
fn example_9_is_printed_with_x_and_y_exchanged() {
    let f = example_9();
    let mut differs = 0;
    for (d, printed) in EXAMPLE_9_PRINTED {
        let printed = on_the_circle(printed, d);
        let part = f.polynomial().part(d).unwrap().clone();
        let exchanged = BinaryForm::new(part.coefficients().into_iter().rev());
        assert_eq!(printed, exchanged, "r^{d}");
        differs += usize::from(printed != part);
    }
    assert_eq!(differs, 6, "as printed, only the constant is right");
}

#[test]
fn example_9_has_three_radii_at_the_fold() {
    let f = example_9();
    let found = parametrize(&f, &Limits::none()).unwrap();
    assert_eq!(found.method, PolarMethod::Numeric);
    let root = |b: &Branch| match &b.radius {
        BranchRadius::Root(root) => Some(root.clone()),
        _ => None,
    };
    let first = root(&found.branches[0]).unwrap();
    let discriminant = first.discriminant();
    assert_eq!(discriminant.len(), 31);
    let zeros: Vec<String> = RealRoot::all_of(&discriminant)
        .iter()
        .map(|t| t.to_decimal(12))
        .collect();
    assert_eq!(zeros, ["0.819692850654", "0.830370818503"]);
    // 219.3412…° and 219.7053…°, where the positive branches end: three of them between.
    let positive: Vec<String> = found
        .branches
        .iter()
        .flat_map(|b| &b.positive)
        .map(|r| format!("{} {}", r.from.to_decimal(6), r.to.to_decimal(6)))
        .collect();
    assert_eq!(
        positive,
        [
            "0.000000 3.834580",
            "3.828227 3.834580",
            "3.828227 6.283185"
        ]
    );
    let counts: Vec<usize> = ["219.34", "219.35", "219.5", "219.70", "219.71"]
        .iter()
        .map(|degrees| {
            let Ray::Points(points) = RaySolver::new(f.polynomial())
                .solve(&Direction::from_degrees(&degrees.parse().unwrap()))
            else {
                panic!("no line")
            };
            points.iter().filter(|p| p.r > 0.0).count()
        })
        .collect();
    assert_eq!(counts, [1, 3, 3, 3, 1]);
    // No branch goes around; the outermost radius does, with one jump, and is fitted.
    let fit = fit_branch(&found, &BranchFitOptions::default(), &Limits::none())
        .unwrap()
        .unwrap();
    assert_eq!(
        (fit.branch, fit.jumps.len(), fit.radius.harmonics()),
        (None, 1, 20)
    );
    let bound = fit.error_at_samples.to_f64();
    assert!(bound > 1.0 && bound < 10.0, "{bound}");
    assert!(fit.error_between < fit.error_at_samples.clone() * Rational::from(2));
}

/// Theorem 5 as printed allows five homogeneous parts of any degrees; parts of degrees 5, 1, 0 give a general
/// quintic.
#[test]
fn theorem_5_needs_equally_spaced_degrees() {
    let Form::Curve(curve) = parse_form("x^5 - x - 1 + y^5", "<form>", Numbers::Exact).unwrap()
    else {
        panic!("a plane curve")
    };
    let found = parametrize(&curve, &Limits::none()).unwrap();
    assert_eq!(found.method, PolarMethod::Numeric);
    assert!(
        found.notes[0].contains("degrees 5, 1, 0: degree 5 in r"),
        "{:?}",
        found.notes
    );
    assert!(
        fit_branch(&found, &BranchFitOptions::default(), &Limits::none())
            .unwrap()
            .is_none()
    );
}

/// Example 8 is also a cubic in r⁴: the same certified radii as from its two factors.
#[test]
fn example_8_is_a_cubic_in_r_to_the_fourth_too() {
    let plane = |text: &str| {
        let Form::Curve(curve) = parse_form(text, "<form>", Numbers::Exact).unwrap() else {
            panic!("a plane curve")
        };
        curve.polynomial().clone()
    };
    let (outer, inner) = ("(x^4 - 1.9x^2*y^2 + y^4 - 0.5)", "(x^8 + y^8 - 1e-5)");
    let whole = plane(&format!("{outer}*{inner}*x^10*y^10"));
    assert_eq!(whole.homogeneous_degrees(), [32, 28, 24, 20]);
    assert_eq!(whole.term_count(), 12);
    let radii =
        |f: &PlanePolynomial, direction: &Direction| match RaySolver::new(f).solve(direction) {
            Ray::Points(points) => points.iter().map(|p| p.r).collect::<Vec<f64>>(),
            Ray::Line => Vec::new(),
        };
    for direction in Direction::around(72) {
        let mut expected = [
            radii(&plane(outer), &direction),
            radii(&plane(inner), &direction),
        ]
        .concat();
        expected.sort_by(|a, b| b.total_cmp(a));
        let found = radii(&whole, &direction);
        // Along the axes the whole line belongs to it.
        let on_axis = direction.u().is_zero() || direction.v().is_zero();
        assert_eq!(found, if on_axis { Vec::new() } else { expected });
    }
}
