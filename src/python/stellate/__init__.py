"""Exact conversion between parametric and implicit forms of star-shaped curves and surfaces.

>>> import stellate
>>> curve = stellate.implicitize("r = 1 + cos(t)/5")
>>> curve.degree, curve.parts
(4, [4, 3, 2])
"""

from ._columns import Inspection
from ._form import Form, form, from_points, from_series, from_terms
from ._native import (
    InputError,
    InternalError,
    LimitReached,
    StellateError,
    __version__,
)
from ._verbs import (
    Fit,
    Samples,
    check,
    describe,
    fit,
    implicitize,
    inspect,
    mesh,
    parametrize,
    plot,
    sample,
    schema,
    vectors,
    verify,
)

__all__ = [
    "Fit",
    "Form",
    "InputError",
    "Inspection",
    "InternalError",
    "LimitReached",
    "Samples",
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
