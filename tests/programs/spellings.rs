//! Formulas as people type them who come from Maple, Mathematica, MATLAB, Sage, SymPy, Desmos, GeoGebra, NumPy or a document.

#![expect(clippy::unwrap_used, reason = "a test fails by panicking")]

use stellate::document::{Format, write_form};
use stellate::language::Numbers;
use stellate::reading::read_text;
use stellate::shape::Form;
use stellate::verb::{self, Given, ImplicitizeOptions, Work};

/// What is typed, and what is meant.
const SPELLINGS: &[(&str, &str)] = &[
    ("(x**2 + y**2 - 1)", "x^2 + y^2 = 1"),
    ("x^2+y^2-1=0", "x^2 + y^2 = 1"),
    ("0 = x^2 + y^2 - 1", "x^2 + y^2 = 1"),
    ("f(x,y) = 0 = x^2+y^2-1", "x^2 + y^2 = 1"),
    ("x^{10} + y^{10} = 1", "x^10+y^10=1"),
    ("x²/4 + y² = 1", "x^2/4+y^2=1"),
    ("x¹⁰ + y¹⁰ = 1", "x^10+y^10=1"),
    ("3×x + y = 1", "3x+y=1"),
    ("x÷2 + y = 1", "x/2+y=1"),
    ("2⋅x + y² = 1", "2x+y^2=1"),
    ("2∗x + y² = 1", "2x+y^2=1"),
    ("x² – y² = 1", "x^2-y^2=1"),
    ("½x² + y² = 1", "1/2x^2+y^2=1"),
    ("y = ⅓ x³", "y = 1/3 x^3"),
    ("ｘ＾２＋ｙ＾２＝１", "x^2 + y^2 = 1"),
    ("（cos(t)，sin(t)）", "x = cos(t); y = sin(t)"),
    ("1⁄2 x + y = 1", "1/2 x+y=1"),
    ("“x^2 + y^2 = 1”", "x^2 + y^2 = 1"),
    ("\"x^2 + y^2 = 1\"", "x^2 + y^2 = 1"),
    ("`x^2 + y^2 = 1`", "x^2 + y^2 = 1"),
    ("x² + y² = 1", "x^2 + y^2 = 1"),
    ("x² + y² = 1", "x^2 + y^2 = 1"),
    ("x^2\u{200b} + y^2 = 1", "x^2 + y^2 = 1"),
    ("𝑥² + 𝑦² = 1", "x^2 + y^2 = 1"),
    ("r = 1 + 0.3cos(3φ)", "r=1+0.3cos(3t)"),
    ("r = 1 + 0.3cos(3ϕ)", "r=1+0.3cos(3t)"),
    ("r = 1 + 0.3cos(3ϑ)", "r=1+0.3cos(3t)"),
    ("r = 1 + 0.3*cos(3*phi)", "r=1+0.3cos(3t)"),
    ("r = 1 + 0.3*cos(3*varphi)", "r=1+0.3cos(3t)"),
    ("r=1+0.3cos(3θ)", "r=1+0.3cos(3t)"),
    ("r(t)=1+0.3cos(3t)", "r=1+0.3cos(3t)"),
    ("r(phi) = 1 + cos(phi)/3", "r=1+cos(t)/3"),
    ("1 + 0.3*cos(3*t)", "r=1+0.3cos(3t)"),
    ("1+cos(theta)/5", "r=1+cos(t)/5"),
    ("r = 2 + sin(t)**2", "r=2+sin(t)^2"),
    ("r = 2 + sin^2 t", "r=2+sin(t)^2"),
    ("r = 2 + sin²t", "r=2+sin(t)^2"),
    ("r = 2 + sin2t", "r=2+sin(2t)"),
    ("r = 2 + cos3θ", "r=2+cos(3t)"),
    ("x = cos(t)sin(t), y = sin(t)", "x=cos(t)*sin(t); y=sin(t)"),
    ("(cos t sin t, sin t)", "x=cos(t)*sin(t); y=sin(t)"),
    (
        "(2 cos t - cos 2t, 2 sin t - sin 2t)",
        "x=2cos(t)-cos(2t); y=2sin(t)-sin(2t)",
    ),
    ("r = 2 + cos(t)^2*sin(t)", "r=2+(cos(t))^2*sin(t)"),
    ("{Cos[t], Sin[t]}", "x = cos(t); y = sin(t)"),
    ("{Cos[t]^3, Sin[t]^3}", "x=cos(t)^3; y=sin(t)^3"),
    ("x^2 + 2 x y + y^2 == 1 + 3 x", "x^2+2x*y+y^2=1+3x"),
    ("f[x_, y_] := x^2 + y^2 - 1", "x^2 + y^2 = 1"),
    ("f := (x,y) -> x^2 + y^2 - 1", "x^2 + y^2 = 1"),
    ("x^2 + y^2 = 1:", "x^2 + y^2 = 1"),
    ("{x = cos(t), y = sin(t)}", "x = cos(t); y = sin(t)"),
    ("lambda x, y: x**2 + y**2 - 1", "x^2 + y^2 = 1"),
    ("@(x,y) x.^2 + y.^2 - 1", "x^2 + y^2 = 1"),
    ("@(x,y) 2.*x.^2 + x.*y - 1", "2x^2+x*y=1"),
    ("x^2 + y^2 - 1 % the circle", "x^2 + y^2 = 1"),
    ("x**2 + y**2 - 1  # the circle", "x^2 + y^2 = 1"),
    ("x^2 + y^2 - 1 // the circle", "x^2 + y^2 = 1"),
    ("y = 3x // 2", "y = 3x/2"),
    ("y = (3 + x^2) // x", "y = (3 + x^2)/x"),
    ("x = np.cos(t); y = np.sin(t)", "x = cos(t); y = sin(t)"),
    ("x = math.cos(t); y = math.sin(t)", "x = cos(t); y = sin(t)"),
    ("r = 1 + np.cos(3*t)/5", "r=1+cos(3t)/5"),
    ("Rational(1,3)*x**2 + y**2 - 1", "1/3x^2+y^2=1"),
    ("Eq(x**2/4 + y**2, 1)", "x^2/4+y^2=1"),
    ("(cos(t), sin(t))", "x = cos(t); y = sin(t)"),
    ("pow(x,2) + pow(y,2) - 1", "x^2 + y^2 = 1"),
    ("Fraction(1,3)*x**2 + y**2 - 1", "1/3x^2+y^2=1"),
    ("1//3*x^2 + y^2 = 1", "1/3x^2+y^2=1"),
    ("x*x + y*y = 1", "x^2 + y^2 = 1"),
    ("x x + y y = 1", "x^2 + y^2 = 1"),
    ("x^2 + xy + y^2 = 1", "x^2+x*y+y^2=1"),
    ("x^2 + 2xy = 1", "x^2+2*x*y=1"),
    ("xx + yy = 1", "x^2 + y^2 = 1"),
    ("xyz = 1", "x*y*z=1"),
    ("3(x+1)(y-2) = 1", "3*(x+1)*(y-2)=1"),
    ("(x+1)²(y-2) = 1", "(x+1)^2*(y-2)=1"),
    ("x(x+1) + y^2 = 1", "x*(x+1)+y^2=1"),
    ("y(x^2+1) = 1", "y*(x^2+1)=1"),
    ("x(1-y)^2 = 1", "x*(1-y)^2=1"),
    ("y²=x³-x", "y^2=x^3-x"),
    ("-x^2 + y = 0", "y = x^2"),
    ("x + 1/x = y", "x^2 + 1 = x*y"),
    ("y = 1/x", "x*y = 1"),
    ("y = 1/(1+x^2)", "y*(1+x^2)=1"),
    ("f(x) = x^2 - 2x", "y = x^2-2x"),
    ("X^2 + Y^2 = 1", "x^2 + y^2 = 1"),
    ("x = cos(T), y = sin(T)", "x = cos(t); y = sin(t)"),
    ("x = COS(t), y = SIN(t)", "x = cos(t); y = sin(t)"),
    ("1.5e0*x^2 + y^2 = 1", "1.5x^2+y^2=1"),
    ("r = 1 + 1E-1*cos(t)", "r=1+0.1cos(t)"),
    ("2.*x^2 + y^2 = 1.", "2x^2+y^2=1"),
    ("<cos t, sin t>", "x = cos(t); y = sin(t)"),
    ("⟨cos t, sin t⟩", "x = cos(t); y = sin(t)"),
    ("[cos(t); sin(t)]", "x = cos(t); y = sin(t)"),
    ("(x, y) = (cos(t), sin(t))", "x = cos(t); y = sin(t)"),
    ("c(t) = (cos(t), sin(t))", "x = cos(t); y = sin(t)"),
    ("r(t) = (cos(t), sin(t))", "x = cos(t); y = sin(t)"),
    ("r(t) = <cos t, sin t>", "x = cos(t); y = sin(t)"),
    ("x^2 + y^2 = sqrt(4)", "x^2+y^2=2"),
    ("r = 2 + cos(3t + pi/2)", "r=2-sin(3t)"),
    ("r = 2 + cos(t - pi)", "r=2-cos(t)"),
    ("r = 2 + cos(pi)*cos(t)", "r=2-cos(t)"),
    ("r = 2 + cos(-3t)", "r=2+cos(3t)"),
    ("r = 2 + sin(t*2)", "r=2+sin(2t)"),
    ("r = 2 + cos((2+1)t)", "r=2+cos(3t)"),
    ("r = csc(t)", "y = 1"),
    ("(sec t, tan t)", "x^2-y^2=1"),
    ("(s^2, s^3)", "x=t^2;y=t^3"),
    ("x = cos(u), y = sin(u)", "x = cos(t); y = sin(t)"),
    ("(cos φ, sin φ)", "x = cos(t); y = sin(t)"),
    ("(1 + 2t, 3 - t)", "x=1+2t;y=3-t"),
    ("(cos θ sin φ, sin θ sin φ, cos φ)", "x^2+y^2+z^2=1"),
    ("(cos U sin V, sin U sin V, cos V)", "x^2+y^2+z^2=1"),
    ("z = x^2 + y^2", "x^2+y^2-z=0"),
    ("f(x,y) = x^2 - y^2", "x^2-y^2=0"),
    (
        "superquadric 2D a = 1, 2 e = 1/2",
        "superquadric 2d a=1,2 e=1/2",
    ),
    ("x^2 + y^2 = 2x + 3", "x^2+y^2-2x=3"),
    ("(x^2 - y^2)/(x^2 + y^2) = 1/2", "2(x^2-y^2)=x^2+y^2"),
    ("x^2 - -y^2 = 1", "x^2 + y^2 = 1"),
    ("+x^2 + y^2 = 1", "x^2 + y^2 = 1"),
    ("x^2y = 1", "x^2*y=1"),
    ("x^2^2 + y = 1", "x^4+y=1"),
    ("1/2x + y = 1", "(1/2)*x+y=1"),
    ("1/2(x+y) = 1", "(1/2)*(x+y)=1"),
    ("x/2y = 1", "x*y/2=1"),
    ("(x-1)²+(y+2)²=3²", "(x-1)^2+(y+2)^2=9"),
    ("x^2 + y^2 = 1, z = y^5", "x^2 + y^2 = 1; z = y^5"),
    ("{x^2 + y^2 = 1, z = y^5}", "x^2 + y^2 = 1; z = y^5"),
    ("[x^2 + y^2 == 1, z == y^5]", "x^2 + y^2 = 1; z = y^5"),
    ("(x^2 + y^2 - 1, z - y^5)", "x^2 + y^2 = 1; z = y^5"),
    ("(x^2+y^2-1)(x-y) = 0", "(x^2+y^2-1)*(x-y)=0"),
    ("r = 2 sin(5θ)", "r = 2*sin(5t)"),
    ("r² = 4cos(2θ)", "r^2=4cos(2t)"),
    ("r**2 = cos(2*theta)", "r^2=cos(2t)"),
    ("1 + cos(t)/3 = r", "r=1+cos(t)/3"),
    ("cos(t) = x; sin(t) = y", "x = cos(t); y = sin(t)"),
    ("y = sin(t); x = cos(t)", "x = cos(t); y = sin(t)"),
    ("f(t) = (t^2, t^3)", "x=t^2;y=t^3"),
    ("γ(t) = (t^2, t^3)", "x=t^2;y=t^3"),
    ("X(t) = t^2, Y(t) = t^3", "x=t^2;y=t^3"),
    ("x = t^2; y = t^3;", "x=t^2;y=t^3"),
    ("x = t^2;; y = t^3", "x=t^2;y=t^3"),
    ("x = t^2, y = t^3,", "x=t^2;y=t^3"),
    ("2∙x + y = 1", "2x+y=1"),
    ("xˆ2 + yˆ2 = 1", "x^2 + y^2 = 1"),
    ("x^{2}+y^{2}-1=0", "x^2 + y^2 = 1"),
    ("r = 1 + cos(3𝜃)/5", "r=1+cos(3t)/5"),
    ("y(x) = x^2", "y = x^2"),
    ("y(x) = x^3 - x", "y = x^3 - x"),
    ("x(y) = y^2", "x = y^2"),
    ("z(x,y) = x^2 + y^2", "z = x^2 + y^2"),
    ("(x^2+y^2-1, z)", "x^2 + y^2 = 1; z = 0"),
    ("[x^2 + y^2 + z^2 - 1, x + y + z]", "x^2+y^2+z^2=1; x+y+z=0"),
    ("f(x,y,z) = x^2+y^2-1", "x^2 + y^2 - 1 + 0z"),
    ("r = 2+sin3tcos2t", "r=2+sin(3t)*cos(2t)"),
    ("r=2+cost", "r=2+cos(t)"),
    ("{x}^{2} = y", "y=x^2"),
    ("Superquadric 2d a=1,2 e=1/2", "superquadric 2d a=1,2 e=1/2"),
];

/// The equations of a form as text, or the form where it has none.
fn equations(text: &str) -> String {
    let form = read_text(text, "<form>", Numbers::Exact).unwrap_or_else(|error| panic!("{error}"));
    let found = match form {
        shape @ (Form::Superquadric(_) | Form::SpaceSuperquadric(_)) => shape,
        form => {
            let options = ImplicitizeOptions::default();
            let found = verb::implicitize(Given::from(form), &options, &Work::default());
            found.unwrap_or_else(|error| panic!("{text}: {error}")).form
        }
    };
    let mut written = Vec::new();
    write_form(&found, &[], Format::Text, &mut written).unwrap();
    String::from_utf8(written).unwrap()
}

#[test]
fn what_people_type_is_read_as_meant() {
    for (typed, meant) in SPELLINGS {
        assert_eq!(equations(typed), equations(meant), "{typed}");
    }
}

/// A divisor leaves nothing behind where it is 0: neither a line nor a point of its own.
#[test]
fn factors_that_cancel_leave_no_component() {
    for (typed, meant) in [
        ("(x^2 - y^2)/(x - y) = 1", "x + y = 1"),
        ("(x^2 - 1)/(x - 1) = y", "y = x + 1"),
        ("y/x = x*y/x^2 + x - 1", "x - 1"),
        ("x/(x^2 + y^2) = 1", "x^2 + y^2 = x"),
        ("1/x + 1/y = 1", "x + y = x*y"),
        ("x^-2 + y = 0", "1 + x^2*y"),
        ("1/(1 + 1/x) = y", "x = y*(x + 1)"),
        ("z = 1/(x*y)", "x*y*z = 1"),
    ] {
        assert_eq!(equations(typed), equations(meant), "{typed}");
    }
}
