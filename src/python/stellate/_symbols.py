"""Forms as SymPy expressions and in LaTeX."""

from __future__ import annotations

from fractions import Fraction
from typing import TYPE_CHECKING, Any, Protocol, Sequence

from ._call import Source, call, value
from ._native import InputError

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
    found = [sympy.Tuple(*e) if isinstance(e, tuple) else e for e in map(sympy.sympify, filter(None, lines))]
    return found[0] if len(found) == 1 else sympy.Tuple(*found)


def to_latex(form: Written) -> str:
    """The form in LaTeX."""
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
        import sympy

        return str(sympy.latex(to_sympy(form))) + " = 0"
    lines = [line.partition("%")[0].strip().removesuffix(r"\\").strip() for line in _written(form, "latex")]
    return r" \\ ".join(line for line in lines if line)


def _written(form: Written, format: str) -> list[str]:
    if form.kind == "contour":
        raise InputError("a contour has no formula; stellate.fit gives a series for it")
    return call("form", [form.source()], format=format).decode().splitlines()


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
