"""The code that travels in an archive, as files of one private Python package.

    holonom_<12 hex digits>_slave.py    names the class for pythonfmu's library
    holonom_<12 hex digits>/            slave.py, status.py, ... of fmu_src
        linux64.so, win64.dll           the library of native FMUs that serves the mechanism

All FMUs of a process share Python's table of modules, and pythonfmu imports an FMU's code by plain
name. The digits are a hash of the code, so two FMUs of different versions never run each other's
code, and many FMUs of one version share it. Imports among its modules are relative for that.
"""

from __future__ import annotations

import functools
import hashlib
import importlib.util
from collections.abc import Mapping
from pathlib import Path

from build_fmu.errors import EnvironmentLackError
from build_fmu.platforms import PLATFORMS, library_path, own_platform

SLAVE_NAME = "slavemodule.txt"
"""File below `resources/` in which pythonfmu's library looks for the name of the slave module."""
PYTHONFMU_PLATFORMS = ("linux64", "win64")
"""Those for which pythonfmu has a library; an FMU carries ours for both if they are compiled."""
SUFFIXES = (".so", ".dll", ".dylib")
_SLAVE_MODULE = """import ctypes
import sys

if sys.version_info < (3, 10):
    raise RuntimeError("this FMU needs Python 3.10 or newer, and this is " + sys.version)

from {package}.slave import Slave as Slave

# pythonfmu's library runs this file once per instance and then releases a reference to the module's
# dictionary that it does not own; without this one the second instance reads freed memory.
ctypes.pythonapi.Py_IncRef(ctypes.py_object(globals()))
"""


@functools.cache
def payload(dimension: int, scope: str) -> dict[str, bytes]:
    """Files of the code below `resources/`, by path, for mechanisms that these libraries serve.

    `dimension` is 2 or 3, `scope` one of `platforms.SCOPES`.
    """
    paths = sorted(package_folder("fmu_src").glob("*.py"))
    sources = {path.name: path.read_text(encoding="utf-8").encode() for path in paths}
    own = own_platform() or PYTHONFMU_PLATFORMS[0]
    for platform in {own, *PYTHONFMU_PLATFORMS}:
        path = library_path(package_folder("fmu_src"), platform, dimension, scope)
        if platform == own or path.is_file():
            name = f"{platform}{PLATFORMS[platform].suffix}"
            sources[name] = native_library(platform, dimension, scope)
    package = package_name(sources)
    files = {f"{package}/{path}": data for path, data in sources.items()}
    files[f"{package}_slave.py"] = _SLAVE_MODULE.format(package=package).encode()
    files[SLAVE_NAME] = f"{package}_slave\n".encode()
    return files


def package_name(sources: Mapping[str, bytes]) -> str:
    """Private name of the package with these files, which holds a hash of them."""
    return f"holonom_{digest(sources)[:12]}"


def digest(files: Mapping[str, bytes]) -> str:
    """SHA-256 of files with their paths, in hexadecimal digits."""
    found = hashlib.sha256()
    for path, data in sorted(files.items()):
        found.update(f"{path} {len(data)}\n".encode() + data)
    return found.hexdigest()


@functools.cache
def wrapper_libraries() -> dict[str, bytes]:
    """Libraries of pythonfmu, which carry the FMI functions, by platform and suffix.

    Keys are such as "linux64/.so".
    """
    folder = package_folder("pythonfmu") / "resources" / "binaries"
    found = sorted(path for path in folder.rglob("*") if path.suffix in SUFFIXES)
    if not found:
        text = f"pythonfmu has no libraries in {folder}; install it anew: pip install pythonfmu"
        raise EnvironmentLackError(text)
    return {f"{path.parent.name}/{path.suffix}": path.read_bytes() for path in found}


def package_folder(name: str) -> Path:
    """Folder of an installed package, found without importing it.

    Raises
    ------
    EnvironmentLackError
        If it is not installed.
    """
    spec = importlib.util.find_spec(name)
    if spec is None or not spec.submodule_search_locations:
        text = f"the package {name} is missing; install it: pip install {name}"
        raise EnvironmentLackError(text)
    return Path(next(iter(spec.submodule_search_locations)))


def native_library(platform: str, dimension: int, scope: str) -> bytes:
    """Library of FMUs for a platform.

    Raises
    ------
    EnvironmentLackError
        If it is missing; how to compile it.
    """
    path = library_path(package_folder("fmu_src"), platform, dimension, scope)
    if path.is_file():
        return path.read_bytes()
    remedy = "python -m build_kernel"
    if platform != own_platform():
        remedy = "in a clone of holonom: pip install ziglang, then python -m build_kernel --all"
    text = f"the library of FMUs for {platform} is missing ({path}); compile it: {remedy}"
    raise EnvironmentLackError(text)
