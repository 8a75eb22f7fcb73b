"""What an FMU carries to run: Python code with pythonfmu's libraries, or libraries of its own."""

from __future__ import annotations

import re
import struct
import zipfile
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from xml.etree import ElementTree

from build_fmu.errors import EnvironmentLackError, UsageError
from build_fmu.payload import SLAVE_NAME, native_library, payload, wrapper_libraries
from build_fmu.platforms import PLATFORMS, library_scope, own_platform
from build_fmu.source_package import UNIT, source_files

ALL, NONE = "all", "none"
"""Names of all platforms that one archive can have, and of none, for sources alone."""
NATIVE = "native"


@dataclass(frozen=True)
class Package:
    """How an FMU is packaged.

    Attributes
    ----------
    native : bool
        Whether it has libraries of its own, in C, and needs no Python.
    fmi : int
        Version of the standard, 2 or, if it is native, 3.
    platforms : tuple of str
        Of native libraries, names in `PLATFORMS`.
    sources : bool
        Whether its sources in C are in it, which an importer can compile.
    """

    native: bool = False
    fmi: int = 2
    platforms: tuple[str, ...] = ()
    sources: bool = False

    def entries(self, name: str, sizes: Mapping[str, int]) -> dict[str, bytes]:
        """Entries of the archive that make it run, by path.

        `name` is the model identifier; by the `sizes` of the model its dimension is known, and
        whether it has contacts or frictions.

        Raises
        ------
        EnvironmentLackError
            If a library is missing here.
        """
        if not self.native:
            return _python_entries(name, sizes)
        found = source_files(self.fmi) if self.sources else {}
        for platform in self.platforms:
            folders = self._folders(platform)
            library = native_library(platform, sizes["dim"], library_scope(sizes))
            parts = parts_of(library) if len(folders) > 1 else [library]
            for folder, part in zip(folders, parts, strict=True):
                found[f"binaries/{folder}/{name}{PLATFORMS[platform].suffix}"] = part
        return found

    def _folders(self, platform: str) -> Sequence[str]:
        known = PLATFORMS[platform]
        # FMI 2 has no name for Linux on ARM; importers there look in linux64.
        return known.fmi3 if self.fmi == 3 else (known.fmi2 or "linux64",)


PYTHON = Package()
"""Package of Python code, for the platforms of pythonfmu's libraries."""


def parts_of(universal: bytes) -> list[bytes]:
    """Libraries in a universal file of macOS, one for each processor (mach-o/fat.h)."""
    count = int.from_bytes(universal[4:8], "big")
    places = [struct.unpack_from(">II", universal, 16 + 20 * k) for k in range(count)]
    return [universal[start : start + size] for start, size in places]


def chosen_package(
    native: bool = False, fmi: int = 2, platforms: str | Sequence[str] | None = None,
    sources: bool = False,
) -> Package:  # fmt: skip
    """Package by its options: whether native, version of FMI, names of platforms, "all" or "none".

    Raises
    ------
    UsageError
        If they do not go together, or a platform is unknown.
    EnvironmentLackError
        If this machine is of no platform that FMI has a name for.
    """
    if fmi not in (2, 3):
        text = f"FMI {fmi}: an FMU is one of FMI 2 or 3"
        raise UsageError(text)
    if not native:
        if fmi == 3 or platforms or sources:
            what = "FMI 3.0" if fmi == 3 else "platforms" if platforms else "sources"
            text = f"{what}: for native FMUs alone, those with Python are of FMI 2.0 and for all "
            text += "platforms of pythonfmu; add --native"
            raise UsageError(text)
        return PYTHON
    names = platforms.split(",") if isinstance(platforms, str) else [*(platforms or ())]
    names = [name.strip() for name in names]
    if names == [ALL]:  # FMI 2 has one folder for both kinds of Linux
        names = [name for name, known in PLATFORMS.items() if fmi == 3 or known.fmi2]
    if names == [NONE] and sources:
        return Package(True, fmi, (), sources)
    for name in names:
        if name not in PLATFORMS:
            text = f"platform {name!r}: must be one of {', '.join(PLATFORMS)}, or all"
            text += "; or none of an FMU with --sources" if name == NONE else ""
            raise UsageError(text)
    if fmi == 2 and {"linux64", "linux-arm64"} <= {*names}:
        text = "platforms linux64 and linux-arm64: FMI 2.0 has one folder for both; "
        text += "build an FMU for each, or one of FMI 3.0"
        raise UsageError(text)
    own = own_platform()
    if not names and not own and not sources:
        text = "FMI has no name for this platform; name others: --platforms linux64"
        raise EnvironmentLackError(text)
    return Package(True, fmi, tuple(dict.fromkeys(names)) or ((own,) if own else ()), sources)


def _python_entries(name: str, sizes: Mapping[str, int]) -> dict[str, bytes]:
    code = payload(sizes["dim"], library_scope(sizes))
    entries = {f"resources/{file}": data for file, data in code.items()}
    for library, data in wrapper_libraries().items():
        platform, suffix = library.split("/")
        entries[f"binaries/{platform}/{name}{suffix}"] = data
    return entries


def package_of(path: str) -> dict[str, object]:
    """What the archive of an FMU says of how it is packaged: FMI version, kind, platforms."""
    with zipfile.ZipFile(path) as archive:
        names = archive.namelist()
        with archive.open("modelDescription.xml") as text:
            _, root = next(ElementTree.iterparse(text, events=("start",)))
    platforms = {name.split("/")[1] for name in names if re.match("binaries/[^/]+/.", name)}
    has_python = f"resources/{SLAVE_NAME}" in names
    return {
        "fmi": root.get("fmiVersion"),
        "kind": "Python, by pythonfmu" if has_python else NATIVE,
        "sources": f"sources/{UNIT}" in names,
        "platforms": sorted(platforms),
    }
