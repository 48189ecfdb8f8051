"""Inspection on Spark with two worker processes, and on Dask and Ray. It is run with STELLATE_CLUSTERS=1, where these and Java are
installed."""

import os
import re
import shutil
import signal
import sys
import threading
import time
from pathlib import Path

import numpy as np
import pytest

import stellate

pytestmark = pytest.mark.skipif(
    not os.environ.get("STELLATE_CLUSTERS"), reason="clusters are started with STELLATE_CLUSTERS=1"
)
TORUS = "(x^2 + y^2 + z^2 + 3)^2 = 16*(x^2 + y^2)"
ROWS = 120_000


@pytest.fixture(scope="module")
def spark():
    pytest.importorskip("pyspark")
    if shutil.which("java") is None:
        pytest.skip("Spark needs Java")
    from pyspark.sql import SparkSession

    # The two workers are on this machine, whatever network it has.
    os.environ.setdefault("SPARK_LOCAL_IP", "127.0.0.1")
    # Their Python is the one that has the packages.
    os.environ["PYSPARK_PYTHON"] = os.environ["PYSPARK_DRIVER_PYTHON"] = sys.executable
    session = (
        SparkSession.builder.master("local-cluster[2,1,1024]")
        .config("spark.ui.enabled", "false")
        .config("spark.sql.shuffle.partitions", "5")
        .config("spark.sql.execution.arrow.maxRecordsPerBatch", "5000")
        .config("spark.executorEnv.PYTHONPATH", os.environ.get("PYTHONPATH", ""))
        .getOrCreate()
    )
    yield session
    session.stop()


@pytest.fixture(scope="module")
def points(tmp_path_factory):
    """A Parquet file, and the answers of one process."""
    pyarrow = pytest.importorskip("pyarrow")
    import pyarrow.parquet

    rng = np.random.default_rng(8)
    u, v = rng.uniform(0, 2 * np.pi, (2, ROWS))
    tube = 1 + rng.normal(scale=0.08, size=ROWS)
    # Some points are far away, and take longer.
    tube[::100] = rng.uniform(0, 3, ROWS // 100)
    places = ((2 + tube * np.cos(v)) * np.cos(u), (2 + tube * np.cos(v)) * np.sin(u), tube * np.sin(v))
    columns = {axis: np.round(place, 4) for axis, place in zip("xyz", places)}
    table = pyarrow.table({"id": np.arange(ROWS), **columns})
    path = tmp_path_factory.mktemp("points") / "points.parquet"
    pyarrow.parquet.write_table(table, path, row_group_size=10_000)
    return path, stellate.inspect(TORUS, table, "1/10", keep=True).to_arrow()


def same_bytes(one, two):
    """Whether two tables are the same, byte for byte."""
    import pyarrow

    def written(table):
        sink = pyarrow.BufferOutputStream()
        plain = table.replace_schema_metadata(None).combine_chunks()
        plain = pyarrow.table({name: plain.column(name).combine_chunks() for name in plain.column_names})
        with pyarrow.ipc.new_stream(sink, plain.schema) as out:
            out.write_table(plain)
        return sink.getvalue().to_pybytes()

    return written(one) == written(two)


def read(folder):
    import pyarrow.parquet

    return pyarrow.parquet.read_table(folder).sort_by("id")


@pytest.mark.parametrize("partitions", [1, 3, 16])
def test_any_partitioning_gives_the_bytes_of_one_process(spark, points, tmp_path, partitions):
    from stellate.spark import inspect

    path, expected = points
    frame = spark.read.parquet(str(path)).repartition(partitions)
    inspect(frame, TORUS, "1/10").write.parquet(str(tmp_path / "out"))
    assert same_bytes(read(tmp_path / "out"), expected)


def test_the_columns_are_named(spark, points):
    from stellate.spark import inspect

    path, _ = points
    frame = spark.read.parquet(str(path)).limit(10).withColumnRenamed("x", "east")
    found = inspect(frame, TORUS, "1/10", columns=("east", "y", "z"))
    assert found.columns == ["id", "east", "y", "z", "verdict", "curve", "distance_low", "distance_high", "sign"]
    assert found.count() == 10
    with pytest.raises(stellate.InputError, match="verdict"):
        inspect(found, TORUS, "1/10", columns=("east", "y", "z"))


def executors(spark):
    """The process ids of the workers' processes of this application."""
    name = spark.sparkContext.applicationId
    found = []
    for folder in Path("/proc").glob("[0-9]*"):
        try:
            words = (folder / "cmdline").read_bytes().decode(errors="replace").split("\0")
        except OSError:
            continue
        if any("ExecutorBackend" in word for word in words) and name in words:
            found.append(int(folder.name))
    return found


@pytest.mark.skipif(not Path("/proc").is_dir(), reason="processes are found in /proc")
def test_a_killed_worker_loses_and_doubles_nothing(spark, points, tmp_path):
    from stellate.spark import inspect

    path, expected = points
    # Slower than it has to be, so that the work is in its middle when the worker dies.
    frame = spark.read.parquet(str(path)).repartition(40)
    work = inspect(frame, TORUS, "1/10", digits=12)
    answers = stellate.inspect(TORUS, expected.select(["id", "x", "y", "z"]), "1/10", digits=12, keep=True)
    failed = []

    def run():
        try:
            work.write.parquet(str(tmp_path / "out"))
        except Exception as error:
            failed.append(error)

    before = executors(spark)
    assert len(before) == 2
    job = threading.Thread(target=run)
    job.start()
    tracker = spark.sparkContext.statusTracker()
    deadline = time.monotonic() + 60
    while time.monotonic() < deadline:
        stages = [tracker.getStageInfo(stage) for stage in tracker.getActiveStageIds()]
        if any(stage and 2 <= stage.numCompletedTasks < stage.numTasks - 4 for stage in stages if stage.numTasks == 40):
            break
        time.sleep(0.01)
    else:
        pytest.fail("the work was never seen in its middle")
    os.kill(before[0], signal.SIGKILL)
    job.join(300)
    assert not job.is_alive() and not failed
    assert before[0] not in executors(spark)
    out = read(tmp_path / "out")
    assert out.num_rows == ROWS
    assert same_bytes(out, answers.to_arrow())


def run_example(of, points, folder, monkeypatch, **names):
    """Runs an example of the guide on the points, and compares its answers."""
    text = (Path(__file__).resolve().parents[2] / "src/guide/clusters.md").read_text()
    (block,) = (b.split("```")[0] for b in text.split("```python\n")[1:] if of in b)
    shutil.copy(points[0], folder / "measured.parquet")
    monkeypatch.chdir(folder)
    # The processes of a cluster have folders of their own.
    exec(re.sub(r'"(\w[-\w]*\.parquet)"', rf'"{folder}/\1"', block), names)
    (out,) = folder.glob("verdicts*.parquet")
    found = read(out)
    assert found.column_names == points[1].column_names
    for name in found.column_names:
        assert found.column(name).to_pylist() == points[1].column(name).to_pylist()


def test_the_example_of_spark(spark, points, tmp_path, monkeypatch):
    run_example("stellate.spark", points, tmp_path, monkeypatch, spark=spark)


def test_the_example_of_dask(points, tmp_path, monkeypatch):
    pytest.importorskip("dask.dataframe")
    run_example("dask.dataframe", points, tmp_path, monkeypatch)


def test_the_example_of_ray(points, tmp_path, monkeypatch):
    ray = pytest.importorskip("ray")
    ray.init(num_cpus=2, include_dashboard=False, log_to_driver=False)
    try:
        run_example("ray.data", points, tmp_path, monkeypatch)
    finally:
        ray.shutdown()
