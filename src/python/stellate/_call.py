"""Calls of the native functions, and exact numbers as texts."""

from __future__ import annotations

import json
import os
from fractions import Fraction
from typing import Any, Callable, Iterable, Union

import numpy as np

from . import _native

Number = Union[int, float, str, Fraction]
#: Called as ``progress(what, done, total)`` some ten times a second while a verb works.
Progress = Callable[[str, int, int], object]
# A text or a path, or the text of a document or table with a name for messages; and the options of how it is read, as JSON.
Source = tuple[str, Union[str, None], str]

# The answer that was finished when a limit ended the rest; None if there is none.
_native.LimitReached.finished = None


def exact(number: Number) -> str:
    """The text of a number: a float is its exact binary value, as in ``Fraction(0.1)``."""
    if isinstance(number, (float, np.floating)):
        try:
            return str(Fraction(float(number)))
        except (ValueError, OverflowError) as error:
            raise _native.InputError(f"{number} is not a number") from error
    if isinstance(number, (int, np.integer)):
        return str(int(number))
    return str(number)


def value(text: str) -> int | Fraction:
    """The number that a text of a document is."""
    number = Fraction(text)
    return number.numerator if number.denominator == 1 else number


def tell(notes: Iterable[str]) -> None:
    """Hands remarks to the logger ``stellate``."""
    for note in notes:
        import logging

        logging.getLogger("stellate").info(note)


def native_options(options: dict[str, Any]) -> str:
    return json.dumps({k: v for k, v in options.items() if v is not None})


def call(
    verb: str,
    sources: Iterable[Source],
    data: bytes = b"",
    *,
    proof: str | os.PathLike[str] | None = None,
    progress: Progress | None = None,
    **options: object,
) -> bytes:
    """Calls the native function of a verb."""
    if proof is not None:
        options["proof"] = True
    document, notes, missing, claims = _native.call(
        verb, list(sources), native_options(options), data, progress
    )
    tell(notes)
    if proof is not None and claims is not None:
        write(proof, claims.encode())
    if missing is not None:
        limit = _native.LimitReached(missing)
        limit.finished = document
        raise limit
    return document


def write(path: str | os.PathLike[str], content: bytes) -> None:
    """Writes a file beside its place, and renames it."""
    path = os.fspath(path)
    if os.path.exists(path) and not os.path.isfile(path):
        # A device or a pipe is written to.
        with open(path, "wb") as out:
            out.write(content)
        return
    beside = f"{path}.{os.getpid()}.part"
    try:
        with open(beside, "wb") as out:
            out.write(content)
        os.replace(beside, path)
    except OSError:
        if os.path.exists(beside):
            os.remove(beside)
        raise
