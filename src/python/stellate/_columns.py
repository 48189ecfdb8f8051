"""Calls of the native functions, and what they write as columns."""

from __future__ import annotations

import csv
import io
import json
from dataclasses import dataclass
from fractions import Fraction
from typing import Any, Iterable, Sequence, Union

import numpy as np
import numpy.typing as npt

from . import _native

Number = Union[int, float, str, Fraction]
Doubles = npt.NDArray[np.float64]
Signs = np.ma.MaskedArray[Any, np.dtype[np.int8]]
# A text or a path, or the text of a document or table with a name for messages.
Source = tuple[str, Union[str, None]]


def exact(number: Number) -> str:
    """The text of a number: a float is its exact binary value, as in ``Fraction(0.1)``."""
    if isinstance(number, (float, np.floating)):
        return str(Fraction(float(number)))
    if isinstance(number, (int, np.integer)):
        return str(int(number))
    return str(number)


def value(text: str) -> int | Fraction:
    """The number that a text of a document is."""
    number = Fraction(text)
    return number.numerator if number.denominator == 1 else number


def call(
    verb: str,
    sources: Iterable[Source],
    data: bytes = b"",
    **options: object,
) -> bytes:
    """Calls the native function of a verb."""
    given = json.dumps({k: v for k, v in options.items() if v is not None})
    return _native.call(verb, list(sources), given, data)


def table(points: npt.ArrayLike, names: Sequence[str]) -> bytes:
    """The rows of an array as a table; every double is written so that it is read back."""
    array = np.atleast_2d(np.asarray(points, dtype=np.float64))
    if array.ndim != 2 or array.shape[1] not in (2, 3):
        raise _native.InputError(
            f"points: an array of shape (n, 2) or (n, 3) is expected, not {array.shape}"
        )
    rows = [",".join(names[: array.shape[1]])]
    rows.extend(",".join(map(repr, row)) for row in array.tolist())
    return ("\n".join(rows) + "\n").encode()


def rows_of(text: str) -> list[dict[str, str]]:
    lines = (line for line in io.StringIO(text) if not line.startswith("#"))
    return list(csv.DictReader(lines))


def arrow(columns: object, names: Sequence[str]) -> Any:
    import pyarrow

    found = {name: getattr(columns, name) for name in names}
    return pyarrow.table({k: v for k, v in found.items() if v is not None})


@dataclass(frozen=True)
class Inspection:
    """The certified answers for points, one element for each point.

    ``sign`` is masked where a point has no side: for open curves and space curves, or where it is not decided.
    """

    verdict: npt.NDArray[np.str_]
    curve: npt.NDArray[np.str_]
    distance_low: Doubles
    distance_high: Doubles
    sign: Signs

    def toarrow(self) -> Any:
        """The columns as a ``pyarrow.Table``, which must be installed."""
        return arrow(self, ("verdict", "curve", "distance_low", "distance_high", "sign"))


def inspection(text: str) -> Inspection:
    """The answers of a table that the verb `inspect` writes."""
    rows = rows_of(text)

    def column(name: str) -> list[str]:
        return [row[name] for row in rows]

    signs = column("sign")
    return Inspection(
        verdict=np.array(column("verdict"), dtype=np.str_),
        curve=np.array(column("curve"), dtype=np.str_),
        distance_low=np.array(column("distance_low"), dtype=np.float64),
        distance_high=np.array(column("distance_high"), dtype=np.float64),
        sign=np.ma.MaskedArray(
            [int(sign or 0) for sign in signs],
            mask=[not sign for sign in signs],
            dtype=np.int8,
        ),
    )
