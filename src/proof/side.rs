//! The claim `side`: the sign of a polynomial at a point, or on which side of a radius a point is.

use super::forms::{Forms, Locus};
use super::json::Claim;
use super::numbers::{Exact, squared_distance, vector};
use super::refusal::{Checked, Refusal};
use super::series::Series;

pub(super) fn check(forms: &Forms, claim: &Claim<'_>) -> Checked<()> {
    claim.expansion()?;
    let fields = claim.statement(&["form", "point", "sign"], &[])?;
    let locus = fields.get("form", |index| forms.locus(index))?;
    let point = fields.get("point", |value| vector(value, locus.dimension()))?;
    let stated = fields.get("sign", |value| value.integer(-1..=1))?;
    let found = match locus {
        Locus::Implicit(form) => form.terms.sign_at(&point),
        Locus::Series(radius) => side_of_radius(radius, &point)?,
    };
    if stated == found {
        Ok(())
    } else {
        Err(Refusal::new(format!("the sign is {found}"))
            .within("sign")
            .within("statement"))
    }
}

/// The sign of |e| − r for the vector e from the center to the point, where r is the radius in its direction; −1 at the center.
fn side_of_radius(radius: &Series, point: &[Exact]) -> Checked<i64> {
    if point == radius.center {
        return Ok(-1);
    }
    let vector: Vec<_> = point
        .iter()
        .zip(&radius.center)
        .map(|(p, c)| p - c)
        .collect();
    let square = squared_distance(point, &radius.center);
    let parts = radius.radius(&vector)?;
    // |e| − r = p·|e| + q, whose sign is that of p·|p|·|e|² + q·|q|.
    let p = &Exact::one() - &parts.of_length;
    let q = -&parts.rational;
    Ok((&signed_square(&p, &square) + &signed_square(&q, &Exact::one())).sign())
}

/// factor·value·|value|.
fn signed_square(value: &Exact, factor: &Exact) -> Exact {
    let square = &value.squared() * factor;
    if value.sign() < 0 { -&square } else { square }
}
