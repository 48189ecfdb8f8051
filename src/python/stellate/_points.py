"""Points as columns of coordinates: from NumPy arrays and Arrow tables, without copies where their layout allows it."""

from __future__ import annotations

from fractions import Fraction
from typing import TYPE_CHECKING, Any, NamedTuple, Protocol, Sequence, Union

import numpy as np
import numpy.typing as npt

from ._native import InputError
from ._numbers import exact, fraction

if TYPE_CHECKING:
    import pyarrow as pa

Doubles = npt.NDArray[np.float64]
AXES = ("x", "y", "z")
# All integers up to here are doubles.
WHOLE = 2.0**53


class ArrowStream(Protocol):
    """A table of any library that has Arrow's PyCapsule interface: pyarrow, polars, pandas, DuckDB, …"""

    def __arrow_c_stream__(self, requested_schema: object | None = None) -> object: ...


class ArrowArray(Protocol):
    """A record batch with Arrow's PyCapsule interface."""

    def __arrow_c_array__(self, requested_schema: object | None = None) -> object: ...


Points = Union[npt.ArrayLike, ArrowStream, ArrowArray]


class Columns(NamedTuple):
    """The coordinates of points."""

    axes: list[Doubles]
    shape: tuple[int, ...]
    table: pa.Table | None


def columns(points: Points, names: Sequence[str] = AXES) -> Columns:
    """The columns of an array of shape (…, 2) or (…, 3), or of a table with columns of these names, of which the third is optional.

    A coordinate that is no double is refused. What is masked or null is missing: NaN.
    """
    table = arrow_table(points)
    if table is not None:
        return _of_table(table, names)
    array = doubles(points, "points")
    if array.ndim == 0 or array.shape[-1] not in (2, 3):
        raise InputError(
            f"points: an array of shape (n, 2) or (n, 3) is expected, not {array.shape}"
        )
    shape = array.shape[:-1]
    if array.ndim == 1:
        array = array[np.newaxis]
    elif array.ndim > 2:
        array = array.reshape(-1, array.shape[-1])
    return Columns([array[:, k] for k in range(array.shape[1])], shape, None)


def arrow_table(points: object) -> pa.Table | None:
    """The table that something with Arrow's PyCapsule interface is."""
    if hasattr(points, "__arrow_c_stream__"):
        import pyarrow

        return pyarrow.table(points)
    if hasattr(points, "__arrow_c_array__"):
        import pyarrow

        return pyarrow.Table.from_batches([pyarrow.record_batch(points)])
    return None


def _of_table(table: pa.Table, names: Sequence[str]) -> Columns:
    if len(names) not in (2, 3):
        raise InputError(f"names: those of two or three columns are expected, not {names!r}")
    missing = [name for name in names[:2] if name not in table.column_names]
    if missing:
        raise InputError(
            f"points: there is no column {missing[0]!r}; there are {', '.join(table.column_names)}"
        )
    found = [name for name in names if name in table.column_names]
    return Columns([_doubles(table, name) for name in found], (table.num_rows,), table)


def _doubles(table: pa.Table, name: str) -> Doubles:
    import pyarrow

    column = table.column(name)
    if pyarrow.types.is_floating(column.type) or pyarrow.types.is_integer(column.type):
        try:
            return _joined(column.cast(pyarrow.float64()).chunks)
        except (pyarrow.ArrowInvalid, pyarrow.ArrowNotImplementedError):
            # Some integers are large, or this version cannot convert the type.
            pass
    return doubles(np.array(column.to_pylist(), dtype=object), f"points: the column {name!r}")


def _joined(chunks: Sequence[pa.Array]) -> Doubles:
    arrays = [chunk.to_numpy(zero_copy_only=False) for chunk in chunks]
    if len(arrays) == 1:
        one: Doubles = arrays[0]
        return one
    return np.concatenate(arrays) if arrays else np.empty(0)


def doubles(numbers: Any, place: str) -> Doubles:
    """The same numbers as doubles, in place if they are. A number that would be rounded is refused; what is masked or None is NaN."""
    if isinstance(numbers, (list, tuple)) and any(isinstance(part, np.ma.MaskedArray) for part in numbers):
        numbers = np.ma.array(numbers)
    if isinstance(numbers, np.ma.MaskedArray):
        found = np.array(doubles(numbers.filled(0), place))
        found[np.ma.getmaskarray(numbers)] = np.nan
        return found
    array = np.asarray(numbers)
    kind, size = array.dtype.kind, array.itemsize
    if kind == "f" and size <= 8:
        found = array.astype(np.float64, copy=False)
        if isinstance(numbers, np.ndarray) or not (np.abs(found) >= WHOLE).any():
            return found
        # A list may have had integers that NumPy has rounded.
        array, kind = np.array(numbers, dtype=object), "O"
    if kind == "O":
        return np.array([_double(number, place) for number in array.flat], np.float64).reshape(array.shape)
    if kind not in "fiub":
        raise InputError(f"{place}: numbers are expected, not {array.dtype}")
    found = array.astype(np.float64)
    rounded = np.abs(found) >= WHOLE if kind in "iu" else found.astype(array.dtype) != array
    for number in array[rounded]:
        _double(number, place)
    return found


def _double(number: object, place: str) -> float:
    """The number as a double, if it is one; NaN for None."""
    if isinstance(number, float):
        return number
    if number is None or number is np.ma.masked:
        return np.nan
    if isinstance(number, np.floating) and not np.isfinite(number):
        return float(number)
    ratio = None if isinstance(number, str) else fraction(number)
    if ratio is None:
        raise InputError(f"{place}: numbers are expected, not {number!r}")
    try:
        double = float(ratio)
    except OverflowError:
        double = np.inf
    if np.isinf(double) or ratio != Fraction(double):
        raise InputError(f"{place}: {_shown(number)} is no double, and would be rounded; doubles are taken exactly")
    return double


def _shown(number: object) -> str:
    try:
        return str(number)
    except ValueError:
        # It has more digits than Python shows.
        return exact(number)[:20] + "…"


def good_rows(axes: list[Doubles]) -> npt.NDArray[np.bool_]:
    """Which rows have finite coordinates."""
    found = np.isfinite(axes[0])
    for axis in axes[1:]:
        found &= np.isfinite(axis)
    return found


def csv_table(axes: Sequence[Doubles], names: Sequence[str]) -> bytes:
    """The rows as a table; every double is written so that it is read back."""
    rows = [",".join(names[: len(axes)])]
    rows.extend(",".join(map(repr, row)) for row in zip(*(axis.tolist() for axis in axes)))
    return ("\n".join(rows) + "\n").encode()


def rows_of(text: str) -> list[dict[str, str]]:
    """The rows of a table that the program writes."""
    import csv
    from io import StringIO

    # The remarks are in the first lines; a name in a row may begin with their mark, and have line breaks in it.
    while text.startswith("#"):
        _, _, text = text.partition("\n")
    return list(csv.DictReader(StringIO(text, newline="")))


def any_column(texts: list[str]) -> npt.NDArray[Any]:
    """Texts as whole numbers, doubles or texts, the first that all of them are."""
    for kind in (np.int64, np.float64):
        try:
            return np.array(texts, dtype=np.str_).astype(kind)
        except (ValueError, OverflowError):
            continue
    return np.array(texts, dtype=np.str_)
