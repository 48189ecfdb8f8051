"""Forms: curves and surfaces, exactly."""

from __future__ import annotations

import json
from fractions import Fraction
from operator import index
from os import PathLike
from typing import TYPE_CHECKING, Any, Mapping, Sequence, Union

import numpy as np
import numpy.typing as npt

from . import _native
from ._columns import Doubles, Inspection, Number, call, exact, inspection, table, value

if TYPE_CHECKING:
    import sympy

FormLike = Union["Form", str, "PathLike[str]", Mapping[Any, Number]]


class Form:
    """A curve or surface: its text, a document, or the rows of an outline.

    Two forms are equal if their documents are. The exact numbers of a form are ``int`` or ``fractions.Fraction``.

    >>> import stellate
    >>> circle = stellate.form("x^2 + y^2 = 1/4")
    >>> circle.terms
    {(2, 0): 1, (0, 2): 1, (0, 0): Fraction(-1, 4)}
    """

    __slots__ = ("_document", "source")

    source: tuple[str, str | None]
    _document: dict[str, Any] | None

    def __init__(self, text: str, place: str | None = None) -> None:
        self.source = (text, place)
        self._document = None

    @property
    def document(self) -> dict[str, Any]:
        """The JSON document of the form, with exact numbers as texts."""
        if self._document is None:
            self._document = json.loads(call("form", [self.source]))
        return self._document

    def to_json(self) -> str:
        """The JSON document as a text, which every verb reads."""
        return json.dumps(self.document)

    @property
    def kind(self) -> str:
        """The kind of the document: implicit, fourier, parametric, spherical, …"""
        return str(self.document["kind"])

    def _implicit(self) -> dict[str, Any]:
        if self.kind != "implicit":
            raise _native.InputError(
                f"this form is of the kind {self.kind}; stellate.implicitize gives its equation"
            )
        return self.document

    @property
    def terms(self) -> dict[tuple[int, ...], int | Fraction]:
        """The terms of an equation: exponents and coefficients."""
        return {
            tuple(term["exponents"]): value(term["coefficient"])
            for term in self._implicit()["terms"]
        }

    @property
    def degree(self) -> int:
        """The total degree of an equation."""
        return int(self._implicit()["degree"])

    @property
    def parts(self) -> list[int]:
        """The degrees of the homogeneous parts of an equation, descending."""
        return [int(d) for d in self._implicit()["homogeneous_degrees"]]

    @property
    def cos(self) -> list[int | Fraction]:
        """The coefficients of the cosines of a Fourier radius, from 0 to N."""
        return [value(text) for text in self.document["cos"]]

    @property
    def sin(self) -> list[int | Fraction]:
        """The coefficients of the sines of a Fourier radius, from 0 to N."""
        return [value(text) for text in self.document["sin"]]

    def sympy(self) -> sympy.Expr:
        """The polynomial of an equation, or the radius of a Fourier form in the symbol theta, as a SymPy expression."""
        import sympy

        def rational(number: int | Fraction) -> sympy.Rational:
            return sympy.Rational(number.numerator, number.denominator)

        if self.kind == "fourier":
            theta = sympy.Symbol("theta")
            waves = [
                rational(a) * sympy.cos(n * theta) + rational(b) * sympy.sin(n * theta)
                for n, (a, b) in enumerate(zip(self.cos, self.sin))
            ]
            return sympy.Add(*waves)
        symbols = sympy.symbols(self._implicit()["variables"])
        products = [
            sympy.Mul(rational(c), *(s**e for s, e in zip(symbols, exponents)))
            for exponents, c in self.terms.items()
        ]
        return sympy.Add(*products)

    def latex(self) -> str:
        """The form in LaTeX."""
        if self.kind == "fourier":
            names = [(r"\cos", self.cos), (r"\sin", self.sin)]
            parts = [
                (c, "" if n == 0 else rf" {name} {n if n > 1 else ''}\theta")
                for n in range(len(self.cos))
                for name, list_ in names
                if (c := list_[n])
            ]
            return "r = " + _sum(parts)
        variables = self._implicit()["variables"]
        parts = [
            (c, "".join(f" {v}" + (f"^{{{e}}}" if e > 1 else "") for v, e in zip(variables, key) if e))
            for key, c in self.terms.items()
        ]
        return _sum(parts) + " = 0"

    def _repr_latex_(self) -> str:
        return f"${self.latex()}$"

    def _repr_svg_(self) -> str:
        return call("plot", [self.source], format="svg").decode()

    def radius(self, theta: npt.ArrayLike) -> Doubles:
        """The radius r(θ) of a Fourier form at angles in radians, in doubles (approximate)."""
        angles = np.asarray(theta, dtype=np.float64)
        data = json.dumps(angles.ravel().tolist()).encode()
        found = json.loads(call("radius", [self.source], data))
        return np.asarray(found, dtype=np.float64).reshape(angles.shape)

    def _inspected(self, points: npt.ArrayLike) -> Inspection:
        data = table(points, ("x", "y", "z"))
        return inspection(call("inspect", [self.source], data, tolerance="1").decode())

    def sign(self, points: npt.ArrayLike) -> npt.NDArray[np.int8]:
        """The side of each point, exactly: −1 inside, 0 on the form, 1 outside. Open curves and space curves have no sides."""
        sign = self._inspected(points).sign
        if np.ma.is_masked(sign):
            raise _native.InputError(
                "a point has no side: this form is no closed curve or surface, or it is not decided"
            )
        return sign.filled()

    def distance(self, points: npt.ArrayLike) -> tuple[Doubles, Doubles]:
        """Certified lower and upper bounds of the distance of each point."""
        found = self._inspected(points)
        return found.distance_low, found.distance_high

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Form) and self._key() == other._key()

    def __hash__(self) -> int:
        return hash(self._key())

    def _key(self) -> str:
        document = self.document
        if document["kind"] == "contour":
            return repr(self.source)
        left_out = ("notes", "schema")
        return json.dumps({k: v for k, v in document.items() if k not in left_out}, sort_keys=True)

    def __reduce__(self) -> tuple[type[Form], tuple[str, str | None]]:
        return (Form, self.source)

    def __repr__(self) -> str:
        text, place = self.source
        return f"stellate.form({text!r})" if place is None else f"<stellate form from {place}>"


def _sum(parts: Sequence[tuple[int | Fraction, str]]) -> str:
    text = ""
    for c, factor in parts:
        size = abs(Fraction(c))
        number = str(size) if size.denominator == 1 else rf"\frac{{{size.numerator}}}{{{size.denominator}}}"
        if size == 1 and factor:
            number = ""
        sign = "-" if c < 0 else "+"
        text += f" {sign} {number}{factor}" if text else f"{'-' if c < 0 else ''}{number}{factor}"
    return text.replace("  ", " ").strip() or "0"


def form(given: FormLike) -> Form:
    """A form from a text, a path, or the terms of a polynomial.

    >>> import stellate
    >>> stellate.form({(4, 0): 1, (2, 0): -1, (0, 2): 1}).degree
    4
    """
    if isinstance(given, Form):
        return given
    if isinstance(given, Mapping):
        return from_terms(given)
    if isinstance(given, PathLike):
        return Form(str(given))
    if isinstance(given, str):
        return Form(given, "document") if given.lstrip().startswith("{") else Form(given)
    if type(given).__module__.startswith("sympy"):
        return Form(str(given))
    raise _native.InputError(f"a form is a text, a path or terms, not {type(given).__name__}")


def from_terms(terms: Mapping[Any, Number]) -> Form:
    """The curve or surface with these terms: exponents (i, j) or (i, j, k), and coefficients."""
    names = ("x", "y", "z")
    parts = []
    for exponents, c in terms.items():
        if len(exponents) not in (2, 3) or any(index(e) < 0 for e in exponents):
            raise _native.InputError(
                f"terms: exponents are two or three integers that are not negative, not {exponents}"
            )
        powers = [f"*{v}^{index(e)}" for v, e in zip(names, exponents) if e]
        parts.append(f"({_finite(c)})" + "".join(powers))
    if not parts:
        raise _native.InputError("terms: a polynomial has at least one term")
    three = any(len(key) == 3 for key in terms)
    return Form(" + ".join(parts) + (" + 0*z" if three else "") + " = 0")


def _finite(number: Number) -> str:
    """The text of a number that is not infinite and not NaN."""
    try:
        return exact(number)
    except (ValueError, OverflowError) as error:
        raise _native.InputError(f"{number} is not a number") from error


def from_series(cos: Sequence[Number], sin: Sequence[Number] | None = None) -> Form:
    """The Fourier radius ``r = cos[0] + Σ cos[n] cos nθ + sin[n] sin nθ``; ``sin[0]`` is not used.

    >>> import stellate
    >>> stellate.from_series([1, 0, "1/5"]).cos
    [1, 0, Fraction(1, 5)]
    """
    size = max(len(cos), len(sin or ()))
    if size == 0:
        raise _native.InputError("a series has at least the mean, cos[0]")
    padded = [[*map(_finite, list_ or ()), *["0"] * (size - len(list_ or ()))] for list_ in (cos, sin)]
    padded[1][0] = "0"
    document = {"schema": "stellate/1", "kind": "fourier", "cos": padded[0], "sin": padded[1]}
    return Form(json.dumps(document), "series")


def from_points(points: npt.ArrayLike) -> Form:
    """The outline with these vertices in order: an array of shape (n, 2)."""
    return Form(table(points, ("x", "y")).decode(), "points.csv")
