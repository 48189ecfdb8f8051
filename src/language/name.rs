//! The names of the language, and how a run of letters is split into them.

use super::source::Span;
use crate::error::Invariant;

/// A name that has a meaning; several spellings may stand for one name.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Name {
    /// The coordinates of a point.
    X,
    Y,
    Z,
    /// The radius.
    R,
    /// The radius of a surface, `R`.
    SpaceRadius,
    /// `Y(l, m)`, a spherical harmonic.
    Harmonic,
    /// The parameter of a curve, or the angle of a radius.
    T,
    Theta,
    /// The other parameters of curves and patches.
    U,
    V,
    Phi,
    S,
    W,
    Cos,
    Sin,
    Tan,
    Cot,
    Sec,
    Csc,
    /// π, in angles only.
    Pi,
    /// `Rational(p, q)`, as SymPy writes a fraction.
    Rational,
    /// `pow(a, b)`, as Python and C write a power.
    Pow,
    /// A function that is neither a polynomial nor a finite Fourier series.
    Function,
    /// The square root, whose values are in general not rational.
    Irrational,
    /// `superquadric`.
    Superquadric,
    /// `ring` and `poly`: the statements of Singular.
    Ring,
    Poly,
}

/// The number of names.
pub(super) const NAMES: usize = Name::Poly as usize + 1;

/// The coordinates of a point.
pub(super) const COORDINATES: [Name; 3] = [Name::X, Name::Y, Name::Z];

/// The parameters of curves and patches, in the order in which a patch has them.
pub(super) const PARAMETERS: [Name; 7] = [
    Name::T,
    Name::Theta,
    Name::U,
    Name::V,
    Name::Phi,
    Name::S,
    Name::W,
];

impl Name {
    /// The functions of angles.
    pub(super) const OF_ANGLES: [Name; 6] = [
        Name::Cos,
        Name::Sin,
        Name::Tan,
        Name::Cot,
        Name::Sec,
        Name::Csc,
    ];

    /// Whether the name is that of a parameter.
    pub(super) fn is_parameter(self) -> bool {
        PARAMETERS.contains(&self)
    }

    /// The usual spelling of a parameter.
    pub(super) fn parameter_name(self) -> &'static str {
        match self {
            Name::Theta => "theta",
            Name::U => "u",
            Name::V => "v",
            Name::Phi => "phi",
            Name::S => "s",
            Name::W => "w",
            _ => "t",
        }
    }

    /// The index of a parameter among the [`PARAMETERS`].
    pub(super) fn parameter_index(self) -> usize {
        let place = PARAMETERS.iter().position(|&p| p == self);
        place.invariant("the name is that of a parameter")
    }
}

/// All spellings, ordered by descending length, so that the first one that fits is the longest.
const SPELLINGS: &[(&str, Name)] = &[
    ("superquadric", Name::Superquadric),
    ("Rational", Name::Rational),
    ("Fraction", Name::Rational),
    ("vartheta", Name::Theta),
    ("arcsin", Name::Function),
    ("arccos", Name::Function),
    ("arctan", Name::Function),
    ("varphi", Name::Phi),
    ("theta", Name::Theta),
    ("Theta", Name::Theta),
    ("sqrt", Name::Irrational),
    ("asin", Name::Function),
    ("acos", Name::Function),
    ("atan", Name::Function),
    ("sinh", Name::Function),
    ("cosh", Name::Function),
    ("tanh", Name::Function),
    ("ring", Name::Ring),
    ("poly", Name::Poly),
    ("Sqrt", Name::Irrational),
    ("cos", Name::Cos),
    ("Cos", Name::Cos),
    ("Sin", Name::Sin),
    ("Tan", Name::Tan),
    ("Cot", Name::Cot),
    ("Sec", Name::Sec),
    ("Csc", Name::Csc),
    ("sin", Name::Sin),
    ("phi", Name::Phi),
    ("rho", Name::R),
    ("tan", Name::Tan),
    ("cot", Name::Cot),
    ("sec", Name::Sec),
    ("csc", Name::Csc),
    ("exp", Name::Function),
    ("log", Name::Function),
    ("abs", Name::Function),
    ("COS", Name::Cos),
    ("SIN", Name::Sin),
    ("TAN", Name::Tan),
    ("pow", Name::Pow),
    ("Phi", Name::Phi),
    ("Abs", Name::Function),
    ("Exp", Name::Function),
    ("Log", Name::Function),
    ("ln", Name::Function),
    ("pi", Name::Pi),
    ("Pi", Name::Pi),
    ("PI", Name::Pi),
    ("π", Name::Pi),
    ("√", Name::Irrational),
    ("θ", Name::Theta),
    ("ρ", Name::R),
    ("φ", Name::Phi),
    ("ϕ", Name::Phi),
    ("x", Name::X),
    ("y", Name::Y),
    ("z", Name::Z),
    ("r", Name::R),
    ("t", Name::T),
    ("u", Name::U),
    ("v", Name::V),
    ("s", Name::S),
    ("w", Name::W),
    ("X", Name::X),
    ("Y", Name::Y),
    ("Z", Name::Z),
    ("T", Name::T),
    ("U", Name::U),
    ("V", Name::V),
    ("R", Name::SpaceRadius),
];

/// The largest number of letters of a word for which a similar name is looked for.
const LONGEST_SLIP: usize = 30;

/// The name, of at least three letters, for which a word is most likely a slip.
pub(super) fn similar_name(word: &str) -> Option<&'static str> {
    let letters = word.chars().count();
    if !(3..=LONGEST_SLIP).contains(&letters) {
        return None;
    }
    let most = if letters < 6 { 1 } else { 2 };
    let names = SPELLINGS.iter().map(|(spelling, _)| *spelling);
    let distances = names
        .filter(|name| name.len() > 2)
        .map(|name| (distance(word, name), name));
    let found = distances
        .filter(|(distance, _)| *distance <= most)
        .min_by_key(|(distance, _)| *distance);
    found.map(|(_, name)| name)
}

/// The smallest number of changes that turn one word into the other (optimal string alignment). A change replaces, inserts or
/// removes a letter, or exchanges two neighbours.
fn distance(a: &str, b: &str) -> usize {
    let [a, b] = [a, b].map(|word| word.chars().collect::<Vec<char>>());
    // The entry in row i and column j is the distance between the first i letters of a and the first j letters of b.
    let mut rows: Vec<Vec<usize>> = vec![(0..=b.len()).collect()];
    for i in 1..=a.len() {
        let mut row = vec![i];
        for j in 1..=b.len() {
            let change = usize::from(a[i - 1] != b[j - 1]);
            let one_more = (rows[i - 1][j] + 1).min(row[j - 1] + 1);
            let mut least = one_more.min(rows[i - 1][j - 1] + change);
            if i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1] {
                least = least.min(rows[i - 2][j - 2] + 1);
            }
            row.push(least);
        }
        rows.push(row);
    }
    rows[a.len()][b.len()]
}

/// The names of which `word` consists; it starts at byte `start`. At every place the longest name that fits is taken, so that
/// `xy` is x and y, but `theta` is one name. `None` if no name fits at some place; then the word is unknown.
pub(super) fn split_word(word: &str, start: u32) -> Option<Vec<(Name, Span)>> {
    let mut names = Vec::new();
    let (mut rest, mut at) = (word, start);
    while !rest.is_empty() {
        let (spelling, name) = SPELLINGS.iter().find(|(s, _)| rest.starts_with(s))?;
        let end = at + u32::try_from(spelling.len()).ok()?;
        names.push((*name, Span { start: at, end }));
        at = end;
        rest = &rest[spelling.len()..];
    }
    Some(names)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn longer_names_come_first() {
        for (a, b) in SPELLINGS.iter().zip(&SPELLINGS[1..]) {
            assert!(
                a.0.chars().count() >= b.0.chars().count(),
                "{} {}",
                a.0,
                b.0
            );
        }
    }

    #[test]
    fn slips_are_counted_and_similar_names_found() {
        for (a, b, expected) in [
            ("cos", "cos", 0),
            ("con", "cos", 1),
            ("sni", "sin", 1),
            ("thta", "theta", 1),
            ("abc", "", 3),
            ("superquadic", "superquadric", 1),
            ("tehat", "theta", 2),
        ] {
            assert_eq!(distance(a, b), expected, "{a} {b}");
            assert_eq!(distance(b, a), expected, "{b} {a}");
        }
        assert_eq!(similar_name("thta"), Some("theta"));
        assert_eq!(similar_name("xy"), None);
    }

    #[test]
    fn words_are_split_into_names() {
        let names = |word| {
            split_word(word, 0).map(|names| names.into_iter().map(|(n, _)| n).collect::<Vec<_>>())
        };
        assert_eq!(names("xy"), Some(vec![Name::X, Name::Y]));
        assert_eq!(names("theta"), Some(vec![Name::Theta]));
        assert_eq!(names("cost"), Some(vec![Name::Cos, Name::T]));
        assert_eq!(names("radius"), None);
    }
}
