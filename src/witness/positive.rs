//! Claims about the sign of a radius in all directions (T5).

use malachite::Integer;
use malachite::base::num::basic::traits::Zero;
use malachite::base::polynomial::Polynomial;
use serde_json::{Value, json};

use super::breakpoints::{End, Roots};
use super::forms::{harmonic_form, radius_form, texts};
use super::proof::Proof;
use crate::exact::Rational;
use crate::poly::{IntegerPolynomial, doubled_form_from_harmonics};
use crate::roots::real_roots;
use crate::shape::{FourierRadius, HarmonicSurface};

/// The largest number of halvings of a cover.
const DEPTH: u32 = 40;

/// Claims whether r > 0 for every angle: `positive-radius`.
pub(crate) fn positive_radius(proof: &mut Proof, radius: &FourierRadius, positive: bool) {
    let form = radius_form(proof, radius);
    let quarters: Vec<Vec<Integer>> = (0..4).map(|quarter| on_quarter(radius, quarter)).collect();
    let witness = form.and_then(|_| match positive {
        true => {
            let breakpoints: Option<Vec<Value>> = quarters
                .iter()
                .map(|quarter| without_roots(quarter).map(|list| texts(&list)))
                .collect();
            Some(json!({ "quarters": breakpoints? }))
        }
        false => {
            let found = quarters.iter().enumerate();
            let direction = found
                .filter_map(|(q, f)| Some((q, not_positive(f)?)))
                .next();
            direction.map(|(q, t)| json!({ "direction": texts(&direction_at(q, &t)) }))
        }
    });
    let statement = json!({ "form": form, "positive": positive });
    proof.claim("positive-radius", &statement, witness);
}

/// Claims whether R > 0 in every direction: `positive-radius`. The witness is a rule for a cover, or a direction with R ≤ 0.
pub(crate) fn positive_sphere(
    proof: &mut Proof,
    surface: &HarmonicSurface,
    not_positive_in: Option<&[Rational; 3]>,
) {
    let form = harmonic_form(proof, surface);
    let statement = json!({ "form": form, "positive": not_positive_in.is_none() });
    let witness = match not_positive_in {
        Some(direction) => json!({ "direction": texts(direction) }),
        None => json!({ "depth": DEPTH }),
    };
    proof.claim("positive-radius", &statement, form.map(|_| witness));
}

/// (1 + t²)^N r at the angle qπ/2 + 2 atan t, times a positive number: 2N + 1 coefficients, ascending.
fn on_quarter(radius: &FourierRadius, quarter: usize) -> Vec<Integer> {
    let n = radius.harmonics();
    let (_, cos, sin) = radius.over_common_denominator();
    // a cos n(θ + qπ/2) + b sin n(θ + qπ/2) = Re (a − ib) i^(qn) e^(inθ).
    let turned: Vec<[Integer; 2]> = cos
        .into_iter()
        .zip(sin)
        .enumerate()
        .map(|(m, (a, b))| match quarter * m % 4 {
            0 => [a, b],
            1 => [b, -a],
            2 => [-a, -b],
            _ => [-b, a],
        })
        .collect();
    let halves = turned.iter().enumerate().map(|(m, [a, b])| (2 * m, a, b));
    let form = doubled_form_from_harmonics(2 * n, halves);
    let mut coefficients = form.dehomogenized().coefficients_asc().to_vec();
    coefficients.resize(2 * n + 1, Integer::ZERO);
    coefficients
}

/// Breakpoints in (0, 1) for a polynomial without roots in [0, 1].
fn without_roots(coefficients: &[Integer]) -> Option<Vec<Rational>> {
    let roots = Roots {
        coefficients,
        enclosures: &[],
    };
    let [from, to] = [Rational::zero(), Rational::one()].map(End::At);
    roots.breakpoints(&from, &to)
}

/// A rational number in [0, 1] at which the polynomial is not positive.
fn not_positive(coefficients: &[Integer]) -> Option<Rational> {
    let f = IntegerPolynomial::from_coefficients_asc(coefficients.to_vec());
    let sign = |t: &Rational| crate::poly::sign_at_rational(&f, t);
    let [zero, one] = [Rational::zero(), Rational::one()];
    let mut cuts = vec![zero.clone(), one.clone()];
    for root in real_roots(&f) {
        let (low, high) = root.bounds();
        cuts.extend(root.as_rational());
        cuts.extend([low, high]);
    }
    cuts.retain(|cut| *cut >= zero && *cut <= one);
    cuts.sort_unstable();
    let middles: Vec<Rational> = cuts
        .windows(2)
        .map(|pair| Rational::simplest_between(&pair[0], &pair[1]))
        .collect();
    cuts.into_iter().chain(middles).find(|t| sign(t) <= 0)
}

/// The unit vector at the angle qπ/2 + 2 atan t.
fn direction_at(quarter: usize, t: &Rational) -> [Rational; 2] {
    let square = t * t;
    let length = &Rational::one() + &square;
    let cos = &(&Rational::one() - &square) / &length;
    let sin = &(&Rational::from(2) * t) / &length;
    match quarter {
        0 => [cos, sin],
        1 => [-sin, cos],
        2 => [-cos, -sin],
        _ => [sin, -cos],
    }
}
