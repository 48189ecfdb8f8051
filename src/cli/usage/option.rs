//! Options that a verb does not have.

use clap::{Arg, Command};
use stellate::document::Format;

use super::typed::long_names;

/// Other names that people try for `--harmonics`.
const HARMONICS: [&str; 5] = ["n", "order", "degree", "modes", "terms"];

/// The message for an option that the verb does not have. `similar` is the option with the most similar name.
pub(super) fn unknown(
    option: &str,
    similar: Option<&str>,
    verb: &Command,
    command: &Command,
) -> String {
    let name = option
        .trim_start_matches('-')
        .to_lowercase()
        .replace('_', "-");
    let instead = |meant: &str| format!("there is no option {option}; write {meant}");
    if let Some(long) = long_names(verb).find(|long| **long == name) {
        if option.strip_prefix("--") == Some(long) {
            let verb = verb.get_name();
            return format!(
                "{option} belongs to {verb} and stands behind it: stellate {verb} {option}"
            );
        }
        return instead(&format!("--{long}"));
    }
    let owners: Vec<&str> = command
        .get_subcommands()
        .filter(|other| long_names(other).any(|long| long == name))
        .map(Command::get_name)
        .collect();
    if !owners.is_empty() {
        let owners = enumerated(&owners);
        return match verb.get_name() == command.get_name() {
            true => format!("{option} belongs to {owners} and stands behind the verb"),
            false => format!("{option} belongs to {owners}, not to {}", verb.get_name()),
        };
    }
    let has_harmonics = long_names(verb).any(|long| long == "harmonics");
    if has_harmonics && HARMONICS.contains(&&*name) {
        return instead("--harmonics N or -n N");
    }
    if let Ok(format) = name.parse::<Format>() {
        return instead(&format!("--format {format}"));
    }
    // The first letter of a form behind its sign, for a verb with several forms; a single one may begin with a sign.
    let takes_signs = verb.get_positionals().any(Arg::is_allow_hyphen_values_set);
    if !takes_signs
        && let Some(first) = option.strip_prefix('-')
        && let [first] = *first.as_bytes()
        && b"xyzrRt(.0123456789".contains(&first)
    {
        return format!(
            "there is no option {option}; a form that begins with a minus sign stands behind --, after all options"
        );
    }
    let mut beginning = long_names(verb).filter(|long| long.starts_with(&name));
    match (beginning.next(), beginning.next(), similar) {
        (Some(long), None, _) => instead(&format!("--{long}")),
        (None, _, Some(similar)) => {
            format!("there is no option {option}; did you mean {similar}?")
        }
        _ => format!("there is no option {option}; there are {}", listed(verb)),
    }
}

/// The names as a list: `a`, `a and b`, `a, b and c`.
fn enumerated(names: &[&str]) -> String {
    match names {
        [others @ .., last] if !others.is_empty() => format!("{} and {last}", others.join(", ")),
        _ => names.concat(),
    }
}

/// The names of the options of a verb, first its own, then those of every verb.
fn listed(verb: &Command) -> String {
    let (shared, own): (Vec<&Arg>, Vec<&Arg>) = verb
        .get_arguments()
        .partition(|argument| argument.is_global_set());
    let names = own.into_iter().chain(shared).filter_map(Arg::get_long);
    let names: Vec<String> = names.map(|name| format!("--{name}")).collect();
    names.join(", ")
}
