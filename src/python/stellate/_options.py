"""The keyword options that several verbs have, with the names of the command line."""

from __future__ import annotations

from typing import Any, Literal, NamedTuple, Sequence, TypedDict, Union

import numpy.typing as npt

from ._call import Progress
from ._numbers import Number, exact

Center = Union[Literal["auto", "centroid", "kernel", "best"], Sequence[Number]]


class OutlineOptions(TypedDict, total=False):
    """How a form is read, and an outline found in a file.

    ``numbers``: ``"exact"`` takes decimals as written, ``"f64"`` as the nearest double. ``columns``: of a table, those of x and y, by name
    or by number from 1. ``weights``: of a table, the column of 1/σ²; of an array of points in `fit`, an array. ``blob``: of a picture, which
    outline, from 1 by size; ``threshold`` (0 to 254) and ``invert``: its colours. ``repair``: mend an outline that touches itself.
    ``normalization`` (``"unnormalized"``, ``"4pi"``, ``"orthonormal"``, ``"schmidt"``) and ``condon_shortley``: of a file of spherical
    harmonics.
    """

    numbers: Literal["exact", "f64"]
    columns: str | Sequence[str | int]
    weights: str | int | npt.ArrayLike
    blob: int
    threshold: int | None
    invert: bool
    repair: bool
    normalization: Literal["unnormalized", "4pi", "orthonormal", "schmidt"]
    condon_shortley: bool


class ReadingOptions(OutlineOptions, total=False):
    """How a form is read. ``cloud``: the points of a table are in no order."""

    cloud: bool


class WorkOptions(TypedDict, total=False):
    """What may bound the work, and who is told of it.

    ``time_limit``: seconds. ``max_degree``: of a polynomial. ``threads``: by default one per core. ``progress``: called as
    ``progress(what, done, total)``, some twenty times a second at most.
    """

    time_limit: float | None
    max_degree: int | None
    threads: int | None
    progress: Progress | None


class CommonOptions(OutlineOptions, WorkOptions, total=False):
    """The options of every verb, where they mean something."""


class SeriesOptions(ReadingOptions, WorkOptions, total=False):
    """How a contour becomes a series; ``harmonics`` apart.

    ``model``: ``"radius"`` or ``"elliptic"``. ``tolerance``, ``distance``, ``power``: the fewest harmonics with an error, a certified
    distance, or a share of the power like this, in place of ``harmonics``. ``center``: ``"auto"``, ``"centroid"``, ``"kernel"``,
    ``"best"`` or coordinates. ``samples``: their number. ``estimator``: ``"quadrature"`` or ``"least-squares"``. ``robust``: Huber's
    loss. ``decimals``: to which the series is rounded.
    """

    tolerance: Number | None
    distance: Number | None
    power: Number | None
    center: Center
    samples: int | None
    estimator: Literal["quadrature", "least-squares"] | None
    robust: bool
    decimals: int | None


class FitOptions(SeriesOptions, total=False):
    """How a contour becomes a series."""

    model: Literal["radius", "elliptic"]
    harmonics: int | None


READING = frozenset(ReadingOptions.__annotations__)
NUMBERS = ("tolerance", "distance", "power")


class Prepared(NamedTuple):
    """Options as the native functions take them."""

    reading: dict[str, Any]
    verb: dict[str, Any]


def prepared(options: dict[str, Any], known: type) -> Prepared:
    """Separates how a form is read from what the verb does; exact numbers become texts."""
    names = known.__annotations__
    for name in options:
        if name not in names:
            raise TypeError(f"there is no option {name!r}; the options are {', '.join(sorted(names))}")
    reading = {k: v for k, v in options.items() if k in READING and v is not None}
    if not isinstance(reading.get("columns", ""), str):
        reading["columns"] = ",".join(map(str, reading["columns"]))
    if "weights" in reading:
        reading["weights"] = str(reading["weights"])
    verb = {k: v for k, v in options.items() if k not in READING}
    for name in NUMBERS:
        if verb.get(name) is not None:
            verb[name] = exact(verb[name])
    center = verb.pop("center", None)
    if isinstance(center, str):
        verb["center_choice"] = center
    elif center is not None:
        verb["center"] = [exact(c) for c in center]
    return Prepared(reading, verb)
