"""What every verb does with its arguments."""

from __future__ import annotations

import os
from os import PathLike
from typing import Sequence, Union

from ._call import Source
from ._form import FormLike, form
from ._options import Prepared

Path = Union[str, "PathLike[str]"]


def sources_of(given: FormLike, options: Prepared) -> list[Source]:
    return [form(given).source(options.reading)]


def extension(path: Path) -> str:
    """The extension of a name, in lower case and without its point."""
    return os.path.splitext(os.fspath(path))[1].lstrip(".").lower()


def floats(numbers: Sequence[float] | None) -> list[float] | None:
    """Numbers as floats of Python."""
    return None if numbers is None else [float(number) for number in numbers]
