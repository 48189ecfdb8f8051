//! Dashes: one in place of two makes letters of a name, of which the first may well be `-h`, and long ones come from documents.

use clap::Command;

use super::typed::{Typed, find, long_names};

/// So many letters of a name are no row of short options any more.
const PART_OF_A_NAME: usize = 3;

/// What is wrong with the dashes of an argument, and with blanks round `=`.
pub(super) fn mistake(typed: &Typed, command: &Command) -> Option<String> {
    let verb = typed.verb(command);
    let words = &typed.words;
    let wrong_dash = words.iter().find_map(|word| {
        let (given, name) = word_with_a_wrong_dash(word)?;
        let meant = meant_name(name, verb)?;
        Some(format!(
            "{given}: a long name has two plain dashes before it: --{meant}"
        ))
    });
    wrong_dash.or_else(|| {
        let mut pairs = words.windows(2);
        let pair = pairs.find(|pair| pair[1] == "=" && find(verb, &pair[0]).is_some())?;
        let name = &pair[0];
        Some(format!(
            "{name} =: without blanks round it, as in {name}=VALUE, or without ="
        ))
    })
}

/// An argument up to its value, and its name behind one dash or behind long ones.
fn word_with_a_wrong_dash(word: &str) -> Option<(&str, &str)> {
    let given = word.split('=').next()?;
    let name = given.trim_start_matches(['—', '–']);
    let is_long_dash = name.len() < given.len();
    let name = match is_long_dash {
        true => name,
        false => given
            .strip_prefix('-')
            .filter(|name| !name.starts_with('-'))?,
    };
    Some((given, name))
}

/// The long name that is meant: the whole of it or its beginning.
fn meant_name<'v>(name: &str, verb: &'v Command) -> Option<&'v str> {
    let name = name.to_lowercase();
    if name.chars().count() < PART_OF_A_NAME {
        return None;
    }
    let whole = long_names(verb).find(|long| **long == name);
    whole.or_else(|| long_names(verb).find(|long| long.starts_with(&name)))
}
