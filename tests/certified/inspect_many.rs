//! Many points at, just inside and just outside the tolerance, against distances that are exact by construction or by another
//! arithmetic (num-rational).
//!
//! `STELLATE_POINTS=100000 cargo test --release --test certified inspect_many` takes so many of each kind instead of a few hundred.

#![expect(clippy::unwrap_used, reason = "a test fails by panicking")]

use num_rational::BigRational;
use stellate::exact::Rational;
use stellate::inspect::{Inspector, InspectorOptions, Verdict};
use stellate::language::{Numbers, parse_form};
use stellate::limits::Limits;
use stellate::shape::Form;

use crate::common::random::SplitMix;

const TORUS: &str = "(x^2+y^2+z^2+3)^2 = 16*(x^2+y^2)";

fn count(default: u64) -> u64 {
    let given = std::env::var("STELLATE_POINTS").ok();
    given.map_or(default, |text| text.parse().unwrap())
}

fn inspector(text: &str, tolerance: &Rational) -> Inspector {
    let options = InspectorOptions::new(tolerance.clone());
    let Form::Surface(surface) = parse_form(text, "<form>", Numbers::Exact).unwrap() else {
        panic!("{text}")
    };
    Inspector::surface(&surface, &options, &Limits::none()).unwrap()
}

struct Random(SplitMix);

impl Random {
    /// In −n … n
    fn integer(&mut self, n: i64) -> i64 {
        i64::try_from(self.0.word() >> 1).unwrap() % (2 * n + 1) - n
    }

    fn rational(&mut self, n: i64, over: i64) -> Rational {
        Rational::from(self.integer(n)) / Rational::from(over)
    }

    /// A rational unit vector, by stereographic projection.
    fn unit(&mut self) -> [Rational; 3] {
        let [s, t] = [self.rational(60, 17), self.rational(60, 19)];
        let squares = &s * &s + &t * &t;
        let weight = Rational::one() + &squares;
        let two = Rational::from(2);
        let third = (Rational::one() - squares) / &weight;
        [s * &two / &weight, t * two / weight, third]
    }

    /// A rational point of the unit circle.
    fn circle(&mut self) -> [Rational; 2] {
        let s = self.rational(60, 23);
        let weight = Rational::one() + &s * &s;
        [
            (Rational::one() - &s * &s) / &weight,
            s * Rational::from(2) / weight,
        ]
    }
}

/// A foot, the unit normal there, and how far along it in either sense there is nothing nearer.
struct Foot {
    surface: String,
    foot: [Rational; 3],
    normal: [Rational; 3],
    inwards: bool,
}

fn feet(kind: &str, random: &mut Random) -> Foot {
    let of = |surface: &str, foot, normal, inwards| Foot {
        surface: surface.into(),
        foot,
        normal,
        inwards,
    };
    match kind {
        "sphere" => {
            let u = random.unit();
            of("x^2 + y^2 + z^2 = 1", u.clone(), u, true)
        }
        "cylinder" => {
            let [c, s] = random.circle();
            let z = random.rational(300, 7);
            let foot = [c.clone(), s.clone(), z];
            of("x^2 + y^2 + 0z = 1", foot, [c, s, Rational::zero()], true)
        }
        "torus" => {
            let ([a, b], [c, s]) = (random.circle(), random.circle());
            let ring = Rational::from(2) + &c;
            let foot = [&ring * &a, &ring * &b, s.clone()];
            of(TORUS, foot, [&c * &a, c * b, s], true)
        }
        "plane" => {
            let u = random.unit();
            let level = random.rational(50, 13);
            let text = format!("({})*x + ({})*y + ({})*z = {level}", u[0], u[1], u[2]);
            let foot = u.each_ref().map(|x| x * &level);
            of(&text, foot, u, true)
        }
        _ => {
            // The ellipsoid x²/A + y²/B + z²/C = 1 through q with normal u: A = q₁ (q·u)/u₁ and so on.
            let mut u = random.unit();
            while u.iter().any(Rational::is_zero) {
                u = random.unit();
            }
            let q = u.each_ref().map(|x| {
                let size = Rational::from(1 + random.integer(400).abs()) / Rational::from(100);
                size * Rational::from(i32::from(x.signum()))
            });
            let product = q
                .iter()
                .zip(&u)
                .fold(Rational::zero(), |sum, (a, b)| sum + a * b);
            let axes = [0, 1, 2].map(|i| &q[i] * &product / &u[i]);
            let text = format!(
                "x^2/({}) + y^2/({}) + z^2/({}) = 1",
                axes[0], axes[1], axes[2]
            );
            of(&text, q, u, false)
        }
    }
}

/// Points exactly at the distance d, and an ulp to either side of it.
#[test]
fn at_the_tolerance_and_an_ulp_beside_it() {
    let mut random = Random(SplitMix(12));
    for kind in ["sphere", "cylinder", "torus", "plane", "ellipsoid"] {
        for n in 0..count(60) {
            let found = feet(kind, &mut random);
            let d = Rational::from(1 + random.integer(400).abs()) / Rational::from(1001);
            let inspector = inspector(&found.surface, &d);
            let outwards = !found.inwards || n % 2 == 0;
            let ulp = Rational::from(2).pow(-52).unwrap();
            for (off, expected) in [
                (Rational::zero(), Verdict::Inside),
                (ulp.clone(), Verdict::Outside),
                (-ulp, Verdict::Inside),
            ] {
                let mut along = &d + &off;
                if !outwards {
                    along = -along;
                }
                let p = [0, 1, 2].map(|i| &found.foot[i] + &(&along * &found.normal[i]));
                let answer = inspector.inspect(&p);
                let curve = Some(expected == Verdict::Inside);
                assert_eq!(
                    (answer.verdict, answer.curve),
                    (expected, curve),
                    "{} {p:?} {d} {answer:?}",
                    found.surface
                );
            }
        }
    }
}

/// Points at any distance outside random ellipsoids, on the normal of a known foot: the ellipsoid is convex.
#[test]
fn outside_of_ellipsoids() {
    let mut random = Random(SplitMix(5));
    for _ in 0..count(100) {
        let found = feet("ellipsoid", &mut random);
        let [d, t] =
            [0; 2].map(|_| Rational::from(1 + random.integer(900).abs()) / Rational::from(1009));
        let p = [0, 1, 2].map(|i| &found.foot[i] + &(&t * &found.normal[i]));
        let answer = inspector(&found.surface, &d).inspect(&p);
        let is_inside = answer.verdict == Verdict::Inside;
        assert_eq!(is_inside, t <= d, "{} {p:?} {d} {answer:?}", found.surface);
        assert!(answer.verdict != Verdict::Undecided);
        let bounds = answer.distance;
        assert!(
            bounds.low <= t.to_f64() * (1.0 + 1e-15) && t.to_f64() * (1.0 - 1e-15) <= bounds.high
        );
    }
}

fn big(q: &Rational) -> BigRational {
    q.to_string().parse().unwrap()
}

/// Whether the distance is at most d, by comparing squares.
fn is_within(kind: &str, p: &[Rational; 3], d: &Rational) -> bool {
    let [x, y, z] = p.each_ref().map(big);
    let d = big(d);
    let one = BigRational::from_integer(1.into());
    let number = |k: i64| BigRational::from_integer(k.into());
    let inner = |r: &BigRational| if r > &d { r - &d } else { number(0) };
    let between = |square: &BigRational, r: &BigRational| {
        let (low, high) = (inner(r), r + &d);
        &low * &low <= *square && *square <= &high * &high
    };
    match kind {
        "sphere" => between(&(&x * &x + &y * &y + &z * &z), &one),
        "cylinder" => between(&(&x * &x + &y * &y), &one),
        "plane" => {
            let value = &x + number(2) * &y - number(2) * &z - &one;
            &value * &value <= number(9) * &d * &d
        }
        _ => {
            // (ρ − 2)² + z² ≤ c with ρ² = x² + y²: ρ² + z² + 4 − c ≤ 4ρ
            let ring = &x * &x + &y * &y;
            let at_most = |c: &BigRational| {
                let left = &ring + &z * &z + number(4) - c;
                left <= number(0) || &left * &left <= number(16) * &ring
            };
            let low = inner(&one);
            let high = &one + &d;
            // Beyond the tube's inner circle nothing is excluded: c < (1 − d)² strictly.
            let strictly = |c: &BigRational| {
                let left = &ring + &z * &z + number(4) - c;
                left < number(0) || &left * &left < number(16) * &ring
            };
            at_most(&(&high * &high)) && !(low > number(0) && strictly(&(&low * &low)))
        }
    }
}

/// Points anywhere in a box.
#[test]
fn anywhere() {
    let mut random = Random(SplitMix(7));
    let tolerances = ["1/10", "3/7", "1/1000"];
    for (kind, surface) in [
        ("sphere", "x^2 + y^2 + z^2 = 1"),
        ("cylinder", "x^2 + y^2 + 0z = 1"),
        ("plane", "x + 2*y - 2*z = 1"),
        ("torus", TORUS),
    ] {
        for text in tolerances {
            let d: Rational = text.parse().unwrap();
            let inspector = inspector(surface, &d);
            for _ in 0..count(150) / 3 {
                let p = [0; 3].map(|_| random.rational(3_200_000, 1_000_003));
                let expected = if is_within(kind, &p, &d) {
                    Verdict::Inside
                } else {
                    Verdict::Outside
                };
                let answer = inspector.inspect(&p);
                assert_eq!(answer.verdict, expected, "{surface} {p:?} {d} {answer:?}");
                assert_eq!(
                    answer.curve,
                    Some(expected == Verdict::Inside),
                    "{surface} {p:?} {d}"
                );
            }
        }
    }
}

/// Surfaces of high degree, singular ones among them: nothing is left undecided, and no point within the tolerance of a
/// known zero is said to be outside.
#[test]
fn every_verdict_is_certified() {
    let mut random = Random(SplitMix(3));
    for surface in [
        "(x^2 + 9/4*y^2 + z^2 - 1)^3 = x^2*z^3 + 9/80*y^2*z^3",
        "x^12 + y^12 + z^12 + x^4*y^4*z^4 = 1",
    ] {
        let inspector = inspector(surface, &"1/20".parse().unwrap());
        for _ in 0..count(120) {
            let p = [0; 3].map(|_| random.rational(1_500_000, 1_000_003));
            let answer = inspector.inspect(&p);
            assert!(answer.verdict != Verdict::Undecided, "{surface} {p:?}");
            assert!(answer.curve.is_some(), "{surface} {p:?}");
            assert!(answer.distance.low <= answer.distance.high);
        }
    }
}
