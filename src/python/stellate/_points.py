"""Points as columns of coordinates: from NumPy arrays and Arrow tables, without copies where their layout allows it."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, NamedTuple, Protocol, Sequence, Union

import numpy as np
import numpy.typing as npt

from ._native import InputError

if TYPE_CHECKING:
    import pyarrow as pa

Doubles = npt.NDArray[np.float64]
AXES = ("x", "y", "z")


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
    """The columns of an array of shape (…, 2) or (…, 3), or of a table with columns of these names, of which the third is optional."""
    table = arrow_table(points)
    if table is not None:
        return _of_table(table, names)
    array = np.asarray(points, dtype=np.float64)
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
    try:
        chunks = column.cast(pyarrow.float64()).chunks
    except (pyarrow.ArrowInvalid, pyarrow.ArrowNotImplementedError) as error:
        raise InputError(f"points: the column {name!r} holds no numbers: {error}") from error
    arrays = [chunk.to_numpy(zero_copy_only=False) for chunk in chunks]
    if len(arrays) == 1:
        one: Doubles = arrays[0]
        return one
    return np.concatenate(arrays) if arrays else np.empty(0)


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

    lines = (line for line in text.splitlines() if not line.startswith("#"))
    return list(csv.DictReader(lines))


def any_column(texts: list[str]) -> npt.NDArray[Any]:
    """Texts as whole numbers, doubles or texts, the first that all of them are."""
    for kind in (np.int64, np.float64):
        try:
            return np.array(texts, dtype=np.str_).astype(kind)
        except ValueError:
            continue
    return np.array(texts, dtype=np.str_)
