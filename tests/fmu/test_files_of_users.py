"""Files that users name: what has no end is refused at once, and a file is written whole or not."""

from __future__ import annotations

import contextlib
import os
import signal
import socket
import stat
import subprocess
import sys
from pathlib import Path

import pytest

import holonom
from solver.files import is_reserved, read_whole, written_whole
from tests.support.fmus.commands import run
from tests.support.fmus.fmu_instance import SCENES, scene_fmu

pytestmark = pytest.mark.skipif(os.name == "nt", reason="no such files")

PENDULUM = str(SCENES / "double_pendulum.toml")
PROFILE = 'name = "a"\ndimension = 2\n[profiles]\nlobe = { file = "it.csv" }\n'
FIELD = (
    'name = "a"\ndimension = 3\n[contacts.f]\ntype = "height_field"\npoint = "A"\nfile = "it.csv"\n'
)
MESH = 'name = "a"\ndimension = 3\n[contacts.f]\ntype = "mesh"\npoint = "A"\nfile = "it.stl"\n'
STOP = ("--stop", "0.01")


@pytest.fixture(autouse=True)
def _no_wait():
    """End a test that would wait for a writer of a pipe, or read a device, for ever."""
    before = signal.signal(signal.SIGALRM, lambda *_: pytest.fail("it waits"))
    signal.alarm(60)
    yield
    signal.alarm(0)
    signal.signal(signal.SIGALRM, before)


def pipe(path: Path) -> None:
    os.mkfifo(path)


def endless(path: Path) -> None:
    path.symlink_to("/dev/zero")


def folder(path: Path) -> None:
    path.mkdir()


@contextlib.contextmanager
def _in(path: Path):
    before = Path.cwd()
    os.chdir(path)
    yield
    os.chdir(before)


def listener(path: Path) -> None:
    with _in(path.parent), socket.socket(socket.AF_UNIX) as made:
        made.bind(path.name)  # names of sockets are short


KINDS = {
    pipe: "a named pipe, and only regular files are read",
    endless: "a device, and only regular files are read",
    folder: "is a directory",
    listener: "a socket, and only regular files are read",
}


def command(suffix: str, path: Path, fmu: str) -> list[str]:
    """A command that reads a file of this kind."""
    return {
        "scene.toml": ["info", str(path)],
        "scene.json": ["build", str(path), "-o", str(path.parent / "made.fmu")],
        "an.fmu": ["simulate", str(path), *STOP],
        "validated.fmu": ["validate", str(path)],
        "inputs.csv": ["simulate", fmu, *STOP, "--inputs", str(path)],
        "table.csv": ["sweep", fmu, *STOP, "--table", str(path), "-o", str(path.parent / "o.csv")],
        "results.csv": ["report", fmu, "--results", str(path)],
        "values.csv": ["info", PENDULUM, "--parameters", str(path)],
        "values.ssv": ["info", PENDULUM, "--parameters", str(path)],
        "values.toml": ["info", PENDULUM, "--parameters", str(path)],
        "values.json": ["info", PENDULUM, "--parameters", str(path)],
    }[suffix]


@pytest.mark.parametrize("make", KINDS, ids=lambda make: make.__name__)
@pytest.mark.parametrize(
    "name",
    [
        *("scene.toml", "scene.json", "an.fmu", "validated.fmu", "inputs.csv", "table.csv"),
        *("results.csv", "values.csv", "values.ssv", "values.toml", "values.json"),
    ],
)
def test_what_has_no_end_is_refused_as_any_input(tmp_path, capsys, name, make):
    make(tmp_path / name)
    code, _, err = run(capsys, *command(name, tmp_path / name, str(scene_fmu("double_pendulum"))))
    assert code == 2
    assert f"{tmp_path / name}: " in err
    assert KINDS[make] in err.lower()


@pytest.mark.parametrize("make", KINDS, ids=lambda make: make.__name__)
@pytest.mark.parametrize("scene", [PROFILE, FIELD, MESH], ids=["profile", "field", "mesh"])
def test_so_is_a_file_that_a_scene_names(tmp_path, make, scene):
    make(tmp_path / ("it.stl" if "stl" in scene else "it.csv"))
    (tmp_path / "a.toml").write_text(scene)
    with pytest.raises(holonom.SceneError, match=KINDS[make]):
        holonom.load(tmp_path / "a.toml")


@pytest.mark.parametrize("name", ["o.h5", "manifest.csv", "double_pendulum_1.ssv"])
def test_a_pipe_in_the_place_of_a_file_to_write_is_refused(tmp_path, capsys, name):
    pipe(tmp_path / name)
    if name == "o.h5":
        pytest.importorskip("h5py")
        words = ["sweep", PENDULUM, "-o", str(tmp_path / name), *STOP]
    else:
        words = ["variants", PENDULUM, "-o", str(tmp_path)]
    code, _, err = run(capsys, *words, "--grid", "mass=1", "--engine", "serial")
    assert code == 2
    assert f"{tmp_path / name}" in err


def test_a_pipe_that_the_program_was_given_is_read_to_its_end():
    rows = "time,push\n0,1\n1,1\n"
    script = (
        f"from solver.files import read_whole; print(read_whole('/dev/stdin') == {rows.encode()!r})"
    )
    answer = subprocess.run(
        [sys.executable, "-c", script], input=rows, capture_output=True, text=True, check=True
    )
    assert answer.stdout == "True\n"


@pytest.mark.skipif(not Path("/proc/kmsg").exists(), reason="no such file")
@pytest.mark.parametrize("name", ["/proc/kmsg", "/proc/self/status"])
def test_what_the_system_shows_as_files_is_not_read(tmp_path, capsys, name):
    (tmp_path / "table.csv").symlink_to(name)
    words = ("info", PENDULUM, "--parameters", tmp_path / "table.csv")
    code, _, err = run(capsys, *words)
    assert code == 2
    assert "of the operating system, and only regular files are read" in err.lower()


def test_a_file_is_read_as_it_is(tmp_path):
    (tmp_path / "a").write_bytes(b"a\r\n")
    assert read_whole(tmp_path / "a") == b"a\r\n"
    with pytest.raises(FileNotFoundError):
        read_whole(tmp_path / "b")


# ------------------------------------------------------------------------------------ written


def test_a_file_that_is_not_written_to_its_end_leaves_the_one_before(tmp_path):
    path = tmp_path / "a.csv"
    path.write_text("before")

    def fail() -> None:
        with written_whole(path, "w") as file:
            file.write("half of")
            raise OSError(28, "No space left on device")

    with pytest.raises(OSError, match="No space") as caught:
        fail()
    assert caught.value.filename == str(path)
    assert [x.name for x in tmp_path.iterdir()] == ["a.csv"]
    assert path.read_text() == "before"


def test_a_link_and_the_rights_of_a_file_stay(tmp_path):
    (tmp_path / "real").write_text("before")
    (tmp_path / "real").chmod(0o600)
    (tmp_path / "link").symlink_to("real")
    with written_whole(tmp_path / "link", "w") as file:
        file.write("after")
    assert (tmp_path / "link").is_symlink()
    assert (tmp_path / "real").read_text() == "after"
    assert stat.S_IMODE((tmp_path / "real").stat().st_mode) == 0o600


@pytest.mark.parametrize("make", KINDS, ids=lambda make: make.__name__)
@pytest.mark.parametrize(
    ("name", "words"),
    [
        ("out.csv", ("simulate", PENDULUM, "--csv", "PATH")),
        ("out.html", ("simulate", PENDULUM, "--report", "PATH")),
        ("out.html", ("check", PENDULUM, "--report", "PATH")),
        ("out.png", ("simulate", PENDULUM, "--plot", "PATH")),
        ("out.json", ("schema", "-o", "PATH")),
        ("out.toml", ("assemble", PENDULUM, "-o", "PATH")),
        ("out.html", ("report", PENDULUM, "--results", "none.csv", "-o", "PATH")),
        ("out.h5", ("sweep", PENDULUM, "--grid", "mass=1", "-o", "PATH")),
        ("out.csv", ("sweep", PENDULUM, "--grid", "mass=1", "-o", "PATH", "--fresh")),
        ("out.csv", ("variants", PENDULUM, "--grid", "mass=1", "-o", "v", "--manifest", "PATH")),
    ],
)
def test_what_has_no_end_is_not_written_and_nothing_is_computed_for_it(
    tmp_path, monkeypatch, capsys, make, name, words
):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "v").mkdir()
    path = tmp_path / "v" / name
    make(path)
    words = [name if words[0] == "variants" and x == "PATH" else x for x in words]
    code, out, err = run(capsys, *(str(path) if x == "PATH" else x for x in words))
    assert (code, out) == (2, "")
    assert KINDS[make].replace("read", "written") in err.lower()
    assert name in err
    assert [x.name for x in path.parent.iterdir()] == [name]


def test_what_the_program_was_given_as_its_output_is_written_into(tmp_path):
    """Whether it is a pipe or a file, which keeps what it had."""
    script = "from solver.files import write_whole; write_whole('/dev/stdout', 'a,b\\n')"
    words = [sys.executable, "-c", script]
    assert subprocess.run(words, capture_output=True, check=True).stdout == b"a,b\n"
    with (tmp_path / "a").open("ab") as file:
        file.write(b"before\n")
        file.flush()
        subprocess.run(words, stdout=file, check=True)
    assert (tmp_path / "a").read_bytes() == b"before\na,b\n"


def test_a_device_is_written_into_and_not_replaced(tmp_path):
    (tmp_path / "link").symlink_to("/dev/null")
    with written_whole(tmp_path / "link") as file:
        file.write(b"gone")
    assert (tmp_path / "link").is_symlink()
    with written_whole("/dev/null") as file:
        file.write(b"gone")
    assert stat.S_ISCHR(Path("/dev/null").stat().st_mode)


# -------------------------------------------------------------------------------------------- names


@pytest.mark.parametrize(
    ("words", "said"),
    [
        (("simulate", PENDULUM, "--csv", "r.mat"), "--csv r.mat: the name must end in .csv; "),
        (("simulate", PENDULUM, "--csv", "r"), "--csv r: the name must end in .csv; "),
        (
            ("simulate", PENDULUM, "--report", "r.pdf"),
            "--report r.pdf: the name must end in one of",
        ),
        (("check", PENDULUM, "--report", "r.csv"), "--report r.csv: the name must end in one of"),
        (("sweep", PENDULUM, "--grid", "mass=1", "-o", "r.mat"), "-o r.mat: the name must end in"),
        (("report", PENDULUM, "--results", "x.csv", "-o", "r.png"), "-o r.png: the name must end"),
        (("schema", "-o", "s.toml"), "-o s.toml: the name must end in .json"),
        (("simulate", PENDULUM, "--plot", "r.mat"), "--plot r.mat: the name must end in one of"),
        (("simulate", PENDULUM, "--csv", "nul.csv"), "--csv nul.csv: Windows reserves this name"),
        (("sweep", PENDULUM, "--grid", "mass=1", "-o", "com1.h5"), "com1.h5: Windows reserves"),
        (("build", PENDULUM, "-o", "r.mat"), "r.mat: the name of an FMU ends in .fmu"),
    ],
)
def test_a_file_that_cannot_be_written_is_refused_before_the_run(
    tmp_path, monkeypatch, capsys, words, said
):
    monkeypatch.chdir(tmp_path)
    code, out, err = run(capsys, *words)
    assert (code, out) == (2, "")
    assert said in err
    assert list(tmp_path.iterdir()) == []


def test_a_device_may_have_any_name(capsys):
    assert run(capsys, "simulate", PENDULUM, *STOP, "--csv", "/dev/null")[0] == 0


RESERVED = ["con", "PRN", "Aux.fmu", "nul.a.fmu", "COM1.fmu", "lpt9 .fmu", "a.fmu.", "a.fmu "]


@pytest.mark.parametrize("name", RESERVED)
def test_no_fmu_has_a_name_that_windows_reserves(tmp_path, capsys, name):
    assert is_reserved(name)
    code, _, err = run(capsys, "build", PENDULUM, "-o", tmp_path / name)
    assert code == 2
    assert "Windows reserves this name" in err
    assert list(tmp_path.iterdir()) == []


@pytest.mark.parametrize(
    "name", ["con_1", "com10", "com0", "lpt", "auxiliary.fmu", "a.con", ".nul"]
)
def test_other_names_are_free(name):
    assert not is_reserved(name)


@pytest.mark.parametrize("name", ["nul", "Com9", "a" * 201])
def test_no_scene_begins_with_such_a_name(tmp_path, capsys, name):
    assert run(capsys, "init", tmp_path / name)[0] == 2
    assert list(tmp_path.iterdir()) == []


def test_variants_have_no_such_names(tmp_path, capsys):
    (tmp_path / "con.a.toml").write_text(Path(PENDULUM).read_text())
    words = ("variants", tmp_path / "con.a.toml", "-o", tmp_path / "v", "--grid", "mass=1,2")
    code, _, err = run(capsys, *words)
    assert code == 2
    assert "Windows reserves this name" in err


def test_a_scene_of_the_longest_name_is_built(tmp_path):
    text = Path(PENDULUM).read_text().replace("double_pendulum", "a" * 200)
    made = holonom.build(holonom.loads(text), tmp_path)
    assert made.name == "a" * 200 + ".fmu"
