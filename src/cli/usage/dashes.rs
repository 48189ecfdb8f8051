//! Wrong dashes before a long name. After a single dash the parser reads every letter as a short option, and `-h` prints the
//! help; long dashes are made by word processors.

use clap::Command;

use super::typed::{Typed, find, long_names};

/// A word with fewer letters is read as short options.
const PART_OF_A_NAME: usize = 3;

/// The message for an argument with wrong dashes, or for blanks around `=`.
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
            "{name} =: without blanks around it, as in {name}=VALUE, or without ="
        ))
    })
}

/// The part of an argument before its value, and its name, if there is one dash before it or a long one.
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

/// The long name that is meant; a part of it from its beginning is enough.
fn meant_name<'v>(name: &str, verb: &'v Command) -> Option<&'v str> {
    let name = name.to_lowercase();
    if name.chars().count() < PART_OF_A_NAME {
        return None;
    }
    let whole = long_names(verb).find(|long| **long == name);
    whole.or_else(|| long_names(verb).find(|long| long.starts_with(&name)))
}
