"""Asks whether an equation changes its sign at the radius that mpmath computes from a file of coefficients.

Arguments: the file, `complex` (rows n m Re Im, orthonormal, with the Condon-Shortley phase) or `real` (rows l m C S, 4pi-normalized), and
the JSON document of the equation.
"""

import json
import sys

from mpmath import cos, factorial, mp, mpf, pi, polyval, sin, sqrt

mp.prec = 400


def read(path, is_complex):
    """The harmonics l, m >= 0 with the coefficients of cos m theta and sin m theta, of P_lm without the phase."""
    for line in open(path):
        words = line.split()
        if line.startswith("#") or len(words) != 4:
            continue
        l, m = int(words[0]), int(words[1])
        c, s = mpf(words[2]), mpf(words[3])
        if m < 0:
            continue
        norm = (2 - (m == 0)) * (2 * l + 1) * factorial(l - m) / factorial(l + m)
        if is_complex:
            norm = (-1) ** m * sqrt(norm * (2 - (m == 0)) / (4 * pi))
            yield l, m, norm * c, -norm * s
        else:
            yield l, m, sqrt(norm) * c, sqrt(norm) * s


def legendre(l, m):
    """The coefficients of P_lm / sin^m, from the highest power down, without the phase: the m-th derivative of the sum for P_l."""
    coefficients = [mpf(0)] * (l - m + 1)
    for k in range((l - m) // 2 + 1):
        below = 2**l * factorial(k) * factorial(l - k) * factorial(l - 2 * k - m)
        coefficients[2 * k] = (-1) ** k * factorial(2 * l - 2 * k) / below
    return coefficients


def radius(harmonics, theta, phi):
    total = mpf(0)
    for l, m, c, s, coefficients in harmonics:
        value = sin(phi) ** m * polyval(coefficients, cos(phi))
        total += value * (c * cos(m * theta) + s * sin(m * theta))
    return total


def main():
    path, kind, document = sys.argv[1:]
    harmonics = [(*row, legendre(*row[:2])) for row in read(path, kind == "complex")]
    terms = json.load(open(document))["terms"]
    terms = [(t["exponents"], int(t["coefficient"])) for t in terms]
    degree = max(sum(e) for e, _ in terms)

    def equation(point):
        powers = [[mpf(1)] for _ in point]
        for x, row in zip(point, powers):
            for _ in range(degree):
                row.append(row[-1] * x)
        return sum(c * powers[0][i] * powers[1][j] * powers[2][k] for (i, j, k), c in terms)

    changes = 0
    for k in range(100):
        theta = mpf((37 * k + 5) % 101) * 2 * pi / 101 + mpf(1) / 7
        phi = mpf((53 * k + 11) % 103 + 1) * pi / 105
        r = radius(harmonics, theta, phi)
        d = (sin(phi) * cos(theta), sin(phi) * sin(theta), cos(phi))
        ends = [equation([r * (1 + sign * mpf(2) ** -56) * x for x in d]) for sign in (-1, 1)]
        changes += ends[0] * ends[1] < 0
    print(f"100 directions, {changes} changes of sign")


main()
