//! Mistakes in formulas: each is answered with one message that points at the place and says what would be right.

use stellate::language::Numbers;
use stellate::reading::read_text;

use crate::common::forms::refusal;

/// The text, how it goes on where the message points, and a part of the message.
const MISTAKES: &[(&str, &str, &str)] = &[
    // Slips of the keyboard.
    ("(x^2 + y^2 - 1", "(x^2", "this `(` is never closed"),
    ("x^2 + y^2) = 1", ") = 1", "`)` without a `(` before it"),
    ("(x^2 + y^2] = 1", "] = 1", "`]` does not close `(`"),
    ("x^2 + + = 1", "= 1", "expected a number, a name or `(`"),
    ("x^2 + y^2 =", "", "expected a number, a name or `(`"),
    ("= x^2", "= x^2", "expected a number, a name or `(`"),
    ("x^ + y^2 = 1", "+ y^2", "expected an exponent after `^`"),
    ("x^", "", "expected a number, a name or `(`"),
    ("x2 + y2 = 1", "2 + y2", "write `*` or `^` between them"),
    ("1 1/2 x + y = 1", "1/2", "write `*` or `^` between them"),
    (
        "x = y = 1",
        "= 1",
        "equations are separated by `;` or a new line",
    ),
    ("x^2 != y", "!=", "an equation has `=`"),
    ("y = x % 2", "% 2", "unexpected character"),
    ("1.2.3x", ".3x", "a number after a factor"),
    ("2e+x", "2e+", "the exponent after e needs digits"),
    ("x²^3 = y", "^3", "parentheses say what is meant"),
    // Names.
    ("r = 1 + con(3t)", "con", "a similar one is `cos`"),
    ("r = 1 + sni(t)", "sni", "a similar one is `sin`"),
    ("r = 1 + cos(thta)", "thta", "a similar one is `theta`"),
    (
        "superquadic 2d a=1,2 e=1/2",
        "superquadic",
        "a similar one is `superquadric`",
    ),
    (
        "x^n + y^n = 1",
        "n + y",
        "numbers stand in the place of other letters",
    ),
    (
        "a*x^2 + y = 1",
        "a*x",
        "numbers stand in the place of other letters",
    ),
    (
        "R = 1 + cos(t)/3",
        "t)/3",
        "the radius of a plane curve is r",
    ),
    (
        "(a^2, a^3)",
        "a^2",
        "parameters are t, theta, u, v, phi, s, w",
    ),
    (
        "ParametricPlot[{Cos[t], Sin[t]}, {t, 0, 2 Pi}]",
        "Param",
        "without the command that draws it",
    ),
    (
        "ContourPlot[x^2 + y^2 == 1, {x,-2,2}]",
        "Cont",
        "without the command that draws it",
    ),
    (
        "Curve(cos(t), sin(t), t, 0, 2)",
        "Curve",
        "without the command that draws it",
    ),
    ("r = 1 + cosd(3*t)", "cosd", "a similar one is"),
    // Angles and radii.
    ("r = 1 + cos(x)", "x)", "the angle is t or theta"),
    (
        "r = 1 + cos(t)*cos(theta)",
        "theta",
        "use either t or theta",
    ),
    (
        "r = cos(t + 1)",
        "t + 1",
        "an integer multiple of the angle",
    ),
    ("r = t", "t", "outside cos( ) and sin( )"),
    ("r = x", "x", "whose only variable is the angle"),
    ("r = 1 + r", "r", "r stands only on the left"),
    (
        "r*(2 + cos(t)) = 3",
        "r*(",
        "r stands only on the left of a Fourier radius `r = …`",
    ),
    (
        "r - 1 - cos(t)/3 = 0",
        "r - 1",
        "r stands only on the left of a Fourier radius `r = …`",
    ),
    (
        "r = 2 + cos t / 2",
        "t / 2",
        "its argument stands in parentheses, as in cos(3*t)",
    ),
    (
        "r = 2 + sin^-1(t)",
        "^-1",
        "its argument stands in parentheses",
    ),
    ("r = pi + cos(t)", "pi", "write a fraction or a decimal"),
    ("r^(1/2) = 1 + cos(t)", "(1/2)", "as r^2"),
    (
        "theta = pi/4",
        "theta",
        "belongs to a Fourier radius `r = …`",
    ),
    (
        "(cos(2*pi*t), sin(2*pi*t))",
        "t)",
        "where every angle has the factor pi leave it out",
    ),
    // Roots, and what is no polynomial.
    ("y = sqrt(1 - x^2)", "sqrt", "square both sides"),
    ("r = sqrt(cos(2t))", "sqrt", "as in y^2 = 1 - x^2"),
    (
        "x = sqrt(2)*y",
        "sqrt",
        "write a fraction or a decimal, or square both sides",
    ),
    (
        "r = 1 + √2",
        "√",
        "only the square root of the square of a rational number",
    ),
    (
        "x^(2/3) + y^(2/3) = 1",
        "(2/3)",
        "raise both sides to a power",
    ),
    ("x^1.5 + y = 1", "1.5", "raise both sides to a power"),
    (
        "x^pi + y = 1",
        "pi",
        "an exponent and the arguments of Rational are constants",
    ),
    (
        "y = 2^x",
        "x",
        "an exponent and the arguments of Rational are constants",
    ),
    (
        "x^y = 1",
        "y",
        "an exponent and the arguments of Rational are constants",
    ),
    (
        "y = sin(x)",
        "x)",
        "given by a parameter, as in `x = cos(t); y = sin(2*t)`",
    ),
    ("y = x + t", "x + t", "given by a parameter"),
    (
        "y = exp(x)",
        "exp",
        "cos, sin, tan, cot, sec and csc are understood",
    ),
    (
        "y = ln(x)",
        "ln",
        "cos, sin, tan, cot, sec and csc are understood",
    ),
    ("|x| + |y| = 1", "|x|", "a superquadric has them"),
    (
        "x = t*cos(t); y = sin(t)",
        "t*cos",
        "satisfy no polynomial equation",
    ),
    // Ranges, inequalities, and other things beside a formula.
    (
        "x^2 + y^2 < 1",
        "< 1",
        "a curve or surface is the boundary, with `=`",
    ),
    (
        "x^2 + y^2 ≤ 1",
        "≤",
        "a curve or surface is the boundary, with `=`",
    ),
    (
        "y >= x^2",
        ">=",
        "a curve or surface is the boundary, with `=`",
    ),
    (
        "x = cos(t), y = sin(t), t = 0..2*Pi",
        ", t = 0",
        "a range of the parameter is left out",
    ),
    (
        "[cos(t), sin(t), t=0..2*Pi]",
        ", sin",
        "a range of the parameter is left out",
    ),
    (
        "(cos(t), sin(t)), (t, 0, 2*pi)",
        ", sin",
        "a range of the parameter is left out",
    ),
    (
        "x = cos(t); y = sin(t); t in [0, 1]",
        "in",
        "unknown function `in`",
    ),
    (
        "r=1+0.3cos(3θ){0<θ<2π}",
        "<θ",
        "a range of the parameter is left out",
    ),
    (
        "{x -> Cos[t], y -> Sin[t]}",
        ">",
        "belongs to a range or an inequality",
    ),
    (
        "x^2 + y^2 == 1 && z == y^5",
        "&&",
        "separated by `;` or a new line",
    ),
    (
        "x = cos(t) y = sin(t)",
        "= sin",
        "separated by `;` or a new line",
    ),
    ("x + 1,5y = 1", ",5y", "decimals are written with a point"),
    (
        "r = 1 + 0,3 cos(3t)",
        ",3",
        "decimals are written with a point",
    ),
    (
        r"\frac{x^2}{4} + y^2 = 1",
        r"\frac",
        r"write \frac{a}{b} as (a)/(b)",
    ),
    (r"r = 1 + \cos\theta", r"\cos", r"\cos\theta as cos(theta)"),
    ("$x^2 + y^2 = 1$", "$", "this is LaTeX, which is not read"),
    ("x^2 + 'y' = 1", "'y'", "it is written without quotes"),
    ("x\u{1}^2 = y", "\u{1}", "unexpected character: U+0001"),
    ("x⁻¹ = y", "⁻", "write ^(-1), or divide"),
    ("x_1^2 + x_2^2 = 1", "_1", "unexpected character: `_`"),
    ("2½x = y", "½", "unexpected character: `½`"),
    // The number of coordinates and equations.
    (
        "(t, t^2, t^3, t^4)",
        "t^4",
        "two coordinates in the plane or three in space",
    ),
    ("x = t^2", "x", "`y = …` is missing"),
    ("y = t", "y", "`x = …` is missing"),
    ("x = cos(t); x = sin(t)", "x = sin", "a second `x = …`"),
    ("x = u; y = v", "v", "a second parameter"),
    ("x = u; y = v; z = s + u", "s", "a third parameter"),
    ("x = 1; y = 2", "x", "this is a point"),
    ("(1, 2)", "(", "this is a point"),
    ("(1, 2, 3)", "(", "this is a point"),
    ("x^2 + y^2 = 1; x = y", "x = y", "plot takes several forms"),
    ("r = 1; r = 2", "r = 2", "plot takes several forms"),
    (
        "# center: 1, 2\nx = t; y = t^2",
        " 1, 2",
        "a center belongs to",
    ),
    (
        "# center: 1\nr = 1",
        " 1",
        "expected a center such as `1/2, -3`",
    ),
    // Constants.
    ("0 = 0", "0", "every point satisfies it"),
    ("7", "7", "no point satisfies it"),
    ("x - x", "x", "every point satisfies it"),
    ("x/(y - y) = 1", "(y - y)", "division by zero"),
    ("r = 1/0", "0", "division by zero"),
    ("r = 1/(cos(t) - cos(t))", "(cos", "division by zero"),
    ("", "", "there is no equation"),
    ("# only a comment", "", "there is no equation"),
    // Superquadrics.
    ("superquadric a=1,2 e=1/2", "a", "expected `2d` or `3d`"),
    ("superquadric 2d a=1 e=1/2", "1 e", "expected two numbers"),
    ("superquadric 2d e=1/2", "", "missing"),
    ("superquadric 2d a=1,-2 e=1/2", "-2", "the semi-axes"),
];

#[test]
fn one_message_points_at_the_place_and_names_the_fix() {
    assert!(MISTAKES.len() >= 100);
    for (typed, at, part) in MISTAKES {
        let (message, rest) = refusal(typed, read_text(typed, "<form>", Numbers::Exact));
        assert!(message.contains(part), "{typed}: {message}");
        let [rest, at] = [&*rest, at].map(|text| text.trim_start_matches('('));
        assert!(rest.starts_with(at), "{typed}: points at {rest}");
        assert!(!message.contains('\n'), "{typed}: {message}");
    }
}

/// Documents that are none, or are cut off.
#[test]
fn a_document_that_is_none_is_said_to_be_none() {
    for (text, part) in [
        (
            "{\"type\": \"Polygon\", \"coordinates\": []}",
            "this is JSON, but no document of stellate",
        ),
        ("{}", "this is JSON, but no document of stellate"),
        (
            "{\"schema\": \"stellate/1\", \"kind\": \"four",
            "so it was cut off",
        ),
        ("{", "so it was cut off"),
        (
            "{\"schema\": \"stellate/1\", \"kind\": \"description\"}",
            "the kinds of forms are \"fourier\"",
        ),
        (
            "{\"schema\": \"stellate/2\", \"kind\": \"fourier\"}",
            "expected \"stellate/1\"",
        ),
    ] {
        let error = read_text(text, "f.json", Numbers::Exact)
            .unwrap_err()
            .to_string();
        assert!(
            error.starts_with("f.json") && error.contains(part),
            "{text}: {error}"
        );
    }
}
