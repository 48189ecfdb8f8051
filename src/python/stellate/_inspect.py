"""The verb `inspect`: points are compared with a form."""

from __future__ import annotations

import os
from typing import TYPE_CHECKING, Any, Literal, Sequence, Union

import numpy as np

from ._call import Source, call, native_options, write
from ._given import FormLike, Path, extension, floats, form
from ._native import InputError
from ._numbers import Number, exact
from ._options import Center, CommonOptions, prepared
from ._points import AXES, Points, columns, csv_table, good_rows
from ._results import Inspection, answer_columns, refuse_answers

if TYPE_CHECKING:
    from typing_extensions import Unpack


#: A tolerance, or limits (low, high) of the signed distance.
Tolerance = Union[Number, "tuple[Number, Number]"]


class InspectOptions(CommonOptions, total=False):
    """How a contour becomes the form that points are compared with."""

    model: Literal["radius", "elliptic"]
    harmonics: int | None
    distance: Number | None
    center: Center


def inspect(
    given: FormLike,
    points: Points,
    tolerance: Tolerance,
    *,
    uncertainty: Number | None = None,
    feet: bool = False,
    names: Sequence[str] = AXES,
    reach: float | None = None,
    digits: int = 6,
    budget: int = 50_000,
    keep: bool = False,
    skip_bad: bool = False,
    plot: Path | None = None,
    report: Path | None = None,
    cloud: Path | None = None,
    window: Sequence[float] | None = None,
    proof: Path | None = None,
    **options: Unpack[InspectOptions],
) -> Inspection:
    """Whether points are within a tolerance of a form, exactly (Theorem 8), and certified bounds of their distances.

    The form is kept ready for the next call with the same form object and options.

    Parameters
    ----------
    given : form, text or path
        A surface, or a curve of the plane (for points in space a cylinder) or of space.
    points : array_like of float64, shape (…, 2) or (…, 3), or a table with Arrow's PyCapsule interface
        Each double is taken exactly; other numbers are refused if they are no doubles. What is masked or null is missing. Arrays and Arrow
        columns of doubles are read in place.
    tolerance : number or text, or a pair of them
        The largest distance that is inside, exactly: ``"0.1"`` is a tenth, ``0.1`` the double. Two limits ``(low, high)`` with
        low ≤ 0 ≤ high are those of the signed distance, which is negative inside a form with sides.
    uncertainty : number or text
        The true point is at most this far from the measured one: points for which the verdict depends on it are uncertain.
    feet : bool
        Find the nearest point of the form, the normal there and bounds of the signed distance, too.
    names : sequence of str
        Of a table: the columns of the coordinates; the third may be missing.
    reach : float
        Distances are looked for up to here; by default until the nearest point is found.
    digits : int
        The significant digits of the distances.
    budget : int
        Cubes that may be divided for one point before it is undecided.
    keep : bool
        ``to_arrow()`` begins with the columns of the table of points, none of which may have the name of an answer.
    skip_bad : bool
        Leave points out that are missing or not finite, instead of refusing the first.
    plot, report, cloud : path
        A picture (.svg, .png), a folder for a report, a cloud of coloured points (.ply).
    window : sequence of float
        The part of the plane or of space that is drawn.
    proof : path
        A file for everything that the result claims, with witnesses that `verify` checks.
    **options
        ``model``, ``harmonics``, ``distance``, ``center`` and those of `CommonOptions`.

    Raises
    ------
    InputError
        For a form without points to compare with, a reach that is not positive, or a point that is not finite, by its row from 0.

    >>> import stellate
    >>> stellate.inspect("x^2 + y^2 = 1", [[1, 0], [3, 0]], tolerance=1).verdict.tolist()
    ['inside', 'outside']
    """
    asked = prepared(dict(options), InspectOptions)
    axes, shape, table = columns(points, names)
    if keep and table is None:
        raise InputError("keep is for tables; an array has no other columns")
    if keep and table is not None:
        refuse_answers(table.column_names, answer_columns(len(axes), feet))
    row = np.arange(axes[0].size)
    if skip_bad:
        good = good_rows(axes)
        if not good.all():
            axes, row = [axis[good] for axis in axes], row[good]
            shape = row.shape
    progress = asked.verb.pop("progress", None)
    limits = _limits(tolerance)
    if uncertainty is not None:
        limits["uncertainty"] = exact(uncertainty)
    verb = dict(asked.verb, **limits, reach=reach, digits=digits, budget=budget)
    found = form(given)
    inspector = found._inspector(len(axes), native_options(verb), asked.reading, progress)
    answers, at = inspector.inspect_with_feet(axes, progress) if feet else (inspector.inspect(axes, progress), None)
    _draw(found.source(asked.reading), csv_table(axes, AXES) if plot or report or cloud or proof else b"",
          dict(verb, window=floats(window)), plot, report, cloud, proof)  # fmt: skip
    return Inspection(answers, shape, row, table if keep else None, len(axes), at)


def _limits(tolerance: Tolerance) -> dict[str, Any]:
    """The options for a tolerance, or for two limits."""
    texts = exact_tolerance(tolerance)
    if isinstance(texts, str):
        return {"tolerance": texts}
    return {"lower": texts[0], "tolerance": texts[1]}


def exact_tolerance(tolerance: Tolerance) -> str | tuple[str, str]:
    """The text of a tolerance, or those of two limits."""
    if np.ndim(tolerance) == 0:  # type: ignore[arg-type]
        return exact(tolerance)
    limits = tuple(map(exact, tolerance))  # type: ignore[arg-type]
    if len(limits) != 2:
        raise InputError("tolerance: one number, or a pair (low, high) of limits of the signed distance")
    return limits


def _draw(
    source: Source, rows: bytes, verb: dict[str, Any],
    plot: Path | None, report: Path | None, cloud: Path | None, proof: Path | None,
) -> None:  # fmt: skip
    """Writes what is asked for beside the columns of an inspection."""
    if plot is not None:
        write(plot, call("inspect", [source], rows, kind="plot", format=extension(plot), **verb))
    if report is not None:
        page = call("inspect", [source], rows, kind="report", **verb)
        os.makedirs(report, exist_ok=True)
        write(os.path.join(report, "index.html"), page)
    if cloud is not None:
        if extension(cloud) != "ply":
            raise InputError(f"cloud {os.fspath(cloud)}: a cloud of points is a .ply file")
        write(cloud, call("inspect", [source], rows, kind="cloud", **verb))
    if proof is not None:
        call("inspect", [source], rows, proof=proof, **verb)
