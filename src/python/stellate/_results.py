"""What verbs answer: columns of NumPy, which are tables of Arrow, too."""

from __future__ import annotations

from fractions import Fraction
from typing import TYPE_CHECKING, Any, Iterable, Iterator, Mapping

import numpy as np
import numpy.typing as npt

from ._native import InputError
from ._numbers import value
from ._points import Doubles, any_column

if TYPE_CHECKING:
    import pyarrow as pa

    # NumPy imports its module of masked arrays when it is first used.
    Signs = np.ma.MaskedArray[Any, np.dtype[np.int8]]
    Flags = np.ma.MaskedArray[Any, np.dtype[np.bool_]]

Codes = npt.NDArray[np.int8]
VERDICTS = ("inside", "outside", "undecided", "uncertain")
# What stands for an answer that there is not, in native columns of −1, 0 and 1.
NONE = 2


def answer_columns(dimension: int, feet: bool) -> dict[str, str]:
    """The columns of an inspection's table, with the names of their types in Spark."""
    found = {
        "verdict": "string", "curve": "boolean", "distance_low": "double", "distance_high": "double", "sign": "byte",
    }  # fmt: skip
    if feet:
        axes = [f"{name}_{axis}" for name in ("foot", "normal") for axis in "xyz"[:dimension]]
        found.update(dict.fromkeys([*axes, "signed_low", "signed_high"], "double"))
    return found


def refuse_answers(names: Iterable[str], answers: Iterable[str]) -> None:
    """Refuses the columns of a table that have the name of an answer."""
    taken = sorted(set(names) & set(answers))
    if taken:
        raise InputError(f"the table has a column {taken[0]!r} already, which would be an answer's; give it another name")


class Table:
    """Columns that Arrow can read, by ``to_arrow()`` or by its PyCapsule interface. They need pyarrow."""

    def to_arrow(self) -> pa.Table:
        """The columns as a ``pyarrow.Table``; those of numbers are not copied."""
        raise NotImplementedError

    def __arrow_c_stream__(self, requested_schema: object | None = None) -> object:
        return self.to_arrow().__arrow_c_stream__(requested_schema)


class Inspection(Table):
    """The certified answers for points, one element for each.

    Attributes
    ----------
    verdict : ndarray of str
        ``"inside"`` for a distance of at most the tolerance, or a signed distance within the limits, else ``"outside"``, exactly;
        ``"uncertain"`` if that depends on where the true point is; ``"undecided"`` if ``budget`` was too small.
    curve : masked array of bool
        The paper's criterion: whether the form meets the sphere about the point whose radius is the tolerance. Masked: undecided.
    distance_low, distance_high : ndarray of float64
        Certified bounds of the distance, in the units of the form.
    sign : masked array of int8
        −1 inside, 0 on the form, 1 outside. Masked where a point has no side: for open curves and space curves.
    foot, normal : ndarray of float64, shape (…, 2) or (…, 3), or None
        With ``feet=True``: the nearest point of the form, and the unit normal of the form there, approximately; NaN where there is none.
    signed_low, signed_high : ndarray of float64, or None
        With ``feet=True``: certified bounds of the signed distance; NaN where a point has no side.
    row : ndarray of int64
        The numbers of the points, from 0; some are missing only with ``skip_bad=True``.
    """

    __slots__ = (
        "_codes", "_curve", "_sign", "_kept", "_shape", "distance_low", "distance_high", "row",
        "foot", "normal", "signed_low", "signed_high",
    )  # fmt: skip

    def __init__(
        self,
        found: tuple[Codes, Codes, Doubles, Doubles, Codes],
        shape: tuple[int, ...],
        row: npt.NDArray[np.int64],
        kept: pa.Table | None,
        dimension: int,
        feet: tuple[Doubles, Doubles, Doubles, Doubles] | None = None,
    ) -> None:
        codes, curve, low, high, sign = found
        self._codes, self._curve, self._sign = (c.reshape(shape) for c in (codes, curve, sign))
        self.distance_low: Doubles = low.reshape(shape)
        self.distance_high: Doubles = high.reshape(shape)
        self.row = row
        self._kept = kept
        self._shape = shape
        self.foot: Doubles | None = None
        self.normal: Doubles | None = None
        self.signed_low: Doubles | None = None
        self.signed_high: Doubles | None = None
        if feet is not None:
            foot, normal, signed_low, signed_high = feet
            self.foot, self.normal = (v.reshape(*shape, dimension) for v in (foot, normal))
            self.signed_low, self.signed_high = (v.reshape(shape) for v in (signed_low, signed_high))

    @property
    def verdict(self) -> npt.NDArray[np.str_]:
        return np.array(VERDICTS)[self._codes]

    @property
    def inside(self) -> npt.NDArray[np.bool_]:
        """Whether the verdict is ``"inside"``."""
        return np.equal(self._codes, 0)

    @property
    def curve(self) -> Flags:
        return np.ma.MaskedArray(self._curve == 1, mask=self._curve == NONE)

    @property
    def sign(self) -> Signs:
        return np.ma.MaskedArray(self._sign, mask=self._sign == NONE)

    def __len__(self) -> int:
        return self._codes.size

    def __repr__(self) -> str:
        counts = [(name, (self._codes == k).sum()) for k, name in enumerate(VERDICTS)]
        shown = ", ".join(f"{count} {name}" for name, count in counts if count or name != "uncertain")
        return f"<stellate inspection: {shown}>"

    def to_arrow(self) -> pa.Table:
        """The columns ``verdict, curve, distance_low, distance_high, sign``, and with ``feet=True`` those of the feet as in the program's
        table, null where there is none; with ``keep=True`` behind those of the points."""
        import pyarrow

        def flat(array: npt.NDArray[Any]) -> npt.NDArray[Any]:
            return array.reshape(-1)

        names = pyarrow.DictionaryArray.from_arrays(pyarrow.array(flat(self._codes)), list(VERDICTS))
        columns = {
            "verdict": names.dictionary_decode(),
            "curve": pyarrow.array(flat(self._curve == 1), mask=flat(self._curve == NONE)),
            "distance_low": pyarrow.array(flat(self.distance_low)),
            "distance_high": pyarrow.array(flat(self.distance_high)),
            "sign": pyarrow.array(flat(self._sign), mask=flat(self._sign == NONE)),
        }
        for name, vectors in (("foot", self.foot), ("normal", self.normal)):
            if vectors is not None:
                for k, axis in enumerate("xyz"[: vectors.shape[-1]]):
                    columns[f"{name}_{axis}"] = pyarrow.array(flat(vectors[..., k]), from_pandas=True)
        for name, bounds in (("signed_low", self.signed_low), ("signed_high", self.signed_high)):
            if bounds is not None:
                columns[name] = pyarrow.array(flat(bounds), from_pandas=True)
        if self._kept is None:
            return pyarrow.table(columns)
        table = self._kept
        if len(self.row) < table.num_rows:
            table = table.take(pyarrow.array(self.row))
        for name, column in columns.items():
            table = table.append_column(name, column)
        return table


class Samples(Table):
    """Certified points, one element for each.

    Attributes
    ----------
    branch : ndarray of int64
        The number of the point among those of its direction; of an intersection, the number of the arc.
    theta, phi : ndarray of float64, in radians
        The nominal angles; ``phi`` only in space.
    r, x, y, z : ndarray of float64
        The doubles nearest to the exact radius and coordinates; ``z`` only in space.
    multiplicity : ndarray of int64
    columns : dict of ndarray
        All columns, by their names in the program's table, without the exact directions. Of an intersection there are
        ``arc, point, x, y, z, bound, residual1, residual2``: each point is within ``bound`` of the curve.
    center : tuple of int or Fraction, or None
        The origin of the coordinates, if it is not (0, 0).
    """

    def __init__(self, text: str) -> None:
        from ._points import rows_of

        rows = rows_of(text)
        first = text.split("\n", 1)[0]
        self.center: tuple[Fraction, ...] | None = None
        if first.startswith("# center"):
            self.center = tuple(Fraction(value(c)) for c in first.split()[2:])
        header = next(line for line in text.split("\n") if not line.startswith("#")).split(",")
        self._axes = [name for name in ("u", "v", "w") if name in header]
        self._exact = [[row[axis] for axis in self._axes] for row in rows]
        whole = ("branch", "multiplicity", "arc", "point")
        self.columns: dict[str, npt.NDArray[Any]] = {
            name: np.array([row[name] for row in rows], dtype=np.str_).astype(
                np.int64 if name in whole else np.float64
            )
            for name in header
            if name not in self._axes
        }

    @property
    def directions(self) -> list[tuple[Fraction, ...]]:
        """The exact unit vectors of the directions, one for each point."""
        return [tuple(Fraction(value(number)) for number in row) for row in self._exact]

    @property
    def branch(self) -> npt.NDArray[np.int64]:
        return self.columns["branch" if "branch" in self.columns else "arc"]

    @property
    def multiplicity(self) -> npt.NDArray[np.int64]:
        return self.columns["multiplicity"]

    @property
    def theta(self) -> Doubles:
        return self.columns["theta"]

    @property
    def phi(self) -> Doubles | None:
        return self.columns.get("phi")

    @property
    def r(self) -> Doubles:
        return self.columns["r"]

    @property
    def x(self) -> Doubles:
        return self.columns["x"]

    @property
    def y(self) -> Doubles:
        return self.columns["y"]

    @property
    def z(self) -> Doubles | None:
        return self.columns.get("z")

    def __len__(self) -> int:
        return self.x.size

    def __repr__(self) -> str:
        return f"<stellate samples: {len(self)} points, {', '.join(self.columns)}>"

    def to_arrow(self) -> pa.Table:
        """The columns; exact directions are texts ``u, v`` and in space ``w``."""
        import pyarrow

        table = pyarrow.table(self.columns)
        for k, axis in enumerate(self._axes):
            texts = pyarrow.array([row[k] for row in self._exact], pyarrow.string())
            table = table.append_column(axis, texts)
        return table


class Check(Table, Mapping[str, Any]):
    """How far the numbers of a float program are from the exact ones: a mapping, the document of the kind ``check``.

    Attributes
    ----------
    columns : dict of ndarray
        One element for each number that was compared, with the names of the program's table: ``got``, ``exact``, ``digits``, ``ulps``, …
    """

    def __init__(self, document: dict[str, Any], table: str) -> None:
        from ._points import rows_of

        self._document = document
        rows = rows_of(table)
        header = table.split("\n", 1)[0].split(",")
        self.columns = {name: any_column([row[name] for row in rows]) for name in header if name}

    @property
    def passes(self) -> bool | None:
        """Whether everything has the ``digits`` that were asked for; None if none were."""
        return self._document.get("passes")

    @property
    def mistakes(self) -> list[dict[str, Any]]:
        """The mistakes that were recognised."""
        return list(self._document.get("mistakes", ()))

    def __getitem__(self, name: str) -> Any:
        return self._document[name]

    def __iter__(self) -> Iterator[str]:
        return iter(self._document)

    def __len__(self) -> int:
        return len(self._document)

    def __repr__(self) -> str:
        worst = (self._document.get("worst") or {}).get("digits")
        if "rungs" in self._document:
            return f"<stellate check: doubles for {len(self['rungs'])} numbers of harmonics>"
        return f"<stellate check: {self['compared']} compared, worst digits {worst}, {len(self.mistakes)} mistakes>"

    def to_arrow(self) -> pa.Table:
        """One row for each number that was compared."""
        import pyarrow

        return pyarrow.table({k: v.tolist() if v.dtype.kind == "U" else v for k, v in self.columns.items()})


class Mesh(Table):
    """Triangles of a surface.

    Attributes
    ----------
    vertices : ndarray of float64, shape (n, 3)
        Each has a certified zero near it; how near, the logger ``stellate`` is told.
    normals : ndarray of float32, shape (n, 3)
    triangles : ndarray of uint32, shape (m, 3)
        The indices of the vertices of each triangle, counter-clockwise from outside.
    """

    def __init__(self, ply: bytes) -> None:
        head, _, body = ply.partition(b"end_header\n")
        counts = {
            line.split()[1]: int(line.split()[2])
            for line in head.decode().splitlines()
            if line.startswith("element")
        }
        points = np.frombuffer(body, dtype=[("p", "<f8", 3), ("n", "<f4", 3)], count=counts["vertex"])
        faces = np.frombuffer(
            body, dtype=[("k", "u1"), ("v", "<u4", 3)], count=counts["face"], offset=points.nbytes
        )
        self.vertices: Doubles = np.ascontiguousarray(points["p"])
        self.normals: npt.NDArray[np.float32] = np.ascontiguousarray(points["n"])
        self.triangles: npt.NDArray[np.uint32] = np.ascontiguousarray(faces["v"])

    def __repr__(self) -> str:
        return f"<stellate mesh: {len(self.vertices)} vertices, {len(self.triangles)} triangles>"

    def to_arrow(self) -> pa.Table:
        """The vertices and normals: ``x, y, z, nx, ny, nz``."""
        import pyarrow

        names = ("x", "y", "z", "nx", "ny", "nz")
        columns = [*self.vertices.T, *self.normals.T]
        return pyarrow.table({name: np.ascontiguousarray(c) for name, c in zip(names, columns)})
