"""Theorem 2 in NumPy doubles, as one would write it: rows i,j,value of the implicit polynomial.

    stellate fit outline.csv --harmonics 39 --format csv | python3 theorem2.py > coefficients.csv

A form of degree d is the array of its coefficients of x^d, x^(d-1) y, ..., y^d, and a product of forms is a
convolution. F = (r^(N+1) - odd)^2 - r^2 even^2 for odd N, r^2 (r^N - odd)^2 - even^2 for even N, with first coefficient 1.
"""

import sys
from fractions import Fraction

import numpy as np


def read(lines):
    rows = [line.split(",") for line in lines if line[0].isdigit()]
    return [[float(Fraction(value)) for value in row[1:]] for row in rows]


def theorem2(pairs):
    n = len(pairs) - 1
    rho = np.array([1.0, 0.0, 1.0])

    def power(k):
        form = np.array([1.0])
        for _ in range(k):
            form = np.convolve(form, rho)
        return form

    z = np.array([1.0 + 0.0j])
    forms = []
    for a, b in pairs:
        forms.append(a * z.real + b * z.imag)
        z = np.convolve(z, [1.0, 1.0j])

    def total(parity):
        degree = n if n % 2 == parity else n - 1
        form = np.zeros(degree + 1)
        for m in range(parity, degree + 1, 2):
            form = form + np.convolve(forms[m], power((degree - m) // 2))
        return form

    even, odd = total(0), total(1)
    top = power(n + 1)
    middle = -2.0 * np.convolve(power(n // 2 + 1), odd)
    even2, odd2 = np.convolve(even, even), np.convolve(odd, odd)
    if n % 2 == 0:
        low = np.convolve(rho, odd2) - even2
    else:
        low = odd2 - np.convolve(rho, even2)
    return [top, middle, low]


if __name__ == "__main__":
    for part in theorem2(read(sys.stdin)):
        degree = len(part) - 1
        for j, value in enumerate(part):
            if value != 0.0:
                print(f"{degree - j},{j},{float(value)!r}")
