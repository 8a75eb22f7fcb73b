"""What is no FMU, or a damaged one, ends every command with 2 and one sentence."""

from __future__ import annotations

import os
import shutil
import struct
import subprocess
import sys
import zipfile
from pathlib import Path

import pytest

from build_fmu import archive_check
from build_fmu.errors import UsageError
from build_fmu.instance import description_of
from build_fmu.run import run_fmu
from tests.support.fmus.commands import run
from tests.support.fmus.fmu_instance import packed, pendulum

ROOT = Path(__file__).parents[2]
SLAVE = "resources/slavemodule.txt"


def files() -> dict[str, bytes]:
    with zipfile.ZipFile(pendulum()) as archive:
        return {name: archive.read(name) for name in archive.namelist()}


def named(end: str) -> str:
    """Path of the first file in the archive whose name ends so."""
    return next(name for name in files() if name.endswith(end))


def with_file(name: str, text: bytes = b"x") -> bytes:
    return packed({**files(), name: text})


def without(*names: str) -> bytes:
    return packed({name: text for name, text in files().items() if name not in names})


def described(old: str, new: str) -> bytes:
    text = files()["modelDescription.xml"].decode()
    assert old in text
    return with_file("modelDescription.xml", text.replace(old, new).encode())


def twice() -> bytes:
    """Two files of one name."""
    data = with_file("modelDescription.xmm", b"<x/>")
    return data.replace(b"modelDescription.xmm", b"modelDescription.xml")


def encrypted() -> bytes:
    data = bytearray(packed(files()))
    place = data.index(b"PK\1\2") + 8
    data[place] |= 1
    return bytes(data)


def packed_by_no_method() -> bytes:
    data = bytearray(packed(files()))
    struct.pack_into("<H", data, data.index(b"PK\1\2") + 10, 77)
    return bytes(data)


def damaged_of_two_lines() -> bytes:
    """A damaged file whose name has the end of a line."""
    return with_file("resources/a\nb", b"sound").replace(b"sound", b"wrong")


def of_larger_files() -> bytes:
    """The directory says that a file, though whole, is packed into a gigabyte."""
    data = bytearray(pendulum().read_bytes())
    entry = data.rindex(b"PK\x01\x02")
    data[entry + 23] = 0x3C  # the highest byte of the packed size
    return bytes(data)


def with_damaged_bytes() -> bytes:
    data = bytearray(pendulum().read_bytes())
    data[20000:20100] = bytes(100)
    return bytes(data)


COMMANDS = ("info", "simulate", "check", "sweep")
ARGUMENTS = {"sweep": ("--grid", "length=1:2:2")}
KINDS = {
    "files larger than the archive": of_larger_files,
    "text": lambda: b"not a zip",
    "empty": lambda: b"",
    "cut": lambda: pendulum().read_bytes()[:5000],
    "damaged": with_damaged_bytes,
    "two lines": damaged_of_two_lines,
    "module of two lines": lambda: with_file(SLAVE, b"a\rb"),
    "encrypted": encrypted,
    "unknown method": packed_by_no_method,
    "above": lambda: with_file("resources/../../outside"),
    "absolute": lambda: with_file("/outside"),
    "backslash": lambda: with_file("..\\outside"),
    "drive": lambda: with_file("C:/outside"),
    "nameless": lambda: with_file("resources//a"),
    "twice": twice,
    "file as folder": lambda: with_file("resources/model.bin/a"),
    "no description": lambda: without("modelDescription.xml"),
    "no version": lambda: described('fmiVersion="2.0"', ""),
    "another root": lambda: with_file("modelDescription.xml", b'<html fmiVersion="2.0"/>'),
    "no slave module": lambda: without(named("_slave.py")),
    "no name of a slave module": lambda: without(SLAVE),
    "another slave module": lambda: with_file(SLAVE, b"json\n"),
    "slave module without text": lambda: with_file(SLAVE, b""),
    "strange name": lambda: with_file(SLAVE, b"\xff\xfe\0"),
    "no code": lambda: without(named("/slave.py")),
    "no library": lambda: without(named("linux64.so")),
    "cut library": lambda: with_file(named("linux64.so"), files()[named("linux64.so")][:20000]),
}
DESCRIPTIONS = {
    "unknown encoding": lambda: described("encoding='UTF-8'", "encoding='foo'"),
    "empty": lambda: with_file("modelDescription.xml", b""),
    "binary": lambda: with_file("modelDescription.xml", bytes(range(256))),
    "FMI 1": lambda: described('fmiVersion="2.0"', 'fmiVersion="1.0"'),
    "FMI 3": lambda: described('fmiVersion="2.0"', 'fmiVersion="3.0"'),
    "reference": lambda: described('valueReference="1"', 'valueReference="x"'),
    "time": lambda: described('stopTime="1.0"', 'stopTime="soon"'),
}


@pytest.mark.parametrize("kind", KINDS)
@pytest.mark.parametrize("command", ["validate", *COMMANDS])
def test_a_damaged_archive_is_exit_2_and_one_sentence(kind, command, capsys, tmp_path):
    damaged = tmp_path / "damaged.fmu"
    damaged.write_bytes(KINDS[kind]())
    code, out, err = run(capsys, command, damaged, *ARGUMENTS.get(command, ()))
    assert (code, out) == (2, "")
    assert err.startswith(f"holonom: {damaged}: ")
    assert err.count("\n") == 1
    assert list(tmp_path.iterdir()) == [damaged]


@pytest.mark.parametrize("kind", DESCRIPTIONS)
@pytest.mark.parametrize("command", COMMANDS)
def test_a_damaged_description_is_exit_2_and_one_sentence(kind, command, capsys, tmp_path):
    damaged = tmp_path / "damaged.fmu"
    damaged.write_bytes(DESCRIPTIONS[kind]())
    code, out, err = run(capsys, command, damaged, *ARGUMENTS.get(command, ()))
    assert (code, out) == (2, "")
    assert "modelDescription.xml is not one that FMI allows" in err
    assert err.count("\n") == 1


def test_an_archive_of_too_much_is_refused_before_it_is_unpacked(tmp_path, monkeypatch):
    bomb = tmp_path / "bomb.fmu"
    with zipfile.ZipFile(bomb, "w", zipfile.ZIP_DEFLATED) as archive:
        for name, text in {**files(), "resources/zeros": bytes(10**7)}.items():
            archive.writestr(name, text)
    archive_check.require_whole(bomb)
    monkeypatch.setattr(archive_check, "MOST_BYTES", 10**7)
    with pytest.raises(UsageError, match=r"unpacked it has \d+ bytes in \d+ files; an FMU has at"):
        run_fmu(bomb)
    monkeypatch.setattr(archive_check, "MOST_FILES", 39)
    with pytest.raises(UsageError, match=r"in \d+ files"):
        description_of(bomb)


def test_another_programs_fmu_needs_no_slave_module(tmp_path):
    other = tmp_path / "other.fmu"
    names = [n for n in files() if n.startswith(("binaries/", "resources/"))]
    other.write_bytes(without(*names))
    assert description_of(other).modelName == "pendulum"


@pytest.mark.skipif(sys.platform != "linux", reason="a limit of file sizes is one of POSIX")
@pytest.mark.parametrize("command", [("simulate",), ("sweep", "--grid", "length=1:2:2")], ids=str)
def test_where_an_fmu_cannot_be_unpacked_the_folder_is_named_and_gone(command, tmp_path):
    lines = (
        "import resource, sys",
        "from build_fmu.command_line import main",
        "resource.setrlimit(resource.RLIMIT_FSIZE, (20000, 20000))",
        "sys.exit(main(sys.argv[1:]))",
    )
    (tmp_path / "temporary").mkdir()
    process = subprocess.run(
        [sys.executable, "-c", "\n".join(lines), command[0], pendulum(), *command[1:]],
        env={**os.environ, "TMPDIR": str(tmp_path / "temporary"), "PYTHONPATH": str(ROOT)},
        cwd=tmp_path, capture_output=True, text=True, check=False,
    )  # fmt: skip
    assert process.returncode == 2
    assert f"holonom: {tmp_path}/temporary/" in process.stderr
    assert "File too large" in process.stderr
    assert not list((tmp_path / "temporary").iterdir())


def test_what_is_no_file_has_a_sentence(tmp_path):
    for path, words in (
        (tmp_path, "is a directory"),
        (tmp_path / "missing.fmu", "no such file"),
        (Path("/dev/null"), "a device, and only regular files are read"),
    ):
        with pytest.raises(UsageError, match=words):
            run_fmu(path)


def test_an_archive_that_was_unpacked_and_packed_again_is_whole(tmp_path):
    """Other programs write entries of folders too."""
    folder = tmp_path / "unpacked"
    with zipfile.ZipFile(pendulum()) as archive:
        archive.extractall(folder)
    archive_check.require_whole(shutil.make_archive(str(tmp_path / "again"), "zip", folder))
