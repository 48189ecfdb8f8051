"""Forms: equality, formulas and radii of every kind."""

import pickle
from fractions import Fraction

import numpy as np
import pytest

import stellate

KINDS = {
    "r = 1 + cos(t)/3": "fourier",
    "x^2 + y^2 = 1/4": "implicit",
    "x^2 + y^2 + z^2 = 1": "implicit",
    "x = cos(t); y = sin(2*t)": "parametric",
    "x = u; y = v; z = u*v": "parametric",
    "r = cos(2t/3)": "parametric",
    "R = 1 + Y(3,2)/5": "spherical",
    "superquadric 2d a=1,2 e=1/2": "superquadric",
    "superquadric 3d a=1,2,3 e=1/2,1": "superquadric",
    "x^2 + y^2 = 1; z = y^5": "intersection",
}


@pytest.mark.parametrize("text", KINDS)
def test_every_kind_has_formulas_and_comes_back(text):
    sympy = pytest.importorskip("sympy")
    form = stellate.form(text)
    assert form.kind == KINDS[text]
    assert isinstance(form.sympy(), sympy.Basic)
    assert "=" in form.latex()
    again = pickle.loads(pickle.dumps(form))
    assert again == form and hash(again) == hash(form)
    assert stellate.form(form.to_json()) == form
    assert form._repr_latex_()
    others = [stellate.form(other) for other in KINDS if other != text]
    assert all(form != other for other in others)


def test_formulas_are_those_of_the_form():
    sympy = pytest.importorskip("sympy")
    x, y, z = sympy.symbols("x y z")
    t, theta, phi = sympy.symbols("t theta phi")
    assert stellate.form("r = 1 + cos(t)/3").sympy() == 1 + sympy.cos(theta) / 3
    assert stellate.form("x = cos(t); y = sin(2*t)").sympy() == sympy.Tuple(sympy.cos(t), sympy.sin(2 * t))
    assert stellate.form("x^2 + y^2 = 1; z = y^5").sympy() == sympy.Tuple(x**2 + y**2 - 1, z - y**5)
    surface = stellate.form("R = 1 + Y(3,2)/5").sympy()
    # P_3^2(c) = 15 c (1 − c²), without the phase.
    expected = 1 + 3 * sympy.cos(phi) * sympy.sin(phi) ** 2 * sympy.cos(2 * theta)
    at = {theta: sympy.Rational(3, 7), phi: sympy.Rational(5, 4)}
    assert abs(float((surface - expected).subs(at).evalf(30))) < 1e-25
    # Expressions of SymPy are forms.
    assert stellate.form(x**2 + y**2 / 4 - 1).terms == {(2, 0): 1, (0, 2): Fraction(1, 4), (0, 0): -1}
    shape = stellate.form("superquadric 3d a=1,2,3 e=1/2,1").sympy()
    assert shape.subs({x: 0, y: 2, z: 0}) == 0 and shape.subs({x: 0, y: 0, z: 3}) == 0


def test_equations_are_equal_up_to_a_factor():
    one = stellate.form("x^2 + y^2 = 1/4")
    for same in ("4x^2 + 4y^2 = 1", "1/4 = x^2 + y^2", "-8x^2 - 8y^2 + 2 = 0"):
        other = stellate.form(same)
        assert one == other and hash(one) == hash(other)
    assert one != stellate.form("x^2 + y^2 + 0*z = 1/4")
    assert one != stellate.form("(x^2 + y^2 - 1/4)^2 = 0")
    assert stellate.form("r = 1 + 0*cos(t)") == stellate.form("r = 1")
    assert len({one, stellate.form("4x^2 + 4y^2 = 1"), stellate.form("r = 1/2")}) == 2
    # The center of a fit belongs to a form, and its errors do not.
    points = [[3 + np.cos(a), np.sin(a)] for a in np.linspace(0, 6.2, 60)]
    fit = stellate.fit(points, 3).form
    again = stellate.from_series(fit.cos, fit.sin)
    assert fit.center is not None and fit != again and fit.cos == again.cos


def test_a_sine_of_order_0_is_refused():
    assert stellate.from_series([1], [0]).cos == [1]
    with pytest.raises(stellate.InputError, match=r"sin\[0\]"):
        stellate.from_series([1, 2], [1, 1])
    with pytest.raises(stellate.InputError, match="kind implicit"):
        stellate.form("x^2 + y^2 = 1").cos


def test_radii_of_every_kind():
    theta = np.linspace(0, 6, 24).reshape(4, 6)
    assert np.allclose(stellate.form("r = 2 + cos(3*t)/5").radius(theta), 2 + np.cos(3 * theta) / 5, atol=1e-15)
    assert np.allclose(stellate.form("x^2 + y^2 = 4").radius(theta), 2, atol=0)
    ellipse = stellate.form("superquadric 2d a=1,2 e=1").radius(theta)
    expected = 1 / np.sqrt(np.cos(theta) ** 2 + np.sin(theta) ** 2 / 4)
    assert np.allclose(ellipse, expected, rtol=1e-15)
    # Of two circles the outer one counts, and to the left there is none.
    two = stellate.form("(x^2 + y^2 - 2x)*(x^2 + y^2 - 3x) = 0")
    assert two.radius(0.0) == 3 and np.isnan(two.radius(np.pi))
    phi = np.linspace(0, 3, 5)
    surface = stellate.form("R = 2 + Y(1,0)/2")
    assert np.allclose(surface.radius(0.3, phi), 2 + np.cos(phi) / 2, atol=1e-15)
    ball = stellate.form("x^2 + y^2 + z^2 = 9")
    assert ball.radius(theta[:, :1], phi[np.newaxis]).tolist() == [[3.0] * 5] * 4
    with pytest.raises(stellate.InputError, match="theta alone"):
        two.radius(0.0, 1.0)
    with pytest.raises(stellate.InputError, match="phi"):
        ball.radius(0.0)
    with pytest.raises(stellate.InputError, match="implicitize"):
        stellate.form("x = t; y = t^2").radius(0.0)
    with pytest.raises(stellate.InputError, match="numbers of radians"):
        two.radius([np.nan])


def test_reading_options_belong_to_a_form(tmp_path):
    path = tmp_path / "C.sh"
    path.write_text("0 0 1 0\n1 0 0.1 0\n1 1 0 0\n")
    named = stellate.form(path, normalization="unnormalized")
    assert named.coefficients == {(0, 0): 1, (1, 0): Fraction(1, 10)}
    assert stellate.form(path).coefficients != named.coefficients
    assert stellate.implicitize(named) == stellate.implicitize("R = 1 + Y(1,0)/10")
    assert stellate.form("r = 1 + 0.1*cos(t)", numbers="f64").cos[1] == Fraction(0.1)
    with pytest.raises(TypeError, match="no option 'number'"):
        stellate.form("r = 1", number="f64")
    # A form that was read from a file is itself where it is unpickled.
    copy = pickle.dumps(named)
    path.unlink()
    assert pickle.loads(copy).coefficients == named.coefficients
