#!/usr/bin/env python3
"""Checks a proof file of stellate.   Usage: checker.py [--complete] FILE
The page about proof files defines the format, and has a theorem for every claim: T1 to T8. No float decides.
Exit code 0: every claim with a witness holds (--complete: and all have one). 1: one does not. 2: no proof."""
import functools, json, math, operator, re, signal, sys
from fractions import Fraction
from itertools import accumulate
FILE, DIGITS, LARGEST, DEGREE, ITEMS = 1 << 27, 20000, 1 << 31, 512, 100000     # the limits of the page
WORK, CELLS, BOX, SECONDS, ZERO, ONE = 10 ** 10, 100000, 300000, 600, Fraction(0), Fraction(1)
if hasattr(sys, "set_int_max_str_digits"): sys.set_int_max_str_digits(4 * DIGITS)
def refuse(why): raise ValueError(ascii(why)[1:200].rstrip("'"))
def need(condition, why): return condition or refuse(why)
def unique(pairs): return dict(pairs) if len(dict(pairs)) == len(pairs) else refuse("a field is given twice")
def small(token): return refuse("-0 is not used") if token == "-0" else integer(int(token[:12]), -LARGEST)
def fields(given, required, optional=""):  # The values in this order; None: an optional one is missing
    required, optional = required.split(), optional.split()
    known = type(given) is dict and set(required) <= set(given) <= set(required + optional)
    need(known, "these fields are expected: " + ", ".join(required + optional))
    need(all(given.get(name, 0) is not None for name in optional), "an optional field is null")
    return [given.get(name) for name in required + optional]
def rational(text, longest=DIGITS // 10):
    need(type(text) is str and len(text) <= longest, "an exact number is a string of limited length")
    known = re.fullmatch(r"0|-?[1-9][0-9]*(/[1-9][0-9]*)?", text)
    return Fraction(text) if known else refuse("no exact number: " + text[:40])
def coefficient(text): return rational(text, DIGITS)
def integer(given, low=0, high=LARGEST):
    return given if type(given) is int and low <= given <= high else refuse("no integer %d..%d" % (low, high))
def double(text):
    need(re.fullmatch(r"-?(inf|[0-9]{1,400}(\.[0-9]{1,400})?(e[+-]?[0-9]{1,4})?)", text), "no double")
    return float(text) if "inf" in text or math.isfinite(float(text)) else refuse("this is written inf")
def array(given, read=lambda v: v, low=0, high=ITEMS):
    need(type(given) is list and low <= len(given) <= high, "no list of %d..%d elements" % (low, high))
    return [read(v) for v in given]
def vector(given, n): return array(given, rational, n, n)
def unit(given, n): return vector(given, n) if sum(v * v for v in vector(given, n)) == 1 else refuse("no unit vector")
def ascending(given, start=None, end=None):  # The breakpoints between the given ends; None is infinity
    points = [start] + array(given, rational) + [end]
    need(all(None in (a, b) or a < b for a, b in zip(points, points[1:])), "the breakpoints must ascend")
    return points
def integers(values):  # The values times their positive common denominator. Polynomials in x are lists, ascending
    d = math.lcm(*(v.denominator for v in values))
    return [int(v * d) for v in values]
def trimmed(p): return p[:max((i + 1 for i, c in enumerate(p) if c), default=0)]
def times(p, q):
    out = [0] * (len(p) + len(q) - 1)
    for i, a in enumerate(p): out[i:i + len(q)] = [c + a * b for c, b in zip(out[i:], q)]
    return out
def added(p, q): return [a + b for a, b in zip(p + [0] * (len(q) - len(p)), q + [0] * (len(p) - len(q)))]
def powers(a, n): return list(accumulate([a] * n, operator.mul, initial=1))
def shifted(p, a):  # p(x + a) for an integer a: with x = a y this is p(a (y + 1)), and prefix sums add 1 to y
    if a == 0: return list(p)
    scale = powers(a, len(p) - 1)
    row = [c * s for c, s in zip(p, scale)][::-1]
    for k in range(len(p), 1, -1): row[:k] = accumulate(row[:k])
    return [c // s for c, s in zip(row[::-1], scale)]
def sign(x): return (x > 0) - (x < 0)
def sign_at(p, q, end=1):  # The sign of p(q); None stands for far out, at the right end or the left end (-1)
    if q is None: return sign(p[-1]) * (end if len(p) % 2 == 0 else 1)
    n, d = q.numerator, q.denominator
    return sign(functools.reduce(lambda v, c: (v[0] * n + c * v[1], v[1] * d), p[::-1], (0, 1))[0])
def linear(p, a, b):  # p(a + b v) in v, times a positive integer that depends on len(p), a and b only
    d, n = math.lcm(a.denominator, b.denominator), len(p) - 1
    p = shifted([c * s for c, s in zip(p, powers(d, n)[::-1])], int(a * d))
    return [c * s for c, s in zip(p, powers(int(b * d), n))]
def bernstein(p, a, b):  # T1: the coefficients of p on [a, b] up to a positive factor; None is infinity
    if a is None:
        need(b is not None or len(p) == 1, "at least one breakpoint is needed")
        return bernstein([c * (-1) ** i for i, c in enumerate(p)], ZERO if b is None else -b, None)[::-1]
    return linear(p, a, ONE) if b is None else shifted(linear(p, a, b - a)[::-1], 1)[::-1]
def variations(coefficients):
    signs = [c > 0 for c in coefficients if c]
    return sum(map(operator.ne, signs, signs[1:]))
def isolated(p, points):  # T1: the pieces (a, b, sign of p at a) that have one root; the others have none
    found = []
    for a, b in zip(points, points[1:]):
        c = bernstein(p, a, b)
        need(c[0] and c[-1] and variations(c) <= 1, "an end is a root, or there are several, from %s to %s" % (a, b))
        if variations(c): found.append((a, b, sign(c[0])))
    return found
def plus(f, g, factor=1):  # Polynomials in several variables are {tuple of exponents: integer}
    out = dict(f)
    for e, c in g.items(): out[e] = out.get(e, 0) + factor * c
    return {e: c for e, c in out.items() if c}
def product(f, g):
    bits = sum(max(map(int.bit_length, h.values()), default=0) for h in (f, g))
    need(len(f) * len(g) * (bits + 300) <= WORK, "this expansion is longer than the limit")
    out = {}
    for e, a in f.items():
        for h, b in g.items():
            k = tuple([i + j for i, j in zip(e, h)])
            out[k] = out.get(k, 0) + a * b
    return {e: c for e, c in out.items() if c}
def power(f, n, variables): return product(power(f, n - 1, variables), f) if n else {(0,) * variables: 1}
def degree(f): return max(map(sum, f), default=0)
def degree_in(f, axis): return max((e[axis] for e in f), default=0)
def proportional(f, g):
    a, b = f.get(max(f)), g.get(max(f))
    return f.keys() == g.keys() and all(c * b == g[e] * a for e, c in f.items())
def along(f, d):  # f(s d) as a polynomial in s of formal degree deg f, times a positive integer
    *direction, w = integers(d + [ONE])
    raised = functools.lru_cache(None)(lambda i, n: direction[i] ** n)
    def form(c):  # The sum of c[i] x^i y^(len(c) - 1 - i), by halves: factors of similar size are faster
        if len(c) == 1: return c[0]
        h = len(c) // 2
        return form(c[:h]) * raised(1, len(c) - h) + form(c[h:]) * raised(0, h)
    out, scale, slices = [0] * (degree(f) + 1), powers(w, degree(f))[::-1], {}     # forms in x, y by k, z^h
    for e, c in f.items(): slices.setdefault((sum(e), sum(e[2:])), [0] * (e[0] + e[1] + 1))[e[0]] = c
    for (k, h), c in slices.items(): out[k] += form(c) * (raised(2, h) if h else 1) * scale[k]
    return out
def value(f, point): return Fraction(sum(along(f, point)), integers(point + [ONE])[-1] ** degree(f))
def substituted(f, axis, a, b):  # f with a + b v for the variable v of this axis, times a positive integer
    n, rows = degree_in(f, axis), {}
    for e, c in f.items(): rows.setdefault(e[:axis] + e[axis + 1:], [0] * (n + 1))[e[axis]] = c
    return {e[:axis] + (i,) + e[axis:]: c for e, row in rows.items() for i, c in enumerate(linear(row, a, b)) if c}
def moved(f, point, factor=ONE):  # f(point + factor v) as a polynomial in v, times a positive integer
    for axis, v in enumerate(point): f = substituted(f, axis, v, factor)
    return f
RHO = {2: {(2, 0): 1, (0, 2): 1}, 3: {(2, 0, 0): 1, (0, 2, 0): 1, (0, 0, 2): 1}}
C, S, MINUS_C, MINUS_S = [1, 0, -1], [0, 2, 0], [-1, 0, 1], [0, -2, 0]        # C + i S = (1 + i t)^2
QUARTERS = [(C, S), (MINUS_S, C), (MINUS_C, MINUS_S), (S, MINUS_C)]           # the parts of i^q (1 + i t)^2
def read_terms(given, variables):  # A polynomial: its integer terms, and their common denominator
    out = {}
    for exponents, c in array(given, lambda t: fields(t, "exponents coefficient")):
        e = tuple(array(exponents, lambda v: integer(v, 0, DEGREE), variables, variables))
        need(sum(e) <= DEGREE and e not in out, "the degree is above the limit, or a term is given twice")
        out[e] = coefficient(c) or refuse("a coefficient is zero")
    d = math.lcm(*(c.denominator for c in out.values()))
    return {e: int(c * d) for e, c in out.items()}, d
def multiple_angle(n):  # cos nt and sin nt as forms in cos t, sin t: real and imaginary part of (c + i s)^n
    return [{(n - k, k): math.comb(n, k) * (-1) ** (k // 2) for k in range(odd, n + 1, 2)} for odd in (0, 1)]
def read_center(given, n): return [ZERO] * n if given is None else vector(given, n)
class Form:  # terms over denominator; or parts, harmonics by degree, over scale; or coordinates, fractions
    def __init__(self, given):
        self.kind = given["kind"]
        need(self.kind in ("implicit", "fourier", "spherical", "parametric"), "unknown kind of form")
        getattr(self, self.kind)(given)
    def implicit(self, given):
        _, variables, terms = fields(given, "kind variables terms")
        self.n = [["x", "y"], ["x", "y", "z"]].index(variables) + 2
        self.terms, self.denominator = read_terms(terms, self.n)
        self.degree = degree(need(self.terms, "there is no term"))
    def fourier(self, given):
        _, cos, sin, center = fields(given, "kind cos sin", "center")
        cos, sin = (array(v, coefficient, 1, DEGREE) for v in (cos, sin))
        need(len(cos) == len(sin) and sin[0] == 0, "cos and sin have the same length, and sin[0] is 0")
        self.n, self.top, self.center = 2, len(cos) - 1, read_center(center, 2)
        *whole, self.scale = integers(cos + sin + [ONE])
        angles = [multiple_angle(n) for n in range(len(cos))]
        self.parts = [plus(plus({}, c, a), s, b) for (c, s), a, b in zip(angles, whole, whole[len(cos):])]
    def spherical(self, given):
        _, top, coefficients, center = fields(given, "kind degree coefficients", "center")
        self.n, self.top, self.center, numbers = 3, integer(top, 0, 128), read_center(center, 3), {}
        for l, m, v in array(coefficients, lambda c: fields(c, "l m value")):
            key = integer(l, 0, self.top), integer(m, -l, l)
            need(key not in numbers, "a coefficient is given twice")
            numbers[key] = coefficient(v) / 2 ** l
        self.scale = math.lcm(*(v.denominator for v in numbers.values()))
        self.parts = [{} for _ in range(self.top + 1)]
        for (l, m), v in numbers.items():
            n, around = abs(m), {e + (l - abs(m),): c for e, c in multiple_angle(abs(m))[m < 0].items()}
            for k in range((l - n) // 2 + 1):
                c = (-1) ** k * math.comb(l, k) * math.comb(2 * l - 2 * k, l) * math.perm(l - 2 * k, n)
                rho = {(i, j, h - 2 * k): r for (i, j, h), r in power(RHO[3], k, 3).items()}
                self.parts[l] = plus(self.parts[l], product(around, rho), c * int(v * self.scale))
    def parametric(self, given):
        _, parameters, coordinates = fields(given, "kind parameters coordinates")
        names = sum(array(parameters, {"rational": ["t"], "angle": ["cos", "sin"]}.__getitem__, 1, 2), [])
        self.generators, self.coordinates = len(names), []
        self.sines = [i for i, name in enumerate(names) if name == "sin"]
        for above, below in array(coordinates, lambda c: fields(c, "numerator denominator"), 2, 3):
            (p, d), (q, e) = (read_terms(v, self.generators) for v in (above, below))
            need(self.normal(q), "a denominator is zero")
            self.coordinates.append((plus({}, p, e), plus({}, q, d)))
    def normal(self, p):  # T3: the polynomial without sin^2, which is 1 - cos^2, for every angle
        for at in self.sines:
            while degree_in(p, at) > 1:
                low = {e[:at] + (e[at] - 2,) + e[at + 1:]: c for e, c in p.items() if e[at] > 1}
                p = plus({e: c for e, c in p.items() if e[at] < 2}, low)
                p = plus(p, {e[:at - 1] + (e[at - 1] + 2,) + e[at:]: c for e, c in low.items()}, -1)
        return p
    def times(self, f, g): return self.normal(product(f, g))
    @functools.lru_cache(None)
    def pair(self):  # T2: A of degree N and B of degree N - 1; scale r = A + B on the unit circle or sphere
        pair = [{}, {}]
        for n, part in enumerate(self.parts):
            odd = (self.top - n) % 2
            pair[odd] = plus(pair[odd], product(part, power(RHO[self.n], (self.top - odd - n) // 2, self.n)))
        return pair
    def radius(self, d):  # Rational numbers a, b: the radius in the direction of the vector d is a + b |d|
        square, sums = sum(v * v for v in d), [ZERO, ZERO]
        for n, part in zip((self.top, self.top - 1), self.pair()):
            sums[n % 2] = value(part, d) / (self.scale * square ** ((n + 1) // 2))
        return sums
    def point(self, d): return [c + sum(self.radius(d)) * u for c, u in zip(self.center, d)]         # |d| = 1
    def quarter(self, q):  # T5: r (1 + t^2)^N scale on a quarter of the circle, a polynomial in t from 0 to 1
        xs, ys = (list(accumulate([u] * self.top, times, initial=[1])) for u in QUARTERS[q])
        out = [0] * (2 * self.top + 1)
        for weight, part in zip(([1], [1, 0, 1]), self.pair()):                  # A(x, y) + (1 + t^2) B(x, y)
            for (i, j), c in part.items(): out = added(out, times(times(xs[i], [c]), times(ys[j], weight)))
        return out
    @functools.lru_cache(None)
    def squares(self, q):  # T6: X^2 + Y^2, XW, YW, W^2 on a quarter; (X, Y)/W is the curve about its center
        w = functools.reduce(times, [[1, 0, 1]] * (self.top + 1), [self.scale])
        x, y = (times(self.quarter(q), u) for u in QUARTERS[q])
        return added(times(x, x), times(y, y)), times(x, w), times(y, w), times(w, w)
    @functools.lru_cache(1024)
    def arc(self, q, j, level):  # T6: the coefficients of these four for t in [j, j + 1]/2^level, in columns
        a, b = Fraction(j, 2 ** level), Fraction(j + 1, 2 ** level)
        return list(zip(*(bernstein(p, a, b) for p in self.squares(q))))
class Proof:
    def __init__(self, text):
        hooks = dict(object_pairs_hook=unique, parse_int=small, parse_float=small, parse_constant=small)
        schema, kind, forms, claims = fields(json.loads(text, **hooks), "schema kind forms claims")
        need(schema == "stellate/1" and kind == "proof", "the document is no proof of schema stellate/1")
        self.forms, self.claims = array(forms, Form), array(claims)
    def form(self, index, *kinds):
        known = integer(index) < len(self.forms) and self.forms[index].kind in kinds
        return self.forms[index] if known else refuse("there is no such form: " + ", ".join(kinds))
def root_count(proof, statement, witness):
    index, d, order, roots, center = fields(statement, "form direction order_at_zero roots", "center")
    breakpoints, parts = fields(witness, "breakpoints", "parts")
    form = proof.form(index, "implicit")
    d, center = unit(d, form.n), read_center(center, form.n)
    roots = array(roots, lambda r: fields(r, "multiplicity", "nearest position"), 0, DEGREE)
    p = trimmed(along(form.terms, d))
    if order == "line":
        return need(not p and roots == breakpoints == [] and parts is None, "f is not zero on the line")
    need(p and integer(order) == next(i for i, c in enumerate(p) if c), "the order at zero is wrong")
    p = p[order:]
    parts = [(1, p)] if parts is None else array(parts, read_part, 1, DEGREE)
    need(sum(m * (len(q) - 1) for m, q in parts) == len(p) - 1, "the parts have the wrong degree")
    simple = functools.reduce(times, (q for _, q in parts))
    whole = p if parts == [(1, p)] else functools.reduce(times, (q for m, q in parts for _ in range(m)))
    need(whole[-1] and all(c * p[-1] == e * whole[-1] for c, e in zip(whole, p)), "the product is different")
    found = isolated(simple, ascending(breakpoints))
    need(len(found) == len(roots), "the number of roots is %d, not %d" % (len(found), len(roots)))
    for piece, (multiplicity, nearest, position) in zip(found, roots):
        changing = [m for m, q in parts if sign_at(q, piece[0], -1) != sign_at(q, piece[1])]
        need([integer(multiplicity)] == changing, "a root has multiplicity %s" % changing)
        numbers = [] if nearest is None else [(ZERO, ONE, double(nearest))]
        if position is not None: numbers += zip(center, d, array(position, double, form.n, form.n))
        for c, u, x in numbers: need_nearest(x, c, u, lambda q: root_side(simple, *piece, q))
def read_part(given):
    m, q = fields(given, "multiplicity coefficients")
    return integer(m, 1, DEGREE), integers(array(q, coefficient, 2, DEGREE + 1))
def root_side(p, a, b, at_a, q):  # The sign of root - q; p has one root in (a, b), this sign at a
    return 1 if a is not None and q <= a else -1 if b is not None and q >= b else sign_at(p, q) * at_a
def exact(x): return Fraction(2) ** 1024 * sign(x) if math.isinf(x) else Fraction(x)
def need_nearest(x, c, u, side):  # No double is nearer than x to c + u root; side(q) is the sign of root - q
    for neighbour, below in (math.nextafter(x, -math.inf), 1), (math.nextafter(x, math.inf), -1):
        if neighbour != x:                             # an infinite x has only one neighbour
            rest = (exact(x) + exact(neighbour)) / 2 - c
            need((side(rest / u) * sign(u) if u else -sign(rest)) * below >= 0, "%r is not nearest" % x)
def series_equation(proof, given, _): same_as_series(proof, *fields(given, "form radius coordinates", "square"))
def same_as_series(proof, index, radius, coordinates, square=None):  # T2; returns the form of the radius
    form, series = proof.form(index, "implicit"), proof.form(radius, "fourier", "spherical")
    need(coordinates in ("center", "original") and form.n == series.n, "bad coordinates or dimension")
    n, rho, pair = series.n, RHO[series.n], series.pair()
    even, odd = pair if series.top % 2 == 0 else pair[::-1]
    odd = plus(plus({}, power(rho, (series.top + 1) // 2, n), series.scale), odd, -1)
    f, g = product(odd, odd), product(even, even)
    f = plus(f, product(rho, g), -1) if series.top % 2 else plus(product(rho, f), g, -1)
    if coordinates == "original": f = moved(f, [-c for c in series.center])
    need(square is None or square is True, "square is true, or missing")
    need(proportional(power(form.terms, 2 if square else 1, n), f), "the polynomial is not that of the series")
    return series
def identity(proof, statement, _):  # T3
    indices, curve = fields(statement, "equations curve")
    curve = proof.form(curve, "parametric")
    for form in array(indices, lambda i: proof.form(i, "implicit"), 1, 8):
        need(form.n == len(curve.coordinates), "the equation and the curve have different dimensions")
        tables, total = [], {}
        for axis, pair in enumerate(curve.coordinates):              # above^i below^(top - i), for every i
            top = degree_in(form.terms, axis)
            up, down = (list(accumulate([p] * top, curve.times, initial={(0,) * curve.generators: 1})) for p in pair)
            tables.append(list(map(curve.times, up, down[::-1])))
        for e, c in form.terms.items():
            total = plus(total, functools.reduce(curve.times, map(operator.getitem, tables, e)), c)
        need(not total, "the equation does not vanish on the curve")
def factorization(proof, statement, _):
    index, constant, factors = fields(statement, "form constant factors")
    form, c, seen = proof.form(index, "implicit"), coefficient(constant), []
    whole = {(0,) * form.n: 1}
    for i, m in array(factors, lambda v: fields(v, "form multiplicity"), 1, DEGREE):
        factor = proof.form(i, "implicit")
        need(factor.n == form.n and factor.degree > 0, "a factor is constant, or has other variables")
        need(not any(proportional(factor.terms, p) for p in seen), "two factors are proportional")
        seen.append(factor.terms)
        for _ in range(integer(m, 1, form.degree)):
            whole, c = product(whole, factor.terms), c / factor.denominator
    need(plus({}, whole, c * form.denominator) == form.terms, "the product is another polynomial")
def irreducible(proof, statement, witness):  # T4
    form = proof.form(*fields(statement, "form"), "implicit")
    if "radius" in witness:
        series = same_as_series(proof, statement["form"], *fields(witness, "radius coordinates"))
        return need(series.parts[-1] and series.pair()[series.top % 2], "the last harmonic or even part is 0")
    point, direction, p = fields(witness, "point direction prime")
    need(form.degree and all(integer(p, 2) % k for k in range(2, math.isqrt(p) + 1)), "%s is no prime" % p)
    q = along(moved(form.terms, vector(point, form.n)), vector(direction, form.n))
    q = [c // math.gcd(*q) for c in q]                                                 # fails if q is 0
    need(q[-1] % p and irreducible_modulo(q, p), "f on the line is reducible, or its degree drops")
def irreducible_modulo(f, p):  # T4: a factor of degree d, at most half that of f, would divide x^(p^d) - x
    def monic(a): return [c * pow(a[-1], -1, p) % p for c in a]
    def rest(a, b):                                                                             # b is monic
        for k in range(len(a) - len(b), -1, -1):
            c, a = a[-1], a[:-1]
            a[k:] = [u - c % p * v for u, v in zip(a[k:], b)]
        return trimmed([c % p for c in a])
    f, image = monic(f), [0, 1]
    for _ in range((len(f) - 1) // 2):
        base, image = image, [1]
        for bit in bin(p)[2:]:                                                         # image = base^p
            image = rest(times(rest(times(image, image), f), base if bit == "1" else [1]), f)
        a, b = f, trimmed([c % p for c in added(image, [0, -1])])
        while b: a, b = b, rest(a, monic(b))
        if len(a) > 1: return False
    return True
def covered(cells, depth, decided, halves):  # Every cell falls into decided ones by `depth` divisions at most
    stack, count, depth = [(cell, 0) for cell in cells], 0, integer(depth, 0, 200)
    while stack:
        (cell, level), count = stack.pop(), count + 1
        if not decided(cell, level):
            stack += [(half, level + 1) for half in halves(cell)]
            need(level < depth and count + len(stack) <= CELLS, "a cell is undecided, or there are too many cells")
def cube(f, n, depth, decided):  # The same on [-1, 1]^n, where f on the cell is moved to [-1, 1]^n as well
    def halves(cell):
        pieces = [(cell[0], ())]
        for axis in range(n):
            pieces = [(substituted(g, axis, Fraction(s, 2), Fraction(1, 2)), c + (2 * cell[1][axis] + s,))
                      for g, c in pieces for s in (-1, 1)]
        return pieces
    covered([(f, (0,) * n)], depth, lambda cell, level: decided(*cell, level), halves)
def reach(c, level, s): return Fraction(sum(max(abs(v) + s, 0) ** 2 for v in c), 4 ** level)  # |v|^2: s = -1 least
def positive_radius(proof, statement, witness):  # T5
    index, positive = fields(statement, "form positive")
    form = proof.form(index, "fourier", "spherical")
    if positive is False: return need(sum(form.radius(unit(*fields(witness, "direction"), form.n))) <= 0, "r > 0")
    need(positive is True and sum(form.radius([ONE] + [ZERO] * (form.n - 1))) > 0, "r <= 0 on the x axis")
    if form.kind == "fourier":
        quarters = array(*fields(witness, "quarters"), lambda v: ascending(v, ZERO, ONE), 4, 4)
        for q, points in enumerate(quarters):
            need(not isolated(form.quarter(q), points), "r is 0 in quarter %d" % q)
    else:
        for k in range(3):                    # a face of the cube: A and B in two variables; B has exponent 1
            ab = {e[:k] + e[k + 1:] + (odd,): c for odd in (0, 1) for e, c in form.pair()[odd].items()}
            cube(ab, 2, *fields(witness, "depth"), nonzero_radius)
def nonzero_radius(f, center, level):  # T5: whether |A| > |B| |d| or |B| |d| > |A| on the whole cell
    a, b = (sum(abs(c) for e, c in f.items() if e[2] == odd) for odd in (0, 1))                # upper bounds
    a_low, b_low = (2 * abs(f.get((0, 0, odd), 0)) - v for odd, v in enumerate((a, b)))        # lower bounds
    far, near = 1 + reach(center, level, 1), 1 + reach(center, level, -1)
    return a_low > 0 and a_low ** 2 > far * b ** 2 or b_low > 0 and b_low ** 2 * near > a ** 2
def sign_on_cube(f, n):  # T6: the sign of f on [-1, 1]^n if its coefficients show it: f has a term c + m v^2 + l v
    c, slope, bend = f.get((0,) * n, 0), [0] * n, [0] * n                              # bend is 2 m
    for e, v in f.items():
        axes = [i for i in range(n) if e[i]][:2]
        for i in axes: bend[i] += 2 * sign(c) * v if max(e) == sum(e) == 2 else -2 * abs(v) // len(axes)
        if sum(e) == 1: slope[axes[0]], bend[axes[0]] = abs(v), bend[axes[0]] + 2 * abs(v)
    lost = (Fraction(l * l, 2 * m) if l < m else l - Fraction(m, 2) for l, m in zip(slope, bend))
    return sign(c) if abs(c) > sum(lost) else 0
def distance(proof, statement, witness):  # T6
    index, point, relation, bound = fields(statement, "form point relation bound")
    form, d = proof.form(index, "implicit", "fourier", "spherical"), rational(bound)
    p, near, sphere = vector(point, form.n), relation in ("at-most", "meets"), relation in ("meets", "misses")
    need(d >= 0 and (near or sphere or relation == "more-than"), "unknown relation, or a negative bound")
    def excess(q): return sum((u - v) ** 2 for u, v in zip(p, q)) - d * d
    if near and form.kind == "implicit":
        ends = array(*fields(witness, "segment"), lambda v: vector(v, form.n), 2, 2)
        need(all(excess(q) == 0 or excess(q) < 0 and not sphere for q in ends), "an end is elsewhere")
        need(value(form.terms, ends[0]) * value(form.terms, ends[1]) <= 0, "the signs at the ends are equal")
    elif near:
        found = array(*fields(witness, "directions"), lambda v: excess(form.point(unit(v, form.n))), 1, 2)
        need(min(found) <= 0 and (max(found) >= 0 or not sphere), "the points are elsewhere")
    elif form.kind == "implicit":
        depth, extra = fields(witness, "depth", "multipliers")
        weights = [ZERO] + ([] if extra is None else array(extra, rational, 1, 8))
        lens = {tuple(int(i == j) for i in range(form.n)): 2 * v for j, v in enumerate(p)}     # d^2 - |x - p|^2
        lens = plus(plus(lens, RHO[form.n], -1), {(0,) * form.n: d * d - sum(v * v for v in p)})
        def decided(f, center, level):
            parts = ({e[:-1]: c for e, c in f.items() if e[-1] == k} for k in range(len(weights)))
            signs = (sign_on_cube(g, form.n) for g in parts)
            outside = reach(center, level, -1) > 1 or sphere and reach(center, level, 1) < 1
            return outside or any(s and (sphere or m * s >= 0) for m, s in zip(weights, signs))
        need(math.prod(max(degree_in(form.terms, k), 2) + 1 for k in range(form.n)) <= BOX, "f is too large")
        both = {}
        for k, m in enumerate(weights):                                             # f - m (d^2 - |x - p|^2)
            h = plus(form.terms, lens, -m * form.denominator)
            both.update(zip([e + (k,) for e in h], integers(list(h.values()))))
        cube(moved(both, p, d), form.n, depth, decided)
    else:
        u, v = map(operator.sub, p, form.center)
        weights = integers([ONE, -2 * u, -2 * v, u * u + v * v - d * d])                # of |C - p|^2 - d^2
        depth, near = fields(witness, "depth", "near")
        near = [] if near is None else array(near, rational, 1, 8)
        def on(columns): return [sum(map(operator.mul, weights, column)) for column in columns]
        def about(q, t, w): return linear(on(zip(*form.squares(q))), t, w)           # for |parameter - t| <= w
        def decided(cell, level):
            (q, j), w, c = cell, Fraction(1, 2 ** level), on(form.arc(*cell, level))
            here = (about(q, u - q, w) for u in near if j * w <= u - q <= (j + 1) * w)
            bowls = (sign_on_cube(dict(zip(zip(range(BOX)), p)), 1) for p in here)
            seen = variations(c) == 0 or variations(c) == 2 and any(bowls)
            return seen and c[0] * c[-1] > 0 and (c[0] > 0 or sphere)
        covered([(q, 0) for q in range(4)], depth, decided, lambda v: [(v[0], 2 * v[1] + i) for i in (0, 1)])
def side(proof, statement, _):
    index, point, given = fields(statement, "form point sign")
    form = proof.form(index, "implicit", "fourier", "spherical")
    p, found = vector(point, form.n), -1
    if form.kind == "implicit": found = sign(value(form.terms, p))
    elif p != form.center:                                                            # |p| - r is b |p| + a
        p = list(map(operator.sub, p, form.center))
        a, b = map(operator.sub, (ZERO, ONE), form.radius(p))
        larger = sign(b * b * sum(v * v for v in p) - a * a)
        found = sign(a) if larger < 0 else sign(b) if larger > 0 or a * b > 0 else 0
    need(integer(given, -1, 1) == found, "the sign is %d" % found)
def constant_roots(f, directions, points):  # The numbers of roots x < 0 and x > 0 of f(x, s), for all s
    n, m, counts = degree_in(f, 0), degree_in(f, 1), [0, 0]
    for a, b in zip(points, points[1:]):
        columns = [bernstein([f.get((i, j), 0) for i in range(n + 1)], a, b) for j in range(m + 1)]
        rows, signs = [bernstein(list(row), *directions) for row in zip(*columns)], []
        firm = all(row[0] and row[-1] and not variations(row) for row in (rows[0], rows[-1]))
        need(firm and 0 in points, "a breakpoint could be a root, or 0 is none of them")
        for row in rows:                                      # a row that may have both signs counts as both
            found = sorted({sign(c) for c in row} - {0})
            signs += found if found[:1] == signs[-1:] else found[::-1]
        need(variations(signs) <= 1, "too many sign changes in the piece from %s to %s" % (a, b))
        counts[a is not None and a >= 0] += variations(signs)
    return counts
def sectors(proof, statement, witness):
    (index, cuts, counts), [pieces] = fields(statement, "form cuts counts"), fields(witness, "sectors")
    form, start = proof.form(index, "implicit"), ZERO
    order = min(map(sum, form.terms))                 # f(x d)/x^order for d = (1, s - 1) and d = (3 - s, 1)
    by_y, by_x = ({(sum(e) - order, e[k]): c for e, c in form.terms.items()} for k in (1, 0))
    charts = substituted(by_y, 1, -ONE, ONE), substituted(by_x, 1, Fraction(3), -ONE)
    cuts = array(cuts, lambda v: fields(v, "between", "angle")) + [(["4", "4"], None)]
    need(form.n == 2 and len(counts) == len(pieces) == len(cuts), "x and y, and one sector more than cuts")
    for (between, angle), given, sector in zip(cuts, array(counts), array(pieces)):
        low, high = vector(between, 2)
        need((given is sector is None) == (low == start), "an empty sector, and only that, is null")
        sector = [] if sector is None else array(sector, lambda v: fields(v, "to breakpoints"), 1)
        ends = ascending([v[0] for v in sector], start)[:-1]
        need(ends[-1] == low <= high <= 4 and (high <= 2 or low >= 2), "a sector does not end at its cut")
        for a, b, (_, breakpoints) in zip(ends, ends[1:], sector):
            need(b <= 2 or a >= 2, "2 must be an end of a piece")
            found = constant_roots(charts[a >= 2], (a, b), ascending(breakpoints))
            need(array(fields(given, "negative positive"), integer) == found, "there are %s roots" % found)
        if angle is not None:
            (a, b), axis = vector(angle, 2), 1 if high <= 2 else 3
            need(below_tangent(a, low - axis) and below_tangent(-b, axis - high), "the angles are too narrow")
        start = high
def below_tangent(a, t):  # Whether a <= atan t: 60 terms of the sine and cosine series are right to 2^-200
    terms = [(-1) ** (k // 2) * a ** k / math.factorial(k) for k in range(60)]
    c, s, e = sum(terms[::2]), sum(terms[1::2]), Fraction(1, 2 ** 200)
    return abs(a) < 2 and c - e > 0 and s + e <= t * (c - e if t > 0 else c + e)
def fit_error(proof, statement, witness):  # T8
    index, samples, largest, rms = fields(statement, "form samples max rms")
    form, [bits] = proof.form(index, "fourier", "spherical"), fields(witness, "bits")
    scale, errors = 1 << integer(bits, 0, 4096), []                              # lengths in units of 2^-bits
    for sample in array(samples, lambda v: vector(v, form.n), 1):
        d = list(map(operator.sub, sample, form.center))                    # not 0: the radius fails there
        (a, b), square = form.radius(d), sum(v * v for v in d)
        root = math.isqrt(square.numerator * scale ** 2 // square.denominator)
        ends = sorted(a * scale + (b - 1) * v for v in (root, root + 1))
        low, high = math.floor(ends[0]), math.ceil(ends[1])
        errors.append((max(low, -high, 0) ** 2, max(-low, high) ** 2))
    lows, highs = zip(*errors)
    for given, of_all in ((largest, max), (rms, lambda squares: Fraction(sum(squares), len(errors)))):
        low, high = (v * scale for v in vector(given, 2))
        need(0 <= low <= high and low ** 2 <= of_all(lows) and of_all(highs) <= high ** 2, "another error")
CHECKS = {check.__name__.replace("_", "-"): check for check in (root_count, series_equation, identity, side,
          factorization, irreducible, positive_radius, distance, sectors, fit_error)}
EXPANDED = ("series-equation", "identity", "factorization", "side")
UNPROVED = ("topology", "closed-form", "ranges", "hausdorff-distance", "overlap", "tracing-index", "genus",
            "minimal-degree", "star-shaped-outline", "real-image")
def late(*_): signal.alarm(1) or refuse("the check takes longer than ten minutes")
def main(arguments):
    counts, seen, refused = {}, {}, 0
    if hasattr(signal, "alarm"): signal.signal(signal.SIGALRM, late), signal.alarm(SECONDS)
    try:
        need(arguments, "usage: checker.py [--complete] FILE")
        with open(arguments[-1], "rb") as file: text = file.read(FILE + 1)
        need(len(text) <= FILE, "the file is longer than the limit")
        proof = Proof(text.decode())
    except Exception as error: return print("no proof: %s" % ascii(str(error))) or 2
    for i, claim in enumerate(proof.claims):
        try:
            name, statement, witness = fields(claim, "claim statement witness")
            need(name in CHECKS or name in UNPROVED and witness is None, "there is no such claim")
            need(type(statement) is dict and statement, "a statement is an object with at least one field")
            need(seen.setdefault(json.dumps([name, statement], sort_keys=True), i) == i, "it is made twice")
            if witness is not None:
                need(name not in EXPANDED or witness == {"method": "expansion"}, "an unknown method")
                CHECKS[name](proof, statement, witness)
            counts.setdefault(name, [0, 0])[witness is None] += 1
        except Exception as error:            # a wrong type or a division by zero refuses a claim, too
            name, refused = claim.get("claim") if type(claim) is dict else "", refused + 1
            print("refused: claim %d (%.40s): %s" % (i, ascii(name).strip("'"), ascii(str(error))[1:-1]))
    for name, pair in sorted(counts.items()): print("%s: %d proved, %d without a witness" % (name, *pair))
    without = sum(c[1] for c in counts.values())
    print("%d claims, %d without a witness, %d refused" % (len(proof.claims), without, refused))
    return 1 if refused or without and "--complete" in arguments else 0
if __name__ == "__main__": sys.exit(main(sys.argv[1:]))
