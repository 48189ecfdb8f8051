//! `stellate vectors`: test vectors for float programs.

use stellate::check::{InputsOf, test_vectors};
use stellate::document::{Format, write_vectors};
use stellate::error::{Error, Result};

use super::check;
use super::check_arguments::Vectors;
use super::output::{check_destination, write_result};
use super::session::Session;

const MAX_DIRECTIONS: usize = 1_000_000;

pub(crate) fn run(verb: &Vectors, session: &mut Session) -> Result<()> {
    check_destination(session)?;
    let format = session.format_or(Format::Json);
    if format != Format::Json {
        return Err(Error::Usage(format!(
            "--format {format}: test vectors are written as json"
        )));
    }
    if verb.directions > MAX_DIRECTIONS {
        return Err(Error::Limit {
            limit: format!(
                "--directions {}: at most {MAX_DIRECTIONS} directions",
                verb.directions
            ),
            finished: String::new(),
        });
    }
    let found = check::reference(&verb.reference, &verb.fit, session)?;
    let inputs = if found.is_parametric {
        InputsOf::Nothing
    } else {
        InputsOf::Form
    };
    let vectors = session.stage("vectors", |session| {
        test_vectors(&found.reference, inputs, verb.directions, &session.limits)
    })?;
    if vectors.rounded > 0 {
        session.note(&format!(
            "{} of {} inputs were no doubles and were rounded; everything follows from the doubles exactly",
            vectors.rounded,
            vectors.inputs.len()
        ));
    }
    write_result(session, |out| write_vectors(&vectors, out))
}
