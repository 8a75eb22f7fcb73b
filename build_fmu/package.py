"""What an FMU carries to run: Python code with pythonfmu's libraries, or libraries of its own."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from build_fmu.errors import EnvironmentLackError
from build_fmu.payload import SLAVE_NAME, package_folder, payload, wrapper_libraries
from build_fmu.platforms import PLATFORMS, library_path, own_platform


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
    """

    native: bool = False
    fmi: int = 2
    platforms: tuple[str, ...] = ()

    def entries(self, name: str, dimension: int) -> dict[str, bytes]:
        """Entries of the archive that make it run, by path.

        `name` is the model identifier, `dimension` that of the mechanism.

        Raises
        ------
        EnvironmentLackError
            If a library is missing here.
        """
        if not self.native:
            return _python_entries(name, dimension)
        return {
            f"binaries/{folder}/{name}{PLATFORMS[platform].suffix}": library
            for platform in self.platforms
            for library in [_native_library(platform, dimension)]
            for folder in self._folders(platform)
        }

    def _folders(self, platform: str) -> Sequence[str]:
        known = PLATFORMS[platform]
        # FMI 2 has no name for Linux on ARM; importers there look in linux64.
        return known.fmi3 if self.fmi == 3 else (known.fmi2 or "linux64",)


PYTHON = Package()
"""Package of Python code, for the platforms of pythonfmu's libraries."""


def native_package(fmi: int = 2, platforms: Sequence[str] = ()) -> Package:
    """Package without Python, for these platforms or, if there are none, for this machine.

    Raises
    ------
    EnvironmentLackError
        If this machine is of no platform that FMI has a name for.
    """
    own = own_platform()
    if not platforms and not own:
        text = "FMI has no name for this platform; name others: --platforms linux64"
        raise EnvironmentLackError(text)
    return Package(True, fmi, tuple(platforms) or (own,))


def _python_entries(name: str, dimension: int) -> dict[str, bytes]:
    code = payload(dimension)
    entries = {f"resources/{file}": data for file, data in code.files.items()}
    entries[f"resources/{SLAVE_NAME}"] = f"{code.slave_module}\n".encode()
    for library, data in wrapper_libraries().items():
        platform, suffix = library.split("/")
        entries[f"binaries/{platform}/{name}{suffix}"] = data
    return entries


def _native_library(platform: str, dimension: int) -> bytes:
    path = library_path(package_folder("fmu_src"), platform, dimension)
    if path.is_file():
        return path.read_bytes()
    remedy = "python -m build_kernel"
    if platform != own_platform():
        remedy = "pip install ziglang, then python -m build_kernel --all"
    text = f"the library of native FMUs for {platform} is missing ({path}); compile it: {remedy}"
    raise EnvironmentLackError(text)
