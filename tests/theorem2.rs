//! Theorem 2 against independent oracles, and the way back.
#![expect(clippy::unwrap_used, reason = "a test fails by panicking")]

use proptest::prelude::*;
use stellate::exact::Rational;
use stellate::implicitize::{SquaredForm, parity_sums, square_away};
use stellate::parametrize::fourier_branches;
use stellate::poly::{PlanePolynomial, Ring, SparsePolynomial};
use stellate::shape::FourierRadius;

mod common;
use common::{radii, rational, theorem_2_oracle};

fn radius(cos: &[&str], sin: &[&str]) -> FourierRadius {
    let parse = |v: &[&str]| v.iter().map(|t| t.parse().unwrap()).collect();
    FourierRadius::new(parse(cos), parse(sin))
}

fn implicit(r: &FourierRadius) -> PlanePolynomial {
    SquaredForm::new(r).unwrap().expand().polynomial().clone()
}

#[test]
fn the_limacon_of_the_first_example() {
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
fn no_harmonics_is_a_circle() {
    let f = implicit(&radius(&["3/2"], &[]));
    let shown: Vec<String> = f
        .terms()
        .map(|((i, j), c)| format!("{c}:{i},{j}"))
        .collect();
    assert_eq!(shown, ["4:2,0", "4:0,2", "-9:0,0"]);
}

#[test]
fn a_zero_radius_is_no_curve() {
    let error = SquaredForm::new(&radius(&["0", "0"], &["0", "0"])).unwrap_err();
    assert!(error.to_string().contains("single point"), "{error}");
}

#[test]
fn odd_harmonics_alone_give_a_perfect_square() {
    let form = SquaredForm::new(&radius(&["0", "1", "0", "1/3"], &["0", "2", "0", "-1"])).unwrap();
    assert!(form.is_perfect_square());
    let (reduced, full) = (form.expand(), form.expand_unreduced());
    let g = reduced.polynomial();
    assert_eq!(g.degree(), Some(4));
    assert_eq!(&g.product(g).primitive(), full.polynomial());
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
fn two_hundred_harmonics_come_back() {
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

proptest! {
    /// The direct formula with num-rational and schoolbook multiplication.
    #[test]
    fn theorem_2_is_the_printed_formula(r in radii(7)) {
        let f = SquaredForm::new(&r).unwrap().expand_unreduced();
        prop_assert!(f.polynomial().check_invariants());
        let naive: Vec<_> = theorem_2_oracle(&r);
        let ours: Vec<_> = f.polynomial().monic().terms().collect();
        prop_assert_eq!(ours.len(), naive.len());
        for ((e, c), (e2, c2)) in ours.into_iter().zip(naive) {
            prop_assert_eq!(e, e2);
            prop_assert_eq!(num_rational::BigRational::from(&c), c2);
        }
    }

    #[test]
    fn the_parts_have_three_degrees_and_the_origin_its_multiplicity(r in radii(9)) {
        let f = SquaredForm::new(&r).unwrap().expand_unreduced();
        let n = r.harmonics();
        let degrees = f.polynomial().homogeneous_degrees();
        prop_assert_eq!(degrees[0], 2 * n + 2);
        prop_assert_eq!(f.polynomial().lowest_degree(), Some(2 * n));
        prop_assert!(degrees.iter().all(|&d| d >= 2 * n));
    }

    /// F(r(θ) (cos θ, sin θ)) = 0 in rational directions, and F ≠ 0 just beside.
    #[test]
    fn f_vanishes_exactly_on_the_curve(r in radii(9), t in rational()) {
        let f = implicit(&r);
        let one = Rational::one();
        let w = &one + &t * &t;
        let (c, s) = ((&one - &t * &t) / &w, Rational::from(2) * &t / &w);
        let radius = common::value_at(&r, &c, &s);
        prop_assert!(f.evaluate(&(&radius * &c), &(&radius * &s)).is_zero());
        let beside = &radius + &"1/1000003".parse::<Rational>().unwrap();
        let opposite = -common::value_at(&r, &-c.clone(), &-s.clone());
        if beside != opposite && !beside.is_zero() {
            prop_assert!(!f.evaluate(&(&beside * &c), &(&beside * &s)).is_zero());
        }
    }

    #[test]
    fn there_and_back_is_the_identity(r in radii(12)) {
        let branches = fourier_branches(&SquaredForm::new(&r).unwrap().expand()).unwrap();
        prop_assert!(branches.radii.contains(&r), "{:?} not in {:?}", r, branches.radii);
    }

    /// Scaling the contour by λ scales the roots: F_λ(λx, λy) is a multiple of F(x, y).
    #[test]
    fn scaling_acts_as_it_should(r in radii(6), p in 1i64..20, q in 1i64..20) {
        let scale = Rational::from(p) / Rational::from(q);
        let times = |v: &[Rational]| v.iter().map(|c| c * &scale).collect();
        let scaled = FourierRadius::new(times(r.cosines()), times(r.sines()));
        let power = |e: usize| scale.pow(i64::try_from(e).unwrap()).unwrap();
        let back = PlanePolynomial::from_terms(
            implicit(&scaled).terms().map(|((i, j), c)| ((i, j), c * power(i + j))),
        );
        prop_assert_eq!(back.primitive(), implicit(&r));
    }

    /// A quarter turn of the contour is a quarter turn of F: (x, y) → (y, −x).
    #[test]
    fn rotation_acts_as_it_should(r in radii(6)) {
        // cos n(θ − π/2), sin n(θ − π/2)
        let (mut cos, mut sin) = (Vec::new(), Vec::new());
        for n in 0..=r.harmonics() {
            let (a, b) = (r.cos(n).clone(), r.sin(n).clone());
            let (a, b) = match n % 4 { 0 => (a, b), 1 => (-b, a), 2 => (-a, -b), _ => (b, -a) };
            cos.push(a);
            sin.push(b);
        }
        let turned = implicit(&FourierRadius::new(cos, sin));
        let back = PlanePolynomial::from_terms(implicit(&r).terms().map(|((i, j), c)| {
            // x → y, y → −x
            ((j, i), if j % 2 == 1 { -c } else { c })
        }));
        prop_assert_eq!(turned, back.primitive());
    }
}
