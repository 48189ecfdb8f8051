//! Laws of traced branches: in every direction they are exactly the certified roots.

use std::sync::Arc;

use malachite::Integer;
use proptest::prelude::*;

use super::{Equation, RootBranch, Tracing};
use crate::language::{Numbers, parse_form};
use crate::limits::Limits;
use crate::parametrize::angle::{AngleRange, ExactAngle};
use crate::poly::{BinaryForm, PlanePolynomial};
use crate::sample::{Direction, Ray, RaySolver};
use crate::shape::Form;

fn polynomial(equation: &Equation) -> PlanePolynomial {
    let parts = equation.forms.iter().filter(|f| !f.is_zero());
    PlanePolynomial::from_parts(parts.cloned(), Integer::from(1))
}

/// The equation of a polynomial in x and y, in powers of r^step.
fn equation(text: &str, step: usize) -> Equation {
    let Ok(Form::Curve(curve)) = parse_form(text, "<form>", Numbers::Exact) else {
        panic!("{text}")
    };
    let degrees = curve.polynomial().homogeneous_degrees();
    let (top, lowest) = (degrees[0], degrees[degrees.len() - 1]);
    let part = |d: usize| {
        curve
            .polynomial()
            .part(d)
            .cloned()
            .unwrap_or_else(|| BinaryForm::zero(d))
    };
    Equation {
        forms: (lowest..=top).step_by(step).map(part).collect(),
        lowest,
        step,
    }
}

fn traced(equation: &Equation) -> (Arc<Tracing>, Vec<RootBranch>) {
    let tracing = Arc::new(Tracing::new(equation.clone(), &Limits::none()).unwrap());
    let branches = tracing.branches();
    (tracing, branches)
}

/// The ranges in which a branch is real and positive, and the angles at which its arcs end, in doubles.
struct Shown {
    real: Vec<[f64; 2]>,
    positive: Vec<[f64; 2]>,
    ends: Vec<f64>,
}

impl Shown {
    fn of(branch: &RootBranch) -> Self {
        let end = |a: &ExactAngle| -> f64 { a.to_decimal(12).parse().unwrap() };
        let pair = |range: &AngleRange| [end(&range.from), end(&range.to)];
        Self {
            real: branch.real.iter().map(pair).collect(),
            positive: branch.positive.iter().map(pair).collect(),
            ends: branch
                .arcs()
                .iter()
                .flat_map(|arc| pair(&arc.range))
                .collect(),
        }
    }
}

fn within(ranges: &[[f64; 2]], theta: f64) -> bool {
    ranges.iter().any(|[from, to]| *from < theta && theta < *to)
}

/// Compares the branches with the certified roots in directions all around, and close to both sides of every critical
/// direction.
fn check(equation: &Equation) -> Result<(), TestCaseError> {
    let f = polynomial(equation);
    let solver = RaySolver::new(&f);
    let (tracing, branches) = traced(equation);
    let shown: Vec<Shown> = branches.iter().map(Shown::of).collect();
    let all = shown
        .iter()
        .flat_map(|s| s.real.iter().flatten().chain(&s.ends));
    let mut critical: Vec<f64> = all.copied().chain([0.0]).collect();
    critical.sort_by(f64::total_cmp);
    critical.dedup();
    let mut angles: Vec<f64> = (0..40).map(|k| 0.013 + f64::from(k) * 0.157).collect();
    angles.extend(
        critical
            .iter()
            .flat_map(|a| [a - 1e-7, a + 1e-7])
            .filter(|a| (0.0..std::f64::consts::TAU).contains(a)),
    );
    for &theta in &angles {
        if critical.iter().any(|c| (c - theta).abs() < 1e-8) {
            continue;
        }
        let direction = Direction::from_radians(theta);
        let Ray::Points(points) = solver.solve(&direction) else {
            return Err(TestCaseError::fail("a line"));
        };
        let mut expected: Vec<f64> = points.iter().map(|p| p.r).collect();
        let mut found = Vec::new();
        for (branch, shown) in branches.iter().zip(&shown) {
            let value = branch.radius(&direction);
            prop_assert_eq!(
                value.is_some(),
                within(&shown.real, theta),
                "real at {}",
                theta
            );
            if let Some(r) = value {
                prop_assert_eq!(
                    r > 0.0,
                    within(&shown.positive, theta),
                    "positive at {}",
                    theta
                );
                found.push(r);
            }
        }
        expected.sort_by(f64::total_cmp);
        found.sort_by(f64::total_cmp);
        prop_assert_eq!(&found, &expected, "at {}", theta);
    }
    // Inside a range the branch is continuous in r^step, across all critical directions.
    let step = f64::from(u32::try_from(equation.step).unwrap());
    for (branch, shown) in branches.iter().zip(&shown) {
        for &angle in critical.iter().filter(|a| within(&shown.real, **a)) {
            let at = |theta: f64| branch.radius(&Direction::from_radians(theta));
            if let (Some(a), Some(b)) = (at(angle - 1e-12), at(angle + 1e-12)) {
                let [low, high] = [a, b].map(|r| r.abs().powf(step).copysign(r));
                prop_assert!(
                    (low - high).abs() < 5e-3 * (1.0 + low.abs()),
                    "{} and {} beside {}",
                    a,
                    b,
                    angle
                );
            }
        }
    }
    prop_assert!(tracing.open_angles().is_empty());
    Ok(())
}

fn isolated(branches: &[RootBranch]) -> Vec<String> {
    let points = branches.iter().filter(|b| b.arcs().is_empty());
    points
        .map(|b| {
            format!(
                "{}{}",
                b.real[0].from.describe(),
                if b.positive.is_empty() { "" } else { " +" }
            )
        })
        .collect()
}

#[test]
fn folds_nodes_cusps_and_asymptotes() {
    for (text, step) in [
        // Roots that tend to infinity, and a fold beside them.
        ("x^5 - x - 1 + y^5", 1),
        // A node and a cusp at (1, 1), and at (1, ±√2).
        ("(x-1)^2 - (y-1)^2 + (x-1)^5 + y*(y-1)^4", 1),
        ("(x-1)^3 - (y-1)^2 + (y-1)^5*x", 1),
        ("(x-1)^2 - (y^2-2)^2 + (x-1)^5 + x*(y^2-2)^3", 1),
        // The curve touches the x axis from above at two points: for r < 0 one pair of roots begins where another one ends.
        ("(y - (x^2-1)^2)*(1 + x^2) + y^3", 1),
        // A polynomial in r².
        ("x^10 + y^10 - 3x^4*y^4 + x^2*y^2*5 - x*y - 1", 2),
        // The origin is on the curve, with branches through it.
        ("x^6 + y^6 + x^3*y^2 - x^2 + 2y^2", 1),
        ("x^7 + y^7 + x^3*y^2 - x*y", 1),
        // A polynomial in r³ with negative r only.
        ("x^15 + y^15 + x^3*y^9 + x^9 + x^3 + 2", 3),
    ] {
        check(&equation(text, step)).unwrap_or_else(|e| panic!("{text}: {e}"));
    }
}

#[test]
fn isolated_points_are_kept() {
    // The point (1, 1) is isolated, because the quadratic part there is definite.
    let (_, branches) = traced(&equation(
        "(x-1)^2 + (y-1)^2 + (x-1)^5 + (x-1)^3*(y-1)^2",
        1,
    ));
    assert_eq!(isolated(&branches), ["pi/4 +", "5*pi/4"]);
    // The points (1, ±√2) are isolated.
    let (_, branches) = traced(&equation("(x-1)^2 + (y^2-2)^2 + (x-1)^5", 1));
    let angles = isolated(&branches);
    assert_eq!(angles.len(), 4);
    assert!(
        angles[0].starts_with("atan(t) with t^2-2 = 0") && angles[0].ends_with(" +"),
        "{}",
        angles[0]
    );
    // In r², the root R = 2 at 45° is isolated.
    let (_, branches) = traced(&equation("(x-y)^2*(1+x^2) + (x^2+y^2-2)^2", 2));
    assert_eq!(
        isolated(&branches),
        ["pi/4 +", "pi/4", "5*pi/4 +", "5*pi/4"]
    );
}

#[test]
fn a_full_branch_is_known() {
    let (_, branches) = traced(&equation("x^6 + y^6 - 1 + x*y^3 - x", 1));
    let covering: Vec<bool> = branches.iter().map(RootBranch::covers_circle).collect();
    assert_eq!(covering, [false, true]);
    assert_eq!(branches[1].outermost_jumps().map(|j| j.len()), Some(0));
    let (_, branches) = traced(&equation("x^5 - x - 1 + y^5", 1));
    assert!(
        branches
            .iter()
            .all(|b| !b.covers_circle() && b.outermost_jumps().is_none())
    );
}

fn forms(degrees: Vec<usize>) -> impl Strategy<Value = Vec<BinaryForm>> {
    degrees
        .into_iter()
        .map(|d| {
            prop::collection::vec(-9i64..10, d + 1).prop_map(|c| {
                BinaryForm::from_coefficients(c.into_iter().map(Integer::from).collect())
            })
        })
        .collect::<Vec<_>>()
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(30))]
    /// Dense polynomials of degree 2 to 6 in r^k; for some of them the origin is on the curve.
    #[test]
    fn branches_are_the_certified_roots(
        (equation, sparse) in (0usize..3, 1usize..4, 2usize..7).prop_flat_map(|(lowest, step, m)| {
            let m = if step > 1 { m.min(4) } else { m };
            let degrees: Vec<usize> = (0..=m).map(|i| lowest + i * step).collect();
            (forms(degrees).prop_map(move |forms| Equation { forms, lowest, step }), 0usize..3)
        }),
    ) {
        let mut equation = equation;
        // Some have no middle parts, and some are even in y.
        let last = equation.forms.len() - 1;
        if sparse == 1 && last > 2 {
            equation.forms[1] = BinaryForm::zero(equation.forms[1].degree());
        }
        if sparse == 2 {
            for form in &mut equation.forms {
                let even = (0..=form.degree()).map(|k| if k % 2 == 0 { form.coefficient(k) } else { Integer::from(0) });
                *form = BinaryForm::from_coefficients(even.collect());
            }
        }
        prop_assume!(!equation.forms[0].is_zero() && !equation.forms[last].is_zero());
        let f = polynomial(&equation);
        let factors = crate::factor::factor_plane(&f, &Limits::none()).unwrap().factors;
        prop_assume!(factors.iter().all(|f| f.multiplicity == 1 && f.polynomial.homogeneous_degrees().len() > 1));
        check(&equation)?;
    }
}
