"""Many instances: one after the other without growth, side by side, in threads, and read-only."""

from __future__ import annotations

import contextlib
import gc
import os
import subprocess
import sys
import time
import weakref
import zipfile
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import pytest
from fmpy import fmi1

from build_fmu.run import run_fmu
from tests.support.fmus.fmu_instance import Instance, instance, pendulum, scene_fmu, stepping_slave

BARE_HOST = Path(__file__).parents[1].joinpath("support/fmus/bare_host.py")
STEPS, H = 20, 0.02
LINUX = pytest.mark.skipif(not sys.platform.startswith("linux"), reason="reads /proc")


def resident() -> int:
    """Bytes of memory that this process holds."""
    pages = int(Path("/proc/self/statm").read_text().split()[1])
    return pages * os.sysconf("SC_PAGE_SIZE")


def slaves() -> int:
    """Slaves that are alive, of whatever copy of the code."""
    return sum(type(each).__name__ == "Slave" for each in gc.get_objects())


def renew(fmu: Instance) -> None:
    """Free the instance, make another one in its place, and take a step."""
    fmu.fmu.fmi2FreeInstance(fmu.fmu.component)
    fmu.fmu.instantiate(callbacks=fmu.callbacks)
    fmu.initialise()
    assert fmu.step(0.0, 0.05)
    state = fmu.fmu.getFMUState()
    copy = fmu.fmu.deserializeFMUState(fmu.fmu.serializeFMUState(state))
    for each in (state, copy):
        fmu.fmu.freeFMUState(each)


@LINUX
def test_instances_made_and_freed_leave_nothing():
    """An instance of the four-bar holds 90 kB; what may remain of it is a tenth, and no slave.

    pythonfmu's library keeps a list and 15 small objects of each, 1.3 kB; the rest is the heap's.
    """
    cycles = 200
    with instance(scene_fmu("four_bar")) as fmu:
        for _ in range(30):
            renew(fmu)
        gc.collect()
        objects, memory, alive = len(gc.get_objects()), resident(), slaves()
        for _ in range(cycles):
            renew(fmu)
        gc.collect()
        assert slaves() == alive
        assert len(gc.get_objects()) - objects <= 1.2 * cycles
        assert resident() - memory < cycles * 9e3


def test_a_slave_that_is_forgotten_is_gone_at_once():
    """Without the library nothing is left: what a slave holds holds no reference to it."""
    with instance(pendulum()):
        slave = stepping_slave()
        assert slave.do_step(0.0, 0.05)
        gone = weakref.ref(slave)
        gc.disable()
        try:
            del slave
            assert gone() is None
        finally:
            gc.enable()


NAMES = ("double_pendulum", "four_bar", "spring_pendulum")


def alone(name: str) -> list[list[float]]:
    with instance(scene_fmu(name)) as fmu:
        fmu.initialise()
        return fmu.run(0.0, H, STEPS)


def test_many_instances_of_several_fmus_move_side_by_side_as_they_do_alone():
    expected = {name: alone(name) for name in NAMES}
    with contextlib.ExitStack() as stack:
        made = [
            (name, stack.enter_context(instance(scene_fmu(name))))
            for name in NAMES
            for _ in "12345"
        ]
        rows: dict[int, list] = {k: [] for k in range(len(made))}
        for _, fmu in made:
            fmu.initialise()
        for i in range(STEPS):
            for k, (_, fmu) in enumerate(made):
                rows[k] += fmu.run(i * H, H, 1)
        for k, (name, _) in enumerate(made):
            assert rows[k] == expected[name]


def test_instances_in_threads_move_as_they_do_alone():
    expected = {name: alone(name) for name in NAMES}
    jobs = [name for name in NAMES for _ in range(4)]
    with ThreadPoolExecutor(6) as pool:
        for name, rows in zip(jobs, pool.map(alone, jobs), strict=True):
            assert rows == expected[name]


def test_runs_in_threads_load_one_library_at_a_time(monkeypatch):
    # fmpy goes to the folder of a library to load it, and the whole process with it.
    fmus = [scene_fmu(name) for name in NAMES]
    before, load, inside = os.getcwd(), fmi1.cdll.LoadLibrary, list[int]()
    monkeypatch.chdir(before)  # where the tests that follow begin, whatever becomes of this one

    def slowly(path: str):
        inside.append(1)
        time.sleep(0.05)
        assert len(inside) == 1
        inside.clear()
        return load(path)

    monkeypatch.setattr(fmi1.cdll, "LoadLibrary", slowly)
    with ThreadPoolExecutor(4) as pool:
        runs = list(pool.map(lambda fmu: run_fmu(fmu, stop_time=0.1), fmus))
    assert all(run.finished for run in runs)
    assert os.getcwd() == before


def test_one_instance_may_be_moved_from_one_thread_to_another():
    with instance(scene_fmu("four_bar")) as fmu:
        fmu.initialise()
        rows = []
        for i in range(STEPS):
            with ThreadPoolExecutor(1) as pool:
                rows += pool.submit(fmu.run, i * H, H, 1).result()
    assert rows == alone("four_bar")


# ------------------------------------------------------------------------------------- folders


def unpacked(folder: Path) -> Path:
    with zipfile.ZipFile(pendulum()) as archive:
        archive.extractall(folder)
    return folder


def run_in(folder: Path) -> subprocess.CompletedProcess[str]:
    environment = {**os.environ, "PYTHONDONTWRITEBYTECODE": "1"}
    command = [sys.executable, str(BARE_HOST), str(folder), "pendulum", "5", "0.1"]
    return subprocess.run(command, capture_output=True, text=True, check=False, env=environment)


def test_an_unpack_folder_may_be_read_only_and_stays_as_it_was(tmp_path):
    folder = unpacked(tmp_path / "fmu")
    files = {path: path.read_bytes() for path in folder.rglob("*") if path.is_file()}
    for path in (folder, *folder.rglob("*")):
        path.chmod(0o555)
    try:
        assert run_in(folder).returncode == 0
        assert files == {path: path.read_bytes() for path in folder.rglob("*") if path.is_file()}
    finally:
        for path in (folder, *folder.rglob("*")):
            path.chmod(0o755)


@pytest.mark.parametrize("name", ["with blanks in it", "a-b_c.d~e", "A" * 120])
def test_folder_names_that_the_wrappers_library_reads(tmp_path, name):
    process = run_in(unpacked(tmp_path / name))
    assert (process.returncode, process.stderr) == (0, "")
