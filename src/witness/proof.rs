//! The document of claims and witnesses.

use std::collections::{HashMap, HashSet};

use serde_json::{Value, json};

use crate::error::{Error, Result};
use crate::proof::{LONGEST_DOCUMENT, check};

/// The largest number of characters of a number in a proof file that is no coefficient.
pub(super) const LONGEST_NUMBER: usize = 2_000;
/// The largest number of bytes of a witness.
const LONGEST_WITNESS: usize = 2_000_000;

/// Everything that an output claims, each claim with its witness or without one.
///
/// ```
/// use stellate::language::Numbers;
/// use stellate::verb::{self, Given, SampleOptions, Work};
/// let given = Given::read("x^2 + y^2 = 2", Numbers::Exact)?;
/// let work = Work::default().with_proof();
/// verb::sample(given, &SampleOptions::default().directions(Some(4)), &work)?;
/// let proof = work.proof().unwrap().checked()?;
/// assert_eq!((proof.claims(), proof.without_witness()), (4, 0));
/// assert!(stellate::proof::check(&proof.text(), true).unwrap().holds());
/// # Ok::<(), stellate::error::Error>(())
/// ```
#[derive(Clone, Debug, Default)]
pub struct Proof {
    forms: Vec<String>,
    index_of_form: HashMap<String, usize>,
    claims: Vec<Claim>,
    made: HashSet<(&'static str, String)>,
}

/// A claim, with a witness or without one.
#[derive(Clone, Debug)]
pub(crate) struct Claim {
    name: &'static str,
    statement: String,
    witness: Option<Value>,
}

impl Claim {
    /// A claim with a number that is too long for a proof file, or with a longer witness than [`LONGEST_WITNESS`], has no witness.
    pub(super) fn new(name: &'static str, statement: &Value, witness: Option<Value>) -> Self {
        let is_short = has_short_numbers(statement);
        let fits = |witness: &Value| {
            has_short_numbers(witness) && witness.to_string().len() <= LONGEST_WITNESS
        };
        Self {
            name,
            statement: statement.to_string(),
            witness: witness.filter(|witness| is_short && fits(witness)),
        }
    }
}

/// Whether all numbers but coefficients are as short as a proof file needs them.
fn has_short_numbers(value: &Value) -> bool {
    match value {
        Value::String(text) => text.len() <= LONGEST_NUMBER,
        Value::Array(elements) => elements.iter().all(has_short_numbers),
        Value::Object(fields) => fields.iter().all(|(name, field)| {
            name == "coefficients" || name == "constant" || has_short_numbers(field)
        }),
        Value::Null | Value::Bool(_) | Value::Number(_) => true,
    }
}

impl Proof {
    /// The index of a form in the table of forms, where it is entered once.
    pub(crate) fn form(&mut self, form: &Value) -> usize {
        let text = form.to_string();
        if let Some(index) = self.index_of_form.get(&text) {
            return *index;
        }
        let index = self.forms.len();
        self.forms.push(text.clone());
        self.index_of_form.insert(text, index);
        index
    }

    /// Makes a claim. A claim that is made already is not made again.
    pub(super) fn claim(&mut self, name: &'static str, statement: &Value, witness: Option<Value>) {
        self.add(Claim::new(name, statement, witness));
    }

    /// As [`Proof::claim`].
    pub(crate) fn add(&mut self, claim: Claim) {
        if self.made.insert((claim.name, claim.statement.clone())) {
            self.claims.push(claim);
        }
    }

    /// The number of claims.
    #[must_use]
    pub fn claims(&self) -> usize {
        self.claims.len()
    }

    /// The number of claims without a witness.
    #[must_use]
    pub fn without_witness(&self) -> usize {
        self.claims.iter().filter(|c| c.witness.is_none()).count()
    }

    /// The document, as JSON.
    #[must_use]
    pub fn text(&self) -> String {
        let claims = self.claims.iter().map(|claim| {
            let witness = claim.witness.as_ref().unwrap_or(&Value::Null);
            format!(
                "{{\"claim\":\"{}\",\"statement\":{},\"witness\":{witness}}}",
                claim.name, claim.statement
            )
        });
        let claims: Vec<String> = claims.collect();
        format!(
            "{{\"schema\":\"stellate/1\",\"kind\":\"proof\",\"forms\":[\n{}\n],\"claims\":[\n{}\n]}}\n",
            self.forms.join(",\n"),
            claims.join(",\n")
        )
    }

    /// The proof after the checker has accepted it. A claim has no witness after this if its check is too long; nor has a claim
    /// about a distance or the errors of a fit, if its witness, which was found in doubles, is not good enough.
    ///
    /// # Errors
    /// [`Error::Limit`] if the document is longer than [`LONGEST_DOCUMENT`]; [`Error::Internal`] if the checker refuses a claim.
    pub fn checked(mut self) -> Result<Self> {
        let text = self.text();
        if text.len() > LONGEST_DOCUMENT {
            return Err(Error::limit("the length of a proof, 2^27 bytes"));
        }
        let report = check(&text, false).map_err(|refusal| {
            Error::internal("a proof", format!("it is well formed: {refusal}"))
        })?;
        for refused in &report.refused {
            let claim = &mut self.claims[refused.index];
            // These witnesses are rules for covers, or were found in doubles, or the check is too long.
            let witness = claim.witness.as_ref();
            let is_cover = witness.is_some_and(|witness| witness.get("depth").is_some());
            let may_fail = is_cover
                || ["distance", "fit-error"].contains(&claim.name)
                || refused.refusal.is_limit();
            if !may_fail {
                return Err(Error::internal(
                    format!("claim {} of the proof ({})", refused.index, refused.name),
                    format!("it holds: {}", refused.refusal),
                ));
            }
            claim.witness = None;
        }
        Ok(self)
    }
}

/// The witness of claims that are checked by expansion.
pub(super) fn by_expansion() -> Option<Value> {
    Some(json!({ "method": "expansion" }))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn long_witnesses_are_left_out() {
        let of = |count: usize| json!({ "breakpoints": vec!["1/2"; count] });
        // A breakpoint takes six bytes with its comma.
        for (count, is_kept) in [
            (LONGEST_WITNESS / 6 - 10, true),
            (LONGEST_WITNESS / 6 + 1, false),
        ] {
            let claim = Claim::new("root-count", &json!({ "form": 0 }), Some(of(count)));
            assert_eq!(claim.witness.is_some(), is_kept, "{count}");
        }
        let long = "1".repeat(LONGEST_NUMBER + 1);
        let claim = Claim::new(
            "root-count",
            &json!({ "form": 0 }),
            Some(json!({ "breakpoints": [long] })),
        );
        assert!(claim.witness.is_none());
    }
}
