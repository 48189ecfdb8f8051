//! The claim `factorization`: a polynomial is a product.

use super::forms::{Forms, HIGHEST_DEGREE, Implicit, MOST_PARTS};
use super::json::Claim;
use super::numbers::Exact;
use super::refusal::{Checked, need};
use super::sparse::Sparse;

pub(super) fn check(forms: &Forms, claim: &Claim<'_>) -> Checked<()> {
    claim.expansion()?;
    let fields = claim.statement(&["form", "constant", "factors"], &[])?;
    let form = fields.get("form", |index| forms.implicit(index))?;
    let constant = fields.get("constant", Exact::read_coefficient)?;
    let factors = fields.get("factors", |list| {
        let mut before: Vec<&Implicit> = Vec::new();
        list.list(1..=MOST_PARTS, |factor| {
            let fields = factor.fields(&["form", "multiplicity"], &[])?;
            let multiplicity = fields.get("multiplicity", |value| value.count(HIGHEST_DEGREE))?;
            need(multiplicity > 0, "a multiplicity is at least 1")?;
            let factor = fields.get("form", |index| forms.implicit(index))?;
            need(
                factor.dimension == form.dimension && factor.terms.degree() > 0,
                "a factor is a polynomial in the same variables that is not constant",
            )?;
            need(
                before
                    .iter()
                    .all(|other| !other.terms.is_proportional_to(&factor.terms)),
                "two factors are proportional",
            )?;
            before.push(factor);
            Ok((factor, multiplicity))
        })
    })?;
    let degree: u32 = factors
        .iter()
        .map(|(factor, m)| factor.terms.degree() * m)
        .sum();
    need(
        degree == form.terms.degree(),
        "the degrees of the factors do not add up",
    )?;
    let mut product = Sparse::constant(1);
    let mut denominator = Exact::one();
    for (factor, multiplicity) in factors {
        for _ in 0..multiplicity {
            product = product.times(&factor.terms)?;
            denominator = &denominator * &Exact::integer(factor.denominator.clone());
        }
    }
    // f = terms/d is constant·product/denominator: compare the terms times the denominators.
    let left = &denominator * &Exact::integer(constant.denominator().clone());
    let right = &constant * &Exact::integer(form.denominator.clone());
    let (mut stated, mut expanded) = (Sparse::default(), Sparse::default());
    stated.add_multiple(left.numerator(), &form.terms);
    expanded.add_multiple(right.numerator(), &product);
    need(stated == expanded, "the product is another polynomial")
}
