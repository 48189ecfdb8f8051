//! The texts of the command line about itself: its help, its completions, its manual page, and the schemas of its documents.

use clap::builder::PossibleValue;
use clap::{Arg, ColorChoice, Command, CommandFactory};
use stellate::document::json_schema;
use stellate::error::{Invariant, Result};

use super::arguments::{Arguments, Completions, FORMS, Schema};
use super::output::{check_destination, write_result};
use super::session::Session;

const NAME: &str = "stellate";

/// The width of the list of the options of every verb.
const WIDTH: usize = 100;
/// The column where the explanations in this list begin.
const INDENT: usize = 30;

/// The syntax of the command line with its help. The options of every verb are shown once, in the help of the program.
pub(crate) fn command() -> Command {
    let mut command = whole_command();
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

/// The syntax of the command line. Named values may be written in capitals. A negative number after an option is its value, so
/// that the reader of the value can say what is wrong with it.
fn whole_command() -> Command {
    let lenient = |argument: Arg| {
        let takes_values = argument.get_action().takes_values();
        let has_names = takes_values && !argument.get_possible_values().is_empty();
        argument
            .allow_negative_numbers(takes_values)
            .ignore_case(has_names)
    };
    let color = Arg::new("color")
        .long("color")
        .global(true)
        .value_name("WHEN")
        .value_parser(clap::value_parser!(ColorChoice))
        .default_value("auto")
        .help("Colours of the help; by itself only on a terminal, and not where NO_COLOR is set");
    Arguments::command()
        .arg(color)
        .mut_args(lenient)
        .mut_subcommands(|verb| verb.mut_args(lenient))
}

/// An option and its explanation, in lines.
fn described(argument: &Arg) -> String {
    let takes_values = argument.get_action().takes_values();
    let short = match argument.get_short() {
        Some(short) => format!("-{short}, "),
        None => "    ".into(),
    };
    let value = match argument.get_value_names() {
        Some([name, ..]) if takes_values => format!(" <{name}>"),
        _ => String::new(),
    };
    let long = argument
        .get_long()
        .invariant("options of every verb have long names");
    let names = format!("  {short}--{long}{value}");
    let help = argument.get_help().invariant("every option is explained");
    let mut text = help.to_string();
    let values = argument.get_possible_values();
    if takes_values && !values.is_empty() {
        let values: Vec<&str> = values.iter().map(PossibleValue::get_name).collect();
        text.push_str(&format!(" [one of {}]", values.join(", ")));
    }
    let defaults = argument.get_default_values().iter();
    let defaults: Vec<_> = defaults.map(|value| value.to_string_lossy()).collect();
    if takes_values && !defaults.is_empty() {
        text.push_str(&format!(" [default: {}]", defaults.join(",")));
    }
    // Names that are too long for the first column have a line of their own.
    let is_long = names.chars().count() + 2 > INDENT;
    let (above, beside) = match is_long {
        true => (names + "\n", String::new()),
        false => (String::new(), names),
    };
    let indent = " ".repeat(INDENT);
    let beside = format!("{beside:INDENT$}");
    let lines = textwrap::Options::new(WIDTH)
        .initial_indent(&beside)
        .subsequent_indent(&indent);
    above + &textwrap::fill(&text, lines) + "\n"
}

/// `stellate completions SHELL`
pub(crate) fn completions(verb: &Completions, session: &Session) -> Result<()> {
    check_destination(session)?;
    let mut text = Vec::new();
    clap_complete::generate(verb.shell, &mut whole_command(), NAME, &mut text);
    write_result(session, |out| Ok(out.write_all(&text)?))
}

/// `stellate man`
pub(crate) fn manual(session: &Session) -> Result<()> {
    check_destination(session)?;
    let mut text = Vec::new();
    clap_mangen::Man::new(whole_command()).render(&mut text)?;
    write_result(session, |out| Ok(out.write_all(&text)?))
}

/// `stellate schema [KIND]`
pub(crate) fn schema(verb: &Schema, session: &Session) -> Result<()> {
    check_destination(session)?;
    let text = json_schema(verb.kind.as_deref())?;
    write_result(session, |out| Ok(out.write_all(text.as_bytes())?))
}
