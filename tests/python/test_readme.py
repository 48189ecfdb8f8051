"""The examples of the README give the same numbers in Python."""

import re
import shlex
from pathlib import Path

import numpy as np
import pytest

import stellate

ROOT = Path(__file__).resolve().parents[2]
TEXT = (ROOT / "README.md").read_text()


@pytest.fixture(scope="module")
def outputs():
    """The commands of the README and what they print."""
    blocks = re.findall(r"```console\n(.*?)```", TEXT, re.S)
    found = {}
    for block in blocks:
        for part in re.split(r"^\$ ", block, flags=re.M)[1:]:
            command, _, output = part.partition("\n")
            # The first example of each verb.
            if command.split()[1] in found:
                continue
            found[command.split()[1]] = (shlex.split(command)[2:], output.splitlines())
    return found


def test_implicitize(outputs):
    (text,), (equation,) = outputs["implicitize"]
    assert stellate.implicitize(text) == stellate.form(equation)


def test_describe(outputs):
    (text,), lines = outputs["describe"]
    found = stellate.describe(text)
    assert f"degree: {found['degree']}" in lines
    assert "homogeneous parts: " + ", ".join(map(str, found["homogeneous_degrees"])) in lines
    assert f"terms: {found['terms']}" in lines
    assert f"multiplicity of the origin: {found['origin_multiplicity']}" in lines


def test_sample(outputs):
    arguments, (header, row) = outputs["sample"]
    assert arguments[1:] == ["--theta", "pi/6", "--positive"]
    found = stellate.sample(arguments[0], theta="pi/6", positive=True)
    written = dict(zip(header.split(","), row.split(",")))
    for name, column in found.columns.items():
        assert float(written[name]) == column[0]
    assert tuple(map(str, found.directions[0])) == (written["u"], written["v"])


def test_parametrize(outputs):
    (text,), lines = outputs["parametrize"]
    (branch,) = stellate.parametrize(text)["branches"]
    assert f"r = {branch['radius']}" in lines


def test_fit(outputs):
    arguments, (note,) = outputs["fit"]
    assert arguments[1:5] == ["--harmonics", "39", "--decimals", "3"]
    found = stellate.fit(ROOT / arguments[0], 39, decimals=3)
    low, high = found.distance
    assert f"radial error ≈ {found.max_radial_error:.3e}".replace("e+0", "e") in note
    # The note has few digits and rounds the bounds outward.
    shown = [float(word) for word in re.search(r"distance (\S+) to (\S+) \(Hausdorff", note).groups()]
    assert 0.999 * low < shown[0] <= low <= high <= shown[1] < 1.001 * high


def test_inspect(outputs):
    arguments, lines = outputs["inspect"]
    assert arguments[1:] == ["--tolerance", "0.1", "--point", "0.66,0.88", "--format", "text"]
    # The point is exact in the README; a double is not the same point.
    found = stellate.inspect(arguments[0], [0.66, 0.88], "0.1")
    assert f"{found.distance_low:.4f} {found.distance_high:.4f}" == "0.1000 0.1000"
    assert "at least 0.0999" in lines[0] and found.sign == 1


def test_check(outputs):
    arguments, lines = outputs["check"]
    coefficients = stellate.implicitize(arguments[0]).terms
    found = stellate.check(arguments[0], coefficients=coefficients, digits=12)
    assert f"coefficients: {found['compared']} compared, {len(found['missing'])} missing, {len(found['extra'])} extra" in lines
    assert found.passes and "passes: everything has 12 digits" in lines
    assert found.columns["got"].tolist() == [1, 2, 1, -2, -2, -3, -4]
    assert np.all(found.columns["digits"] > 15)


def test_mesh(outputs, caplog):
    arguments, notes = outputs["mesh"]
    assert arguments[1:3] == ["--resolution", "24"]
    found = stellate.mesh(arguments[0], resolution=24)
    assert f"note: {len(found.vertices)} vertices, {len(found.triangles)} triangles" in notes[0]
    assert found.triangles.max() < len(found.vertices)
    assert np.allclose(np.hypot(np.hypot(*found.normals.T[:2]), found.normals.T[2]), 1, atol=1e-4)


def test_vectors(outputs):
    arguments, _ = outputs["vectors"]
    assert arguments[1:3] == ["--directions", "4"]
    assert stellate.vectors(arguments[0], directions=4)["kind"] == "vectors"


def test_verify_and_schema(outputs):
    (proof,), lines = outputs["verify"]
    found = stellate.verify(ROOT / proof)
    assert found["text"].splitlines() == lines and found["holds"]
    assert stellate.schema(outputs["schema"][0][0])["$schema"]
