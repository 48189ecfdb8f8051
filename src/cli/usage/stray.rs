//! Arguments in places where none is expected: parts of a form without quotes, a second form, a form in place of a verb.

use std::path::Path;

use clap::error::ContextValue;
use clap::{Arg, Command};
use stellate::language::{Numbers, parse_form};

use super::typed::{Typed, find};

/// The message for an argument that is one too many.
pub(super) fn argument(argument: &str, typed: &Typed, verb: &Command) -> String {
    let name = verb.get_name();
    if let Some(form) = without_quotes(argument, typed, verb) {
        return quoted(verb, &form);
    }
    if let Some((option, value)) = split_list(argument, typed, verb) {
        return in_one_argument(option, value, argument);
    }
    if let Some((option, value)) = argument.split_once('=')
        && let Some(option) = named(option, verb)
    {
        return format!("{argument}: an option has dashes before it: {option} {value}");
    }
    let Some(takes) = verb.get_positionals().find_map(first_name) else {
        return format!("{argument}: {name} takes options only");
    };
    let several = match &*takes {
        "form" => "; plot takes several",
        _ => "",
    };
    format!("{argument}: {name} takes one {takes}, and this is another argument{several}")
}

/// The first word that looks like an option, but is none of the verb; the parser takes it for a form, which may begin with a sign.
pub(super) fn option_as_form<'t>(typed: &'t Typed, verb: &Command) -> Option<&'t str> {
    let mut words = typed.words.iter().map(String::as_str);
    words.find(|word| {
        let name = word.split('=').next().unwrap_or(word);
        let is_named = |rest: &str| {
            let is_part = |c: char| c.is_ascii_alphanumeric() || c == '-' || c == '_';
            rest.len() > 1 && rest.starts_with(char::is_alphabetic) && rest.chars().all(is_part)
        };
        name.strip_prefix("--").is_some_and(is_named) && find(verb, name).is_none()
    })
}

/// The message for an operator that is an argument of its own. It belongs to a form without quotes; the parser does not notice
/// this if the verb takes several forms.
pub(super) fn operator(typed: &Typed, command: &Command) -> Option<String> {
    let verb = typed.verb(command);
    let mut pairs = typed.words.windows(2);
    let pair = pairs.find(|pair| is_operator(&pair[1]) && find(verb, &pair[0]).is_none())?;
    without_quotes(&pair[1], typed, verb).map(|form| quoted(verb, &form))
}

/// Whether a word consists of operators. A single minus does not: it means standard input.
fn is_operator(word: &str) -> bool {
    word != "-" && !word.is_empty() && word.chars().all(|c| "+-*/^=;,".contains(c))
}

/// The message for a form without quotes.
fn quoted(verb: &Command, form: &str) -> String {
    let name = verb.get_name();
    format!("a form that has blanks stands in quotes: stellate {name} \"{form}\"")
}

/// The form without quotes of which the argument is a part.
fn without_quotes(argument: &str, typed: &Typed, verb: &Command) -> Option<String> {
    let words = &typed.words;
    let at = words.iter().position(|word| word == argument)?;
    let is_option = |word: &String| word.starts_with("--") || find(verb, word).is_some();
    let is_part = |word: &String| !is_option(word) && word != verb.get_name();
    let before = words[..at]
        .iter()
        .rev()
        .take_while(|word| is_part(word))
        .count();
    let after = words[at..].iter().take_while(|word| is_part(word)).count();
    let run = &words[at - before..at + after];
    // The values of options may come before the form.
    let mut forms = (0..before).map(|k| run[k..].join(" "));
    let found = forms.find(|form| parse_form(form, "<form>", Numbers::Exact).is_ok());
    found.or_else(|| is_operator(argument).then(|| run.join(" ")))
}

/// The option that takes a list of numbers, and its value, if the argument comes after them and is the next number.
fn split_list<'t>(argument: &str, typed: &'t Typed, verb: &Command) -> Option<(&'t str, &'t str)> {
    argument.parse::<f64>().ok()?;
    let takes_a_list = |option: &str| {
        let names = find(verb, option).and_then(Arg::get_value_names);
        names.is_some_and(|names| names.iter().any(|name| name.contains(',')))
    };
    let mut triples = typed.words.windows(3);
    let triple = triples.find(|words| words[2] == argument && takes_a_list(&words[0]))?;
    Some((&triple[0], &triple[1]))
}

/// The message for an option whose list of numbers is split into several arguments, if the next argument is a number. The parser
/// complains about the value if the verb takes several forms.
pub(super) fn split_value(
    option: &str,
    value: &str,
    typed: &Typed,
    verb: &Command,
) -> Option<String> {
    let mut triples = typed.words.windows(3);
    let triple = triples.find(|words| words[0] == option && words[1] == value)?;
    let (option, value) = split_list(&triple[2], typed, verb)?;
    Some(in_one_argument(option, value, &triple[2]))
}

fn in_one_argument(option: &str, value: &str, argument: &str) -> String {
    format!("{option} takes its numbers in one argument: {option} {value},{argument}")
}

/// The message for an argument of a verb that takes several, if it is no file but a number or an option without dashes.
pub(super) fn among_files(files: &[String], typed: &Typed, verb: &Command) -> Option<String> {
    let is_stray = |name: &&String| {
        let is_assignment = name
            .split_once('=')
            .is_some_and(|(name, _)| named(name, verb).is_some());
        (is_assignment || name.parse::<f64>().is_ok()) && !Path::new(name).exists()
    };
    let stray = files.iter().skip(1).find(is_stray)?;
    Some(argument(stray, typed, verb))
}

/// The option with this name, with its dashes.
fn named(name: &str, verb: &Command) -> Option<String> {
    let name = name.to_lowercase();
    let names = [format!("-{name}"), format!("--{name}")];
    names.into_iter().find(|name| find(verb, name).is_some())
}

/// The name of a positional argument in the help, in small letters.
fn first_name(argument: &Arg) -> Option<String> {
    let name = argument.get_value_names()?.first()?;
    Some(name.to_lowercase())
}

/// The message for a word in the place of the verb. `similar` has the verbs with similar names.
pub(super) fn verb(word: &str, similar: Option<&ContextValue>, command: &Command) -> String {
    let verbs: Vec<&str> = command.get_subcommands().map(Command::get_name).collect();
    let is_form = parse_form(word, "<form>", Numbers::Exact).is_ok() || word.contains('=');
    if is_form || Path::new(word).extension().is_some() || Path::new(word).exists() {
        let takers = command.get_subcommands().filter(|verb| {
            let name = verb.get_positionals().find_map(first_name);
            name.is_some_and(|name| ["form", "forms", "reference", "contour"].contains(&&*name))
        });
        let takers: Vec<&str> = takers.map(Command::get_name).collect();
        let takers = takers.join(", ");
        return format!(
            "a verb stands before the form, as in stellate describe \"{word}\"; those that take one are {takers}"
        );
    }
    let similar = match similar {
        Some(ContextValue::Strings(names)) => names.first(),
        _ => None,
    };
    // Names with another first letter are similar by chance.
    let similar = similar.filter(|name| name.chars().next() == word.to_lowercase().chars().next());
    match similar {
        Some(name) => format!("there is no verb {word}; did you mean {name}?"),
        None => format!(
            "there is no verb {word}; the verbs are {}",
            verbs.join(", ")
        ),
    }
}
