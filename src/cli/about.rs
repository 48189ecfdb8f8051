//! What the command line says of itself: its help, completions and manual page.

use clap::{Arg, Command, CommandFactory, FromArgMatches};
use stellate::document::json_schema;
use stellate::error::Result;

use super::arguments::{Arguments, Completions, FORMS, Schema};
use super::output::{check_destination, write_result};
use super::session::Session;

const NAME: &str = "stellate";

/// The widest line of the options of every verb.
const WIDTH: usize = 100;
/// Where their explanations begin.
const INDENT: usize = 30;

/// The arguments of the process.
pub(crate) fn parsed() -> std::result::Result<Arguments, clap::Error> {
    let matches = command().try_get_matches()?;
    Arguments::from_arg_matches(&matches)
}

/// The command line; the options of every verb are shown once, in the help of the program.
fn command() -> Command {
    let mut command = Arguments::command();
    let shared = command.get_arguments().filter(|a| a.is_global_set());
    let shared: Vec<Arg> = shared.cloned().collect();
    let listed: String = shared.iter().map(described).collect();
    for argument in &shared {
        command = command.mut_arg(argument.get_id(), |argument| argument.hide(true));
    }
    command
        .mut_subcommands(|verb| {
            let own = verb.get_after_help().map(|help| format!("{help}\n\n"));
            let more = "Options of every verb, and what a FORM is: stellate --help";
            verb.after_help(own.unwrap_or_default() + more)
        })
        .override_usage("stellate <COMMAND> [OPTIONS]")
        .after_help(format!("Options of every verb:\n{listed}\n{FORMS}"))
}

/// An option and its explanation, in lines.
fn described(argument: &Arg) -> String {
    let short = match argument.get_short() {
        Some(short) => format!("-{short}, "),
        None => "    ".into(),
    };
    let value = match argument.get_value_names() {
        Some([name, ..]) if argument.get_action().takes_values() => format!(" <{name}>"),
        _ => String::new(),
    };
    let names = format!(
        "  {short}--{}{value}",
        argument.get_long().unwrap_or_default()
    );
    let mut text = argument
        .get_help()
        .map_or_else(String::new, ToString::to_string);
    let values = argument.get_possible_values();
    if argument.get_action().takes_values() && !values.is_empty() {
        let values: Vec<&str> = values
            .iter()
            .map(clap::builder::PossibleValue::get_name)
            .collect();
        text.push_str(&format!(" [one of {}]", values.join(", ")));
    }
    let defaults = argument.get_default_values().iter();
    let defaults: Vec<_> = defaults.map(|value| value.to_string_lossy()).collect();
    if argument.get_action().takes_values() && !defaults.is_empty() {
        text.push_str(&format!(" [default: {}]", defaults.join(",")));
    }
    let is_long = names.chars().count() + 2 > INDENT;
    let mut lines = vec![names];
    lines.extend(is_long.then(String::new));
    for word in text.split_whitespace() {
        let full = lines.last().is_none_or(|line| {
            let length = line.chars().count();
            length > INDENT && length + 1 + word.chars().count() > WIDTH
        });
        if full {
            lines.push(String::new());
        }
        if let Some(line) = lines.last_mut() {
            // Explanations stand below each other, words one blank apart.
            let length = line.chars().count();
            let gap = INDENT.saturating_sub(length).max(1);
            line.push_str(&" ".repeat(gap));
            line.push_str(word);
        }
    }
    lines.join("\n") + "\n"
}

/// `stellate completions SHELL`
pub(crate) fn completions(verb: &Completions, session: &Session) -> Result<()> {
    check_destination(session)?;
    let mut text = Vec::new();
    clap_complete::generate(verb.shell, &mut Arguments::command(), NAME, &mut text);
    write_result(session, |out| Ok(out.write_all(&text)?))
}

/// `stellate man`
pub(crate) fn manual(session: &Session) -> Result<()> {
    check_destination(session)?;
    let mut text = Vec::new();
    clap_mangen::Man::new(Arguments::command()).render(&mut text)?;
    write_result(session, |out| Ok(out.write_all(&text)?))
}

/// `stellate schema [KIND]`
pub(crate) fn schema(verb: &Schema, session: &Session) -> Result<()> {
    check_destination(session)?;
    let text = json_schema(verb.kind.as_deref())?;
    write_result(session, |out| Ok(out.write_all(text.as_bytes())?))
}
