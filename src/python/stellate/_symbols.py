"""Forms as SymPy expressions and in LaTeX."""

from __future__ import annotations

import re
from fractions import Fraction
from typing import TYPE_CHECKING, Any, Protocol, Sequence

from ._call import Source, call
from ._native import InputError
from ._numbers import PART, digits, exact, fraction, value, whole

if TYPE_CHECKING:
    import sympy


class Written(Protocol):
    """What is needed of a form to write it."""

    @property
    def kind(self) -> str: ...
    @property
    def document(self) -> dict[str, Any]: ...
    @property
    def terms(self) -> dict[tuple[int, ...], int | Fraction]: ...
    @property
    def cos(self) -> list[int | Fraction]: ...
    @property
    def sin(self) -> list[int | Fraction]: ...
    @property
    def center(self) -> tuple[int | Fraction, ...] | None: ...
    def source(self) -> Source: ...


def to_sympy(form: Written) -> sympy.Basic:
    """The form as an expression, or as a tuple of expressions."""
    import sympy

    def rational(number: int | Fraction) -> sympy.Rational:
        return sympy.Rational(number.numerator, number.denominator)

    if form.kind == "implicit":
        symbols = sympy.symbols(form.document["variables"])
        products = [
            sympy.Mul(rational(c), *(s**e for s, e in zip(symbols, exponents)))
            for exponents, c in form.terms.items()
        ]
        return sympy.Add(*products)
    if form.kind == "superquadric":
        sizes = [abs(s) / rational(value(a)) for s, a in zip(sympy.symbols("x y z"), form.document["a"])]
        first, *rest = (2 / rational(value(e)) for e in form.document["e"])
        level = rational(value(form.document["level"]))
        if not rest:
            return sizes[0] ** first + sizes[1] ** first - level
        (second,) = rest
        return (sizes[0] ** second + sizes[1] ** second) ** (first / second) + sizes[2] ** first - level
    lines = [line.partition("#")[0].strip() for line in _written(form, "sympy")]
    # Python reads a long integer in hexadecimal digits only.
    lines = [re.sub(rf"\d{{{PART},}}", lambda found: hex(whole(found[0])), line) for line in lines]
    found = [sympy.Tuple(*e) if isinstance(e, tuple) else e for e in map(sympy.sympify, filter(None, lines))]
    return found[0] if len(found) == 1 else sympy.Tuple(*found)


def of_sympy(given: Any) -> str:
    """The text of an expression, with floats taken exactly, and of an equation."""
    import sympy
    from sympy.printing.str import StrPrinter

    class Exact(StrPrinter):  # type: ignore[misc]
        def _print_Integer(self, number: sympy.Integer) -> str:
            return exact(number)

        def _print_Rational(self, number: sympy.Rational) -> str:
            return exact(number)

    if isinstance(given, sympy.Eq):
        return f"{of_sympy(given.lhs)} = {of_sympy(given.rhs)}"
    if isinstance(given, sympy.Poly):
        given = given.as_expr()
    floats = {number: sympy.Rational(fraction(number)) for number in given.atoms(sympy.Float)}
    return str(Exact().doprint(given.xreplace(floats)))


def to_latex(form: Written) -> str:
    """The form in LaTeX, with its center."""
    origin = form.center or ()
    if not any(origin):
        return _latex(form)
    center = ", ".join(map(_number, origin))
    return rf"{_latex(form)} \quad \text{{with the origin at }} \left({center}\right)"


def _latex(form: Written) -> str:
    if form.kind == "fourier":
        names = [(r"\cos", form.cos), (r"\sin", form.sin)]
        parts = [
            (c, "" if n == 0 else rf" {name} {n if n > 1 else ''}\theta")
            for n in range(len(form.cos))
            for name, list_ in names
            if (c := list_[n])
        ]
        return "r = " + _sum(parts)
    if form.kind == "implicit":
        variables = form.document["variables"]
        parts = [
            (c, "".join(f" {v}" + (f"^{{{e}}}" if e > 1 else "") for v, e in zip(variables, key) if e))
            for key, c in form.terms.items()
        ]
        return _sum(parts) + " = 0"
    if form.kind == "superquadric":
        from sympy.printing.latex import LatexPrinter

        class Long(LatexPrinter):  # type: ignore[misc]
            def _print_Integer(self, number: sympy.Integer) -> str:
                return _number(int(number))

            def _print_Rational(self, number: sympy.Rational) -> str:
                return _number(Fraction(int(number.p), int(number.q)))

        return f"{Long().doprint(to_sympy(form))} = 0"
    lines = [line.partition("%")[0].strip().removesuffix(r"\\").strip() for line in _written(form, "latex")]
    return r" \\ ".join(line for line in lines if line)


def _written(form: Written, format: str) -> list[str]:
    if form.kind == "contour":
        raise InputError("a contour has no formula; stellate.fit gives a series for it")
    return call("form", [form.source()], format=format).decode().splitlines()


def _sum(parts: Sequence[tuple[int | Fraction, str]]) -> str:
    text = ""
    for c, factor in parts:
        number = "" if abs(c) == 1 and factor else _number(abs(Fraction(c)))
        sign = "-" if c < 0 else "+"
        text += f" {sign} {number}{factor}" if text else f"{'-' if c < 0 else ''}{number}{factor}"
    return text.replace("  ", " ").strip() or "0"


def _number(number: int | Fraction) -> str:
    above, below = digits(abs(number.numerator)), digits(number.denominator)
    sign = "-" if number < 0 else ""
    return sign + (above if number.denominator == 1 else rf"\frac{{{above}}}{{{below}}}")
