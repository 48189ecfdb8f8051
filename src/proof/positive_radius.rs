//! The claim `positive-radius`: whether a radius is positive in every direction (T5).

use num_bigint::BigInt;

use super::bernstein::{intervals, isolated_roots};
use super::cover::{Budget, Cell, Dense};
use super::forms::Forms;
use super::json::{Claim, Value};
use super::numbers::{Exact, sign, unit_vector};
use super::refusal::{Checked, Refusal, need};
use super::series::{Harmonics, Series};
use super::sparse::Sparse;
use super::univariate::End;

pub(super) fn check(forms: &Forms, claim: &Claim<'_>) -> Checked<()> {
    let fields = claim.statement(&["form", "positive"], &[])?;
    let radius = fields.get("form", |index| forms.series(index))?;
    let positive = fields.get("positive", |value| match value {
        Value::Truth(positive) => Ok(*positive),
        _ => Err(Refusal::new("true or false is expected")),
    })?;
    if !positive {
        let fields = claim.witness(&["direction"], &[])?;
        let direction = fields.get("direction", |value| unit_vector(value, radius.dimension()))?;
        let value = radius.radius_at_unit(&direction)?;
        return need(
            value.sign() <= 0,
            "the radius is positive in this direction",
        );
    }
    let mut east = vec![Exact::zero(); radius.dimension()];
    east[0] = Exact::one();
    need(
        radius.radius_at_unit(&east)?.sign() > 0,
        "the radius is not positive in the direction of the x axis",
    )?;
    match radius.harmonics {
        Harmonics::Plane { .. } => check_quarters(radius, claim),
        Harmonics::Space { .. } => check_faces(radius, claim),
    }
}

/// The radius has no zero on the four closed quarters of the circle.
fn check_quarters(radius: &Series, claim: &Claim<'_>) -> Checked<()> {
    let [zero, one] = [Exact::zero(), Exact::one()].map(End::At);
    let quarters = claim.witness(&["quarters"], &[])?.get("quarters", |list| {
        list.list(4..=4, |breakpoints| intervals(breakpoints, &zero, &one))
    })?;
    for (quarter, pieces) in quarters.iter().enumerate() {
        let roots = isolated_roots(&radius.on_quarter(quarter), pieces);
        let count = roots
            .map_err(|refusal| refusal.at(quarter).within("quarters").within("witness"))?
            .len();
        need(
            count == 0,
            &format!("the radius has a zero in quarter {quarter}"),
        )?;
    }
    Ok(())
}

/// The product of the radii in opposite directions, ±(A² − ρB²), has no zero on three faces of the cube, one for every line
/// through the origin.
fn check_faces(radius: &Series, claim: &Claim<'_>) -> Checked<()> {
    let parity = radius.parity()?;
    let length = radius.top() as usize + 1;
    for face in 0..3 {
        let on_face = |f: &Sparse| Dense::new(&restricted(f, face), &[length, length]);
        let polynomials = vec![on_face(&parity.same)?, on_face(&parity.other)?];
        Cell::whole_cube(polynomials, 2)
            .cover(&mut Budget::read(claim)?, &has_no_zero)
            .map_err(|refusal| Refusal::new(format!("on face {face} of the cube, {refusal}")))?;
    }
    Ok(())
}

/// The polynomial in the other two variables, where the variable of this axis is 1.
fn restricted(f: &Sparse, axis: usize) -> Sparse {
    let mut result = Sparse::default();
    for (&[x, y, z, _], c) in f.terms() {
        let exponents = match axis {
            0 => [y, z, 0, 0],
            1 => [x, z, 0, 0],
            _ => [x, y, 0, 0],
        };
        result.add_term(exponents, c.clone());
    }
    result
}

/// Whether |A| > |B|·|d| or |A| < |B|·|d| on the whole cell, where |d|² = 1 + |v|² for a point v of the face.
fn has_no_zero(cell: &Cell) -> bool {
    let [a, b] = cell.polynomials.as_slice() else {
        return false;
    };
    let [(a_low, a_high), (b_low, b_high)] = [a, b].map(|f| {
        let (constant, rest) = f.constant_and_rest();
        (&constant - &rest, constant + rest)
    });
    let unit = cell.unit();
    let [low, high] = [cell.nearest_square(), cell.farthest_square()].map(|square| square + &unit);
    let square = |value: &BigInt| value * value;
    sign(&a_low) > 0 && square(&a_low) * &unit > square(&b_high) * high
        || sign(&b_low) > 0 && square(&b_low) * low > square(&a_high) * &unit
}
