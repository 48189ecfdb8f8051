"""Fits of series to outlines and meshes."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np
import numpy.typing as npt

from ._form import Form
from ._points import rows_of
from ._results import Table

if TYPE_CHECKING:
    import pyarrow as pa


class Fit:
    """A series that was fitted to an outline or a mesh.

    Attributes
    ----------
    form : Form
        The Fourier radius, the elliptic series or the harmonic surface; its coefficients are exact.
    document : dict
        What the program writes, with all errors.
    """

    def __init__(self, form: Form, document: dict[str, Any]) -> None:
        self.form = form
        self.document = document

    @property
    def max_radial_error(self) -> float | None:
        """The largest radial error at the samples (approximate); None for an elliptic series."""
        error = self.document.get("max_radial_error")
        return None if error is None else float(error)

    @property
    def distance(self) -> tuple[float, float] | None:
        """Certified bounds of the Hausdorff distance between the outline and the curve, or the mesh and the surface; None if there are none."""
        found = self.document.get("distance")
        return None if found is None else (float(found["low"]), float(found["high"]))

    def __repr__(self) -> str:
        return f"<stellate fit: {self.form.kind}, max_radial_error {self.max_radial_error}, distance {self.distance}>"


class FitTable(Table):
    """The fits of several outlines.

    Attributes
    ----------
    columns : dict of ndarray
        One element for each outline, with the names of the program's table: ``file, blob, model, harmonics, degree, …`` and the
        coefficients. Files, models and whether a curve is star-shaped are texts, and what an outline does not have is NaN.
    """

    def __init__(self, text: str) -> None:
        rows = rows_of(text)
        self.columns = {name: _column(name, [row[name] for row in rows]) for name in rows[0]}

    def __len__(self) -> int:
        return len(self.columns["file"])

    def __repr__(self) -> str:
        return f"<stellate fits of {len(self)} outlines>"

    def to_arrow(self) -> pa.Table:
        """One row for each outline."""
        import pyarrow

        return pyarrow.table({k: v.tolist() if v.dtype.kind == "U" else v for k, v in self.columns.items()})


def _column(name: str, texts: list[str]) -> npt.NDArray[Any]:
    """A column of the table, of the type that its name has in every table."""
    if name in ("file", "model", "star_shaped"):
        return np.array(texts, dtype=np.str_)
    if name in ("blob", "harmonics", "degree"):
        return np.array(texts, dtype=np.str_).astype(np.int64)
    return np.array([float(text) if text else np.nan for text in texts])
