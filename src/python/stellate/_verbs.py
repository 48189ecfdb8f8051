"""The verbs. Their options have the names and the defaults of the command line."""

from __future__ import annotations

import json
from dataclasses import dataclass
from fractions import Fraction
from os import PathLike
from pathlib import Path
from typing import Any, Sequence

import numpy as np
import numpy.typing as npt

from ._columns import Doubles, Inspection, Number, arrow, call, exact, inspection, rows_of, table
from ._form import Form, FormLike, form, from_points
from ._native import InputError


def _number(number: Number | None) -> str | None:
    return None if number is None else exact(number)


def _fit_options(options: dict[str, Any]) -> dict[str, Any]:
    """The options of a fit, with exact numbers as texts."""
    known = ("model", "harmonics", "tolerance", "distance", "power", "center", "samples",
             "estimator", "robust", "decimals", "time_limit", "max_degree")  # fmt: skip
    for name in options:
        if name not in known:
            raise TypeError(f"there is no option {name!r}; the options of a fit are {', '.join(known)}")
    result = dict(options)
    for name in ("tolerance", "distance", "power"):
        result[name] = _number(options.get(name))
    center = result.pop("center", None)
    if isinstance(center, str):
        result["center_choice"] = center
    elif center is not None:
        result["center"] = [exact(c) for c in center]
    return result


@dataclass(frozen=True)
class Fit:
    """A series that was fitted to an outline."""

    form: Form
    document: dict[str, Any]

    @property
    def max_radial_error(self) -> float | None:
        """The largest radial error at the samples (approximate); None for an elliptic series."""
        error = self.document.get("max_radial_error")
        return None if error is None else float(error)

    @property
    def distance(self) -> tuple[float, float] | None:
        """Certified bounds of the Hausdorff distance between the outline and the curve."""
        found = self.document.get("distance")
        return None if found is None else (float(found["low"]), float(found["high"]))


@dataclass(frozen=True)
class Samples:
    """Certified points, one element for each. ``directions`` holds the exact unit vectors."""

    branch: npt.NDArray[np.int64]
    theta: Doubles
    phi: Doubles | None
    r: Doubles
    x: Doubles
    y: Doubles
    z: Doubles | None
    multiplicity: npt.NDArray[np.int64]
    directions: list[tuple[Fraction, ...]]

    def toarrow(self) -> Any:
        """The columns as a ``pyarrow.Table`` (which must be installed); directions are left out."""
        return arrow(self, ("branch", "theta", "phi", "r", "x", "y", "z", "multiplicity"))


def _json(verb: str, given: FormLike, **options: Any) -> dict[str, Any]:
    found: dict[str, Any] = json.loads(call(verb, [form(given).source], **options))
    return found


def describe(given: FormLike, **fit: Any) -> dict[str, Any]:
    """What a form is: the document of the kind ``description``. Options: those of :func:`fit`.

    >>> import stellate
    >>> stellate.describe("x^4 - x^2 + y^2 = 0")["homogeneous_degrees"]
    [4, 2]
    """
    return _json("describe", given, **_fit_options(fit))


def implicitize(
    given: FormLike,
    *,
    method: str | None = None,
    scale: str = "integer",
    coordinates: str = "center",
    **fit: Any,
) -> Form:
    """The exact equation of a form (Theorems 1 to 4).

    >>> import stellate
    >>> stellate.implicitize("x = sin(t); y = sin(t)*cos(t)").terms
    {(4, 0): 1, (2, 0): -1, (0, 2): 1}
    """
    options = dict(method=method, scale=scale, coordinates=coordinates, **_fit_options(fit))
    return Form(call("implicitize", [form(given).source], **options).decode(), "implicitize")


def parametrize(
    given: FormLike,
    *,
    branch: int | None = None,
    theta: Sequence[float | str] = (),
    phi: Sequence[float | str] = (),
    **fit: Any,
) -> dict[str, Any]:
    """The radii r(θ) or R(θ, φ) of a form (Lemmas 2 to 10): the document of the kind ``parametric``."""
    options = dict(branch=branch, thetas=_angles(theta), phis=_angles(phi), **_fit_options(fit))
    return _json("parametrize", given, **options)


def fit(
    given: FormLike | npt.ArrayLike,
    harmonics: int | None = None,
    model: str = "radius",
    *,
    normal_form: bool = False,
    **options: Any,
) -> Fit:
    """A Fourier radius (``model="radius"``) or an elliptic series (``"elliptic"``) of an outline.

    The outline is an array of shape (n, 2), a path or a form. Without a size, N = 39. Further options: tolerance, distance, power (one of them
    in place of harmonics), center, samples, estimator, robust, decimals, time_limit, max_degree.
    """
    sized = any(options.get(name) is not None for name in ("tolerance", "distance", "power"))
    if harmonics is None and not sized:
        harmonics = 39
    is_form = isinstance(given, (Form, str, PathLike))
    outline = form(given) if is_form else from_points(given)  # type: ignore[arg-type]
    text = call(
        "fit", [outline.source], normal_form=normal_form,
        **_fit_options(dict(options, harmonics=harmonics, model=model)),
    ).decode()  # fmt: skip
    return Fit(Form(text, "fit"), json.loads(text))


def _angles(angles: Sequence[float | str] | float | str) -> list[str]:
    if isinstance(angles, (int, float, str)):
        angles = [angles]
    return [angle if isinstance(angle, str) else repr(float(angle)) for angle in angles]


def sample(
    given: FormLike,
    directions: int | None = None,
    *,
    theta: Sequence[float | str] = (),
    phi: Sequence[float | str] = (),
    coordinates: str = "center",
    positive: bool = False,
    **fit: Any,
) -> Samples:
    """All real points of a form in exact directions: each coordinate is the nearest double, and their number is proved.

    Angles are radians, or texts such as ``"pi/4"`` and ``"30deg"``.

    >>> import stellate
    >>> stellate.sample("x^2 + y^2 = 4", 4, positive=True).r
    array([2., 2., 2., 2.])
    """
    text = call(
        "sample", [form(given).source], directions=directions, thetas=_angles(theta), phis=_angles(phi),
        coordinates=coordinates, positive=positive, **_fit_options(fit),
    ).decode()  # fmt: skip
    rows = rows_of(text)

    def doubles(name: str) -> Doubles:
        return np.array([float(row[name]) for row in rows])

    def whole(name: str) -> npt.NDArray[np.int64]:
        return np.array([int(row[name]) for row in rows], dtype=np.int64)

    space = "phi" in text.split("\n", 2)[0] or (bool(rows) and "phi" in rows[0])
    axes = ("u", "v", "w") if space else ("u", "v")
    return Samples(
        branch=whole("branch"), theta=doubles("theta"), phi=doubles("phi") if space else None,
        r=doubles("r"), x=doubles("x"), y=doubles("y"), z=doubles("z") if space else None,
        multiplicity=whole("multiplicity"),
        directions=[tuple(Fraction(row[axis]) for axis in axes) for row in rows],
    )  # fmt: skip


def inspect(
    given: FormLike,
    points: npt.ArrayLike,
    tolerance: Number,
    *,
    reach: float | None = None,
    digits: int = 6,
    model: str = "radius",
    harmonics: int | None = None,
    distance: Number | None = None,
    time_limit: float | None = None,
) -> Inspection:
    """Whether points are within a tolerance of a form, exactly (Theorem 8), and certified bounds of their distances.

    ``points`` is an array of shape (n, 2) or (n, 3); each double is taken exactly.

    >>> import stellate
    >>> stellate.inspect("x^2 + y^2 = 1", [[1, 0], [3, 0]], tolerance=1).verdict.tolist()
    ['inside', 'outside']
    """
    text = call(
        "inspect", [form(given).source], table(points, ("x", "y", "z")), tolerance=exact(tolerance),
        reach=reach, digits=digits, model=model, harmonics=harmonics,
        distance=_number(distance), time_limit=time_limit,
    ).decode()  # fmt: skip
    return inspection(text)


def check(
    reference: FormLike,
    *,
    coefficients: dict[tuple[int, ...], float] | str | PathLike[str] | None = None,
    points: npt.ArrayLike | str | PathLike[str] | None = None,
    radii: npt.ArrayLike | str | PathLike[str] | None = None,
    digits: int | None = None,
    **fit: Any,
) -> dict[str, Any]:
    """How far the numbers of a float program are from the exact ones: the document of the kind ``check``.

    One of ``coefficients`` (exponents and values), ``points`` (an array of points) and ``radii`` (an array of angles and radii),
    or a path to a table of them.
    """
    given = [(k, v) for k, v in
             (("coefficients", coefficients), ("points", points), ("radii", radii)) if v is not None]  # fmt: skip
    if len(given) != 1:
        raise InputError("check needs one of coefficients, points and radii")
    kind, numbers = given[0]
    if isinstance(numbers, (str, PathLike)):
        data = Path(numbers).read_bytes()
    elif isinstance(numbers, dict):
        names = ("i", "j", "k")
        size = max(len(key) for key in numbers)
        rows = [",".join([*names[:size], "value"])]
        rows.extend(",".join([*map(str, key), repr(float(c))]) for key, c in numbers.items())
        data = ("\n".join(rows) + "\n").encode()
    else:
        data = table(numbers, ("x", "y", "z") if kind == "points" else ("theta", "r"))
    return dict(json.loads(call("check", [form(reference).source], data, kind=kind, digits=digits, **_fit_options(fit))))


def vectors(reference: FormLike, *, directions: int | None = None, **fit: Any) -> dict[str, Any]:
    """Test vectors for float programs: the document of the kind ``vectors``."""
    return _json("vectors", reference, directions=directions, **_fit_options(fit))


def plot(
    *forms: FormLike,
    output: str | PathLike[str] | None = None,
    window: Sequence[float] | None = None,
    title: str = "",
    **fit: Any,
) -> bytes:
    """A picture of forms over each other, as SVG, or as what the name of ``output`` says; it is written there, if it is given."""
    if not forms:
        raise InputError("plot needs a form")
    format = "svg" if output is None else Path(output).suffix.lstrip(".").lower()
    picture = call(
        "plot", [form(f).source for f in forms], format=format, title=title,
        window=None if window is None else [float(w) for w in window], **_fit_options(fit),
    )  # fmt: skip
    if output is not None:
        Path(output).write_bytes(picture)
    return picture


def mesh(given: FormLike, output: str | PathLike[str], *, resolution: int | None = None) -> None:
    """Writes the triangles of a surface as .obj, .ply or .stl."""
    format = Path(output).suffix.lstrip(".").lower()
    Path(output).write_bytes(call("mesh", [form(given).source], format=format, resolution=resolution))


def verify(proof: str | PathLike[str], *, complete: bool = False) -> dict[str, Any]:
    """Checks a proof file: ``holds``, the number of ``claims`` and of those ``without_witness``, and the report as ``text``."""
    return dict(json.loads(call("verify", [], Path(proof).read_bytes(), complete=complete)))


def schema(kind: str | None = None) -> dict[str, Any]:
    """The JSON Schema of a kind of document, or of all kinds."""
    return dict(json.loads(call("schema", [], kind=kind)))
