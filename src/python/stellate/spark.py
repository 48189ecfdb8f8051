"""Inspection on Apache Spark."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Sequence

from ._given import FormLike
from ._inspect import Tolerance
from ._points import AXES
from ._results import answer_columns, refuse_answers
from .batches import Inspect

if TYPE_CHECKING:
    from pyspark.sql import DataFrame


def inspect(
    df: DataFrame,
    form: FormLike,
    tolerance: Tolerance,
    columns: Sequence[str] = AXES,
    **options: Any,
) -> DataFrame:
    """The rows of a data frame with ``verdict, curve, distance_low, distance_high`` and ``sign`` behind their columns.

    It is ``DataFrame.mapInArrow`` of `stellate.batches.Inspect`, so the verdicts are those of the program, for any partitioning. Every worker
    needs this package and pyarrow.

    Parameters
    ----------
    df : pyspark.sql.DataFrame
    form : form, text or path
        A path is read on the driver.
    tolerance : number or text, or a pair of limits
        Exactly: ``"0.1"`` is a tenth.
    columns : sequence of str
        Those of the coordinates; the third may be missing.
    **options
        Those of `stellate.batches.Inspect`.

    Returns
    -------
    pyspark.sql.DataFrame
        Lazily, as everything in Spark.

    Raises
    ------
    InputError
        For a column with the name of an answer.
    """
    from pyspark.sql.types import StructType

    dimension = sum(column in df.columns for column in columns)
    answers = answer_columns(dimension, bool(options.get("feet")))
    refuse_answers(df.columns, answers)
    stage = Inspect(form, tolerance, columns, **options)
    schema = StructType(list(df.schema.fields))
    for name, kind in answers.items():
        schema = schema.add(name, kind)
    return df.mapInArrow(stage.batches, schema)
