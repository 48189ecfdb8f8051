"""Exact conversion between parametric and implicit forms of star-shaped curves and surfaces.

>>> import stellate
>>> curve = stellate.implicitize("r = 1 + cos(t)/5")
>>> curve.degree, curve.parts
(4, [4, 3, 2])

Exact numbers are ``int`` and ``fractions.Fraction``; a float that is given is taken exactly, bit for bit. Coordinates of points are doubles,
and what would be rounded to one is refused. Angles are in radians. Remarks of the verbs go to the logger ``stellate``, at the level INFO.
"""

from ._check import check
from ._fit import Fit, FitTable
from ._form import Form
from ._given import form, from_points, from_series, from_terms
from ._inspect import InspectOptions, inspect
from ._native import (
    InputError,
    InternalError,
    LimitReached,
    StellateError,
    __version__,
)
from ._options import CommonOptions, FitOptions, ReadingOptions, SeriesOptions
from ._results import Check, Inspection, Mesh, Samples
from ._verbs import (
    describe,
    fit,
    implicitize,
    mesh,
    parametrize,
    plot,
    sample,
    schema,
    vectors,
    verify,
)

__all__ = [
    "Check",
    "CommonOptions",
    "Fit",
    "FitOptions",
    "FitTable",
    "Form",
    "InputError",
    "InspectOptions",
    "Inspection",
    "InternalError",
    "LimitReached",
    "Mesh",
    "ReadingOptions",
    "Samples",
    "SeriesOptions",
    "StellateError",
    "__version__",
    "check",
    "describe",
    "fit",
    "form",
    "from_points",
    "from_series",
    "from_terms",
    "implicitize",
    "inspect",
    "mesh",
    "parametrize",
    "plot",
    "sample",
    "schema",
    "vectors",
    "verify",
]
