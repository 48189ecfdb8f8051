//! Writes a [`Formula`] as MathML.

use super::formula::Formula;
use super::typeset::{infix, wrapped};

/// How tightly a formula binds. A formula that binds less tightly than its place requires stands in parentheses.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Binding {
    Sum,
    Product,
    Atom,
}

/// An equation `left = right` as `<math>` elements, between which a line may break: before the `=`, and before every part of a
/// sum but the first.
pub(super) fn equation(left: &Formula, right: &Formula) -> Vec<String> {
    let mut right = rows(right);
    if let Some(first) = right.first_mut() {
        first.insert_str(0, &infix('='));
    }
    wrapped([rows(left), right].concat())
}

/// A formula as `<math>` elements, in the same way.
pub(super) fn formula(formula: &Formula) -> Vec<String> {
    wrapped(rows(formula))
}

/// A single symbol as a `<math>` element.
pub(super) fn named(name: &str) -> Vec<String> {
    wrapped(vec![symbol(name)])
}

/// One row for each part of a sum; any other formula is one row.
fn rows(formula: &Formula) -> Vec<String> {
    let Formula::Sum(parts) = formula else {
        return vec![markup(formula)];
    };
    let row = |(index, (subtracted, part)): (usize, &(bool, Formula))| {
        let sign = match (subtracted, index) {
            (true, 0) => "<mo form=\"prefix\">−</mo>".into(),
            (true, _) => infix('−'),
            (false, 0) => String::new(),
            (false, _) => infix('+'),
        };
        sign + &within(part, Binding::Product)
    };
    parts.iter().enumerate().map(row).collect()
}

fn markup(formula: &Formula) -> String {
    match formula {
        Formula::Number(value) => number(&value.to_string()),
        Formula::Symbol(name) => symbol(name),
        Formula::Sum(_) => rows(formula).concat(),
        Formula::Product(a, b) => format!(
            "{}<mo>{}</mo>{}",
            within(a, Binding::Product),
            // Two numbers side by side would look like one.
            if matches!(**b, Formula::Number(_)) {
                "·"
            } else {
                "&#x2062;"
            },
            within(b, Binding::Product)
        ),
        Formula::Quotient(a, b) => format!(
            "<mfrac><mrow>{}</mrow><mrow>{}</mrow></mfrac>",
            markup(a),
            markup(b)
        ),
        Formula::Power(base, exponent) => format!(
            "<msup><mrow>{}</mrow><mn>{exponent}</mn></msup>",
            within(base, Binding::Atom)
        ),
    }
}

fn binding(formula: &Formula) -> Binding {
    match formula {
        Formula::Sum(_) => Binding::Sum,
        Formula::Product(..) => Binding::Product,
        Formula::Number(value) if !value.is_integer() => Binding::Product,
        Formula::Quotient(..) | Formula::Power(..) => Binding::Product,
        Formula::Number(_) | Formula::Symbol(_) => Binding::Atom,
    }
}

fn within(formula: &Formula, place: Binding) -> String {
    let inner = markup(formula);
    if binding(formula) < place {
        format!("<mrow><mo>(</mo>{inner}<mo>)</mo></mrow>")
    } else {
        inner
    }
}

/// The markup of an integer or of a fraction p/q.
fn number(text: &str) -> String {
    match text.split_once('/') {
        Some((p, q)) => format!("<mfrac><mn>{p}</mn><mn>{q}</mn></mfrac>"),
        None => format!("<mn>{text}</mn>"),
    }
}

/// The markup of a symbol. The names of some Greek letters become these letters, and digits at the end are an index.
fn symbol(name: &str) -> String {
    let letters = name.trim_end_matches(|c: char| c.is_ascii_digit());
    let index = &name[letters.len()..];
    let shown = match letters {
        "alpha" => "α",
        "beta" => "β",
        "gamma" => "γ",
        "rho" => "ρ",
        other => other,
    };
    if index.is_empty() {
        format!("<mi>{shown}</mi>")
    } else {
        format!("<msub><mi>{shown}</mi><mn>{index}</mn></msub>")
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn parentheses_stand_where_they_must() {
        let shown = |text| markup(&Formula::parse(text).unwrap());
        assert_eq!(
            shown("(a + b)^2"),
            "<msup><mrow><mrow><mo>(</mo><mi>a</mi><mo form=\"infix\">+</mo><mi>b</mi><mo>)</mo></mrow></mrow><mn>2</mn></msup>"
        );
        assert_eq!(
            shown("a - (b - c)"),
            "<mi>a</mi><mo form=\"infix\">−</mo><mrow><mo>(</mo><mi>b</mi><mo form=\"infix\">−</mo><mi>c</mi><mo>)</mo></mrow>"
        );
        assert_eq!(
            shown("-p/(3*s1)"),
            "<mo form=\"prefix\">−</mo><mfrac><mrow><mi>p</mi></mrow><mrow><mn>3</mn><mo>&#x2062;</mo><msub><mi>s</mi><mn>1</mn></msub></mrow></mfrac>"
        );
        assert_eq!(
            shown("0.1*rho"),
            "<mfrac><mn>1</mn><mn>10</mn></mfrac><mo>&#x2062;</mo><mi>ρ</mi>"
        );
    }
}
