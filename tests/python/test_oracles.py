"""Random forms against python-flint and SymPy, which share no code with stellate."""

import random
from fractions import Fraction

import numpy as np
import pytest

import stellate

flint = pytest.importorskip("flint")
SEEDS = range(6)


def rational(rng, size=9):
    return Fraction(rng.randint(-size, size), rng.randint(1, size))


def fmpq(number):
    return flint.fmpq(number.numerator, number.denominator)


def series(rng, order):
    """A Fourier radius with both odd and even harmonics."""
    cos = [Fraction(3)] + [rational(rng) for _ in range(order)]
    sin = [Fraction(0)] + [rational(rng) for _ in range(order)]
    cos[order] = cos[order] or Fraction(1, 2)
    return cos, sin


def monic(terms):
    first = Fraction(terms[max(terms)])
    return {exponents: c / first for exponents, c in terms.items()}


def terms_of(polynomial):
    return {tuple(map(int, e)): Fraction(int(c.p), int(c.q)) for e, c in polynomial.to_dict().items()}


@pytest.mark.parametrize("seed", SEEDS)
def test_theorem_2_is_the_square_of_the_even_and_the_odd_part(seed):
    """ρ^(N+1) = Σ ρ^(N−n) (a_n Re z^n + b_n Im z^n) is E + Oρ = 0 with polynomials E and O, and F = E² − ρ² O² up to a factor."""
    rng = random.Random(seed)
    order = 1 + seed
    cos, sin = series(rng, order)
    ring = flint.fmpq_mpoly_ctx.get(("x", "y"), "lex")
    x, y = ring.gens()
    square = x * x + y * y
    parts = [x * 0, x * 0]
    real, imaginary = x * 0 + 1, x * 0
    for n in range(order + 1):
        power = order - n
        parts[power % 2] -= square ** (power // 2) * (fmpq(cos[n]) * real + fmpq(sin[n]) * imaginary)
        real, imaginary = x * real - y * imaginary, x * imaginary + y * real
    parts[(order + 1) % 2] += square ** ((order + 1) // 2)
    even, odd = parts
    expected = even * even - square * odd * odd
    form = stellate.implicitize(stellate.from_series(cos, sin))
    assert form.degree == 2 * order + 2
    assert monic(form.terms) == monic(terms_of(expected))


@pytest.mark.parametrize("seed", SEEDS)
def test_parametric_curves_against_the_resultant_of_sympy(seed):
    sympy = pytest.importorskip("sympy")
    rng = random.Random(100 + seed)
    t, x, y = sympy.symbols("t x y")
    f, g = (
        sum(sympy.Rational(c.numerator, c.denominator) * t**k for k in range(d + 1) for c in [rational(rng)])
        + t**d * 20
        for d in (rng.randint(2, 3), rng.randint(2, 4))
    )
    found = stellate.implicitize(f"x = {f}; y = {g}")
    resultant = sympy.Poly(sympy.resultant(x - f, y - g, t), x, y)
    # The resultant is a power of the equation: its exponent is the tracing index.
    ((factor, power),) = resultant.factor_list()[1]
    assert found.document["tracing_index"] == power
    assert sympy.Poly(found.sympy(), x, y).monic() == factor.monic()


@pytest.mark.parametrize("seed", SEEDS)
def test_signs_are_those_of_exact_evaluation(seed):
    rng = random.Random(200 + seed)
    exponents = [(i, j, k) for i in range(4) for j in range(4 - i) for k in range(4 - i - j)]
    terms = {e: rational(rng) for e in exponents}
    terms = {e: c for e, c in terms.items() if c}
    form = stellate.form(terms)
    first = 1 if stellate.implicitize(form).terms[max(terms, key=lambda e: (sum(e), e))] * terms[max(terms, key=lambda e: (sum(e), e))] > 0 else -1  # fmt: skip
    rows = [[rng.choice((rng.uniform(-2, 2), rng.randint(-2, 2))) for _ in range(3)] for _ in range(200)]
    signs = form.sign(rows)
    for row, sign in zip(rows, signs.tolist()):
        x, y, z = map(Fraction, row)
        value = sum(c * x**i * y**j * z**k for (i, j, k), c in terms.items())
        assert sign == first * ((value > 0) - (value < 0))


@pytest.mark.parametrize("seed", SEEDS)
def test_the_points_of_a_ray_are_the_roots_of_flint(seed):
    rng = random.Random(300 + seed)
    terms = {(i, j): rational(rng) for i in range(6) for j in range(6 - i)}
    terms[5, 0] = Fraction(1)
    form = stellate.form({e: c for e, c in terms.items() if c})
    found = stellate.sample(form, 12)
    rays = {}
    for direction, r in zip(found.directions, found.r.tolist()):
        rays.setdefault(direction, []).append(r)
    assert len(rays) == 12
    for (u, v), radii in rays.items():
        coefficients = [Fraction(0)] * 6
        for (i, j), c in terms.items():
            coefficients[i + j] += c * u**i * v**j
        polynomial = flint.fmpq_poly([fmpq(c) for c in coefficients])
        roots = [root for root, _ in polynomial.numer().complex_roots()]
        real = sorted(float(root.real) for root in roots if root.imag == 0 and not root.real.contains(0))
        assert np.allclose(sorted(radii), real, rtol=1e-14, atol=0)


@pytest.mark.parametrize("seed", SEEDS)
def test_the_factors_are_those_of_flint(seed):
    rng = random.Random(400 + seed)
    ring = flint.fmpz_mpoly_ctx.get(("x", "y"), "lex")
    x, y = ring.gens()
    product = x * 0 + 1
    for _ in range(rng.randint(1, 3)):
        factor = sum(rng.randint(-4, 4) * x**i * y**j for i in range(3) for j in range(3 - i)) + x**2 * 5
        product *= factor ** rng.randint(1, 2)
    terms = {tuple(map(int, e)): int(c) for e, c in product.to_dict().items()}
    described = stellate.describe(stellate.form(terms))["factors"]
    mine = sorted(
        (factor["multiplicity"], sorted(monic(stellate.form(str_json(factor["polynomial"])).terms).items()))
        for factor in described
    )
    _, theirs = product.factor()
    expected = sorted(
        (power, sorted(monic({tuple(map(int, e)): Fraction(int(c)) for e, c in factor.to_dict().items()}).items()))
        for factor, power in theirs
    )
    assert mine == expected


def str_json(document):
    import json

    return json.dumps(document)


@pytest.mark.parametrize("seed", SEEDS)
def test_distances_hold_the_least_of_many_points(seed):
    rng = random.Random(500 + seed)
    cos, sin = series(rng, 4)
    form = stellate.from_series(cos, sin)
    theta = np.linspace(0, 2 * np.pi, 20_001)
    r = form.radius(theta)
    curve = np.column_stack([r * np.cos(theta), r * np.sin(theta)])
    points = np.random.default_rng(seed).normal(scale=3, size=(20, 2))
    low, high = form.distance(points)
    sampled = np.array([np.hypot(*(curve - p).T).min() for p in points])
    step = np.hypot(*np.diff(curve, axis=0).T).max()
    assert np.all(low <= sampled) and np.all(sampled - step <= high) and np.all(high - low <= 1e-5 * high)
