"""The inspection of record batches: a map stage of every engine that hands out Arrow tables, such as Spark, Dask and Ray.

>>> import pyarrow, stellate.batches
>>> inspect = stellate.batches.Inspect("x^2 + y^2 = 1", "1/10")
>>> batch = pyarrow.record_batch({"id": ["a", "b"], "x": [1.05, 2.0], "y": [0.0, 0.0]})
>>> inspect(batch).column("verdict").to_pylist()
['inside', 'outside']
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Iterable, Iterator, Sequence

from ._given import FormLike, form
from ._inspect import Tolerance, exact_tolerance, inspect
from ._options import READING, FitOptions, WorkOptions
from ._points import AXES
from ._verbs import fit

if TYPE_CHECKING:
    import pyarrow as pa

WORK = WorkOptions.__annotations__.keys()
# The options of the fit of an outline alone; the tolerance is that of the inspection.
FITTING = FitOptions.__annotations__.keys() - READING - WORK - {"tolerance"}


class Inspect:
    """A function of Arrow batches: the same rows in the same order, with the answers of `inspect` behind their columns.

    The answer to a row does not depend on the other rows, so it is the same for any partitioning. The function can be pickled: it carries
    the form itself, also where that was a file, which the other machines do not have. What it computes about the form is kept in the process
    for the next batch.

    Parameters
    ----------
    given : form, text or path
    tolerance : number or text, or a pair of them
        Exactly; see `stellate.inspect`.
    columns : sequence of str
        Those of the coordinates; the third may be missing.
    threads : int
        In each process: 1, since such engines run a process on each core.
    **options
        Those of `stellate.inspect`, and of how the form is read; for an outline, which is fitted here, those of `stellate.fit`.

    Raises
    ------
    InputError
        When it is called: for a column with the name of an answer.
    """

    def __init__(
        self,
        given: FormLike,
        tolerance: Tolerance,
        columns: Sequence[str] = AXES,
        *,
        reach: float | None = None,
        digits: int = 6,
        budget: int = 50_000,
        skip_bad: bool = False,
        **options: Any,
    ) -> None:
        # The form is read here, and an outline is fitted; what is carried is the exact form.
        how: dict[str, Any] = {k: options.pop(k) for k in READING & options.keys()}
        found = form(given, **how)
        self.options: dict[str, Any] = {"threads": 1, "reach": reach, "digits": digits, "budget": budget, **options}
        if found.kind == "contour":
            fitting: dict[str, Any] = {k: self.options.pop(k) for k in FITTING & self.options.keys()}
            work: dict[str, Any] = {k: self.options[k] for k in WORK & self.options.keys()}
            found = fit(found, **fitting, **work).form
        self.document = found.to_json()
        self.tolerance: Tolerance = exact_tolerance(tolerance)
        self.columns = tuple(columns)
        self.skip_bad = skip_bad

    def __call__(self, batch: pa.RecordBatch | pa.Table) -> pa.RecordBatch | pa.Table:
        """The batch with the answers."""
        import pyarrow

        table = inspect(
            _prepared(self.document), batch, self.tolerance, names=self.columns, keep=True,
            skip_bad=self.skip_bad, **self.options,
        ).to_arrow()  # fmt: skip
        if isinstance(batch, pyarrow.RecordBatch):
            return table.combine_chunks().to_batches()[0] if table.num_rows else _empty(table)
        return table

    def batches(self, batches: Iterable[pa.RecordBatch]) -> Iterator[pa.RecordBatch]:
        """The batches with the answers, one after the other: what ``DataFrame.mapInArrow`` of Spark takes."""
        return map(self, batches)


# The forms of this process, so that the tables for one are made once and not for every batch.
_FORMS: dict[str, Any] = {}


def _prepared(document: str) -> Any:
    found = _FORMS.get(document)
    if found is None:
        _FORMS.clear()
        found = _FORMS[document] = form(document)
    return found


def _empty(table: pa.Table) -> pa.RecordBatch:
    import pyarrow

    return pyarrow.RecordBatch.from_pylist([], schema=table.schema)
