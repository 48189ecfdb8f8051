//! The claim `irreducible`: a polynomial that does not factor over the rational numbers (T4).

use num_bigint::BigInt;

use super::forms::{Forms, Implicit};
use super::json::{Claim, LARGEST_INTEGER, Value};
use super::modular::{is_irreducible, is_prime};
use super::numbers::{greatest_common_divisor, vector};
use super::refusal::{Checked, Refusal, need};
use super::series_equation::need_same;

pub(super) fn check(forms: &Forms, claim: &Claim<'_>) -> Checked<()> {
    let form = claim
        .statement(&["form"], &[])?
        .get("form", |index| forms.implicit(index))?;
    match claim.witness {
        Value::Object(map) if map.contains_key("radius") => check_radius(forms, form, claim),
        _ => check_line(form, claim),
    }
}

/// The equation of a radius whose last harmonic and whose even part are not zero is irreducible.
fn check_radius(forms: &Forms, form: &Implicit, claim: &Claim<'_>) -> Checked<()> {
    let fields = claim.witness(&["radius", "coordinates"], &[])?;
    let (series, parity) = need_same(forms, form, 1, &fields)?;
    let even = if series.top() % 2 == 0 {
        &parity.same
    } else {
        &parity.other
    };
    need(
        series
            .solid_harmonics()
            .last()
            .is_some_and(|last| !last.is_zero()),
        "the last harmonic is zero",
    )?;
    need(!even.is_zero(), "the even part of the radius is zero")
}

/// A polynomial that keeps its degree on a line, and there modulo a prime, and is irreducible then, is irreducible.
fn check_line(form: &Implicit, claim: &Claim<'_>) -> Checked<()> {
    let fields = claim.witness(&["point", "direction", "prime"], &[])?;
    let point = fields.get("point", |value| vector(value, form.dimension))?;
    let direction = fields.get("direction", |value| vector(value, form.dimension))?;
    let prime = fields.get("prime", |value| {
        let number = value.integer(2..=LARGEST_INTEGER)?;
        let prime = u64::try_from(number).ok().filter(|prime| is_prime(*prime));
        prime.ok_or_else(|| Refusal::new(format!("{number} is no prime")))
    })?;
    need(form.terms.degree() > 0, "the polynomial is constant")?;
    let on_line = form.terms.about(&point).along(&direction);
    let content = on_line
        .iter()
        .fold(BigInt::ZERO, |gcd, c| greatest_common_divisor(&gcd, c));
    need(
        content != BigInt::ZERO,
        "the polynomial vanishes on the line",
    )?;
    let primitive: Vec<_> = on_line.iter().map(|c| c / &content).collect();
    // The list has as many elements as a polynomial of the full degree, so a lower degree on the line is found out, too.
    need(
        is_irreducible(&primitive, prime),
        "the polynomial on the line is reducible modulo the prime, or its degree is lower",
    )
}
