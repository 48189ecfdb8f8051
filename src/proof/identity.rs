//! The claim `identity`: equations that vanish on a parametrized curve or patch (T3).

use num_bigint::BigInt;

use super::forms::{Forms, Implicit};
use super::json::Claim;
use super::parametric::Parametric;
use super::refusal::{Checked, need};
use super::sparse::{Exponents, Sparse};

/// The largest number of equations.
const MOST_EQUATIONS: usize = 8;

pub(super) fn check(forms: &Forms, claim: &Claim<'_>) -> Checked<()> {
    claim.expansion()?;
    let fields = claim.statement(&["equations", "curve"], &[])?;
    let curve = fields.get("curve", |index| forms.parametric(index))?;
    fields.get("equations", |list| {
        list.list(1..=MOST_EQUATIONS, |index| {
            let form = forms.implicit(index)?;
            need(
                form.dimension == curve.coordinates.len(),
                "the equation and the curve have different numbers of coordinates",
            )?;
            need(
                substituted(form, curve)?.is_zero(),
                "the equation does not vanish on the curve",
            )
        })
    })?;
    Ok(())
}

/// Σ c_e Π P_j^(e_j) Q_j^(d_j − e_j), reduced, where d_j is the degree of the form in its variable j.
fn substituted(form: &Implicit, curve: &Parametric) -> Checked<Sparse> {
    let mut tables = Vec::new();
    for (axis, coordinate) in curve.coordinates.iter().enumerate() {
        let degree = form.terms.degree_in(axis);
        let ups = reduced_powers(curve, &coordinate.numerator, degree)?;
        let downs = reduced_powers(curve, &coordinate.denominator, degree)?;
        let products = ups
            .iter()
            .zip(downs.iter().rev())
            .map(|(up, down)| curve.product(up, down));
        tables.push(products.collect::<Checked<Vec<_>>>()?);
    }
    let terms: Vec<_> = form.terms.terms().collect();
    sum(curve, &tables, &terms)
}

fn reduced_powers(curve: &Parametric, base: &Sparse, largest: u32) -> Checked<Vec<Sparse>> {
    let base = curve.reduced(base.clone());
    let mut powers = vec![Sparse::constant(1)];
    for _ in 0..largest {
        let next = curve.product(&powers[powers.len() - 1], &base)?;
        powers.push(next);
    }
    Ok(powers)
}

/// The sum of the terms, which ascend by their exponents. Terms that have the exponent of the first variable in common are summed
/// over the other variables first.
fn sum(
    curve: &Parametric,
    tables: &[Vec<Sparse>],
    terms: &[(&Exponents, &BigInt)],
) -> Checked<Sparse> {
    fn level(
        curve: &Parametric,
        tables: &[Vec<Sparse>],
        terms: &[(&Exponents, &BigInt)],
        axis: usize,
    ) -> Checked<Sparse> {
        let Some(table) = tables.get(axis) else {
            let mut constant = BigInt::ZERO;
            for (_, c) in terms {
                constant += *c;
            }
            return Ok(Sparse::constant(constant));
        };
        let mut result = Sparse::default();
        for group in terms.chunk_by(|(e, _), (h, _)| e[axis] == h[axis]) {
            let Some((exponents, _)) = group.first() else {
                continue;
            };
            let inner = level(curve, tables, group, axis + 1)?;
            let product = curve.product(&table[exponents[axis] as usize], &inner)?;
            result.add_multiple(&BigInt::from(1), &product);
        }
        Ok(result)
    }
    level(curve, tables, terms, 0)
}
