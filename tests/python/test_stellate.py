"""The Python package, against SymPy and against the program's own documents."""

import doctest
import json
import pickle
import re
import subprocess
import sys
from fractions import Fraction
from pathlib import Path

import numpy as np
import pytest

import stellate

ROOT = Path(__file__).resolve().parents[2]


def test_terms_are_exact():
    curve = stellate.form("x^2 + y^2 = 1/3")
    assert curve.terms == {(2, 0): 1, (0, 2): 1, (0, 0): Fraction(-1, 3)}
    assert stellate.form(curve.terms).terms == curve.terms
    assert stellate.from_series([0.1]).cos == [Fraction(0.1)]


def test_equation_of_theorem_2_is_that_of_sympy():
    sympy = pytest.importorskip("sympy")
    x, y = sympy.symbols("x y")
    found = stellate.implicitize("r = 1 + cos(t)/5 + sin(2*t)/7").sympy()
    # Theorem 2 with N = 2: ρ (ρ − B)² − A², where A = 2xy/7 + ρ collects the even and B = x/5 the odd harmonics.
    rho = x**2 + y**2
    expected = sympy.expand(rho * (rho - x / 5) ** 2 - (2 * x * y / 7 + rho) ** 2)
    ratio = sympy.Poly(found, x, y).LC() / sympy.Poly(expected, x, y).LC()
    assert sympy.expand(found - ratio * expected) == 0
    assert sympy.Poly(found, x, y).total_degree() == 6


def test_round_trips():
    form = stellate.form("r = 2 + cos(3*t)/5")
    again = pickle.loads(pickle.dumps(form))
    assert again == form and hash(again) == hash(form)
    assert stellate.form(form.to_json()) == form
    assert form != stellate.form("r = 2")
    assert form.latex() == r"r = 2 + \frac{1}{5} \cos 3\theta"
    assert stellate.form("x^2 - y = 0").latex() == "x^{2} - y = 0"
    assert "<svg" in form._repr_svg_()


def test_radius_sign_and_distance():
    form = stellate.form("r = 1 + cos(3*t)/5")
    theta = np.linspace(0, 6, 50).reshape(5, 10)
    assert np.allclose(form.radius(theta), 1 + np.cos(3 * theta) / 5, atol=1e-14)
    # The double -0.8 is a little beyond r(pi) = 4/5.
    assert form.sign([[0, 0], [-0.8, 0], [5, 5]]).tolist() == [-1, 1, 1]
    # r(0) = 6/5 is no double, but (9/8, 0) is a point of r = 1 + cos(3t)/8 exactly.
    touched = stellate.form("r = 1 + cos(3*t)/8")
    assert touched.sign([[1.125, 0], [1.125000001, 0]]).tolist() == [0, 1]
    # An open curve has no sides.
    parabola = stellate.form("x = t; y = t^2")
    assert stellate.inspect(parabola, [[0, 1]], tolerance=1).sign.mask.all()
    with pytest.raises(stellate.InputError, match="no side"):
        parabola.sign([[0, 1]])
    low, high = stellate.form("x^2 + y^2 = 4").distance([[0, 5], [0, 1]])
    assert np.all(low <= [3, 1]) and np.all(high >= [3, 1]) and np.allclose(low, high, rtol=1e-5)


def test_samples_are_columns():
    found = stellate.sample("x^2 + y^2 = 4", 8)
    assert found.r.shape == (16,) and set(np.abs(found.r)) == {2.0}
    u, v = found.directions[3]
    assert u * u + v * v == 1
    space = stellate.sample("x^2 + y^2 + z^2 = 9", theta=["30deg"], phi=[1.0])
    assert space.z is not None and space.phi is not None


def test_a_fit_of_points():
    angles = np.linspace(0, 2 * np.pi, 400, endpoint=False)
    points = np.column_stack([3 * np.cos(angles), 2 * np.sin(angles)])
    fit = stellate.fit(points, 12)
    assert fit.form.kind == "fourier" and len(fit.form.cos) == 13
    low, high = fit.distance
    assert 0 <= low <= high < 0.05
    elliptic = stellate.fit(points, 1, model="elliptic")
    assert stellate.implicitize(elliptic.form).degree == 2
    again = stellate.fit(points, tolerance=0.01).form
    assert len(again.cos) <= 13


def test_inspection_and_check():
    found = stellate.inspect("x^2 + y^2 = 1", [[1.05, 0], [2, 0]], tolerance="1/10")
    assert found.verdict.tolist() == ["inside", "outside"]
    right = stellate.check("x^2 + y^2 = 1", coefficients={(2, 0): 1.0, (0, 2): 1.0, (0, 0): -1.0})
    assert right["missing"] == [] and right["mistakes"] == []
    wrong = stellate.check("x^2 + y^2 = 1", coefficients={(2, 0): 1.0, (0, 0): -1.0})
    assert wrong["missing"] and len(wrong.columns["digits"]) == wrong["compared"] + 1
    # Harmonic surfaces: by (l, m), and radii in directions of two angles.
    surface = "R = 2 + Y(1,0)/2 + Y(2,-1)/7"
    values = {(0, 0): 2.0, (1, 0): 0.5, (2, -1): 1 / 7}
    assert stellate.check(surface, coefficients=values, digits=12).passes
    flipped = stellate.check(surface, coefficients={**values, (2, -1): -1 / 7})
    assert flipped.mistakes
    theta, phi = np.meshgrid(np.linspace(0, 6, 8), np.linspace(0.1, 3, 8))
    radii = stellate.form(surface).radius(theta, phi)
    rows = np.column_stack([theta.ravel(), phi.ravel(), radii.ravel()])
    assert stellate.check(surface, radii=rows, digits=12).passes
    with pytest.raises(stellate.InputError, match="keys"):
        stellate.check(surface, coefficients={(1,): 2.0})
    with pytest.raises(stellate.InputError, match="one of"):
        stellate.check(surface)
    ladder = stellate.check("r = 1 + cos(3*t)/5", itself=True)
    assert len(ladder.columns) >= 3 and "numbers of harmonics" in repr(ladder)
    assert f"{right['compared']} compared" in repr(right)


def test_fits_of_many_kinds(tmp_path):
    butterfly = ROOT / "paper-examples/e02-butterfly"
    table = stellate.fit(butterfly / "butterfly.png", 5, all=True)
    assert len(table) == 1 and table.columns["harmonics"].tolist() == [5]
    several = stellate.fit([butterfly / "butterfly.csv", butterfly / "butterfly.png"], 2, all=True)
    assert several.columns["blob"].tolist() == [1, 1]
    angles = np.linspace(0, 2 * np.pi, 300, endpoint=False)
    ring = np.column_stack([2 * np.cos(angles), np.sin(angles)])
    shuffled = np.random.default_rng(1).permutation(ring)
    assert stellate.fit(shuffled, 4, cloud=True).form.kind == "fourier"
    path = tmp_path / "weighted.csv"
    rows = "".join(f"{x!r},{y!r},1\n" for x, y in ring.tolist())
    path.write_text("x,y,w\n" + rows)
    assert stellate.fit(path, 4, weights="w").form.kind == "fourier"
    heavy = np.where(ring[:, 0] > 0, 9.0, 1.0)
    squashed = ring * np.random.default_rng(2).uniform(0.9, 1.1, (300, 1))
    by_array = stellate.fit(squashed, 4, weights=heavy).form
    path.write_text("x,y,w\n" + "".join(f"{x!r},{y!r},{w!r}\n" for (x, y), w in zip(squashed.tolist(), heavy.tolist())))
    assert by_array == stellate.fit(path, 4, weights="w").form != stellate.fit(squashed, 4).form
    with pytest.raises(stellate.InputError, match="one for each"):
        stellate.fit(ring, 4, weights=[1.0])
    path.write_text("x,y,w\n" + rows)
    assert stellate.fit(path, 4, columns=(1, 2)).form == stellate.fit(ring, 4).form
    stellate.mesh("R = 2 + Y(1,0)/2", tmp_path / "egg.ply", resolution=16)
    egg = stellate.fit(tmp_path / "egg.ply", degree=3, center=(0, 0, 0))
    assert egg.form.kind == "spherical" and abs(float(egg.form.coefficients[1, 0]) - 0.5) < 0.05
    with pytest.raises(stellate.InputError, match="degree or tolerance"):
        stellate.fit(tmp_path / "egg.ply", 3, degree=3)
    with pytest.raises(stellate.InputError, match="closed mesh"):
        stellate.fit(ring, degree=3)
    crossing = np.insert(ring, 1, [[2.1, 0.1], [2.1, -0.1]], axis=0)
    with pytest.raises(stellate.InputError, match="cross|touch"):
        stellate.fit(crossing, 4)
    assert stellate.fit(crossing, 4, repair=True).form.kind == "fourier"


def test_a_table_of_fits_has_columns_of_one_type(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    square = "x,y\n0,0\n{0},0\n{0},{0}\n0,{0}\n"
    names = ["#1.csv", "001", "1e5.csv", 'a, "b".csv']
    for name in names:
        Path(name).write_text(square.format("2e20"))
    for model in ("radius", "elliptic"):
        table = stellate.fit(names, 2, model, all=True)
        assert table.columns["file"].tolist() == names
        assert table.to_arrow().column("file").to_pylist() == names
        kinds = {name: column.dtype.kind for name, column in table.columns.items()}
        texts = {"file": "U", "model": "U", "star_shaped": "U", "blob": "i", "harmonics": "i", "degree": "i"}
        assert kinds == {name: texts.get(name, "f") for name in kinds}
        assert len(stellate.fit(["#1.csv"], 2, model, all=True)) == 1
    assert np.isnan(table.columns["center_x"]).all()
    # The coefficient of a large outline is larger than all integers of 64 bits.
    assert stellate.fit("001", 0, all=True).columns["cos_0"][0] > 2.0**63


@pytest.mark.parametrize(
    "call, message",
    [
        (lambda: stellate.describe("r = 1 + 3/2*cos(2*t)", digits=65536), "--digits 65536: .*to 10000"),
        (lambda: stellate.parametrize("x^2 + y^2 = 2x", digits=70000), "--digits 70000"),
        (lambda: stellate.check("r = 1", radii=[[0, 1]], digits=10001), "--digits 10001"),
        (lambda: stellate.form("r = 1").distance([2, 0], digits=10001), "--digits 10001"),
        (lambda: stellate.inspect("r = 1", [[5, 0]], 1, reach=-1), "--reach -1: .*greater than 0"),
        (lambda: stellate.inspect("r = 1", [[5, 0]], 1, reach=0), "--reach 0"),
        (lambda: stellate.inspect("r = 1", [[5, 0]], 1, reach=np.inf), "reach: inf is not a finite number"),
        (lambda: stellate.inspect("r = 1", [[5, 0]], 1, budget=-1), "budget: expected a whole number.*not -1"),
        (lambda: stellate.describe("r = 1", time_limit=np.inf), "time_limit: inf"),
        (lambda: stellate.describe("r = 1", max_degree=2.5), "max_degree: expected a whole number"),
        (lambda: stellate.describe("r = 1", harmonics="x"), "harmonics: expected a whole number"),
        (lambda: stellate.plot("r = 1", window=(0, np.nan, 0, 1)), "window: nan"),
        (lambda: stellate.plot("r = 1", cells=0), "--cells 0: .*8 to 4000"),
        (lambda: stellate.plot("R = 1", view=(0, 90)), "--view 0,90"),
        (lambda: stellate.plot("R = 1", view=(0, 9, 0)), "view: expected fewer numbers"),
        (lambda: stellate.plot("x = t; y = t^2", range={"t": (1, 0)}), "--range t=1,0"),
        (lambda: stellate.plot("x = t; y = t^2", range={"t": (0, np.inf)}), "range: inf"),
        (lambda: stellate.mesh("R = 1", resolution=1), "--resolution 1: .*2 to 1024"),
        (lambda: stellate.sample("x^2 + y^2 = 1; z = y^5", resolution=1), "--resolution 1: .*2 to 4096"),
        (lambda: stellate.form("r = 1", threshold=300).kind, "threshold: expected .*0 to 254"),
        (lambda: stellate.fit(np.empty((0, 2)), 2), "at least three points"),
        (lambda: stellate.fit([[0, 0], [1, 0], [0, 1]], 2, weights=[1, np.nan, 1]), "weights: that of the point 1 is nan"),
        (lambda: stellate.fit([[0, 0], [1, 0], [0, 1]], 2, weights=[1, 1, -1]), "weights: that of the point 2 is -1"),
    ],
)
def test_options_out_of_range_are_named(call, message):
    with pytest.raises(stellate.InputError, match=message):
        call()


def test_numbers_of_numpy_are_options():
    assert len(stellate.sample("r = 1", np.int64(3))) == 6
    near, by_numpy = (stellate.inspect("x^2 + y^2 + z^2 = 1", [[9, 0, 0]], 1, reach=reach) for reach in (3.0, np.float32(3)))
    assert near.distance_low.tolist() == by_numpy.distance_low.tolist()
    points = [[0, 0], [4, 0], [3, 2], [0, 4]]
    harmonics = stellate.fit(points, np.int32(1), robust=np.bool_(True), threads=np.int16(1)).form.cos
    assert len(harmonics) == 2
    assert stellate.plot("R = 1", view=np.array([10, 20]), width=np.uint16(400)).startswith(b"<svg")


def test_a_missing_file_is_a_file_that_is_not_found():
    with pytest.raises(FileNotFoundError, match="missing.csv") as caught:
        stellate.form("missing.csv").kind
    assert caught.value.filename == "missing.csv"


def test_the_options_of_the_program():
    found = stellate.describe("y^2 = (x-1)^2*(x-2)", topology=True)["topology"]
    assert [point["kind"] for point in found["singular_points"]] == ["isolated"]
    arcs = stellate.sample("x^2 + y^2 = 1; z = y^5", resolution=32)
    assert arcs.z is not None and np.allclose(arcs.z, arcs.y**5, atol=1e-12)
    svg = stellate.plot("x = t; y = t^2", range={"t": (-1, 2)}, width=400, title="parabola")
    assert b"parabola" in svg
    stellate.plot("x^2 + y^2 + z^2 = 1", view=(10, 60), cells=12, point=[(0, 0, 1)])
    small = stellate.mesh("x^2 + y^2 + z^2 = 1", resolution=12, window=(-2, 2, -2, 2, -2, 2), angle=90)
    assert len(small.vertices) > 50 and small.to_arrow().num_rows == len(small.vertices)


def test_limits_uncertainties_and_feet():
    points = [[2.4, 3.2], [2.97, 3.96], [3.03, 4.04], [3.6, 4.8]]
    for form in ("x^2 + y^2 = 25", "r = 5", "x = 5*cos(t); y = 5*sin(t)"):
        found = stellate.inspect(form, points, ("-0.06", "0.02"), feet=True)
        assert found.verdict.tolist() == ["outside", "inside", "outside", "outside"]
        assert np.allclose(found.foot, [[3, 4]] * 4, rtol=0, atol=1e-14)
        assert np.allclose(found.normal, [[0.6, 0.8]] * 4, rtol=0, atol=1e-14)
        signed = np.array([-1, -0.05, 0.05, 1])
        assert (found.signed_low <= signed + 1e-15).all() and (signed - 1e-15 <= found.signed_high).all()
        table = found.to_arrow()
        assert table.column_names[5:] == ["foot_x", "foot_y", "normal_x", "normal_y", "signed_low", "signed_high"]
        uncertain = stellate.inspect(form, points, "0.5", uncertainty="0.48")
        assert uncertain.verdict.tolist() == ["outside", "uncertain", "uncertain", "outside"]
        assert repr(uncertain) == "<stellate inspection: 0 inside, 2 outside, 0 undecided, 2 uncertain>"
        assert uncertain.foot is None and uncertain.signed_low is None
    one = stellate.inspect("R = 3", [2.0, -4.0, 4.0], 1, feet=True)
    assert one.foot.shape == (3,) and np.allclose(one.foot, [1, -2, 2])
    space = stellate.inspect("x = 3*cos(t); y = 3*sin(t); z = 0", [[4, 0, 0]], 1, feet=True)
    assert np.isnan(space.normal).all() and np.isnan(space.signed_low).all()
    assert space.to_arrow().column("normal_x").null_count == 1
    for wrong in [(1, 2), (0, 0), (-1, 0, 1)]:
        with pytest.raises(stellate.InputError):
            stellate.inspect("r = 5", points, wrong)


def test_what_an_inspection_writes_beside(tmp_path):
    points = np.random.default_rng(1).normal(size=(50, 3))
    found = stellate.inspect(
        "x^2 + y^2 + z^2 = 1", points, "1/10", plot=tmp_path / "a.svg",
        report=tmp_path / "report", cloud=tmp_path / "a.ply",
    )  # fmt: skip
    assert len(found) == 50
    assert (tmp_path / "a.svg").read_text().startswith("<svg")
    assert "Summary" in (tmp_path / "report/index.html").read_text()
    assert b"element vertex 50" in (tmp_path / "a.ply").read_bytes()


def test_errors_are_exceptions():
    with pytest.raises(stellate.InputError, match="="):
        stellate.implicitize("x^2 + = 1")
    with pytest.raises(stellate.LimitReached):
        stellate.implicitize("r = 1 + cos(60*t)", max_degree=80)
    for terms in ({}, {(-1, 0): 1}, {(1,): 1}, {(1, 0): float("nan")}):
        with pytest.raises(stellate.InputError):
            stellate.form(terms)
    with pytest.raises(TypeError):
        stellate.form({(1.5, 0): 1})
    with pytest.raises(stellate.InputError):
        stellate.from_series([])
    with pytest.raises(stellate.InputError):
        stellate.plot()
    with pytest.raises(TypeError):
        stellate.fit([[0, 0], [1, 0], [0, 1]], harmonic=3)
    with pytest.raises(stellate.InputError, match="shape"):
        stellate.inspect("x^2 + y^2 = 1", np.zeros((2, 4)), tolerance=1)
    assert issubclass(stellate.InternalError, stellate.StellateError)


def test_pictures_meshes_and_proofs(tmp_path):
    assert stellate.plot("r = 1 + cos(t)/3").startswith(b"<svg")
    stellate.plot("x^2 + y^2 = 1", output=tmp_path / "a.png")
    assert (tmp_path / "a.png").read_bytes().startswith(b"\x89PNG")
    stellate.mesh("R = 2 + Y(1,0)/2", tmp_path / "a.obj", resolution=8)
    assert "f " in (tmp_path / "a.obj").read_text()
    found = stellate.verify(ROOT / "tests/proofs/example-8.json")
    assert found["holds"] and found["claims"] == 30
    assert "$defs" in stellate.schema()


def test_the_program_is_there():
    script = Path(sys.executable).with_name("stellate")
    run = subprocess.run([script, "describe", "x^2 = y", "--format", "json"], capture_output=True, text=True)
    assert run.returncode == 0 and json.loads(run.stdout)["degree"] == 2
    assert subprocess.run([script, "descibe", "x"], capture_output=True).returncode == 2


def test_examples_in_the_docstrings():
    pytest.importorskip("pyarrow")
    from stellate import _check, _form, _inspect, _verbs, batches

    tried = 0
    for module in (stellate, _check, _form, _inspect, _verbs, batches):
        result = doctest.testmod(module)
        assert result.failed == 0
        tried += result.attempted
    assert tried >= 25


def test_the_guide(tmp_path, monkeypatch):
    """The Python examples of the guide, one after the other."""
    text = (ROOT / "src/guide/python.md").read_text()
    blocks = re.findall(r"```python\n(.*?)```", text, re.S)
    assert len(blocks) >= 3
    monkeypatch.chdir(tmp_path)
    names = {"__name__": "guide"}
    (tmp_path / "butterfly.csv").write_bytes(
        (ROOT / "paper-examples/e02-butterfly/butterfly.csv").read_bytes()
    )
    for block in blocks:
        exec(block, names)
