"""The verbs. Their options have the names and the defaults of the command line."""

from __future__ import annotations

import json
import os
from os import PathLike
from typing import TYPE_CHECKING, Any, Literal, Mapping, Sequence, Union, overload

import numpy as np
import numpy.typing as npt

from ._call import call, write
from ._fit import Fit, FitTable
from ._form import Form
from ._given import FormLike, Path, extension, floats, form, from_points, sources_of, vertices
from ._native import InputError
from ._options import CommonOptions, FitOptions, Prepared, SeriesOptions, prepared
from ._points import Points, csv_table, doubles
from ._results import Mesh, Samples

if TYPE_CHECKING:
    from typing_extensions import Unpack

Angles = Union[float, str, Sequence[Union[float, str]], npt.NDArray[np.float64]]
MESHES = (".obj", ".ply", ".stl")


def _json(verb: str, given: FormLike, options: Prepared, **more: Any) -> dict[str, Any]:
    found: dict[str, Any] = json.loads(call(verb, sources_of(given, options), **options.verb, **more))
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
        "implicitize", sources_of(given, asked), method=method, scale=scale, coordinates=coordinates, proof=proof,
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
        branch=branch, window=floats(window), resolution=resolution, digits=digits, proof=proof,
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
    if weights is not None and np.ndim(weights) > 0:
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
    axes = vertices(points)
    column = doubles(weights, "weights")
    if column.shape != axes[0].shape:
        raise InputError(f"weights: one for each of {axes[0].size} points is expected, not an array of shape {column.shape}")
    wrong = np.flatnonzero(~(np.isfinite(column) & (column >= 0)))
    if wrong.size:
        raise InputError(
            f"weights: that of the point {wrong[0]} is {column[wrong[0]]}; a weight is a number that is at least 0"
        )
    return Form(csv_table([*axes, column], ("x", "y", "weight")).decode(), "points.csv")


def _outline(given: Any) -> Form:
    is_form = isinstance(given, (Form, Fit, str, PathLike, Mapping)) or type(given).__module__.startswith("sympy")
    return form(given) if is_form else from_points(given)


def _angles(angles: Angles) -> list[str]:
    if isinstance(angles, str) or np.ndim(angles) == 0:
        angles = [angles]  # type: ignore[list-item]
    return [angle if isinstance(angle, str) else repr(float(angle)) for angle in angles]  # type: ignore[union-attr]


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
        "sample", sources_of(given, asked), directions=directions, thetas=_angles(theta), phis=_angles(phi),
        coordinates=coordinates, positive=positive, window=floats(window), resolution=resolution,
        proof=proof, **asked.verb,
    ).decode()  # fmt: skip
    return Samples(text)


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
        "plot", [form(f).source(asked.reading) for f in forms], format="svg" if output is None else extension(output),
        title=title, window=floats(window), view=floats(view), width=width, cells=cells,
        ranges=[(name, [float(a), float(b)]) for name, (a, b) in (range or {}).items()],
        points=[floats(p) for p in point], **asked.verb,
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
    more = dict(window=floats(window), resolution=resolution, angle=angle, solid=solid, **asked.verb)
    if output is not None and extension(output) != "ply":
        write(output, call("mesh", sources_of(given, asked), format=extension(output) or "none", **more))
    ply = call("mesh", sources_of(given, asked), format="ply", **more)
    if output is not None and extension(output) == "ply":
        write(output, ply)
    return Mesh(ply)


def verify(proof: Path, *, complete: bool = False) -> dict[str, Any]:
    """Checks a proof file: ``holds``, the number of ``claims`` and of those ``without_witness``, and the report as ``text``."""
    with open(proof, "rb") as file:
        return dict(json.loads(call("verify", [], file.read(), complete=complete)))


def schema(kind: str | None = None) -> dict[str, Any]:
    """The JSON Schema of a kind of document, or of all kinds."""
    return dict(json.loads(call("schema", [], kind=kind)))
