//! The arguments as they were typed, before they are parsed.

use std::ffi::OsString;

use clap::{Arg, ColorChoice, Command, ValueEnum};

/// The words of the command line, without the name of the program and without `--` and the words after it.
pub(super) struct Typed {
    pub(super) words: Vec<String>,
}

impl Typed {
    pub(super) fn new(words: &[OsString]) -> Self {
        let words = words.iter().skip(1).map(|word| word.to_string_lossy());
        let words = words.take_while(|word| word != "--");
        Self {
            words: words.map(std::borrow::Cow::into_owned).collect(),
        }
    }

    /// The verb, or the whole program if there is none.
    pub(super) fn verb<'c>(&self, command: &'c Command) -> &'c Command {
        let verbs = self.words.iter();
        let mut verbs = verbs.filter_map(|word| command.find_subcommand(word));
        verbs.next().unwrap_or(command)
    }

    /// Whether the help is coloured. The parser must know this before it parses, because it writes the help.
    pub(super) fn color(&self) -> ColorChoice {
        let choice = self.value_of("--color");
        let choice = choice.and_then(|when| ColorChoice::from_str(when, true).ok());
        choice.unwrap_or_default()
    }

    /// Whether the result is to be written in JSON; then errors are, too.
    pub(super) fn wants_json(&self) -> bool {
        let format = self.value_of("--format");
        format.is_some_and(|format| format.eq_ignore_ascii_case("json"))
    }

    /// The value of an option: the next word, or the text after `=`.
    fn value_of(&self, option: &str) -> Option<&str> {
        let at = self.words.iter().rposition(|word| {
            let rest = word.strip_prefix(option);
            rest.is_some_and(|rest| rest.is_empty() || rest.starts_with('='))
        })?;
        match self.words[at].split_once('=') {
            Some((_, value)) => Some(value),
            None => self.words.get(at + 1).map(String::as_str),
        }
    }
}

/// The option of a verb with this name, its dashes included.
pub(super) fn find<'v>(verb: &'v Command, name: &str) -> Option<&'v Arg> {
    verb.get_arguments().find(|argument| {
        let long = argument
            .get_long()
            .is_some_and(|long| name.strip_prefix("--") == Some(long));
        long || argument
            .get_short()
            .is_some_and(|short| name == format!("-{short}"))
    })
}

/// The long names of the options of a verb.
pub(super) fn long_names(verb: &Command) -> impl Iterator<Item = &str> {
    verb.get_arguments().filter_map(Arg::get_long)
}
