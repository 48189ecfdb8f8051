"""Columns in and out: NumPy, Arrow, and exact answers for arrays."""

import time
from fractions import Fraction

import numpy as np
import pytest

import stellate
from stellate._points import columns


def test_signs_of_any_shape_are_exact():
    circle = stellate.form("x^2 + y^2 = 1")
    grid = np.stack(np.meshgrid(np.linspace(-2, 2, 9), np.linspace(-2, 2, 7)), axis=-1)
    signs = circle.sign(grid)
    assert signs.shape == (7, 9) and signs.dtype == np.int8
    exact = [[(Fraction(x) ** 2 + Fraction(y) ** 2 > 1) - (Fraction(x) ** 2 + Fraction(y) ** 2 < 1) for x, y in row] for row in grid.tolist()]  # fmt: skip
    assert signs.tolist() == exact
    assert circle.sign([0.6, 0.8]) == 1 - 2 * (Fraction(0.6) ** 2 + Fraction(0.8) ** 2 < 1)
    assert circle.sign(np.empty((0, 2))).shape == (0,)
    low, high = circle.distance([3, 4])
    assert low.shape == () and low <= 4 <= high
    low, high = circle.distance(np.zeros((2, 5, 2)), digits=3)
    assert high.shape == (2, 5)


@pytest.mark.parametrize(
    "text",
    [
        "r = 2 + cos(5*t)/3",
        "r = 1/2 + cos(3*t)",
        "x = cos(t); y = sin(2*t)",
        "x = (1-t^2)/(1+t^2); y = 2*t/(1+t^2)",
        "y^2 = x^3 - x",
        "(x^2 + y^2 - 1)^2*(x - y) = 0",
        "superquadric 2d a=1,2 e=1/2",
        "R = 2 + Y(3,1)/9",
        "x^2 + y^2*z + z^3 = 1",
        "x^2 + y^2 + 0*z = 2",
    ],
)
def test_the_sign_is_that_of_the_inspection(text):
    form = stellate.form(text)
    rng = np.random.default_rng(5)
    size = 3 if any(letter in text for letter in "zR") else 2
    points = rng.integers(-24, 25, (60, size)) / 8
    inspected = stellate.inspect(form, points, 1)
    assert not np.ma.is_masked(inspected.sign)
    assert form.sign(points).tolist() == inspected.sign.tolist()


def test_a_fitted_outline_has_sides_in_its_own_coordinates():
    angles = np.linspace(0, 2 * np.pi, 200, endpoint=False)
    fit = stellate.fit(np.column_stack([10 + 3 * np.cos(angles), 5 + 2 * np.sin(angles)]), 6).form
    equation = stellate.implicitize(fit)
    points = [[10, 5], [12.5, 5], [13.5, 5], [0, 0], [10, 6.9], [10, 7.2]]
    assert fit.sign(points).tolist() == [-1, -1, 1, 1, -1, 1]
    # The equation has an isolated point of its own at the center.
    assert equation.sign(points[1:]).tolist() == [-1, 1, 1, -1, 1]


def test_arrays_are_read_in_place():
    array = np.arange(12.0).reshape(4, 3)
    assert all(np.shares_memory(axis, array) for axis in columns(array).axes)
    assert all(np.shares_memory(axis, array) for axis in columns(array[::2]).axes)
    one = np.array([1.0, 2.0])
    assert all(np.shares_memory(axis, one) for axis in columns(one).axes)
    read_only = np.arange(6.0).reshape(3, 2)
    read_only.setflags(write=False)
    assert stellate.form("x^2 + y^2 = 1").sign(read_only).tolist() == [0, 1, 1]


def test_wrong_points_are_named():
    circle = stellate.form("x^2 + y^2 = 1")
    for points in (1.0, [1.0], np.zeros((2, 4)), np.zeros((3, 2, 5))):
        with pytest.raises(stellate.InputError, match="shape"):
            circle.sign(points)
    with pytest.raises(stellate.InputError, match="row 3"):
        circle.sign([[0, 0], [1, 1], [2, 2], [np.nan, 0]])
    found = stellate.inspect(circle, [[0, 0], [np.inf, 1], [1, 0]], "1/2", skip_bad=True)
    assert found.verdict.tolist() == ["outside", "inside"] and found.row.tolist() == [0, 2]
    with pytest.raises(stellate.InputError, match="are X,Y,Z"):
        stellate.form("x^2 + y^2 + z^2 = 1").sign([[0, 0]])


def test_arrow_in_and_out():
    pyarrow = pytest.importorskip("pyarrow")
    table = pyarrow.table({"id": ["a", "b", "c"], "y": [0.0, 0.0, 3.0], "x": [1.0, 1.05, 4.0]})
    x = table.column("x").chunk(0).to_numpy()
    assert np.shares_memory(columns(table).axes[0], x)
    found = stellate.inspect("x^2 + y^2 = 1", table, "1/10", keep=True)
    out = found.to_arrow()
    assert out.column_names == ["id", "y", "x", "verdict", "curve", "distance_low", "distance_high", "sign"]
    assert out.column("verdict").to_pylist() == ["inside", "inside", "outside"]
    assert out.column("curve").to_pylist() == [True, True, False]
    assert out.column("sign").to_pylist() == [0, 1, 1]
    # By the interface alone, without a method of pyarrow.
    again = pyarrow.table(stellate.inspect("x^2 + y^2 = 1", table.to_batches()[0], "1/10"))
    assert again.column("distance_high").to_pylist() == out.column("distance_high").to_pylist()
    chunks = pyarrow.concat_tables([table, table])
    assert stellate.form("x^2 + y^2 = 1").sign(chunks).tolist() == [0, 1, 1] * 2
    renamed = table.rename_columns(["id", "north", "east"])
    assert stellate.inspect("x^2 + y^2 = 1", renamed, 1, names=("east", "north")).inside.tolist() == [True, True, False]
    with pytest.raises(stellate.InputError, match="no column 'x'"):
        stellate.inspect("x^2 + y^2 = 1", renamed, 1)
    with pytest.raises(stellate.InputError, match="column .id.: numbers are expected"):
        stellate.inspect("x^2 + y^2 = 1", table, 1, names=("id", "y"))
    with_null = pyarrow.table({"x": [1.0, None], "y": [0.0, 0.0]})
    with pytest.raises(stellate.InputError, match="row 1"):
        stellate.inspect("x^2 + y^2 = 1", with_null, 1)
    kept = stellate.inspect("x^2 + y^2 = 1", with_null, 1, skip_bad=True, keep=True).to_arrow()
    assert kept.num_rows == 1 and kept.column("x").to_pylist() == [1.0]
    # Open curves have no sides.
    parabola = stellate.inspect("x = t; y = t^2", table, 1).to_arrow()
    assert parabola.column("sign").to_pylist() == [None] * 3
    assert stellate.sample("x^2 + y^2 = 4", 4).to_arrow().column("u").to_pylist()[0] == "1"


def test_batches_are_answered_with_their_rows():
    pyarrow = pytest.importorskip("pyarrow")
    import pickle

    from stellate.batches import Inspect

    stage = pickle.loads(pickle.dumps(Inspect("R = 1 + Y(2,0)/9", 0.25, ("a", "b", "c"))))
    rng = np.random.default_rng(1)
    table = pyarrow.table({name: rng.normal(size=100) for name in ("b", "a", "c", "weight")})
    whole = stage(table)
    for size in (1, 7, 100):
        parts = list(stage.batches(table.to_batches(max_chunksize=size)))
        assert pyarrow.Table.from_batches(parts).equals(whole.combine_chunks())
    empty = stage(table.to_batches()[0].slice(0, 0))
    assert empty.num_rows == 0 and empty.schema == whole.schema


def test_a_sign_takes_microseconds():
    """The bound is generous: builds with debug checks and busy machines pass, and reading the form again for every call does not."""
    for text, point in (("r = 1 + cos(3*t)/8", (0.3, 0.4)), ("x^4 + y^4 + z^4 = 1", (0.3, 0.4, 0.5))):
        form, points = stellate.form(text), np.array([point])
        assert form.sign(points).tolist() == [-1]
        best = np.inf
        for _ in range(20):
            start = time.perf_counter()
            for _ in range(50):
                form.sign(points)
            best = min(best, (time.perf_counter() - start) / 50)
        assert best < 100e-6
