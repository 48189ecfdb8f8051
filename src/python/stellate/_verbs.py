"""The verbs. Their options have the names and the defaults of the command line."""

from __future__ import annotations

import json
import os
from os import PathLike
from typing import TYPE_CHECKING, Any, Literal, Mapping, Sequence, Union, overload

import numpy as np
import numpy.typing as npt

from ._call import Number, Source, call, exact, native_options, write
from ._form import Form, FormLike, form, from_points
from ._native import InputError
from ._options import Center, CommonOptions, FitOptions, Prepared, SeriesOptions, prepared
from ._points import AXES, Points, columns, csv_table, good_rows
from ._results import Check, Fit, FitTable, Inspection, Mesh, Samples

if TYPE_CHECKING:
    from typing_extensions import Unpack

Path = Union[str, "PathLike[str]"]
Angles = Union[float, str, Sequence[Union[float, str]], npt.NDArray[np.float64]]
MESHES = (".obj", ".ply", ".stl")


class InspectOptions(CommonOptions, total=False):
    """How a contour becomes the form that points are compared with."""

    model: Literal["radius", "elliptic"]
    harmonics: int | None
    distance: Number | None
    center: Center


def _of(given: FormLike, options: Prepared) -> list[Source]:
    return [form(given).source(options.reading)]


def _json(verb: str, given: FormLike, options: Prepared, **more: Any) -> dict[str, Any]:
    found: dict[str, Any] = json.loads(call(verb, _of(given, options), **options.verb, **more))
    return found


def describe(
    given: FormLike,
    *,
    topology: bool = False,
    digits: int | None = None,
    proof: Path | None = None,
    **options: Unpack[FitOptions],
) -> dict[str, Any]:
    """What a form is, and what is certain about it: the document of the kind ``description``.

    Parameters
    ----------
    given : form, text or path
    topology : bool
        For plane curves: components and what contains what, exact extents, singular points, asymptotes, and the genus of each factor.
    digits : int
        The decimals of algebraic numbers; 16 by default.
    proof : path
        A file for everything that the result claims, with witnesses that `verify` checks.
    **options
        See `FitOptions`.

    >>> import stellate
    >>> stellate.describe("x^4 - x^2 + y^2 = 0")["homogeneous_degrees"]
    [4, 2]
    >>> found = stellate.describe("y^2 = x^3 - x", topology=True)["topology"]
    >>> sorted(piece["kind"] for piece in found["components"])
    ['oval', 'unbounded']
    """
    return _json("describe", given, prepared(dict(options), FitOptions),
                 topology=topology, digits=digits, proof=proof)  # fmt: skip


def implicitize(
    given: FormLike,
    *,
    method: Literal["polar", "resultant"] | None = None,
    scale: Literal["integer", "monic"] = "integer",
    coordinates: Literal["center", "original"] = "center",
    proof: Path | None = None,
    **options: Unpack[FitOptions],
) -> Form:
    """The exact equation of a form (Theorems 1 to 4).

    Parameters
    ----------
    given : form, text or path
        A Fourier radius, a contour, a parametric curve or patch, a harmonic surface, a superquadric, or an equation.
    method : {"polar", "resultant"}, optional
        The paper's substitution, or a resultant (plane curves).
    scale : {"integer", "monic"}
        Coprime integers with the first term positive, or first coefficient 1.
    coordinates : {"center", "original"}
        Relative to the center of a fit, or the contour's own.
    proof : path
        A file for everything that the result claims, with witnesses that `verify` checks.
    **options
        See `FitOptions`.

    Returns
    -------
    Form
        Of the kind ``implicit``; of a space curve ``intersection``.

    >>> import stellate
    >>> stellate.implicitize("x = sin(t); y = sin(t)*cos(t)").terms
    {(4, 0): 1, (2, 0): -1, (0, 2): 1}
    """
    asked = prepared(dict(options), FitOptions)
    text = call(
        "implicitize", _of(given, asked), method=method, scale=scale, coordinates=coordinates, proof=proof,
        **asked.verb,
    ).decode()  # fmt: skip
    return Form.of_document(text, "implicitize")


def parametrize(
    given: FormLike,
    *,
    theta: Angles = (),
    phi: Angles = (),
    branch: int | None = None,
    window: Sequence[float] | None = None,
    resolution: int | None = None,
    digits: int | None = None,
    proof: Path | None = None,
    **options: Unpack[FitOptions],
) -> dict[str, Any]:
    """The radii r(θ) or R(θ, φ) of a form (Lemmas 2 to 10): the document of the kind ``parametric``.

    Parameters
    ----------
    given : form, text or path
        An equation, a Fourier radius, a superquadric, a contour, or an intersection of two surfaces.
    theta, phi : angles
        For a surface: the meridians on which the exact ranges of φ are found, or with both the directions in which all is certain.
        Radians, or texts such as ``"pi/4"`` and ``"30deg"``.
    branch : int
        The branch to which a Fourier series is fitted where there is no closed form; the outermost by default.
    window, resolution
        For an intersection: the box (six numbers) in which the curve is followed, and the least number of steps along it.
    digits : int
        The decimals of the ends of ranges; 16 by default.
    proof : path
        A file for everything that the result claims, with witnesses that `verify` checks.
    **options
        See `FitOptions`.

    >>> import stellate
    >>> stellate.parametrize("x^2 + y^2 = 2x")["branches"][0]["radius"]
    '2*cos(theta)'
    """
    return _json(
        "parametrize", given, prepared(dict(options), FitOptions), thetas=_angles(theta), phis=_angles(phi),
        branch=branch, window=_floats(window), resolution=resolution, digits=digits, proof=proof,
    )  # fmt: skip


@overload
def fit(
    given: FormLike | Points, harmonics: int | None = ..., model: Literal["radius", "elliptic"] = ...,
    *, degree: int | None = ..., normal_form: bool = ..., all: Literal[False] = ...,
    proof: Path | None = ..., **options: Unpack[SeriesOptions],
) -> Fit: ...  # fmt: skip


@overload
def fit(
    given: FormLike | Points | Sequence[Path], harmonics: int | None = ...,
    model: Literal["radius", "elliptic"] = ...,
    *, all: Literal[True], normal_form: bool = ...,
    proof: Path | None = ..., **options: Unpack[SeriesOptions],
) -> FitTable: ...  # fmt: skip


def fit(
    given: FormLike | Points | Sequence[Path],
    harmonics: int | None = None,
    model: Literal["radius", "elliptic"] = "radius",
    *,
    degree: int | None = None,
    normal_form: bool = False,
    all: bool = False,
    proof: Path | None = None,
    **options: Unpack[SeriesOptions],
) -> Fit | FitTable:
    """A Fourier radius (``model="radius"``) or an elliptic series (``"elliptic"``) of an outline, or a harmonic surface of a closed mesh.

    Parameters
    ----------
    given : array of shape (n, 2), Arrow table, path or form
        The outline. A path of the extension .obj, .ply or .stl is a mesh, which needs ``degree`` or ``tolerance``.
    harmonics : int
        N; 39 if no other size is given.
    model : {"radius", "elliptic"}
    degree : int
        Of a mesh, the degree L of the harmonics.
    normal_form : bool
        An elliptic series without position, size, rotation, starting point and direction.
    all : bool
        All outlines of a picture, a drawing or GeoJSON, largest first, and of all files of a list: then a `FitTable` is returned.
    proof : path
        A file for everything that the result claims, with witnesses that `verify` checks.
    **options
        See `SeriesOptions`.

    >>> import numpy as np, stellate
    >>> angles = np.linspace(0, 2 * np.pi, 100, endpoint=False)
    >>> found = stellate.fit(np.column_stack([2 * np.cos(angles), np.sin(angles)]), 1, "elliptic")
    >>> stellate.implicitize(found.form).degree
    2
    """
    weights = options.get("weights")
    if weights is not None and not isinstance(weights, (str, int)):
        given = _weighted(given, weights)
        options["weights"] = "weight"
    asked = prepared(dict(options), SeriesOptions)
    verb = dict(asked.verb, normal_form=normal_form, model=model)
    is_name = isinstance(given, (str, PathLike))
    is_mesh = is_name and os.fspath(given).lower().endswith(MESHES)  # type: ignore[arg-type]
    sized = any(verb.get(name) is not None for name in ("tolerance", "distance", "power"))
    if degree is not None and not is_mesh:
        raise InputError("degree is for a closed mesh, a .obj, .ply or .stl file; a contour has harmonics")
    if harmonics is None and not sized and not is_mesh:
        harmonics = 39
    verb["harmonics"] = harmonics
    if all:
        several = given if isinstance(given, (list, tuple)) else [given]
        sources = [_outline(one).source(asked.reading) for one in several]
        return FitTable(call("fit_all", sources, proof=proof, **verb).decode())
    if is_mesh and asked.reading:
        raise InputError(f"{', '.join(asked.reading)}: options of contours; this is a mesh")
    text = call("fit", [_outline(given).source(asked.reading)], degree=degree, proof=proof, **verb).decode()
    found = Form.of_document(text, "fit")
    return Fit(found, found.document)


def _weighted(points: Any, weights: npt.ArrayLike) -> Form:
    """The outline with these vertices, each with a weight in a column of that name."""
    axes, _, _ = columns(points)
    column = np.asarray(weights, dtype=np.float64)
    if len(axes) != 2 or column.shape != axes[0].shape:
        raise InputError(f"weights: one for each of {axes[0].size} points is expected, not an array of shape {column.shape}")
    return Form(csv_table([*axes, column], ("x", "y", "weight")).decode(), "points.csv")


def _outline(given: Any) -> Form:
    is_form = isinstance(given, (Form, str, PathLike, Mapping)) or type(given).__module__.startswith("sympy")
    return form(given) if is_form else from_points(given)


def _angles(angles: Angles) -> list[str]:
    if isinstance(angles, str) or np.ndim(angles) == 0:
        angles = [angles]  # type: ignore[list-item]
    return [angle if isinstance(angle, str) else repr(float(angle)) for angle in angles]  # type: ignore[union-attr]


def _floats(numbers: Sequence[float] | None) -> list[float] | None:
    return None if numbers is None else [float(number) for number in numbers]


def sample(
    given: FormLike,
    directions: int | None = None,
    *,
    theta: Angles = (),
    phi: Angles = (),
    coordinates: Literal["center", "original"] = "center",
    positive: bool = False,
    window: Sequence[float] | None = None,
    resolution: int | None = None,
    proof: Path | None = None,
    **options: Unpack[FitOptions],
) -> Samples:
    """All real points of a form in exact directions: each coordinate is the nearest double, and their number is proved.

    Parameters
    ----------
    given : form, text or path
    directions : int
        So many around the circle, or spread over the sphere; 360 if no angle is given.
    theta, phi : angles
        Radians, or texts such as ``"pi/4"`` and ``"30deg"``; every θ is taken with every φ.
    coordinates : {"center", "original"}
    positive : bool
        Only points with r > 0.
    window, resolution
        For an intersection: the box (six numbers) in which the curve is followed, and the least number of steps along it.
    proof : path
        A file for everything that the result claims, with witnesses that `verify` checks.
    **options
        See `FitOptions`.

    >>> import stellate
    >>> stellate.sample("x^2 + y^2 = 4", 4, positive=True).r
    array([2., 2., 2., 2.])
    """
    asked = prepared(dict(options), FitOptions)
    text = call(
        "sample", _of(given, asked), directions=directions, thetas=_angles(theta), phis=_angles(phi),
        coordinates=coordinates, positive=positive, window=_floats(window), resolution=resolution,
        proof=proof, **asked.verb,
    ).decode()  # fmt: skip
    return Samples(text)


def inspect(
    given: FormLike,
    points: Points,
    tolerance: Number,
    *,
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
        Each double is taken exactly. Arrays and Arrow columns of doubles are read in place.
    tolerance : number or text
        The largest distance that is inside, exactly: ``"0.1"`` is a tenth, ``0.1`` the double.
    names : sequence of str
        Of a table: the columns of the coordinates; the third may be missing.
    reach : float
        Distances are looked for up to here; by default until the nearest point is found.
    digits : int
        The significant digits of the distances.
    budget : int
        Cubes that may be divided for one point before it is undecided.
    keep : bool
        ``to_arrow()`` begins with the columns of the table of points.
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
        For a form without points to compare with, or a point that is not finite, by its row from 0.

    >>> import stellate
    >>> stellate.inspect("x^2 + y^2 = 1", [[1, 0], [3, 0]], tolerance=1).verdict.tolist()
    ['inside', 'outside']
    """
    asked = prepared(dict(options), InspectOptions)
    axes, shape, table = columns(points, names)
    if keep and table is None:
        raise InputError("keep is for tables; an array has no other columns")
    row = np.arange(axes[0].size)
    if skip_bad:
        good = good_rows(axes)
        if not good.all():
            axes, row = [axis[good] for axis in axes], row[good]
            shape = row.shape
    progress = asked.verb.pop("progress", None)
    verb = dict(asked.verb, tolerance=exact(tolerance), reach=reach, digits=digits, budget=budget)
    found = form(given)
    inspector = found._inspector(len(axes), native_options(verb), asked.reading, progress)
    answers = inspector.inspect(axes, progress)
    _draw(found.source(asked.reading), csv_table(axes, AXES) if plot or report or cloud or proof else b"",
          dict(verb, window=_floats(window)), plot, report, cloud, proof)  # fmt: skip
    return Inspection(answers, shape, row, table if keep else None)


def _draw(
    source: Source, rows: bytes, verb: dict[str, Any],
    plot: Path | None, report: Path | None, cloud: Path | None, proof: Path | None,
) -> None:  # fmt: skip
    """Writes what is asked for beside the columns of an inspection."""
    if plot is not None:
        write(plot, call("inspect", [source], rows, kind="plot", format=_extension(plot), **verb))
    if report is not None:
        page = call("inspect", [source], rows, kind="report", **verb)
        os.makedirs(report, exist_ok=True)
        write(os.path.join(report, "index.html"), page)
    if cloud is not None:
        if _extension(cloud) != "ply":
            raise InputError(f"cloud {os.fspath(cloud)}: a cloud of points is a .ply file")
        write(cloud, call("inspect", [source], rows, kind="cloud", **verb))
    if proof is not None:
        call("inspect", [source], rows, proof=proof, **verb)


def _extension(path: Path) -> str:
    return os.path.splitext(os.fspath(path))[1].lstrip(".").lower()


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
    sources = _of(reference, asked)
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
        write(plot, call("check", sources, data, format=_extension(plot) or "none", **verb))
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


def vectors(
    reference: FormLike, *, directions: int | None = None, **options: Unpack[FitOptions]
) -> dict[str, Any]:
    """Test vectors for float programs: the document of the kind ``vectors``.

    Parameters
    ----------
    reference : form, text or path
    directions : int
        Certified radii and points in so many directions around the circle; 16 by default.
    **options
        See `FitOptions`.
    """
    return _json("vectors", reference, prepared(dict(options), FitOptions), directions=directions)


def plot(
    *forms: FormLike,
    output: Path | None = None,
    window: Sequence[float] | None = None,
    range: Mapping[str, tuple[float, float]] | None = None,
    view: tuple[float, float] | None = None,
    title: str = "",
    width: int | None = None,
    cells: int | None = None,
    point: Sequence[Sequence[float]] = (),
    **options: Unpack[FitOptions],
) -> bytes:
    """A picture of forms over each other.

    Parameters
    ----------
    *forms : forms, texts or paths
        From the lowest to the topmost.
    output : path
        A .svg or .png file that is written, too.
    window : four numbers, in space six
        The part that is shown.
    range : mapping of str to pairs
        The ranges of parameters that are drawn.
    view : pair of float, in degrees
        In space: where the eye is, from +x towards +y, and above the plane of x and y.
    title : str
    width : int
        In units of the SVG, from 300 to 4000.
    cells : int
        Along the larger side, for tracing.
    point : sequence of points
        In space: points to be marked.
    **options
        See `FitOptions`.

    Returns
    -------
    bytes
        The SVG, or what the name of ``output`` says.
    """
    if not forms:
        raise InputError("plot needs a form")
    asked = prepared(dict(options), FitOptions)
    picture = call(
        "plot", [form(f).source(asked.reading) for f in forms], format="svg" if output is None else _extension(output),
        title=title, window=_floats(window), view=_floats(view), width=width, cells=cells,
        ranges=[(name, [float(a), float(b)]) for name, (a, b) in (range or {}).items()],
        points=[_floats(p) for p in point], **asked.verb,
    )  # fmt: skip
    if output is not None:
        write(output, picture)
    return picture


def mesh(
    given: FormLike,
    output: Path | None = None,
    *,
    window: Sequence[float] | None = None,
    resolution: int = 64,
    angle: float = 20.0,
    solid: bool = False,
    **options: Unpack[CommonOptions],
) -> Mesh:
    """Triangles of a surface: every sheet, with certified vertices.

    Parameters
    ----------
    given : form, text or path
    output : path
        A .obj, .ply or .stl file that is written, too.
    window : six numbers
        The box that is covered; around the surface by default.
    resolution : int
        Cells along the longest side of the box.
    angle : float, in degrees
        Edges are split where the surface bends by more than this.
    solid : bool
        Turn closed pieces inside others inward.
    **options
        See `CommonOptions`.

    >>> import stellate
    >>> stellate.mesh("x^2 + y^2 + z^2 = 1", resolution=8).triangles.shape[1]
    3
    """
    asked = prepared(dict(options), CommonOptions)
    more = dict(window=_floats(window), resolution=resolution, angle=angle, solid=solid, **asked.verb)
    if output is not None and _extension(output) != "ply":
        write(output, call("mesh", _of(given, asked), format=_extension(output) or "none", **more))
    ply = call("mesh", _of(given, asked), format="ply", **more)
    if output is not None and _extension(output) == "ply":
        write(output, ply)
    return Mesh(ply)


def verify(proof: Path, *, complete: bool = False) -> dict[str, Any]:
    """Checks a proof file: ``holds``, the number of ``claims`` and of those ``without_witness``, and the report as ``text``."""
    with open(proof, "rb") as file:
        return dict(json.loads(call("verify", [], file.read(), complete=complete)))


def schema(kind: str | None = None) -> dict[str, Any]:
    """The JSON Schema of a kind of document, or of all kinds."""
    return dict(json.loads(call("schema", [], kind=kind)))
