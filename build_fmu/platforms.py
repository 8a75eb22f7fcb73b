"""Platforms of native FMUs, and where their libraries are; `build_kernel` compiles these."""

from __future__ import annotations

import platform
from collections.abc import Mapping
from pathlib import Path
from typing import NamedTuple


class Platform(NamedTuple):
    """A platform of native FMUs.

    Attributes
    ----------
    fmi2 : str
        Folder below ``binaries/`` in FMI 2; empty where the standard has no name.
    fmi3 : tuple of str
        Folders in FMI 3, one for each architecture of a library.
    targets : tuple of str
        Names for zig, likewise.
    suffix : str
    wheel : str
        Platform in the name of a wheel.
    """

    fmi2: str
    fmi3: tuple[str, ...]
    targets: tuple[str, ...]
    suffix: str
    wheel: str


GLIBC, MACOS = "2.17", "11.0"
"""Oldest versions that libraries are for; wheels say manylinux2014 for the first."""
PLATFORMS = {
    "linux64": Platform(
        "linux64", ("x86_64-linux",), (f"x86_64-linux-gnu.{GLIBC}",), ".so",
        "manylinux2014_x86_64",
    ),
    "win64": Platform(
        "win64", ("x86_64-windows",), ("x86_64-windows-gnu",), ".dll", "win_amd64",
    ),
    "darwin64": Platform(
        "darwin64", ("x86_64-darwin", "aarch64-darwin"),
        (f"x86_64-macos.{MACOS}", f"aarch64-macos.{MACOS}"), ".dylib", "macosx_11_0_universal2",
    ),
    # FMI 2 knows linux64 alone, where importers on ARM look, too: it has an archive of its own.
    "linux-arm64": Platform(
        "", ("aarch64-linux",), (f"aarch64-linux-gnu.{GLIBC}",), ".so", "manylinux2014_aarch64",
    ),
}  # fmt: skip
SCOPES = ("points", "bodies", "contacts")
"""What a library serves, each the one before it, too: points and bars, rigid bodies, contacts."""


def own_platform(system: str = "", machine: str = "") -> str:
    """Name in `PLATFORMS` of this machine; empty if it is none of them."""
    system, machine = system or platform.system(), (machine or platform.machine()).lower()
    is_arm = machine in ("arm64", "aarch64")
    if system == "Linux":
        return "linux-arm64" if is_arm else "linux64" if machine in ("x86_64", "amd64") else ""
    if system == "Windows":
        return "win64" if machine in ("x86_64", "amd64") else ""
    return "darwin64" if system == "Darwin" else ""


def library_scope(sizes: Mapping[str, int]) -> str:
    """The smallest of `SCOPES` that serves a model of these sizes."""
    if sizes["unilateral"]:
        return "contacts"
    return "bodies" if sizes["n_bodies"] else "points"


def library_path(root: Path, name: str, dimension: int, scope: str) -> Path:
    """Library for a platform and mechanisms of this dimension, below the folder of `fmu_src`."""
    word = library_word(dimension, scope)
    return root / "native" / "_libraries" / name / f"{word}{PLATFORMS[name].suffix}"


def library_word(dimension: int, scope: str) -> str:
    """Name of a library on every platform."""
    return ("planar_" if dimension == 2 else "spatial_") + scope
