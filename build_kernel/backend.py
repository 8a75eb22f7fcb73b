"""Build backend (PEP 517, PEP 660): setuptools, and the kernel compiled before each wheel.

The kernel is compiled into the source tree, where an editable install finds it and from where a
wheel takes it. Only a machine without a working C compiler is asked to install `ziglang`.
"""

from __future__ import annotations

import os
import shutil
import sys
from pathlib import Path
from typing import TYPE_CHECKING, Any

from setuptools import build_meta
from setuptools.command.bdist_wheel import bdist_wheel
from setuptools.command.build_py import build_py

from build_fmu.platforms import PLATFORMS
from build_kernel.compiler import CompilerError, compile_kernel, system_compiler, take_kernels

if TYPE_CHECKING:
    Settings = dict[str, Any] | None

ROOT = Path(__file__).resolve().parent.parent

build_sdist = build_meta.build_sdist
get_requires_for_build_sdist = build_meta.get_requires_for_build_sdist
prepare_metadata_for_build_editable = build_meta.prepare_metadata_for_build_editable
prepare_metadata_for_build_wheel = build_meta.prepare_metadata_for_build_wheel


def get_requires_for_build_wheel(config_settings: Settings = None) -> list[str]:
    """Packages that building a wheel needs on this machine."""
    return [*build_meta.get_requires_for_build_wheel(config_settings), *_compiler_package()]


def get_requires_for_build_editable(config_settings: Settings = None) -> list[str]:
    """Packages that an editable install needs on this machine."""
    return [*build_meta.get_requires_for_build_editable(config_settings), *_compiler_package()]


def build_wheel(
    wheel_directory: str, config_settings: Settings = None, metadata_directory: str | None = None
) -> str:
    """Compile the kernel and build a wheel with it inside.

    `make release` names a ``platform``: the wheel is for that, with kernels compiled before.
    """
    if name := (config_settings or {}).get("platform"):
        take_kernels(ROOT, name)
        for kept in (ROOT / "build").glob("lib*"):  # by setuptools, with kernels of other platforms
            shutil.rmtree(kept)
        config_settings = {"--build-option": f"--plat-name={PLATFORMS[name].wheel}"}
    else:
        _compile()
    return build_meta.build_wheel(wheel_directory, config_settings, metadata_directory)


def build_editable(
    wheel_directory: str, config_settings: Settings = None, metadata_directory: str | None = None
) -> str:
    """Compile the kernel into the source tree and build a wheel that points there.

    The Makefile names ``cflags`` for it, which those of the environment would be for all packages.
    """
    if flags := (config_settings or {}).get("cflags"):
        os.environ["CFLAGS"] = flags
    _compile()
    return build_meta.build_editable(wheel_directory, config_settings, metadata_directory)


class KernelWheel(bdist_wheel):
    """A wheel for one platform and every Python 3: the kernel knows no Python interface."""

    def finalize_options(self) -> None:
        """Declare the content to depend on the platform."""
        self.distribution.has_ext_modules = lambda: True
        super().finalize_options()

    def get_tag(self) -> tuple[str, str, str]:
        """Tag such as py3-none-linux_x86_64."""
        return "py3", "none", super().get_tag()[2]


class PackagesWithScenes(build_py):
    """Packages, and the scenes of a clone as data of one of them, which `holonom init` copies."""

    def run(self) -> None:
        """Copy the scenes too; an editable install finds them where they are."""
        super().run()
        if not self.editable_mode:
            folder = Path(self.build_lib, "build_fmu", "scenes")
            self.mkpath(str(folder))
            for scene in sorted((ROOT / "scenes").glob("*.toml")):
                self.copy_file(str(scene), str(folder / scene.name))


def _compiler_package() -> list[str]:
    return [] if system_compiler() else ["ziglang"]


def _compile() -> None:
    try:
        compile_kernel(ROOT)
    except CompilerError as error:
        sys.exit(f"holonom: {error}")  # a message, where a traceback would bury it
