//! Parses the arguments of the process. Wrong arguments are answered by one message, which says what would be right.

mod dashes;
mod option;
mod stray;
mod typed;

use std::error::Error as _;
use std::ffi::OsString;

use clap::error::{ContextKind, ContextValue, ErrorKind};
use clap::{ArgMatches, FromArgMatches};

use stellate::error::Invariant;

use super::about;
use super::arguments::{Arguments, Verb};
use super::{mesh, plot};
use typed::Typed;

/// The reason why no verb is run.
pub(crate) enum Refusal {
    /// The user asked for the help or the version, which is this text.
    Shown(clap::Error),
    /// The arguments are wrong: the message, and whether it is written in JSON.
    Wrong(String, bool),
}

/// The arguments that these words are, of which the first is the name of the program.
pub(crate) fn parsed(words: &[OsString]) -> Result<Arguments, Refusal> {
    let mut command = about::command();
    let typed = Typed::new(words);
    command = command.color(typed.color());
    command.build();
    let wrong = |message| Refusal::Wrong(message, typed.wants_json());
    let mistake = dashes::mistake(&typed, &command).or_else(|| stray::operator(&typed, &command));
    if let Some(message) = mistake {
        return Err(wrong(message));
    }
    let matches = command.try_get_matches_from_mut(words);
    let arguments = matches.and_then(|matches: ArgMatches| Arguments::from_arg_matches(&matches));
    let arguments = arguments.map_err(|error| match error.use_stderr() {
        true => wrong(message(&error, &typed, &command)),
        false => Refusal::Shown(error),
    })?;
    if let Verb::Fit(fit) = &arguments.verb
        && let Some(message) = stray::among_files(&fit.contours, &typed, typed.verb(&command))
    {
        return Err(wrong(message));
    }
    Ok(arguments)
}

/// The message for an error of the parser.
fn message(error: &clap::Error, typed: &Typed, command: &clap::Command) -> String {
    let context = |kind| match error.get(kind) {
        Some(ContextValue::String(text)) => Some(text.as_str()),
        _ => None,
    };
    let argument = context(ContextKind::InvalidArg);
    let name = argument.and_then(|argument| argument.split_whitespace().next());
    let value = context(ContextKind::InvalidValue).filter(|value| !value.is_empty());
    let verb = typed.verb(command);
    match (error.kind(), argument, name) {
        (ErrorKind::InvalidValue, Some(argument), _) if value.is_none() => {
            format!("{argument}: the value is missing")
        }
        (ErrorKind::InvalidValue, _, Some("--format")) if verb.get_name() == "mesh" => {
            mesh::NO_FORMAT.into()
        }
        (ErrorKind::InvalidValue, _, Some("--format")) if verb.get_name() == "plot" => {
            plot::NO_FORMAT.into()
        }
        (ErrorKind::InvalidValue, _, Some(name)) => {
            let values = match error.get(ContextKind::ValidValue) {
                Some(ContextValue::Strings(values)) => Some(values.join(", ")),
                _ => None,
            };
            let values = values.invariant("a wrong name comes with the right ones");
            let value = value.invariant("a missing value was answered above");
            format!("{name} {value}: expected one of {values}")
        }
        (ErrorKind::ValueValidation, _, Some(name)) => {
            let split = value.and_then(|value| stray::split_value(name, value, typed, verb));
            if let Some(message) = split {
                return message;
            }
            let why = error.source().invariant("a reader says what is wrong");
            format!("{name} {}: {why}", value.unwrap_or("\"\""))
        }
        (ErrorKind::UnknownArgument, Some(argument), Some(name)) => {
            match name.starts_with('-') && name != "-" {
                true => {
                    let similar = context(ContextKind::SuggestedArg);
                    option::unknown(name, similar, verb, command)
                }
                false => match stray::option_as_form(typed, verb) {
                    Some(option) => behind_a_form(option, typed, command),
                    None => stray::argument(argument, typed, verb),
                },
            }
        }
        (ErrorKind::InvalidSubcommand, ..) => {
            let word = context(ContextKind::InvalidSubcommand);
            let word = word.invariant("a verb that there is not has a name");
            stray::verb(word, error.get(ContextKind::SuggestedSubcommand), command)
        }
        _ => {
            let text = error.render().to_string();
            let text = text.strip_prefix("error: ").unwrap_or(&text);
            text.trim_end().into()
        }
    }
}

/// The message for an unknown option that the parser took for a form. Behind a form the parser knows an option with a similar name.
fn behind_a_form(option: &str, typed: &Typed, command: &clap::Command) -> String {
    let verb = typed.verb(command);
    let words = [command.get_name(), verb.get_name(), "-", option];
    let error = command.clone().try_get_matches_from(words).err();
    let similar = error.and_then(|error| match error.get(ContextKind::SuggestedArg) {
        Some(ContextValue::String(similar)) => Some(similar.clone()),
        _ => None,
    });
    option::unknown(option, similar.as_deref(), verb, command)
}
