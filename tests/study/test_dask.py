"""Sweeps on the workers of dask.distributed: the same results, and one run for a dead worker."""

from __future__ import annotations

import multiprocessing
import tempfile
import warnings
from types import SimpleNamespace

import pytest

import build_fmu
from build_fmu.errors import EnvironmentLackError, UsageError
from build_fmu.study import dask_workers
from build_fmu.study.engines import engine_of
from build_fmu.study.processes import DIED, Task, together
from tests.support.fmus.ending_jobs import FATAL, lost, slow, square
from tests.support.fmus.fmu_instance import pendulum

with warnings.catch_warnings():
    warnings.simplefilter("ignore")
    distributed = pytest.importorskip("distributed")
pytestmark = pytest.mark.filterwarnings("ignore")  # those of dask and its packages


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    """Folder for temporary files of workers."""
    with pytest.MonkeyPatch.context() as patch:
        path = tmp_path_factory.mktemp("temporary")
        patch.setenv("TMPDIR", str(path))
        patch.setattr(tempfile, "tempdir", None)
        yield path


@pytest.fixture(scope="module")
def engine(folder):
    """Two workers with a process each, and the engine that finds them; none is left afterwards."""
    settings = {"n_workers": 2, "threads_per_worker": 1, "dashboard_address": None}
    with (
        distributed.dask.config.set({"distributed.scheduler.allowed-failures": 0}),
        distributed.LocalCluster(**settings, local_directory=str(folder)) as cluster,
    ):
        yield f"dask://{cluster.scheduler_address.removeprefix('tcp://')}"
    assert multiprocessing.active_children() == []
    assert list(folder.rglob("fmu-*")) == []


def test_a_sweep_has_the_results_of_this_process(engine):
    arguments = {"grid": {"mass": [1.0, -1.0, 2.0, 3.0]}, "outputs": ["A.x", "energy.error"]}
    here = build_fmu.sweep(pendulum(), engine="serial", **arguments)
    there = build_fmu.sweep(pendulum(), engine=engine, **arguments)
    assert repr(there.tolist()) == repr(here.tolist())  # with NaN where no step was taken
    assert list(there["finished"]) == [True, False, True, True]


def test_a_sweep_takes_a_client_and_leaves_it_open(engine, tmp_path):
    arguments = {"grid": {"mass": [1.0, 2.0, 3.0]}, "outputs": ["A.x"], "stop_time": 0.1}
    here = build_fmu.sweep(pendulum(), engine="serial", **arguments)
    with distributed.Client(engine.replace("dask:", "tcp:")) as client:
        there = build_fmu.sweep(pendulum(), engine=client, path=tmp_path / "a.csv", **arguments)
        assert client.status == "running"
        assert client.submit(int, 3).result() == 3
    assert repr(there.tolist()) == repr(here.tolist())


def test_jobs_come_back_as_they_end(engine, monkeypatch):
    """Of jobs that take longer than what may come back at once, each comes back by itself."""
    monkeypatch.setattr(dask_workers, "TOGETHER", 0.01)
    with distributed.Client(engine.replace("dask:", "tcp:")) as client:
        sizes, submit = [], client.submit
        monkeypatch.setattr(
            client, "submit", lambda f, *x, **how: sizes.append(len(x[-1])) or submit(f, *x, **how)
        )
        found = dict(engine_of(client)(Task(slow, [1], lost), range(40)))
    assert found == {i: i for i in range(40)}
    assert sizes == [1] * 41  # with what all share


def test_short_jobs_go_together_and_long_ones_alone():
    limits = dask_workers.TOGETHER, dask_workers.MOST_TOGETHER
    assert together(0.0, 1, *limits) == dask_workers.MOST_TOGETHER
    assert together(0.1, 2, *limits) == 4
    assert together(1e3, 1, *limits) == 1


@pytest.mark.parametrize(("given", "words"), [(3, "got int"), (None, "got NoneType")])
def test_what_is_no_client_is_refused(given, words):
    with pytest.raises(UsageError, match=words):
        engine_of(given)


def test_a_client_whose_answers_must_be_awaited_is_refused():
    with pytest.raises(UsageError, match="asynchronous"):
        engine_of(SimpleNamespace(submit=0, nthreads=0, cancel=0, asynchronous=True))


def test_a_job_that_ends_its_worker_is_lost_and_no_other(engine):
    found = dict(engine_of(engine)(Task(square, -1, lost), range(10)))
    assert found == {i: i * i for i in range(10)} | {FATAL: DIED}


def test_without_a_scheduler_the_environment_lacks_something(monkeypatch):
    monkeypatch.setattr(dask_workers, "CONNECTION", 0.5)
    with pytest.raises(
        EnvironmentLackError, match=r"no scheduler of dask answers at 127\.0\.0\.1:9"
    ):
        engine_of("dask://127.0.0.1:9")
