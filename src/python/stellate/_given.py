"""What every verb does with its arguments: forms from what is given, and paths and numbers."""

from __future__ import annotations

import json
import os
from collections.abc import Mapping
from operator import index
from os import PathLike
from typing import TYPE_CHECKING, Any, Sequence, Union

from ._call import Source
from ._fit import Fit
from ._form import Form
from ._native import InputError
from ._numbers import Number, exact, value
from ._options import Prepared, ReadingOptions, prepared
from ._points import AXES, Doubles, Points, columns, csv_table
from ._symbols import of_sympy

if TYPE_CHECKING:
    import sympy
    from typing_extensions import Unpack

FormLike = Union[Form, str, "PathLike[str]", Mapping[Any, Number], Fit, "sympy.Expr"]
Path = Union[str, "PathLike[str]"]


def sources_of(given: FormLike, options: Prepared) -> list[Source]:
    return [form(given).source(options.reading)]


def extension(path: Path) -> str:
    """The extension of a name, in lower case and without its point."""
    return os.path.splitext(os.fspath(path))[1].lstrip(".").lower()


def floats(numbers: Sequence[float] | None) -> list[float] | None:
    """Numbers as floats of Python."""
    return None if numbers is None else [float(number) for number in numbers]


def form(given: FormLike, **reading: Unpack[ReadingOptions]) -> Form:
    """A form from a text, a path, a document, the terms of a polynomial, a fit, or a SymPy expression.

    Floats are taken exactly, bit for bit, also those of SymPy.

    Options
    -------
    numbers, columns, weights, cloud, blob, threshold, invert, repair, normalization, condon_shortley
        How it is read, as in ``stellate fit --help``.

    Raises
    ------
    InputError
        For another type. A text is read when the form is first used.

    >>> import stellate
    >>> stellate.form({(4, 0): 1, (2, 0): -1, (0, 2): 1}).degree
    4
    """
    how = prepared(dict(reading), ReadingOptions).reading
    if isinstance(given, Fit):
        given = given.form
    if isinstance(given, Form):
        return Form(given.text, given.place, {**given.reading, **how}) if how else given
    if isinstance(given, Mapping):
        return from_terms(given)
    if isinstance(given, PathLike):
        return Form(os.fspath(given), None, how)
    if isinstance(given, str):
        is_document = given.lstrip().startswith("{")
        return Form(given, "document" if is_document else None, how)
    if type(given).__module__.startswith("sympy"):
        return Form(of_sympy(given), None, how)
    raise InputError(f"a form is a text, a path or terms, not {type(given).__name__}")


def from_terms(terms: Mapping[Any, Number]) -> Form:
    """The curve or surface with these terms: exponents (i, j) or (i, j, k), and coefficients."""
    names = ("x", "y", "z")
    parts = []
    for exponents, c in terms.items():
        if len(exponents) not in (2, 3) or any(index(e) < 0 for e in exponents):
            raise InputError(
                f"terms: exponents are two or three integers that are not negative, not {exponents}"
            )
        powers = [f"*{v}^{index(e)}" for v, e in zip(names, exponents) if e]
        parts.append(f"({exact(c)})" + "".join(powers))
    if not parts:
        raise InputError("terms: a polynomial has at least one term")
    three = any(len(key) == 3 for key in terms)
    return Form(" + ".join(parts) + (" + 0*z" if three else "") + " = 0")


def from_series(cos: Sequence[Number], sin: Sequence[Number] | None = None) -> Form:
    """The Fourier radius ``r = cos[0] + Σ cos[n] cos nθ + sin[n] sin nθ``.

    Raises
    ------
    InputError
        For a ``sin[0]`` that is not 0, since it belongs to nothing.

    >>> import stellate
    >>> stellate.from_series([1, 0, "1/5"]).cos
    [1, 0, Fraction(1, 5)]
    """
    sin = [] if sin is None else sin
    size = max(len(cos), len(sin))
    if size == 0:
        raise InputError("a series has at least the mean, cos[0]")
    padded = [[*map(exact, list_), *["0"] * (size - len(list_))] for list_ in (cos, sin)]
    if len(sin) and not _is_zero(padded[1][0]):
        raise InputError(
            "sin[0] is not 0, but there is no sine of the order 0: sin[n] belongs to sin nθ"
        )
    document = {"schema": "stellate/1", "kind": "fourier", "cos": padded[0], "sin": padded[1]}
    return Form(json.dumps(document), "series")


def _is_zero(text: str) -> bool:
    try:
        return value(text) == 0
    except (ValueError, ZeroDivisionError):
        # The reader says what is wrong with it.
        return True


def from_points(points: Points, **reading: Unpack[ReadingOptions]) -> Form:
    """The outline with these vertices in order: an array of shape (n, 2), or an Arrow table with columns x and y.

    With ``cloud=True``, points in no order.
    """
    how = prepared(dict(reading), ReadingOptions).reading
    return Form(csv_table(vertices(points), AXES).decode(), "points.csv", how)


def vertices(points: Points) -> list[Doubles]:
    """The columns of the points of an outline."""
    axes, shape, _ = columns(points)
    if len(axes) != 2 or len(shape) != 1 or axes[0].size < 3:
        raise InputError(
            f"points: an outline is an array of shape (n, 2) with at least three points, not {(*shape, len(axes))}"
        )
    return axes
