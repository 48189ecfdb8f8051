//! Tolerance zones and uncertainties, against points whose signed distance is known by construction.

#![expect(clippy::unwrap_used, reason = "a test fails by panicking")]

use proptest::prelude::*;
use stellate::exact::Rational;
use stellate::inspect::{ToleranceZone, Verdict};
use stellate::language::Numbers;
use stellate::verb::{self, Given, InspectionOptions, InspectionTask, Work};

fn rational(text: &str) -> Rational {
    text.parse().unwrap()
}

fn ratio(p: i64, q: i64) -> Rational {
    Rational::from(p) / Rational::from(q)
}

fn task(
    form: &str,
    dimension: usize,
    zone: &ToleranceZone,
) -> stellate::error::Result<InspectionTask> {
    let given = Given::read(form, Numbers::Exact).unwrap();
    let [low, high] = zone.limits().map(Clone::clone);
    let options = InspectionOptions::default()
        .tolerance(high)
        .lower(Some(low))
        .uncertainty(zone.uncertainty().clone());
    verb::inspect(given, dimension, &options, &Work::default())
}

/// The rational unit vector with the half-angle tangent m/n.
fn direction(m: i64, n: i64) -> [Rational; 2] {
    let below = m * m + n * n;
    [ratio(n * n - m * m, below), ratio(2 * m * n, below)]
}

/// Forms with a point at each signed distance s > −2 from a nearest point in a rational direction.
#[derive(Clone, Copy, Debug)]
enum Known {
    /// The circle or sphere of radius 5 about the origin, the circle's cylinder among them.
    Round(&'static str, usize),
    /// The circle of radius 5 about (10, −3).
    Shifted(&'static str),
    /// The torus with the radii 5 and 2; distances are from the tube.
    Torus,
}

const KNOWN: [Known; 9] = [
    Known::Round("x^2 + y^2 = 25", 2),
    Known::Round("x^2 + y^2 = 25", 3),
    Known::Round("r = 5", 2),
    Known::Round("r = 5", 3),
    Known::Round("x = 5*sin(t); y = 5*cos(t)", 2),
    Known::Round("x^2 + y^2 + z^2 = 25", 3),
    Known::Round("R = 5", 3),
    Known::Shifted("# center: 10, -3\nx^2 + y^2 = 25"),
    Known::Torus,
];

impl Known {
    fn form(self) -> (&'static str, usize) {
        match self {
            Self::Round(form, dimension) => (form, dimension),
            Self::Shifted(form) => (form, 2),
            Self::Torus => ("(x^2 + y^2 + z^2 + 21)^2 = 100*(x^2 + y^2)", 3),
        }
    }

    fn point(self, s: &Rational, a: &[Rational; 2], b: &[Rational; 2]) -> [Rational; 3] {
        let five = Rational::from(5);
        let out = &five + s;
        match self {
            Self::Round(form, 3) if form.contains('z') || form.starts_with('R') => {
                let flat = &out * &b[0];
                [&flat * &a[0], &flat * &a[1], &out * &b[1]]
            }
            Self::Round(_, 3) => [&out * &a[0], &out * &a[1], b[1].clone()],
            Self::Round(..) => [&out * &a[0], &out * &a[1], Rational::zero()],
            Self::Shifted(_) => [
                &out * &a[0] + Rational::from(10),
                &out * &a[1] - Rational::from(3),
                Rational::zero(),
            ],
            Self::Torus => {
                let tube = Rational::from(2) + s;
                let flat = &five + &(&tube * &b[0]);
                [&flat * &a[0], &flat * &a[1], &tube * &b[1]]
            }
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 150, ..ProptestConfig::default() })]

    /// Points exactly at the ends of the zones and beside them by as little as 10^(−30), on all kinds of forms with sides.
    #[test]
    fn verdicts_are_exact_at_every_limit(
        known in prop::sample::select(&KNOWN[..]),
        limits in (0i64..9, 0i64..9),
        u in prop::sample::select(vec![0i64, 0, 1, 2, 3, 9]),
        end in 0usize..6,
        beside in prop::sample::select(vec!["0", "1e-30", "-1e-30", "1/7", "-1/7"]),
        a in (-9i64..10, 1i64..9),
        b in (-9i64..10, 1i64..9),
    ) {
        prop_assume!(limits.0 + limits.1 > 0);
        let (low, high, u) = (ratio(-limits.0, 10), ratio(limits.1, 10), ratio(u, 20));
        let zone = ToleranceZone::new(low.clone(), high.clone()).unwrap();
        let zone = zone.with_uncertainty(u.clone()).unwrap();
        let (form, dimension) = known.form();
        let task = task(form, dimension, &zone).unwrap();
        let ends = [&low - &u, low.clone(), &low + &u, &high - &u, high.clone(), &high + &u];
        let s = &ends[end] + &rational(beside);
        let p = known.point(&s, &direction(a.0, a.1), &direction(b.0, b.1));
        let found = task.point(&p);
        prop_assert_eq!(found.sign, Some(s.signum()));
        let d = s.abs();
        let [least, most] = [found.distance.low, found.distance.high].map(|x| Rational::try_from(x).unwrap());
        prop_assert!(least <= d && d <= most, "{s}: {found:?}");
        let is_single = zone.tolerance().is_some();
        let (first, last) = (&low + &u, &high - &u);
        let is_left_out = !is_single && (s == first && first.signum() > 0 || s == last && last.signum() < 0);
        let expected = if first <= s && s <= last && !is_left_out {
            Verdict::Inside
        } else if s < &low - &u || s > &high + &u {
            Verdict::Outside
        } else {
            Verdict::Uncertain
        };
        prop_assert_eq!(found.verdict, expected, "{} in {} ± {}: {:?}", s, zone, u, found);
        // The farthest points of these forms are farther than all tolerances.
        prop_assert_eq!(found.curve, Some(d <= zone.tolerance_of_side(Some(s.signum()))), "{}: {:?}", s, found);
    }

    /// A limit of equal size on both sides is the same as a tolerance, also without sides.
    #[test]
    fn equal_limits_are_a_tolerance(
        form in prop::sample::select(vec![("x = t; y = t^2", 2usize), ("x = cos(t); y = sin(t); z = t/(1+t^2)*0 + sin(2t)", 3), ("x^2/4 + y^2 = 1", 2)]),
        p in prop::array::uniform3(-20i64..20),
        d in 1i64..20,
    ) {
        let (form, dimension) = form;
        let mut p = p.map(|x| ratio(x, 10));
        if dimension == 2 {
            p[2] = Rational::zero();
        }
        let given = || Given::read(form, Numbers::Exact);
        let Ok(given_once) = given() else { return Ok(()) };
        let d = ratio(d, 10);
        let options = InspectionOptions::default().tolerance(d.clone());
        let single = verb::inspect(given_once, dimension, &options, &Work::default()).unwrap();
        let zone = ToleranceZone::new(-d.clone(), d).unwrap();
        prop_assert_eq!(task(form, dimension, &zone).unwrap().point(&p), single.point(&p));
    }
}

#[test]
fn a_form_without_sides_has_no_two_limits() {
    let zone: ToleranceZone = "-0.02,0.05".parse().unwrap();
    let forms = [
        ("x = t; y = t^2", 2),
        ("x = t; y = t^2", 3),
        ("x = cos(t); y = sin(t); z = sin(2t)", 3),
        ("x = u; y = v; z = u*v", 3),
        ("R = Y(2,0)", 3),
    ];
    for (form, dimension) in forms {
        let error = task(form, dimension, &zone).unwrap_err().to_string();
        assert!(
            error.contains("has no inside and no outside: it takes one tolerance, such as 1/20"),
            "{form}: {error}"
        );
    }
}

#[test]
fn uncertain_points_need_no_sides() {
    // The distance of (0, −3) from the parabola is 3.
    let at = |tolerance: &str, u: &str| {
        let zone: ToleranceZone = tolerance.parse().unwrap();
        let zone = zone.with_uncertainty(rational(u)).unwrap();
        let task = task("x = t; y = t^2", 2, &zone).unwrap();
        task.point(&["0", "-3", "0"].map(rational)).verdict
    };
    let near = "1e-40";
    assert_eq!(at("4", "1"), Verdict::Inside);
    assert_eq!(
        at("4", &format!("1.{}1", "0".repeat(40))),
        Verdict::Uncertain
    );
    assert_eq!(at("2", "1"), Verdict::Uncertain);
    assert_eq!(at("2", &format!("0.{}", "9".repeat(40))), Verdict::Outside);
    assert_eq!(at("3", near), Verdict::Uncertain);
    assert_eq!(at("3", "5"), Verdict::Uncertain);
    // With an uncertainty equal to the tolerance only points on the form are inside.
    let zone: ToleranceZone = "1".parse().unwrap();
    let zone = zone.with_uncertainty(rational("1")).unwrap();
    let task = task("x = t; y = t^2", 2, &zone).unwrap();
    let verdict = |x: &str, y: &str| task.point(&[x, y, "0"].map(rational)).verdict;
    assert_eq!(verdict("1/3", "1/9"), Verdict::Inside);
    assert_eq!(
        verdict("1/3", "0.1111111111111111111111"),
        Verdict::Uncertain
    );
}

#[test]
fn a_patch_is_judged_by_its_own_distance() {
    // The half x ≥ 0 of the plane x = z.
    let zone: ToleranceZone = "1".parse().unwrap();
    let zone = zone.with_uncertainty(rational("1/4")).unwrap();
    let task = task("x = u^2; y = v; z = u^2", 3, &zone).unwrap();
    let verdict = |p: [&str; 3]| task.point(&p.map(rational)).verdict;
    assert_eq!(verdict(["3", "0", "3.5"]), Verdict::Inside);
    assert_eq!(verdict(["3", "0", "4.5"]), Verdict::Uncertain);
    assert_eq!(verdict(["3", "0", "5"]), Verdict::Outside);
}
