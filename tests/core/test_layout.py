"""Python's picture of the kernel's memory against the kernel's header, name by name."""

from __future__ import annotations

import re
import sysconfig
from pathlib import Path

import pytest

from solver.options import CHOICES
from solver.runtime import Integrator, kernel
from solver.runtime.errors import Status
from solver.runtime.layout import ABI, HEAD, OFFSETS, SIZES, TABLES
from tests.twins import PENDULUM, model_of

HEADER = (Path(__file__).parents[2] / "solver" / "kernel" / "holonom.h").read_text("utf-8")
CODE = re.sub(r"/\*.*?\*/", "", HEADER, flags=re.DOTALL)
STRUCTURE = re.search(r"typedef struct holonom_model \{(.*?)\} holonom_model;", CODE, re.DOTALL)[1]


def test_the_sizes_are_the_integers_of_the_structure():
    names = [
        name.strip()
        for line in re.findall(r"int32_t ([^*;]*);", STRUCTURE)
        for name in line.split(",")
    ]
    sizes = [name for name in names if not name.endswith("_at")]
    place = sizes.index("n_tape[4]")
    segments = ("parameters", "laws", "signals", "outputs")
    sizes[place : place + 1] = [f"n_tape_{name}" for name in segments]
    assert tuple(sizes) == SIZES
    assert tuple(name.removesuffix("_at") for name in names if name.endswith("_at")) == OFFSETS


ELIMINATION = re.search(r"struct holonom_elimination \{(.*?)\} holonom_elim", CODE, re.DOTALL)[1]


def test_the_tables_are_the_pointers_of_the_structure():
    pointer = r"const int32_t \*(\w+);"
    of_one = re.findall(pointer, ELIMINATION)
    members = re.findall(pointer + r"|holonom_elimination (full), (lean);", STRUCTURE)
    tables = [[name] if name else [*of_one, *(f"lean_{x}" for x in of_one)] for name, *_ in members]
    assert tuple(name for names in tables for name in names) == TABLES


def test_the_head_of_a_state_is_that_of_the_header():
    places = re.search(r"enum holonom_state_place \{(.*?)\};", CODE, re.DOTALL)[1]
    names = [name.strip() for name in places.split(",")]
    assert names.pop() == "S_HEAD"
    renamed = {"newton": "newton_iterations", "uzawa": "uzawa_iterations"}
    found = (name.removeprefix("S_").lower() for name in names)
    assert tuple(renamed.get(name, name) for name in found) == HEAD


def test_codes_of_status_and_formulation_are_those_of_the_header():
    codes = dict(re.findall(r"HOLONOM_(\w+) = (\d+)", CODE))
    assert {status.name: str(int(status)) for status in Status}.items() <= codes.items()
    for index, word in enumerate(CHOICES["formulation"]):
        assert codes[word.upper().replace("-", "_")] == str(index)


def test_the_version_of_the_interface_is_that_of_the_header():
    assert re.search(r"#define HOLONOM_ABI (\d+)", HEADER)[1] == str(ABI)


def test_a_kernel_of_another_version_is_not_taken(monkeypatch):
    monkeypatch.setattr(kernel, "ABI", ABI + 1)
    with pytest.raises(kernel.KernelMissingError, match="another version"):
        kernel.load_library(2)


def test_a_kernel_for_the_plane_is_not_taken_for_space():
    with pytest.raises(kernel.KernelMissingError, match="another version"):
        kernel.load_library(3, kernel.library_path(2))


@pytest.mark.parametrize(
    ("head", "expected"),
    [
        (b"\x7fELF\x02\x01\x01".ljust(18, b"\0") + b"\xb7\0", "linux-aarch64"),
        (b"MZ".ljust(60, b"\0") + b"\x80".ljust(68, b"\0") + b"PE\0\0\x64\x86", "win-amd64"),
        (b"\xcf\xfa\xed\xfe\x0c\0\0\x01", "macosx-arm64"),
        (b"text", "another machine (libholonom.so)"),
    ],
)
def test_the_platform_of_a_library_is_read_from_its_first_bytes(tmp_path, head, expected):
    path = tmp_path / "libholonom.so"
    path.write_bytes(head)
    assert kernel.library_platform(str(path)) == expected


def test_a_missing_kernel_is_reported_with_platform_and_remedy(monkeypatch, tmp_path):
    monkeypatch.setattr(kernel, "library_path", lambda _: str(tmp_path / "libholonom_planar.so"))
    kernel.shared_library.cache_clear()
    with pytest.raises(kernel.KernelMissingError) as missing:
        Integrator(model_of(PENDULUM))
    kernel.shared_library.cache_clear()
    assert str(missing.value) == (
        f"no kernel for this platform, {sysconfig.get_platform()}: the folder {tmp_path} has no "
        "kernel; build the FMU on this platform, or compile the kernel: python -m build_kernel"
    )
