"""Check of an FMU before a file of it is unpacked or loaded.

A library that is cut off ends the process without a message, and so does missing code. A small
archive can unpack to so much that the disk is full. Such files are refused with a sentence.
"""

from __future__ import annotations

import io
import re
import struct
import zipfile
import zlib
from lzma import LZMAError
from os import PathLike, fspath
from pathlib import Path, PurePosixPath
from xml.etree import ElementTree

from build_fmu.errors import UsageError
from build_fmu.payload import SLAVE_NAME, package_name
from solver.files import read_whole, why_unreadable

MOST_BYTES = 2**30
"""Of all files of an FMU, unpacked; large ones of other tools have some hundred million."""
MOST_FILES = 20_000

_DESCRIPTION = "modelDescription.xml"
_AGAIN = "; build it again, or fetch it again from where it came"
_DAMAGE = (
    *(zipfile.BadZipFile, zlib.error, LZMAError, struct.error, EOFError, OSError),
    *(ValueError, RuntimeError),  # names that are not text; unknown compression; a password
)
_PACKAGE = re.compile(r"resources/(holonom_[0-9a-f]{12})/(.+)")


def require_whole(path: str | PathLike[str]) -> None:
    """Refuse a file that is no FMU, damaged, or larger than an FMU can be.

    Raises
    ------
    UsageError
        With the file and what is wrong with it.
    """
    file = Path(path)
    problem = ""
    if reason := why_unreadable(file):
        problem = reason
    elif file.stat().st_size > MOST_BYTES:
        problem = f"larger than {MOST_BYTES} bytes, the most of an FMU"
    elif not zipfile.is_zipfile(file):
        problem = f"not an FMU (a zip file with {_DESCRIPTION})"
    else:
        data = read_whole(file)
        try:
            with zipfile.ZipFile(io.BytesIO(data)) as archive:
                problem = _size_problem(archive) or _name_problem(archive) or _file_problem(archive)
        except _DAMAGE as error:
            problem = f"the archive is damaged ({error}){_AGAIN}"
    if problem:
        text = f"{fspath(path)}: {problem}"
        raise UsageError(text)


def _size_problem(archive: zipfile.ZipFile) -> str:
    """Say why the sizes of the files cannot be those of an FMU; empty if they can."""
    entries = archive.infolist()
    if any(entry.header_offset + entry.compress_size > archive.start_dir for entry in entries):
        return f"the archive is damaged: its directory lists a file that does not fit in it{_AGAIN}"
    size = sum(entry.file_size for entry in entries)
    if size > MOST_BYTES or len(entries) > MOST_FILES:
        return (
            f"unpacked it has {size} bytes in {len(entries)} files; an FMU has at most "
            f"{MOST_BYTES} in {MOST_FILES}"
        )
    return ""


def _name_problem(archive: zipfile.ZipFile) -> str:
    """Say which name is not that of one file of its own inside of a folder; empty if all are."""
    names = [entry.orig_filename for entry in archive.infolist()]
    files = {name for name in names if not name.endswith("/")}
    seen = set()
    for name in names:
        parts = name.removesuffix("/").split("/")
        if {"", ".", ".."} & set(parts) or re.search(r"[\\:\0]", name):
            return f"the archive has a file {name!r}, which lies outside its folder"
        if name in seen or any(str(folder) in files for folder in PurePosixPath(name).parents):
            return f"the archive has two files in one place, {name!r}{_AGAIN}"
        seen.add(name)
    return "" if _DESCRIPTION in files else f"not an FMU (a zip file with {_DESCRIPTION})"


def _file_problem(archive: zipfile.ZipFile) -> str:
    """Say which file is damaged or missing; empty if none is."""
    damaged = archive.testzip()
    if damaged:
        return f"the archive is damaged: {damaged!r} has another checksum{_AGAIN}"
    if not _has_description_root(archive):
        return f"{_DESCRIPTION} does not begin with <fmiModelDescription fmiVersion=...>"
    names = archive.namelist()
    libraries = [name for name in names if name.startswith("binaries/")]
    if any(SLAVE_NAME.encode() in archive.read(name) for name in libraries):
        named = f"resources/{SLAVE_NAME}"
        text = archive.read(named).decode(errors="replace") if named in names else ""
        module = f"resources/{text.partition(chr(10))[0].strip()}.py"
        if module not in names:
            missing = module if text.strip() else named
            return f"{missing!r} is missing, and without it the library ends the process{_AGAIN}"
    code: dict[str, dict[str, bytes]] = {}
    files = (name for name in names if not name.endswith("/") and "/__pycache__/" not in name)
    for found in filter(None, map(_PACKAGE.fullmatch, files)):
        code.setdefault(found[1], {})[found[2]] = archive.read(found[0])
    for package, parts in code.items():
        if package_name(parts) != package:
            return f"the code in resources/{package} has changed since it was built{_AGAIN}"
    return ""


def _has_description_root(archive: zipfile.ZipFile) -> bool:
    with archive.open(_DESCRIPTION) as text:
        try:
            _, root = next(ElementTree.iterparse(text, events=("start",)))
        except (ElementTree.ParseError, LookupError, ValueError):
            return True  # fmpy says where it is no XML, or what its encoding is
    return root.tag == "fmiModelDescription" and "fmiVersion" in root.attrib
