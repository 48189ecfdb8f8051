"""Calls of the native functions."""

from __future__ import annotations

import json
import os
from math import isfinite
from operator import index
from typing import Any, Callable, Iterable, Union

import numpy as np

from . import _native

#: Called as ``progress(what, done, total)`` some ten times a second while a verb works.
Progress = Callable[[str, int, int], object]
# Options that the native functions take by another name.
RENAMED = {"ranges": "range", "points": "point", "thetas": "theta", "phis": "phi"}
# A text or a path, or the text of a document or table with a name for messages; and the options of how it is read, as JSON.
Source = tuple[str, Union[str, None], str]

# The answer that was finished when a limit ended the rest; None if there is none.
_native.LimitReached.finished = None


def tell(notes: Iterable[str]) -> None:
    """Hands remarks to the logger ``stellate``."""
    for note in notes:
        import logging

        logging.getLogger("stellate").info(note)


def native_options(options: dict[str, Any]) -> str:
    """The options that are given as the native functions take them, with numbers of Python for those of NumPy."""
    return json.dumps({k: _plain(RENAMED.get(k, k), v) for k, v in options.items() if v is not None})


def _plain(name: str, value: Any) -> Any:
    """An option without numbers of NumPy; a number that no option can be is refused."""
    if isinstance(value, (np.ndarray, np.generic)):
        value = value.tolist()
    if isinstance(value, (list, tuple)):
        return [_plain(name, one) for one in value]
    if isinstance(value, (str, bool)):
        return value
    try:
        return index(value)
    except TypeError:
        pass
    try:
        number = float(value)
    except (TypeError, ValueError, OverflowError) as error:
        raise _native.InputError(f"{name}: {value!r} is neither a number nor a text") from error
    if not isfinite(number):
        raise _native.InputError(f"{name}: {number} is not a finite number")
    return number


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
