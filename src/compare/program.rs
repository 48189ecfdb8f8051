//! The other programs of the comparison: their names, the commands that run them, and their scripts.

use std::time::Duration;

use super::process::{Ended, run};
use super::radius::System;
use crate::error::Result;
use crate::limits::Limits;
use crate::notation::Notation;
use crate::shape::FourierRadius;

/// A program that reads a script on its standard input.
#[derive(Debug)]
pub(super) struct Program {
    pub(super) name: &'static str,
    pub(super) command: &'static str,
    arguments: &'static [&'static str],
    notation: Notation,
    /// A script that prints the line `VERSION …`.
    version: &'static str,
    pub(super) methods: &'static [Script],
}

/// One way to eliminate a variable with a program.
#[derive(Debug)]
pub(super) struct Script {
    pub(super) what: &'static str,
    system: System,
    /// The text of the script, in which `FIRST` and `SECOND` stand for the two polynomials. The script prints the line
    /// `TIME milliseconds runs` and then the answer.
    text: &'static str,
}

pub(super) const PROGRAMS: [Program; 3] = [
    Program {
        name: "PARI/GP",
        command: "gp",
        arguments: &["-q", "-f"],
        notation: Notation::Explicit,
        version: include_str!("scripts/version.gp"),
        methods: &[
            Script {
                what: "polresultant over tan(θ/2)",
                system: System::HalfAngle,
                text: include_str!("scripts/resultant.gp"),
            },
            Script {
                what: "polresultant over r of r² - x² - y² and Eq. (6), the paper's idea",
                system: System::Radius,
                text: include_str!("scripts/resultant.gp"),
            },
        ],
    },
    Program {
        name: "Singular",
        command: "Singular",
        arguments: &["-q", "--no-rc", "--no-tty"],
        notation: Notation::Explicit,
        version: include_str!("scripts/version.sing"),
        methods: &[
            Script {
                what: "eliminate (a Gröbner basis) over tan(θ/2)",
                system: System::HalfAngle,
                text: include_str!("scripts/eliminate.sing"),
            },
            Script {
                what: "resultant over tan(θ/2)",
                system: System::HalfAngle,
                text: include_str!("scripts/resultant.sing"),
            },
        ],
    },
    Program {
        name: "SymPy",
        command: "python3",
        arguments: &["-"],
        notation: Notation::Python,
        version: include_str!("scripts/version.py"),
        methods: &[Script {
            what: "resultant over tan(θ/2)",
            system: System::HalfAngle,
            text: include_str!("scripts/resultant.py"),
        }],
    },
];

/// Whether a program can take part in the comparison.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) enum Presence {
    Version(String),
    Absent,
    /// The command exists, but it cannot be used, for this reason.
    Useless(String),
}

impl Program {
    /// Runs the program for at most `time` to find out its version.
    ///
    /// # Errors
    /// Those of `limits`.
    pub(super) fn presence(&self, time: Duration, limits: &Limits) -> Result<Presence> {
        let ended = run(self.command, self.arguments, self.version, time, limits)?;
        Ok(match ended {
            Ended::Absent => Presence::Absent,
            Ended::OverTime => Presence::Useless(format!(
                "asked for its version it said nothing within {} s",
                time.as_secs_f64()
            )),
            Ended::Failed(reason) => Presence::Useless(reason),
            Ended::Done(output) => match field(&output.text, "VERSION") {
                Some((version, _)) => Presence::Version(version.to_owned()),
                None => {
                    Presence::Useless(format!("asked for its version it said {}", output.said()))
                }
            },
        })
    }

    /// The text of a script for a radius.
    pub(super) fn script(&self, method: &Script, radius: &FourierRadius) -> String {
        let [first, second] = method.system.polynomials(radius);
        let [first, second] = [first, second].map(|f| self.notation.polynomial(&f));
        method
            .text
            .replace("FIRST", &first)
            .replace("SECOND", &second)
    }

    /// Runs a script, for at most `time`.
    ///
    /// # Errors
    /// Those of `limits`.
    pub(super) fn answer(&self, script: &str, time: Duration, limits: &Limits) -> Result<Ended> {
        run(self.command, self.arguments, script, time, limits)
    }
}

/// The value in the first line `NAME value` of a text, and the text after that line.
pub(super) fn field<'a>(text: &'a str, name: &str) -> Option<(&'a str, &'a str)> {
    let mut rest = text;
    while !rest.is_empty() {
        let (line, after) = rest.split_once('\n').unwrap_or((rest, ""));
        if let Some(value) = line
            .strip_prefix(name)
            .and_then(|value| value.strip_prefix(' '))
        {
            return Some((value.trim(), after));
        }
        rest = after;
    }
    None
}

#[cfg(test)]
mod tests {
    use super::super::radius::ladder_radius;
    use super::*;

    #[test]
    fn a_field_is_a_line_of_its_own() {
        let text = "noise TIME 1\nTIMES 2\nTIME 3 4\r\nx^2\n";
        assert_eq!(field(text, "TIME"), Some(("3 4", "x^2\n")));
        assert_eq!(field("TIME 3", "TIME"), Some(("3", "")));
        assert_eq!(field("TIMEX", "TIME"), None);
    }

    #[test]
    fn scripts_have_the_polynomials_in_the_notation_of_the_program() {
        let radius = ladder_radius(1);
        let [pari, _, sympy] = &PROGRAMS;
        let [half_angle, in_r] = pari.methods else {
            panic!("two methods")
        };
        let script = pari.script(half_angle, &radius);
        assert!(
            script.contains("first = 200*x*z^4 + 205*z^4 + "),
            "{script}"
        );
        let script = pari.script(in_r, &radius);
        assert!(script.contains("first = -x^2 - y^2 + z^2;"), "{script}");
        assert!(
            script.contains("second = 200*z^2 + 5*x - 3*y - 200*z;"),
            "{script}"
        );
        let script = sympy.script(&sympy.methods[0], &radius);
        assert!(script.contains("Poly(200*x*z**4"), "{script}");
        for program in &PROGRAMS {
            for method in program.methods {
                let script = program.script(method, &radius);
                assert!(!script.contains("FIRST") && !script.contains("SECOND"));
            }
        }
    }
}
