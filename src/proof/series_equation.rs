//! The claim `series-equation`: the polynomial of a radius that is a finite series (T2).

use num_bigint::BigInt;

use super::forms::{Forms, Implicit};
use super::json::{Claim, Fields, Value};
use super::numbers::Exact;
use super::refusal::{Checked, Refusal, need};
use super::series::{Parity, Series};
use super::sparse::Sparse;

pub(super) fn check(forms: &Forms, claim: &Claim<'_>) -> Checked<()> {
    claim.expansion()?;
    let fields = claim.statement(&["form", "radius", "coordinates"], &["square"])?;
    let form = fields.get("form", |index| forms.implicit(index))?;
    let square = fields.optional("square", |value| {
        need(*value == Value::Truth(true), "square is true, or missing")
    })?;
    let exponent = if square.is_some() { 2 } else { 1 };
    need_same(forms, form, exponent, &fields).map(|_| ())
}

/// Needs the power of the form with this exponent to be the equation of the radius in the fields `radius` and `coordinates`, and returns the radius with its
/// parts A and B.
pub(super) fn need_same<'a>(
    forms: &'a Forms,
    form: &Implicit,
    exponent: u32,
    fields: &Fields<'_>,
) -> Checked<(&'a Series, Parity)> {
    let series = fields.get("radius", |index| forms.series(index))?;
    let about_center = fields.get("coordinates", |value| match value.text()? {
        "center" => Ok(true),
        "original" => Ok(false),
        _ => Err(Refusal::new("the coordinates are center or original")),
    })?;
    need(
        form.dimension == series.dimension(),
        "the form and the radius have different numbers of variables",
    )?;
    let parity = series.parity()?;
    let mut equation = squared_equation(series, &parity)?;
    if !about_center {
        let back: Vec<Exact> = series.center.iter().map(|c| -c).collect();
        equation = equation.about(&back);
    }
    need(
        form.terms.power(exponent)?.is_proportional_to(&equation),
        "the polynomial is not the equation of the radius",
    )?;
    Ok((series, parity))
}

/// T times the square of the scale: (ρ^((N + 1)/2) − A)² − ρB² for odd N, and ρ(ρ^(N/2) − B)² − A² for even N.
fn squared_equation(series: &Series, parity: &Parity) -> Checked<Sparse> {
    let top = series.top();
    let (one, minus) = (BigInt::from(1), BigInt::from(-1));
    let rho = Sparse::squared_radius(series.dimension());
    let (with_power, alone) = if top % 2 == 1 {
        (&parity.same, &parity.other)
    } else {
        (&parity.other, &parity.same)
    };
    let mut difference = Sparse::default();
    difference.add_multiple(&series.solid_scale(), &rho.power(top.div_ceil(2))?);
    difference.add_multiple(&minus, with_power);
    let mut squares = [difference.times(&difference)?, alone.times(alone)?];
    let times_rho = usize::from(top % 2 == 1);
    squares[times_rho] = squares[times_rho].times(&rho)?;
    let mut equation = Sparse::default();
    equation.add_multiple(&one, &squares[0]);
    equation.add_multiple(&minus, &squares[1]);
    Ok(equation)
}
