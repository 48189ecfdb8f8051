"""Forms, errors and stages of a cluster that go to another process, and the columns that come back."""

import multiprocessing
import pickle
import shutil
from pathlib import Path

import numpy as np
import pytest

import stellate

BUTTERFLY = Path(__file__).resolve().parents[2] / "paper-examples/e02-butterfly"


@pytest.mark.parametrize("kind", ["StellateError", "InputError", "LimitReached", "InternalError"])
def test_errors_can_be_pickled(kind):
    error = getattr(stellate, kind)("what is wrong")
    again = pickle.loads(pickle.dumps(error))
    assert type(again) is type(error) and again.args == error.args
    assert type(error).__module__ == "stellate"


def test_errors_of_other_processes_arrive():
    with multiprocessing.get_context("spawn").Pool(1) as pool:
        with pytest.raises(stellate.InputError, match="unknown"):
            pool.apply(stellate.describe, ("x = q",))
    with pytest.raises(stellate.LimitReached) as caught:
        stellate.implicitize("r = 1 + cos(60*t)", max_degree=80)
    caught.value.finished = b"half"
    assert pickle.loads(pickle.dumps(caught.value)).finished == b"half"


def test_an_outline_travels_with_its_vertices(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    for name in ("butterfly.csv", "butterfly.png"):
        shutil.copy(BUTTERFLY / name, name)
    Path("weighted.csv").write_text("x,y,w\n" + "".join(f"{x},{y},{w}\n" for x, y, w in [(0, 0, 1), (3, 0, 2), (4, 2, 1), (3, 5, 1), (0.1, 4, 7), (-1, 2, 1)]))
    forms = [
        stellate.form("butterfly.csv"),
        stellate.form("butterfly.png"),
        stellate.form("butterfly.csv", cloud=True),
        stellate.form("weighted.csv", weights="w"),
        stellate.form("weighted.csv", columns="1,2"),
    ]
    known = [stellate.fit(form, 2).form for form in forms]
    copies = [pickle.dumps(form) for form in forms]
    for name in ("butterfly.csv", "butterfly.png", "weighted.csv"):
        Path(name).unlink()
        # Another outline has the name.
        Path("weighted.csv").write_text("x,y,w\n0,0,1\n1,0,1\n0,1,1\n")
    for form, copy, fit in zip(forms, copies, known):
        again = pickle.loads(copy)
        assert again == form and hash(again) == hash(form) and again.kind == "contour"
        assert stellate.fit(again, 2).form == fit
        assert stellate.form(form.to_json()) == form
    assert len(set(forms)) == 5
    assert len(stellate.fit([pickle.loads(copies[0])], 2, all=True)) == 1
    with pytest.raises(stellate.InputError, match="columns"):
        stellate.form(pickle.loads(copies[0]), columns="2,1").kind


def test_outlines_are_equal_by_their_data(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    shutil.copy(BUTTERFLY / "butterfly.csv", "butterfly.csv")
    one = stellate.form("butterfly.csv")
    assert one == stellate.form("./butterfly.csv") == stellate.form(tmp_path / "butterfly.csv", repair=True)
    points = np.loadtxt("butterfly.csv", delimiter=",")
    assert one == stellate.from_points(points) != stellate.from_points(points[1:])
    angles = np.linspace(0, 2 * np.pi, 100, endpoint=False)
    ring = np.column_stack([2 * np.cos(angles), np.sin(angles)])
    mended = stellate.from_points(np.insert(ring, 1, [[2.1, 0.1], [2.1, -0.1]], axis=0), repair=True)
    # The loop is cut off where the outline meets itself.
    assert mended == pickle.loads(pickle.dumps(mended)) == stellate.form(mended.to_json())
    assert len(mended.document["points"]) == len(ring) + 1


@pytest.mark.parametrize("options", [{"numbers": "f64"}, {}])
def test_a_form_is_shown_with_how_it_is_read(options):
    form = stellate.form("x = 0.3", **options)
    assert eval(repr(form)) == form
    assert (form == stellate.form("x = 0.3")) == (not options)


def test_the_center_is_shown():
    points = [[3 + np.cos(a), np.sin(a)] for a in np.linspace(0, 6.2, 60)]
    fit = stellate.fit(points, 3, center=("7/2", "-1/4")).form
    assert fit.center is not None
    shown = r"\quad \text{with the origin at } \left(\frac{7}{2}, -\frac{1}{4}\right)"
    for form in (fit, stellate.implicitize(fit)):
        assert form.latex().endswith(shown) and shown in form._repr_latex_()
    assert "origin" not in stellate.implicitize(fit, coordinates="original").latex()


def test_a_stage_reads_its_form_as_it_is_told():
    pyarrow = pytest.importorskip("pyarrow")
    from stellate.batches import Inspect

    table = pyarrow.table({"x": [0.3], "y": [0.0]})
    verdict = {}
    for numbers in ("exact", "f64"):
        stage = pickle.loads(pickle.dumps(Inspect("r = 0.3", "1e-30", numbers=numbers)))
        verdict[numbers] = stage(table).column("verdict").to_pylist()
        assert verdict[numbers] == stellate.inspect("r = 0.3", table, "1e-30", numbers=numbers).verdict.tolist()
    assert verdict == {"exact": ["outside"], "f64": ["inside"]}


def test_a_stage_takes_an_outline_with_all_options():
    pyarrow = pytest.importorskip("pyarrow")
    from stellate.batches import Inspect

    table = pyarrow.table({"x": [840.0, 0.0], "y": [600.0, 0.0]})
    how = {"harmonics": 5, "feet": True, "uncertainty": "0.5", "time_limit": 100.0}
    found = Inspect(BUTTERFLY / "butterfly.csv", 1, **how)(table)
    direct = stellate.inspect(BUTTERFLY / "butterfly.csv", table, 1, keep=True, **how).to_arrow()
    assert found.equals(direct) and "foot_x" in found.column_names
    coarse = Inspect(BUTTERFLY / "butterfly.csv", 1, harmonics=5, decimals=0, samples=64)
    assert stellate.form(coarse.document) == stellate.fit(BUTTERFLY / "butterfly.csv", 5, decimals=0, samples=64).form


def test_no_points_have_the_columns_of_points():
    pyarrow = pytest.importorskip("pyarrow")
    from stellate.batches import Inspect

    for form, size in (("r = 1", 2), ("R = 1", 3), ("x^2 + y^2 = 1", 3)):
        found = stellate.inspect(form, np.empty((0, size)), 1, feet=True)
        assert found.foot.shape == found.normal.shape == (0, size) and found.signed_low.shape == (0,)
        names = "xyz"[:size]
        batch = pyarrow.record_batch({name: [1.0, 2.0] for name in names})
        stage = Inspect(form, 1, names, feet=True)
        assert stage(batch.slice(0, 0)).schema == stage(batch).schema


def test_a_column_with_the_name_of_an_answer_is_refused():
    pyarrow = pytest.importorskip("pyarrow")
    from stellate.batches import Inspect

    columns = {"x": [1.0], "y": [0.0]}
    for name, feet in (("verdict", False), ("sign", True), ("foot_x", True)):
        table = pyarrow.table({**columns, name: [1.0]})
        with pytest.raises(stellate.InputError, match=f"column '{name}' already"):
            Inspect("r = 1", 1, feet=feet)(table)
        with pytest.raises(stellate.InputError, match=f"column '{name}' already"):
            stellate.inspect("r = 1", table, 1, keep=True, feet=feet)
        # Without the other columns of the table the answers stand alone.
        assert stellate.inspect("r = 1", table, 1, feet=feet).to_arrow().column("verdict").to_pylist() == ["inside"]
    free = pyarrow.table({**columns, "foot_x": [1.0], "foot_z": [2.0]})
    assert Inspect("r = 1", 1)(free).column_names[:4] == ["x", "y", "foot_x", "foot_z"]
    with pytest.raises(stellate.InputError, match="foot_x"):
        Inspect("r = 1", 1, feet=True)(free)
