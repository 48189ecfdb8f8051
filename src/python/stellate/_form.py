"""Forms: curves and surfaces, exactly."""

from __future__ import annotations

import json
import os
from fractions import Fraction
from typing import TYPE_CHECKING, Any

import numpy as np
import numpy.typing as npt

from . import _native
from ._call import Progress, Source, call, native_options, tell
from ._numbers import value
from ._points import Doubles, Points, columns
from ._results import NONE
from ._symbols import to_latex, to_sympy

if TYPE_CHECKING:
    import sympy

# As many inspectors are kept with a form; each has the tables that it needs for fast answers.
KEPT = 8


class Form:
    """A curve or surface: its text, a document, or the rows of an outline.

    The exact numbers of a form are ``int`` or ``fractions.Fraction``.

    Two forms are equal if they are of one kind, have the same exact data and the same center; outlines, if they have the same vertices from
    the same first one on, with the same weights, wherever they were read. Equations are F = 0, so they are equal up to
    a constant factor of F; a curve and a radius that describe the same points are different forms. Equal forms have equal hashes.

    >>> import stellate
    >>> circle = stellate.form("x^2 + y^2 = 1/4")
    >>> circle.terms
    {(2, 0): 1, (0, 2): 1, (0, 0): Fraction(-1, 4)}
    >>> circle == stellate.form("4x^2 + 4y^2 = 1")
    True
    """

    __slots__ = ("_document", "_inspectors", "_key", "_radius", "place", "reading", "text")

    def __init__(self, text: str, place: str | None = None, reading: dict[str, Any] | None = None) -> None:
        #: A text of the input language or a path, or the content of a document or table.
        self.text = text
        #: The name of that content in messages; None for a text or a path.
        self.place = place
        #: How the form is read.
        self.reading = reading or {}
        self._document: dict[str, Any] | None = None
        self._key: tuple[Any, ...] | None = None
        self._radius: _native.Radius | None = None
        self._inspectors: dict[tuple[str, int], _native.Inspector] = {}

    @classmethod
    def of_document(cls, text: str, place: str) -> Form:
        """The form of a document that a verb has written, with all that it says."""
        form = cls(text, place)
        form._document = json.loads(text)
        return form

    def source(self, reading: dict[str, Any] | None = None) -> Source:
        """The form as the native functions take it, with further options of how it is read."""
        return (self.text, self.place, native_options({**self.reading, **(reading or {})}))

    @property
    def document(self) -> dict[str, Any]:
        """The JSON document of the form, with exact numbers as texts."""
        if self._document is None:
            self._document = json.loads(call("form", [self.source()]))
        return self._document

    def to_json(self) -> str:
        """The JSON document as a text, which every verb reads."""
        return json.dumps(self.document)

    @property
    def kind(self) -> str:
        """The kind of the document: implicit, intersection, fourier, spherical, parametric, superquadric; or contour."""
        return str(self.document["kind"])

    def _implicit(self) -> dict[str, Any]:
        if self.kind != "implicit":
            raise _native.InputError(
                f"this form is of the kind {self.kind}; stellate.implicitize gives its equation"
            )
        return self.document

    def _series(self, name: str) -> list[int | Fraction]:
        if self.kind != "fourier":
            raise _native.InputError(f"this form is of the kind {self.kind}, and has no cos and sin")
        return [value(text) for text in self.document[name]]

    @property
    def terms(self) -> dict[tuple[int, ...], int | Fraction]:
        """The terms of an equation: exponents and coefficients."""
        return _terms(self._implicit())

    @property
    def degree(self) -> int:
        """The total degree of an equation."""
        return int(self._implicit()["degree"])

    @property
    def parts(self) -> list[int]:
        """The degrees of the homogeneous parts of an equation, descending."""
        return [int(d) for d in self._implicit()["homogeneous_degrees"]]

    @property
    def cos(self) -> list[int | Fraction]:
        """The coefficients of the cosines of a Fourier radius, from 0 to N."""
        return self._series("cos")

    @property
    def sin(self) -> list[int | Fraction]:
        """The coefficients of the sines of a Fourier radius, from 0 to N."""
        return self._series("sin")

    @property
    def coefficients(self) -> dict[tuple[int, int], int | Fraction]:
        """The coefficients of a harmonic surface, by (l, m), for unnormalised harmonics without the Condon–Shortley phase."""
        if self.kind != "spherical":
            raise _native.InputError(f"this form is of the kind {self.kind}, and has no coefficients (l, m)")
        return {
            (int(entry["l"]), int(entry["m"])): value(entry["value"])
            for entry in self.document["coefficients"]
        }

    @property
    def center(self) -> tuple[int | Fraction, ...] | None:
        """The origin of the form's coordinates in the contour's own; None if they are the same."""
        found = self.document.get("center")
        return None if found is None else tuple(value(text) for text in found)

    def sympy(self) -> sympy.Basic:
        """The form as a SymPy expression.

        Of an equation its polynomial F; of a Fourier radius r in the symbol ``theta``, of a harmonic surface R in ``theta`` and ``phi``; of
        a parametric form a ``Tuple`` of the coordinates, of an intersection one of the polynomials; of a superquadric its F. It is relative
        to the center of the form, which is no part of the expression; `center` tells it.

        Raises
        ------
        ImportError
            If SymPy is not installed.
        InputError
            For a contour.
        """
        return to_sympy(self)

    def latex(self) -> str:
        """The form in LaTeX: an equation, or one for each coordinate or surface, with line breaks between them; behind it the center."""
        return to_latex(self)

    def _repr_latex_(self) -> str | None:
        if self.kind == "contour":
            return None
        text = self.latex()
        return rf"$\displaystyle \begin{{gathered}} {text} \end{{gathered}}$" if r"\\" in text else f"${text}$"

    def _repr_svg_(self) -> str:
        return call("plot", [self.source()], format="svg").decode()

    def radius(self, theta: npt.ArrayLike, phi: npt.ArrayLike | None = None) -> Doubles:
        """The radius in directions, in double precision, from the origin of the form's own coordinates.

        Parameters
        ----------
        theta, phi : array_like of float, in radians
            The angle from +x towards +y and, for a surface, that from +z; they are broadcast against each other.

        Returns
        -------
        ndarray of float64
            Of the shape of the angles. Of a Fourier radius r(θ), approximate: about 16 digits of the largest coefficient. Of a harmonic
            surface R(θ, φ), of equations and superquadrics the outermost r > 0, each the double nearest to the exact radius in the rational
            direction nearest to the angles; NaN where there is none.

        Raises
        ------
        InputError
            For contours and parametric forms, and for angles that are not finite.

        >>> import stellate
        >>> stellate.form("r = 2 + cos(t)").radius([0.0]).tolist()
        [3.0]
        >>> float(stellate.form("x^2 + y^2 = 4x").radius(0.0))
        4.0
        """
        if self._radius is None:
            self._radius = _native.Radius(self.source())
        angles = [np.asarray(theta, dtype=np.float64)]
        if phi is not None:
            angles = list(np.broadcast_arrays(angles[0], np.asarray(phi, dtype=np.float64)))
        flat = [angle.reshape(-1) for angle in angles]
        found = self._radius.at(flat[0], flat[1] if phi is not None else None)
        return found.reshape(angles[0].shape)[()]

    def _inspector(
        self, dimension: int, options: str, reading: dict[str, Any], progress: Progress | None
    ) -> _native.Inspector:
        """The inspector with these options, which is kept. One that may never be over is made once."""
        source = self.source(reading)
        key = (source[2] + options, dimension)
        known = self._inspectors.get(key)
        if known is None or known.is_over:
            known = _native.Inspector(source, options, dimension, progress)
            tell(known.notes)
            if '"time_limit"' in options:
                return known
            while len(self._inspectors) >= KEPT:
                del self._inspectors[next(iter(self._inspectors))]
            self._inspectors[key] = known
        return known

    def sign(self, points: Points, *, progress: Progress | None = None) -> npt.NDArray[np.int8]:
        """The side of each point, exactly.

        Parameters
        ----------
        points : array_like of float64, shape (…, 2) or (…, 3), or an Arrow table with columns x, y and z
            In original coordinates; each double is taken exactly.

        Returns
        -------
        ndarray of int8, shape (…)
            −1 inside, 0 on the form, 1 outside. Of an equation, the sign of its polynomial with a positive first term.

        Raises
        ------
        InputError
            For open curves and space curves, which have no sides; for points that are not finite, by their row.

        >>> import stellate
        >>> stellate.form("r = 1 + cos(3*t)/8").sign([[0, 0], [1.125, 0], [2, 0]])
        array([-1,  0,  1], dtype=int8)
        """
        axes, shape, _ = columns(points)
        found = self._inspector(len(axes), "{}", {}, progress).sign(axes, progress)
        if (found == NONE).any():
            raise _native.InputError(
                "a point has no side: this form is no closed curve or surface, or it is not decided"
            )
        return found.reshape(shape)[()]

    def distance(
        self, points: Points, *, digits: int = 6, progress: Progress | None = None
    ) -> tuple[Doubles, Doubles]:
        """Certified bounds of the distance of each point from the form.

        Parameters
        ----------
        points : array_like of float64, shape (…, 2) or (…, 3), or an Arrow table with columns x, y and z
        digits : int
            The significant digits that the bounds should determine.

        Returns
        -------
        low, high : ndarray of float64, shape (…)

        >>> import stellate
        >>> low, high = stellate.form("x^2 + y^2 = 4").distance([0, 5])
        >>> bool(low <= 3 <= high and high - low < 1e-5)
        True
        """
        axes, shape, _ = columns(points)
        options = native_options({"digits": digits})
        found = self._inspector(len(axes), options, {}, progress).inspect(axes, progress)
        low, high = (bound.reshape(shape)[()] for bound in found[2:4])
        return low, high

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Form) and self._identity() == other._identity()

    def __hash__(self) -> int:
        return hash(self._identity())

    def _identity(self) -> tuple[Any, ...]:
        """What makes a form equal to another."""
        if self._key is None:
            self._key = _identity(self.document)
        return self._key

    def __reduce__(self) -> tuple[type[Form], tuple[str, str | None, dict[str, Any]]]:
        # A file may be elsewhere, or another one, where this is read again.
        if self.place is None and os.path.exists(self.text):
            return (Form, (self.to_json(), os.path.basename(self.text), {}))
        return (Form, (self.text, self.place, self.reading))

    def __repr__(self) -> str:
        if self.place is not None:
            return f"<stellate form from {self.place}>"
        how = "".join(f", {name}={option!r}" for name, option in self.reading.items())
        return f"stellate.form({self.text!r}{how})"


def _terms(document: dict[str, Any]) -> dict[tuple[int, ...], int | Fraction]:
    return {tuple(term["exponents"]): value(term["coefficient"]) for term in document["terms"]}


def _identity(document: dict[str, Any]) -> tuple[Any, ...]:
    kind = document["kind"]
    center = tuple(value(c) for c in document.get("center", ()))
    placed = (kind, center if any(center) else ())
    if kind == "implicit":
        terms = sorted(_terms(document).items(), reverse=True)
        first = terms[0][1] if terms else 1
        monic = tuple((exponents, Fraction(c) / first) for exponents, c in terms)
        return (*placed, len(document["variables"]), monic)
    if kind == "intersection":
        return (*placed, tuple(_identity(surface) for surface in document["surfaces"]))
    if kind == "fourier":
        pairs = [(value(a), value(b)) for a, b in zip(document["cos"], document["sin"])]
        while len(pairs) > 1 and not any(pairs[-1]):
            pairs.pop()
        return (*placed, tuple(pairs))
    if kind == "spherical":
        values = {(c["l"], c["m"]): value(c["value"]) for c in document["coefficients"]}
        return (*placed, tuple(sorted((k, v) for k, v in values.items() if v)))
    if kind == "contour":
        vertices = tuple(tuple(point) for point in document["points"])
        return (kind, document["cloud"], document["resolution"], vertices, tuple(document["weights"]))
    names = ("parameters", "coordinates", "dimension", "a", "e", "level")
    return (*placed, json.dumps({k: document[k] for k in names if k in document}, sort_keys=True))
