//! Documents and claims: the entry of the checker, and its report.

use std::collections::{BTreeMap, HashSet};
use std::fmt;

use super::forms::Forms;
use super::json::{Claim, LONGEST_LIST, Value, beginning, parse};
use super::refusal::{Checked, Refusal, need};
use super::{
    clock, distance, factorization, fit_error, identity, irreducible, positive_radius, root_count,
    sectors, series_equation, side,
};

/// The largest length of a document in bytes.
pub const LONGEST_DOCUMENT: usize = 1 << 27;

/// The claims that are made without a witness only.
const UNPROVED: [&str; 10] = [
    "topology",
    "closed-form",
    "ranges",
    "hausdorff-distance",
    "overlap",
    "tracing-index",
    "minimal-degree",
    "genus",
    "star-shaped-outline",
    "real-image",
];

/// The check of a claim with its witness.
type Check = fn(&Forms, &Claim<'_>) -> Checked<()>;

/// The claims that have witnesses.
const CHECKS: [(&str, Check); 10] = [
    ("root-count", root_count::check),
    ("series-equation", series_equation::check),
    ("identity", identity::check),
    ("factorization", factorization::check),
    ("irreducible", irreducible::check),
    ("positive-radius", positive_radius::check),
    ("distance", distance::check),
    ("side", side::check),
    ("sectors", sectors::check),
    ("fit-error", fit_error::check),
];

/// How many claims of one name were accepted.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Count {
    /// The claims with a witness that proves them.
    pub proved: usize,
    /// The claims without a witness.
    pub without_witness: usize,
}

/// A claim that was not accepted.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct RefusedClaim {
    /// The index of the claim in the document, from 0.
    pub index: usize,
    /// The beginning of its name, if it has one.
    pub name: String,
    /// The reason, with the place in the claim.
    pub refusal: Refusal,
}

/// The result of a check. `Display` writes a line for every refused claim and every name, and a last line with the sums.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Report {
    /// The number of claims in the document.
    pub claims: usize,
    /// The accepted claims by name.
    pub counts: BTreeMap<&'static str, Count>,
    /// The claims that were refused, in the order of the document.
    pub refused: Vec<RefusedClaim>,
    /// Whether a claim without a witness is a fault.
    complete: bool,
}

/// Checks a document of the kind `proof`. If it must be complete, a claim without a witness is a fault, too.
///
/// # Errors
/// Refuses a text that is no proof at all: it is longer than [`LONGEST_DOCUMENT`], no JSON, of another schema or kind, or has a
/// form that is not valid. A claim that does not hold is no error of this function, but a part of the report.
pub fn check(text: &str, complete: bool) -> Result<Report, Refusal> {
    clock::start();
    need(
        text.len() <= LONGEST_DOCUMENT,
        "the document is longer than 2^27 bytes",
    )?;
    let document = parse(text)?;
    let fields = document.fields(&["schema", "kind", "forms", "claims"], &[])?;
    for (name, expected) in [("schema", "stellate/1"), ("kind", "proof")] {
        fields.get(name, |value| {
            need(
                value.text()? == expected,
                "this is no proof of the schema stellate/1",
            )
        })?;
    }
    let forms = fields.get("forms", Forms::read)?;
    let claims = fields.get("claims", |list| list.list(0..=LONGEST_LIST, Ok))?;
    let mut report = Report {
        claims: claims.len(),
        complete,
        ..Report::default()
    };
    let mut seen = HashSet::new();
    for (index, claim) in claims.into_iter().enumerate() {
        match check_claim(&forms, claim, &mut seen) {
            Ok((name, true)) => report.counts.entry(name).or_default().proved += 1,
            Ok((name, false)) => report.counts.entry(name).or_default().without_witness += 1,
            Err(refusal) => report.refused.push(RefusedClaim {
                index,
                name: name_of(claim),
                refusal,
            }),
        }
    }
    Ok(report)
}

/// The name of an accepted claim, and whether it has a witness.
fn check_claim<'a>(
    forms: &Forms,
    claim: &'a Value,
    seen: &mut HashSet<(&'static str, &'a Value)>,
) -> Checked<(&'static str, bool)> {
    let fields = claim.fields(&["claim", "statement", "witness"], &[])?;
    let (name, check) = fields.get("claim", named_check)?;
    let statement = fields.get("statement", |statement| match statement {
        Value::Object(map) if !map.is_empty() => Ok(statement),
        _ => Err(Refusal::new(
            "a statement is an object with at least one field",
        )),
    })?;
    need(seen.insert((name, statement)), "this claim is made twice")?;
    let witness = fields.get("witness", Ok)?;
    if *witness == Value::Null {
        return Ok((name, false));
    }
    let check = check.ok_or_else(|| {
        Refusal::new("there is no witness for claims of this name").within("witness")
    })?;
    check(forms, &Claim { statement, witness })?;
    Ok((name, true))
}

fn named_check(value: &Value) -> Checked<(&'static str, Option<Check>)> {
    let name = value.text()?;
    let proved = CHECKS.iter().find(|(known, _)| *known == name);
    let unproved = UNPROVED.iter().find(|known| **known == name);
    proved
        .map(|(name, check)| (*name, Some(*check)))
        .or(unproved.map(|name| (*name, None)))
        .ok_or_else(|| Refusal::new(format!("there is no claim {}", beginning(name))))
}

fn name_of(claim: &Value) -> String {
    match claim {
        Value::Object(map) => match map.get("claim") {
            Some(Value::Text(name)) => beginning(name),
            _ => String::new(),
        },
        _ => String::new(),
    }
}

impl Report {
    /// The number of accepted claims without a witness.
    #[must_use]
    pub fn without_witness(&self) -> usize {
        self.counts
            .values()
            .map(|count| count.without_witness)
            .sum()
    }

    /// Whether every claim with a witness holds, and every claim has one if the document must be complete.
    #[must_use]
    pub fn holds(&self) -> bool {
        self.refused.is_empty() && !(self.complete && self.without_witness() > 0)
    }
}

impl fmt::Display for Report {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        for claim in &self.refused {
            let RefusedClaim {
                index,
                name,
                refusal,
            } = claim;
            writeln!(out, "refused: claim {index} ({name}): {refusal}")?;
        }
        for (name, count) in &self.counts {
            let Count {
                proved,
                without_witness,
            } = count;
            writeln!(
                out,
                "{name}: {proved} proved, {without_witness} without a witness"
            )?;
        }
        write!(
            out,
            "{} claims, {} without a witness, {} refused",
            self.claims,
            self.without_witness(),
            self.refused.len()
        )
    }
}
