"""What FMUs with Python need on Linux: README and archive name what their library asks for."""

from __future__ import annotations

import re
import zipfile
from pathlib import Path

from build_fmu.payload import wrapper_libraries
from tests.support.fmus.fmu_instance import pendulum

ROOT = Path(__file__).parents[2]
NEWEST_GCC = {"3.4.29": "11", "3.4.30": "12", "3.4.31": "13", "3.4.32": "13", "3.4.33": "14"}
"""First GCC whose libstdc++ has symbols of a version (its manual, ABI Policy and Guidelines)."""


def newest(library: bytes, name: str) -> str:
    """Newest version of symbols that a library of Linux names: `GLIBC_2.32` is one of GLIBC."""
    found = re.findall(rb"\0%s_([0-9.]+)(?=\0)" % name.encode(), library)
    return max((x.decode() for x in found), key=lambda text: [*map(int, text.split("."))])


def test_glibc_and_libstdcxx_are_named_where_users_read_of_them():
    (library,) = (x for path, x in wrapper_libraries().items() if path.startswith("linux64/"))
    glibc, libstdcxx = newest(library, "GLIBC"), newest(library, "GLIBCXX")
    with zipfile.ZipFile(pendulum()) as archive:
        needs = archive.read("documentation/externalDependencies.txt").decode()
        page = archive.read("documentation/index.html").decode()
    for text in (needs, page, (ROOT / "README.md").read_text(encoding="utf-8")):
        words = " ".join(text.split())
        assert f"glibc {glibc} " in words
        assert f"the libstdc++ of GCC {NEWEST_GCC[libstdcxx]} (GLIBCXX_{libstdcxx})" in words


def test_windows_needs_what_is_named_of_it():
    (library,) = (x for path, x in wrapper_libraries().items() if path.startswith("win64/"))
    assert b"MSVCP140.dll\0" in library
    with zipfile.ZipFile(pendulum()) as archive:
        assert b"MSVCP140.dll" in archive.read("documentation/externalDependencies.txt")
