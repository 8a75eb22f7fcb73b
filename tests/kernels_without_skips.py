"""Kernels without some of the skips of docs/skips.md: compiled once, kept in files."""

from __future__ import annotations

import ctypes
import functools
import hashlib
import os
import platform
import tempfile
from pathlib import Path

import pytest

from build_kernel.compiler import SOURCES, compile_library, flags, system_compiler, zig_compiler
from solver.runtime import Integrator, Model
from solver.runtime.kernel import load_library

FOLDER = Path(__file__).resolve().parents[1] / SOURCES
OPTIMISATION = "-O1"
"""Times are not measured, and a kernel takes 4 s to compile."""

needs_compiler = pytest.mark.skipif(
    not (system_compiler() or zig_compiler()), reason="no C compiler to compile kernels with"
)


def _digest() -> str:
    """Hash of all that makes a kernel."""
    digest = hashlib.sha256(" ".join([*flags(platform.system()), OPTIMISATION]).encode())
    for path in sorted(FOLDER.iterdir()):
        digest.update(path.name.encode() + path.read_bytes())
    return digest.hexdigest()[:16]


@functools.cache
def kernel_without(bits: int, dimension: int) -> ctypes.CDLL:
    """Kernel of a dimension without the skips of these bits (`enum skip` of internal.h)."""
    folder = Path(tempfile.gettempdir(), f"holonom-kernels-{_digest()}")
    folder.mkdir(exist_ok=True)
    target = folder / f"without{bits}in{dimension}.library"
    if not target.exists():
        compiler = system_compiler() or zig_compiler()
        assert compiler is not None
        mine = folder / f"{os.getpid()}-{target.name}"  # another process may compile it as well
        options = (OPTIMISATION, f"-DHOLONOM_WITHOUT={bits}")
        compile_library(compiler, FOLDER, dimension, mine, *options)
        mine.replace(target)
    return load_library(dimension, str(target))


def integrator_without(bits: int, model: Model, **settings: float | str | bool) -> Integrator:
    """Integrator without the skips of these bits, at the start of its run."""
    library = kernel_without(bits, model.sizes["dim"])
    integrator = Integrator(model, log=lambda _: None, library=library)
    for name, value in settings.items():
        integrator[f"solver.{name}"] = value
    integrator.initialise()
    return integrator
