"""Numbers are taken exactly, or they are refused: floats of every kind, long integers, and coordinates that are no doubles."""

import sys
from decimal import Decimal
from fractions import Fraction

import numpy as np
import pytest

import stellate
from stellate._numbers import digits, exact, value, whole

LONG = 10**5000 + 7
TENTH = Fraction(0.1)


def test_floats_of_sympy_are_taken_bit_for_bit():
    sympy = pytest.importorskip("sympy")
    x, y, t, theta = sympy.symbols("x y t theta")
    assert stellate.form(x**2 + y**2 - 1 / 3).terms[0, 0] == -Fraction(1 / 3)
    assert stellate.form(1 + 0.1 * sympy.cos(theta)).cos == [1, TENTH]
    assert stellate.from_series([sympy.Float(0.1), sympy.Rational(1, 3)]).cos == [TENTH, Fraction(1, 3)]
    curve = stellate.form(sympy.Tuple(0.1 * sympy.cos(t), sympy.sin(t)))
    assert curve == stellate.form(f"x = {TENTH}*cos(t); y = sin(t)")
    # Forty digits are more than a double has, and exponents and products keep their meaning.
    precise = sympy.Float("0.1", 40)
    found = stellate.form(precise * x**2 - sympy.Rational(2, 3) * x * y / 7 + 0.5).terms
    ratio = sympy.Rational(precise)
    assert found == {(2, 0): Fraction(int(ratio.p), int(ratio.q)), (1, 1): Fraction(-2, 21), (0, 0): Fraction(1, 2)}
    assert found[2, 0] != TENTH
    assert stellate.form(sympy.Eq(x**2, 0.1 * y)).terms[0, 1] == -TENTH
    assert stellate.form(sympy.Poly(x**2 + 0.1 * y)).terms[0, 1] == TENTH


def test_numbers_of_numpy_are_taken_exactly():
    long_double = np.longdouble("0.1")
    for number in (0.1, np.float64(0.1), np.array(0.1), np.float32(0.1), long_double, np.array(long_double)):
        above, below = np.asarray(number)[()].as_integer_ratio()
        assert stellate.from_series([number]).cos == [Fraction(above, below)]
    assert stellate.from_series([Decimal("0.1"), np.array(3), True, "0.1"]).cos == [Fraction(1, 10), 3, 1, Fraction(1, 10)]
    for tolerance in (0.1, np.array(0.1)):
        # The point is on the circle about the origin with the double as radius, not with a tenth.
        assert stellate.inspect("x = 0", [[0.1, 0]], tolerance).verdict.tolist() == ["inside"]
    limits = stellate.inspect("r = 5", [[3.6, 4.8]], np.array([-0.5, 1.5]))
    assert limits.verdict.tolist() == ["inside"]
    for number in (np.nan, np.inf, np.array(np.nan), np.longdouble("inf"), Decimal("nan")):
        with pytest.raises(stellate.InputError, match="is not a number"):
            stellate.from_series([number])


@pytest.mark.parametrize("number", [0, 7, 10**599, 10**600 - 1, 2**2000, LONG, 3**20000], ids=int.bit_length)
def test_texts_of_long_numbers(number):
    assert whole(digits(number)) == number and whole(digits(-number)) == -number
    assert value(exact(number).removesuffix("p0")) == number
    if number.bit_length() < 10_000:
        assert digits(number) == str(number)


@pytest.mark.skipif(not hasattr(sys, "get_int_max_str_digits"), reason="this Python has no limit")
def test_long_numbers_need_no_setting_of_python():
    assert 0 < sys.get_int_max_str_digits() < 5000
    pairs = [
        (stellate.form({(1, 0): LONG, (0, 0): 1}), stellate.form({(1, 0): 2 * LONG, (0, 0): 2})),
        (stellate.from_series([LONG, Fraction(1, LONG)]), stellate.from_series([LONG, Fraction(1, LONG)], [0])),
    ]
    for one, other in pairs:
        assert one == other and hash(one) == hash(other)
        assert len(one.latex()) > 5000
    assert pairs[0][0].terms == {(1, 0): LONG, (0, 0): 1}
    assert pairs[1][0].cos == [LONG, Fraction(1, LONG)]
    with pytest.raises(stellate.InputError, match=r"sin\[0\]"):
        stellate.from_series([1], [LONG])


def test_long_numbers_in_sympy():
    sympy = pytest.importorskip("sympy")
    x, y, t = sympy.symbols("x y t")
    line = stellate.form({(1, 0): LONG, (0, 1): Fraction(1, LONG), (0, 0): 1})
    assert line.sympy() == LONG * x + y / LONG + 1
    assert stellate.form(line.sympy()) == line
    assert stellate.form(f"x = {digits(LONG)}*t; y = t").sympy() == sympy.Tuple(LONG * t, t)
    shape = stellate.form(f"superquadric 2d a={digits(LONG)},2 e=1")
    assert digits(LONG**2) in shape.latex() and shape.sympy().subs({x: LONG, y: 0}) == 0


def test_coordinates_that_are_no_doubles_are_refused():
    line = stellate.form("x = 9007199254740993")
    large = 2**53 + 1
    long_double = np.longdouble("0.1")
    wrong = [
        [[large, 0]],
        np.array([[large, 0]]),
        np.array([[2**64 - 1, 0]], np.uint64),
        [[0.5, large]],
        [[Fraction(1, 3), 0]],
        [[Decimal("0.1"), 0]],
        [[10**400, 0]],
        [[LONG, 0]],
        [[Fraction(1, LONG), 0]],
    ]
    if long_double != np.float64(long_double):
        wrong.append(np.array([[long_double, 0]]))
    for points in wrong:
        with pytest.raises(stellate.InputError, match="would be rounded"):
            line.sign(points)
    for points in ([["0.1", "0"]], [[1j, 0]]):
        with pytest.raises(stellate.InputError, match="numbers are expected"):
            line.sign(points)
    right = [[[2**53, 0]], np.array([[2**60, 0]]), [[Fraction(1, 2), 0]], np.array([[np.longdouble(0.1), 0]]), [[0.5, 2**53]]]
    assert [int(line.sign(points)[0]) for points in right] == [-1, 1, -1, -1, -1]
    pyarrow = pytest.importorskip("pyarrow")
    for x in (large, Decimal("0.1")):
        table = pyarrow.table({"x": [x], "y": [0.0]})
        with pytest.raises(stellate.InputError, match="column 'x'.*would be rounded"):
            line.sign(table)
    assert line.sign(pyarrow.table({"x": [Decimal("0.5")], "y": [2**53]})).tolist() == [-1]


def test_masked_points_are_missing():
    masked = np.ma.masked_array([[1.0, 0.0], [0.0, 0.0], [1.0, 0.0]], mask=[[0, 1], [0, 0], [0, 0]])
    for points in (masked, masked.astype(np.int64), list(masked), [[1.0, None], [0.0, 0.0], [1.0, 0.0]]):
        found = stellate.inspect("r = 1", points, "1/10", skip_bad=True)
        assert found.row.tolist() == [1, 2] and found.verdict.tolist() == ["outside", "inside"]
        with pytest.raises(stellate.InputError, match="row 0"):
            stellate.form("r = 1").sign(points)
    with pytest.raises(stellate.InputError):
        stellate.from_points(masked).degree
    # The array of the user is not changed.
    assert masked.data.tolist() == [[1.0, 0.0], [0.0, 0.0], [1.0, 0.0]]
