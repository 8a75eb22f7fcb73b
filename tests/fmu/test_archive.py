"""What travels: the same bytes for the same scene, code under a private name, a bare Python."""

from __future__ import annotations

import hashlib
import io
import subprocess
import sys
import sysconfig
import zipfile
import zlib
from pathlib import Path

import fmpy
import pytest
from pythonfmu import fmi2slave

from build_fmu import build
from build_fmu.archive import SHARED, _remembered, write_archive
from build_fmu.archive import archive as archive_bytes
from build_fmu.errors import UsageError
from build_fmu.export import identifier
from build_fmu.instance import Log, instantiated
from build_fmu.payload import SLAVE_NAME, payload
from build_fmu.run import run_fmu
from fmu_src.log import CATEGORIES, Fmi2Slave
from fmu_src.status import LOG_CATEGORIES
from solver.runtime.model_file import HEADER
from tests.support.fmus.fmu_instance import SCENES, instance, pendulum, scene_fmu

BARE_HOST = Path(__file__).parents[1].joinpath("support/fmus/bare_host.py")


def repack(source: Path, target: Path, change) -> Path:
    """Copy an archive; `change(path, data)` gives the new path and data of an entry."""
    with zipfile.ZipFile(source) as archive:
        entries = [change(name, archive.read(name)) for name in archive.namelist()]
    write_archive(target, dict(entries))
    return target


def private_package() -> str:
    return payload(2, "points")[SLAVE_NAME].decode().removesuffix("_slave\n")


def renamed(path: str, data: bytes, name: str) -> tuple[str, bytes]:
    """Entry of an archive whose code has another private name."""
    if path.endswith(("_slave.py", "slavemodule.txt")):
        data = data.replace(private_package().encode(), name.encode())
    return path.replace(private_package(), name), data


# ------------------------------------------------------------------------------ equal bytes


def test_two_builds_of_a_scene_give_the_same_bytes(tmp_path):
    first = scene_fmu("four_bar").read_bytes()
    assert build(SCENES / "four_bar.toml", tmp_path / "a.fmu").read_bytes() == first
    code = "import sys; from build_fmu import build; build(sys.argv[1], sys.argv[2])"
    command = [sys.executable, "-c", code, SCENES / "four_bar.toml", tmp_path / "b.fmu"]
    subprocess.run(command, check=True, cwd=SCENES.parent, env={"PYTHONHASHSEED": "7"})
    assert (tmp_path / "b.fmu").read_bytes() == first


def test_another_number_gives_other_bytes(tmp_path):
    overridden = build(
        SCENES / "double_pendulum.toml", tmp_path / "a.fmu", parameters={"mass": 2.0}
    )
    assert overridden.read_bytes() != scene_fmu("double_pendulum").read_bytes()


def test_entries_are_sorted_deflated_and_of_one_time():
    with zipfile.ZipFile(scene_fmu("four_bar")) as archive:
        entries = archive.infolist()
        assert archive.testzip() is None
    names = [entry.filename for entry in entries]
    shared = [name for name in names if name.startswith(SHARED)]
    assert names == sorted(shared) + sorted({*names} - {*shared})
    assert {entry.date_time for entry in entries} == {(1980, 1, 1, 0, 0, 0)}
    assert {entry.compress_type for entry in entries} == {zipfile.ZIP_DEFLATED}


def test_what_fmus_share_is_zipped_once_and_the_rest_behind_it_as_if_all_were_new():
    shared = {"binaries/a.so": b"\x7fELF", "resources/holonom_1/a.py": b"text " * 99}
    entries = [shared | {"b/é.txt": text, "empty": b""} for text in (b"first", b"second")]
    archives = [archive_bytes(each) for each in entries]
    _remembered.cache_clear()
    assert archive_bytes(entries[1]) == archives[1]
    for each, data in zip(entries, archives, strict=True):
        with zipfile.ZipFile(io.BytesIO(data)) as archive:
            assert {name: archive.read(name) for name in archive.namelist()} == each
            modes = {x.filename: x.external_attr >> 16 & 0o777 for x in archive.infolist()}
        assert modes == {name: 0o755 if name == "binaries/a.so" else 0o644 for name in each}


def test_the_archive_has_what_the_standard_wants():
    with zipfile.ZipFile(scene_fmu("four_bar")) as archive:
        names = set(archive.namelist())
        page = archive.read("documentation/index.html").decode()
        licence = archive.read("documentation/licenses/license.txt").decode()
    assert {"modelDescription.xml", "documentation/externalDependencies.txt"} <= names
    assert {"binaries/linux64/four_bar.so", "binaries/win64/four_bar.dll"} <= names
    assert "<code>crank0.angle</code>" in page
    assert "MIT License" in licence


def test_a_failed_build_leaves_the_old_file(tmp_path):
    target = tmp_path / "a.fmu"
    target.write_text("old")
    with pytest.raises(TypeError):
        write_archive(target, {"entry": None})
    assert [path.name for path in tmp_path.iterdir()] == ["a.fmu"]
    assert target.read_text() == "old"


@pytest.mark.parametrize(
    ("name", "expected"),
    [("four_bar", "four_bar"), ("4 bar-ü", "_4_bar__"), ("", "mechanism")],
)
def test_the_identifier_is_one_of_c(name, expected):
    assert identifier(name) == expected


# ------------------------------------------------------------------------------ private code


@pytest.mark.parametrize(("name", "most"), [("double_pendulum", 202e3), ("four_bar", 204e3)])
def test_an_archive_of_a_small_mechanism_is_small_beside_pythonfmus_libraries(name, most):
    # 13 kB of it close mechanisms, differentiate drivers up to their limits and name what fails.
    with zipfile.ZipFile(scene_fmu(name)) as archive:
        entries = {entry.filename: archive.read(entry) for entry in archive.infolist()}
    own = {path: data for path, data in entries.items() if not path.startswith("binaries/")}
    assert len(archive_bytes(own)) <= most


def test_the_model_in_an_archive_has_its_guid():
    fmu = scene_fmu("four_bar")
    with zipfile.ZipFile(fmu) as archive:
        *_, guid, _, _ = HEADER.unpack_from(archive.read("resources/model.bin"))
    assert guid.rstrip(b"\0").decode() == fmpy.read_model_description(fmu).guid


def test_the_private_name_is_a_hash_of_the_code(monkeypatch):
    name = private_package()
    assert name.startswith("holonom_")
    assert len(name) == len("holonom_") + 12
    monkeypatch.setattr("build_fmu.payload.native_library", lambda *_: b"other")
    payload.cache_clear()
    other = private_package()
    payload.cache_clear()
    assert other != name


def test_two_versions_in_one_process_do_not_run_each_others_code(tmp_path):
    def another_version(path, data):
        if path.endswith("/linux64.so"):
            data = data.replace(b"the size must be > 0 s", b"the size must be > 0 m")
        return renamed(path, data, "holonom_0123456789ab")

    changed = repack(pendulum(), tmp_path / "changed.fmu", another_version)
    with instance(pendulum()) as a, instance(changed) as b:
        a.initialise()
        b.initialise()
        for fmu, words in ((a, "must be > 0 s"), (b, "must be > 0 m")):
            assert not fmu.step(0.0, -1.0)
            assert fmu.log[-1][2].endswith(words)
            assert fmu.step(0.0, 0.1)


def test_a_second_instance_does_not_need_the_first_ones_folder():
    with instance(pendulum()) as fmu:
        fmu.initialise()
        path = list(sys.path)
    with instance(pendulum()) as fmu:
        fmu.initialise()
        assert fmu.step(0.0, 0.1)
    assert sys.path == path
    assert not any("resources" in entry for entry in sys.path)


@pytest.mark.parametrize(
    ("damage", "carried"), [("moved", " has none"), ("of another machine", " has linux64.so (")]
)
@pytest.mark.skipif(sysconfig.get_platform() != "linux-x86_64", reason="changes an ELF header")
def test_without_a_library_for_the_platform_no_instance_is_made_and_the_log_says_why(
    tmp_path, damage, carried
):
    def change(path, data):
        if path.endswith("/linux64.so"):
            if damage == "of another machine":
                data = data[:18] + (183).to_bytes(2, "little") + data[20:]
            else:
                path = path.replace("linux64.so", "elsewhere/linux64.so")
        return renamed(path, data, f"holonom_{zlib.crc32(damage.encode()):012x}")

    foreign = repack(pendulum(), tmp_path / "foreign.fmu", change)
    log = Log()
    with zipfile.ZipFile(foreign) as archive:
        archive.extractall(tmp_path)
    with pytest.raises(UsageError, match="cannot be instantiated: "):
        instantiated(fmpy.read_model_description(str(foreign)), str(tmp_path), log)
    (line,) = log.messages
    assert "no library for this platform, linux-x86_64: the folder " in line
    assert carried in line
    assert "; build the FMU on this platform" in line
    with instance(pendulum()) as fmu:
        fmu.initialise()
        assert fmu.step(0.0, 0.1)


def test_a_damaged_archive_is_not_instantiated_and_harms_nothing(tmp_path):
    def cut_model(path, data):
        return path, data[:100] if path.endswith("model.bin") else data

    damaged = repack(pendulum(), tmp_path / "damaged.fmu", cut_model)
    with pytest.raises(Exception, match="Failed to instantiate"), instance(damaged):
        pass
    with instance(pendulum()) as fmu:
        fmu.initialise()
        assert fmu.step(0.0, 0.1)
    with pytest.raises(UsageError, match="the model cannot be used"):  # so says the log
        run_fmu(damaged)


def test_the_log_hands_over_the_levels_and_categories_of_pythonfmus_own():
    slave, theirs = Fmi2Slave(instance_name="a"), fmi2slave.Fmi2Slave
    whole = type("Whole", (theirs,), {"do_step": None, "log_categories": LOG_CATEGORIES})
    whole = whole(instance_name="a")
    for level in CATEGORIES:
        slave.say("text", level)
        whole.log("text", fmi2slave.Fmi2Status(level))
    ours = slave._get_log_queue()
    assert [vars(message) for message in ours] == [vars(m) for m in whole._get_log_queue()]


# ------------------------------------------------------------------------------- bare Python


def resources(fmu: Path, folder: Path) -> Path:
    with zipfile.ZipFile(fmu) as archive:
        archive.extractall(folder)
    return folder / "resources"


def bare_python(*arguments: str | Path) -> subprocess.CompletedProcess[str]:
    """Run Python without site-packages, environment and user folder."""
    command = [sys.executable, "-I", "-S", *map(str, arguments)]
    return subprocess.run(command, check=True, capture_output=True, text=True)


def test_importing_the_slave_takes_a_part_of_the_standard_library(tmp_path):
    folder = resources(pendulum(), tmp_path)
    module = f"{private_package()}_slave"
    code = f"import sys; sys.path.insert(0, {str(folder)!r}); import {module}"
    report = bare_python("-X", "importtime", "-c", code).stderr
    modules = {line.split("|")[-1].strip() for line in report.splitlines()}
    ours = {name for name in modules if name.startswith("holonom_")}
    assert module in ours
    tops = {name.split(".")[0] for name in modules - ours if name != "imported package"}
    assert tops <= {*sys.stdlib_module_names, "org"}  # copy looks for Jython's org.python.core
    heavy = {"argparse", "asyncio", "datetime", "email", "logging", "uuid", "xml", "zipfile"}
    assert not heavy & modules


@pytest.mark.parametrize("name", ["four_bar", "die_in_a_bowl"])
def test_it_runs_on_a_bare_python_to_the_same_bits(tmp_path, name):
    """Without NumPy, and with a mesh without the libraries that read it."""
    resources(scene_fmu(name), tmp_path)
    bare = bare_python(BARE_HOST, tmp_path, name, "20", "0.05").stdout
    with instance(scene_fmu(name)) as fmu:
        fmu.initialise()
        rows = fmu.run(0.0, 0.05, 20)
    digest = hashlib.sha256(repr(rows[-1]).encode()).hexdigest()
    assert bare.strip() == digest
