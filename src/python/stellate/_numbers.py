"""Exact numbers: from numbers of Python, NumPy, SymPy and others to texts that the program reads, and back."""

from __future__ import annotations

from fractions import Fraction
from operator import index
from typing import Any, Union

import numpy as np

from ._native import InputError

Number = Union[int, float, str, Fraction]

# Python refuses to convert integers and decimal texts of more than some digits; 640 is the least limit that can be set.
PART = 600


def exact(number: Any) -> str:
    """The text of a number. What has an exact value keeps it: ``0.1`` is the double, as in ``Fraction(0.1)``, and a ``Decimal``, a
    ``Float`` of SymPy or a ``longdouble`` is all its digits. A text is taken as it is written."""
    if isinstance(number, np.ndarray) and number.ndim == 0:
        number = number[()]
    if isinstance(number, str):
        return str(number)
    ratio = fraction(number)
    if ratio is None:
        return str(number)
    below = "" if ratio.denominator == 1 else f"/{_literal(ratio.denominator)}"
    return _literal(ratio.numerator) + below


def fraction(number: Any) -> Fraction | None:
    """The exact value of a number; None if it does not tell it."""
    # The parts of a float of SymPy and mpmath: sign, mantissa, exponent, and the length of the mantissa.
    parts = getattr(number, "_mpf_", None)
    try:
        if parts is not None:
            sign, mantissa, exponent, _ = parts
            if not mantissa and exponent:
                raise ValueError(number)
            return Fraction(-int(mantissa) if sign else int(mantissa)) * Fraction(2) ** int(exponent)
        if hasattr(number, "as_integer_ratio"):
            above, below = number.as_integer_ratio()
            return Fraction(int(above), int(below))
        return Fraction(index(number))
    except (ValueError, OverflowError) as error:
        raise InputError(f"{number} is not a number") from error
    except TypeError:
        return None


def value(text: str) -> int | Fraction:
    """The number that a text of a document is."""
    above, _, below = text.partition("/")
    try:
        number = Fraction(whole(above), whole(below) if below else 1)
    except ValueError:
        # A decimal, in a document that the program has not written.
        number = Fraction(text)
    return number.numerator if number.denominator == 1 else number


def whole(text: str) -> int:
    """The integer that a text is; any number of digits is read."""
    text = text.strip()
    if text.startswith(("-", "+")):
        return -whole(text[1:]) if text[0] == "-" else whole(text[1:])
    if text.startswith("0x"):
        return int(text.removesuffix("p0"), 16)
    if len(text) <= PART:
        return int(text)
    low = len(text) // 2
    return whole(text[:-low]) * int(10**low) + whole(text[-low:])


def digits(number: int) -> str:
    """The decimal text of an integer of any number of digits."""
    if number < 0:
        return "-" + digits(-number)
    # A bit is less than 0.302 digits.
    size = number.bit_length() * 302 // 1000 + 1
    if size <= PART:
        return str(number)
    low = size // 2
    above, below = divmod(number, 10**low)
    return digits(above) + digits(below).zfill(low)


def _literal(number: int) -> str:
    """The text of an integer as the program reads it: large ones in hexadecimal digits, of which Python converts any number."""
    return str(number) if number.bit_length() < 3 * PART else f"{hex(number)}p0"
