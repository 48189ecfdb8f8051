"""The verb `check`: the numbers of float programs are compared with the exact ones."""

from __future__ import annotations

import json
from os import PathLike
from typing import TYPE_CHECKING, Any, Mapping

import numpy as np
import numpy.typing as npt

from ._call import call, write
from ._given import FormLike, Path, extension, form, sources_of
from ._native import InputError
from ._options import FitOptions, prepared
from ._points import AXES, columns, csv_table
from ._results import Check

if TYPE_CHECKING:
    from typing_extensions import Unpack


def check(
    reference: FormLike,
    *,
    coefficients: Mapping[tuple[int, ...], float] | npt.ArrayLike | Path | None = None,
    points: npt.ArrayLike | Path | None = None,
    radii: npt.ArrayLike | Path | None = None,
    itself: bool = False,
    digits: int | None = None,
    plot: Path | None = None,
    **options: Unpack[FitOptions],
) -> Check:
    """How far the numbers of a float program are from the exact ones, and which usual mistakes explain it.

    Parameters
    ----------
    reference : form, text or path
        What is right.
    coefficients : mapping, array or path
        Values by exponents (i, j) or (i, j, k), or by (l, m) if the reference is a harmonic surface; or a matrix ``c[i, j]``.
    points : array of shape (n, 2) or (n, 3), or path
    radii : array of shape (n, 2), or (n, 3) for a harmonic surface, or path
        Rows θ, r or θ, φ, r; angles in radians.
    itself : bool
        Instead of these: the paper's own algorithm in doubles, for growing N (``--self``).
    digits : int
        The correct digits that everything must have, for ``passes``.
    plot : path
        A picture of the digits, .svg or .png.
    **options
        See `FitOptions`.

    Returns
    -------
    Check
        A mapping: the document, with ``mistakes, missing, extra, worst, median_digits, …``; and columns.

    >>> import stellate
    >>> found = stellate.check("R = 2 + Y(1,0)/2", coefficients={(0, 0): 2.0, (1, 0): 0.5}, digits=12)
    >>> found.passes, found["missing"]
    (True, [])
    """
    asked = prepared(dict(options), FitOptions)
    sources = sources_of(reference, asked)
    given: list[tuple[str, Any]] = [
        (name, numbers)
        for name, numbers in (("coefficients", coefficients), ("points", points), ("radii", radii))
        if numbers is not None
    ]
    if itself:
        given.append(("self", None))
    if len(given) != 1:
        raise InputError("check needs one of coefficients, points and radii, or itself")
    (kind, numbers), = given  # fmt: skip
    if isinstance(numbers, Mapping):
        data = _coefficient_rows(numbers, form(reference).kind == "spherical")
    elif isinstance(numbers, (str, PathLike)):
        with open(numbers, "rb") as file:
            data = file.read()
    elif kind == "coefficients":
        matrix = np.asarray(numbers, dtype=np.float64)
        if matrix.ndim != 2:
            raise InputError(f"coefficients: a matrix c[i, j] is expected, not an array of shape {matrix.shape}")
        data = "".join(",".join(map(repr, row)) + "\n" for row in matrix.tolist()).encode()
    elif kind == "self":
        data = b""
    else:
        axes, _, _ = columns(numbers)
        names = AXES if kind == "points" else ("theta", "phi", "r") if len(axes) == 3 else ("theta", "r")
        data = csv_table(axes, names)
    verb = dict(asked.verb, kind=kind, digits=digits)
    if plot is not None:
        write(plot, call("check", sources, data, format=extension(plot) or "none", **verb))
    found = json.loads(call("check", sources, data, **verb))
    return Check(found["document"], found["table"])


def _coefficient_rows(numbers: Mapping[tuple[int, ...], float], is_spherical: bool) -> bytes:
    sizes = {len(key) for key in numbers}
    if sizes not in ({2}, {3}):
        raise InputError("coefficients: the keys are exponents (i, j) or (i, j, k), or (l, m)")
    (size,) = sizes
    names = ("l", "m") if is_spherical and size == 2 else ("i", "j", "k")[:size]
    rows = [",".join([*names, "value"])]
    rows.extend(",".join([*map(str, key), repr(float(c))]) for key, c in numbers.items())
    return ("\n".join(rows) + "\n").encode()
