"""Archives that are damaged or no FMUs, given to every command: an exit code and one sentence."""

from __future__ import annotations

import contextlib
import functools
import io
import random
import re
import zipfile
from pathlib import Path

import solver
from build_fmu import build
from build_fmu.command_line import main
from tests.support.fmus.fmu_instance import packed

CPU_LIMIT = 5.0
SCENE = """
name = "hung"
dimension = 2
[parameters]
length = { value = 1.0, min = 0.01 }
[inputs]
push = { start = 0.0, min = -5, max = 5 }
[points]
O = { position = [0, 0], fixed = true }
A = { position = ["length", 0], mass = 1.0 }
[joints]
rod = { type = "distance", points = ["O", "A"] }
[forces]
wind = { type = "force", point = "A", value = [0, "push"] }
"""
COMMANDS = (
    ("info",),
    ("validate",),
    ("simulate", "--stop", "0.1"),
    ("check", "--stop", "0.1"),
    ("sweep", "--stop", "0.1", "--grid", "length=1:2:2", "--engine", "serial", "--json"),
)
DESCRIPTION = "modelDescription.xml"
NAMES = ("../outside", "/outside", "a\\b", "C:a", "a/../../b", "", "é/ü", "a" * 300, "resources")
WORDS = ("", "nan", "-1", "1e999", "x", "é", "0", "99999999999999999999", "true", "&amp;", "a b")
CODES = {0, 1, 2, 3, 4}


def prepare(folder: Path) -> None:
    """Build an FMU."""
    build(solver.loads(SCENE), folder / "good.fmu")


@functools.cache
def _good(folder: Path) -> tuple[bytes, dict[str, bytes]]:
    data = (folder / "good.fmu").read_bytes()
    with zipfile.ZipFile(io.BytesIO(data)) as archive:
        return data, {name: archive.read(name) for name in archive.namelist()}


def case(seed: str, number: int, folder: Path) -> str | None:
    """Give a damaged archive to a command."""
    chance = random.Random(f"{seed}/{number}")
    damaged = folder / f"case_{number}.fmu"
    damaged.write_bytes(_damaged(chance, *_good(folder)))
    command, *arguments = chance.choice(COMMANDS)
    if command == "sweep":
        arguments += ["-o", str(folder / f"case_{number}.csv")]
    out, err = io.StringIO(), io.StringIO()
    with contextlib.redirect_stdout(out), contextlib.redirect_stderr(err):
        code = main([command, str(damaged), *arguments])
    for path in folder.glob(f"case_{number}.*"):
        path.unlink()
    said = err.getvalue()
    if code not in CODES or "Traceback" in said:
        return f"{command} ended with {code}: {said[-200:]}"
    if code == 2 and not re.fullmatch(r"holonom: .+\n|(.+: error: .+\n( += help: .+\n)?)+", said):
        return f"{command} has no sentence: {said[:300]!r}"
    return None


def _damaged(chance: random.Random, good: bytes, files: dict[str, bytes]) -> bytes:
    """Bytes of the archive, damaged as they stand or packed anew with another content."""
    kind = chance.randrange(10)
    if kind < 3:
        return _damaged_bytes(chance, good)
    content = dict(files)
    # What has the right checksum and is code runs as it stands: its content is left alone.
    data = [name for name in files if not name.startswith("binaries/") and name[-3:] != ".py"]
    name = chance.choice(data)
    if kind == 3:
        content.pop(chance.choice(list(files)))
    elif kind == 4:
        content[name] = _damaged_bytes(chance, content[name])
    elif kind == 5:
        content[chance.choice(NAMES) or "x"] = chance.randbytes(20)
    elif kind == 6:
        content[name] = chance.choice([b"", b"x", bytes(1000), chance.randbytes(100)])
    elif kind < 9:
        content[DESCRIPTION] = _damaged_description(chance, content[DESCRIPTION].decode()).encode()
    else:
        prefix = chance.choice(["resources/", "binaries/", "binaries/linux64", "documentation/"])
        content = {name: text for name, text in files.items() if not name.startswith(prefix)}
    return packed(content)


def _damaged_bytes(chance: random.Random, good: bytes) -> bytes:
    data, place = bytearray(good or b"x"), chance.randrange(len(good) or 1)
    length = chance.choice([1, 8, 100, 4000])
    kind = chance.randrange(6)
    if kind == 0:
        data[place] ^= 1 << chance.randrange(8)
    elif kind == 1:
        del data[place:]
    elif kind == 2:
        data[place : place + length] = bytes(length)
    elif kind == 3:
        del data[place : place + length]
    elif kind == 4:
        place = max(0, len(data) - chance.randrange(1, 3000))  # the directory of an archive
        data[place] = chance.randrange(256)
    else:
        data[place:place] = chance.randbytes(length)
    return bytes(data)


def _damaged_description(chance: random.Random, text: str) -> str:
    if chance.random() < 0.3:  # an element is gone, or there twice
        found = chance.choice(list(re.finditer(r"<(\w+)[^<>]*/>", text)))
        return text[: found.start()] + chance.choice(["", 2 * found[0]]) + text[found.end() :]
    found = chance.choice(list(re.finditer(r'(\w+)="([^"]*)"', text)))
    attribute = chance.choice(["", f'{found[1]}="{chance.choice(WORDS)}"', f'odd="{found[2]}"'])
    return text[: found.start()] + attribute + text[found.end() :]
