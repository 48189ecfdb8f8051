"""Long work: progress, interruptions, limits, threads, forks and proofs."""

import json
import logging
import os
import signal
import subprocess
import sys
import threading
import time

import numpy as np
import pytest

import stellate

# The equation of degree 302 takes long, and its resultant has few checkpoints.
LONG = "x = cos(t) + cos(70*t)/9 + cos(150*t)/30; y = sin(t) + sin(90*t)/7 + sin(151*t)/40"


def interrupted(code, delay):
    """The time from Ctrl-C until a program of Python has ended, and what it has written."""
    program = subprocess.Popen(
        [sys.executable, "-c", code], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True
    )
    assert program.stdout is not None and program.stdout.readline() == "ready\n"
    time.sleep(delay)
    start = time.perf_counter()
    program.send_signal(signal.SIGINT)
    out = program.communicate(timeout=60)[0]
    return time.perf_counter() - start, out


@pytest.mark.parametrize(
    "work",
    [
        f"stellate.implicitize({LONG!r}, method='resultant')",
        "stellate.inspect('x^4 + y^4 + z^4 = 1', np.random.default_rng(1).normal(size=(3_000_000, 3)), 0.1)",
    ],
)
def test_ctrl_c_ends_work(work):
    code = (
        "import numpy as np, os, stellate\n"
        "print('ready', flush=True)\n"
        f"try:\n    {work}\n"
        "except KeyboardInterrupt:\n    print('interrupted', flush=True)\n    os._exit(0)\n"
    )
    taken, out = interrupted(code, 1.0)
    assert out == "interrupted\n"
    assert taken < 2.0


def test_a_form_can_be_asked_again_after_an_interruption():
    form = stellate.form("x^4 + y^4 + z^4 = 1")
    points = np.random.default_rng(2).normal(size=(300_000, 3))
    form.sign(points[:10])

    def stop(what, done, total):
        raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        stellate.inspect(form, points, 0.1, progress=stop)
    found = stellate.inspect(form, points[:1000], 0.1)
    assert len(found) == 1000


def test_progress_is_told():
    told = []
    points = np.random.default_rng(3).normal(size=(100_000, 3))
    stellate.inspect("x^2 + y^2 + z^2 = 1", points, 0.1, progress=lambda *now: told.append(now))
    assert told and told[-1] == ("inspecting", 100_000, 100_000)
    done = [now[1] for now in told]
    assert done == sorted(done)
    told.clear()
    stellate.sample("r = 1 + cos(40*t)/3", 20_000, progress=lambda *now: told.append(now))
    assert told[-1] == ("directions", 20_000, 20_000)


def test_an_error_of_the_callback_ends_the_work():
    def fail(*now):
        raise ValueError("enough")

    with pytest.raises(ValueError, match="enough"):
        stellate.sample("r = 1 + cos(80*t)/3", 100_000, progress=fail)


def test_other_threads_run_meanwhile():
    counted = 0
    done = threading.Event()

    def count():
        nonlocal counted
        while not done.is_set():
            counted += 1
            time.sleep(0.001)

    other = threading.Thread(target=count)
    other.start()
    start = time.perf_counter()
    stellate.sample("r = 1 + cos(80*t)/3", 40_000)
    taken = time.perf_counter() - start
    done.set()
    other.join()
    assert counted > taken * 50


def test_time_limits():
    start = time.perf_counter()
    with pytest.raises(stellate.LimitReached, match="time-limit"):
        stellate.implicitize(LONG, method="resultant", time_limit=0.3)
    assert time.perf_counter() - start < 3
    with pytest.raises(stellate.LimitReached):
        stellate.inspect("x^4 + y^4 + z^4 = 1", np.random.default_rng(4).normal(size=(2_000_000, 3)), 0.1, time_limit=0.2)
    with pytest.raises(stellate.InputError, match="time_limit"):
        stellate.describe("x = y", time_limit=-1)


def test_the_answer_does_not_depend_on_threads():
    points = np.random.default_rng(6).normal(size=(2000, 2))
    one, two = (stellate.inspect("y^2 = x^3 - x", points, 0.3, threads=n) for n in (1, 2))
    assert one.distance_low.tolist() == two.distance_low.tolist()
    with pytest.raises(stellate.InputError, match="at least one thread"):
        stellate.describe("x = y", threads=0)


@pytest.mark.skipif(not hasattr(os, "fork"), reason="there is no fork here")
def test_a_forked_process_has_threads_of_its_own():
    code = (
        "import os, numpy as np, stellate\n"
        "points = np.random.default_rng(1).normal(size=(1000, 2))\n"
        "form = stellate.form('y^2 = x^3 - x')\n"
        "mine = stellate.inspect(form, points, 1).distance_high.sum()\n"
        "child = os.fork()\n"
        "if child == 0:\n"
        "    theirs = stellate.inspect(form, points, 1).distance_high.sum()\n"
        "    os._exit(0 if theirs == mine else 1)\n"
        "assert os.waitpid(child, 0)[1] == 0\n"
    )
    subprocess.run([sys.executable, "-W", "ignore", "-c", code], check=True, timeout=60)


def test_an_import_takes_nothing_that_is_not_used():
    code = (
        "import sys, numpy\nbefore = set(sys.modules)\nimport stellate\n"
        "print(*sorted(name.split('.')[0] for name in set(sys.modules) - before))"
    )
    run = subprocess.run([sys.executable, "-c", code], check=True, capture_output=True, text=True)
    imported = set(run.stdout.split())
    assert "stellate" in imported
    assert not imported & {"pyarrow", "sympy", "pandas", "pyspark", "csv", "dataclasses", "logging"}


def test_remarks_are_logged(caplog):
    with caplog.at_level(logging.INFO, logger="stellate"):
        stellate.inspect("x^2 + y^2 = 1", [[0, 0]], 1)
        assert not caplog.records
        stellate.sample("x*y*(x^2 + y^2 - 1) = 0", theta=0.0)
    assert any("theta" in record.getMessage() or "line" in record.getMessage() for record in caplog.records)


def test_proofs_are_written_and_hold(tmp_path):
    proof = tmp_path / "proof.json"
    stellate.sample("x^4 - x^2 + y^2 = 0", 8, proof=proof)
    found = stellate.verify(proof)
    assert found["holds"] and found["claims"] >= 8
    stellate.inspect("x^2 + y^2 = 1", [[1.05, 0.0], [3.0, 0.0]], "1/10", proof=proof)
    assert stellate.verify(proof)["holds"]
    stellate.describe("x^2 + y^2 = 1", proof=proof)
    assert json.loads(proof.read_text())["kind"] == "proof"
    assert not list(tmp_path.glob("*.part"))
