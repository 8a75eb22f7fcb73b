"""Kernels without some of the skips of docs/skips.md, compiled once for each dimension.

Which skips are left out is then a variable of the library, of which each choice loads a copy.
"""

from __future__ import annotations

import ctypes
import functools
import hashlib
import os
import platform
import shutil
import sys
import tempfile
import threading
from pathlib import Path
from typing import NamedTuple

import pytest

from build_kernel.compiler import (
    SOURCES,
    Kind,
    compile_library,
    flags,
    system_compiler,
    zig_compiler,
)
from solver.runtime import Integrator, Model
from solver.runtime.kernel import load_library

FOLDER = Path(__file__).resolve().parents[3] / SOURCES
OPTIMISATION = "-O1"
"""Times are not measured, and a kernel takes 4 s to compile."""

COUNTER = Path(__file__).with_name("count_products.c")
CHOICE = COUNTER.with_suffix(".h")
"""Declares the variable that has the bits of the skips that are left out."""
PROBE = COUNTER.with_name("probe.c")
WRAPPED = [f"-Wl,--wrap=hm_{x}_{name}" for x in ("lu", "block") for name in ("factor", "solve")]
"""The linker of Linux puts the counter in place of factorisations and solves."""

COMPILING = threading.Lock()
"""Threads ask for the same kernel at once."""

needs_compiler = pytest.mark.skipif(
    not (system_compiler() or zig_compiler()), reason="no C compiler to compile kernels with"
)


def _digest() -> str:
    """Hash of all that makes a kernel."""
    digest = hashlib.sha256(" ".join([*flags(platform.system()), OPTIMISATION]).encode())
    for path in [*sorted(FOLDER.rglob("*.[ch]")), COUNTER, CHOICE, PROBE]:
        digest.update(path.name.encode() + path.read_bytes())
    return digest.hexdigest()[:16]


def _compiled(dimension: int) -> Path:
    """Kernel of a dimension that asks a variable which skips it may take."""
    folder = Path(tempfile.gettempdir(), f"holonom-kernels-{_digest()}")
    folder.mkdir(exist_ok=True)
    target = folder / f"kernel{dimension}.library"
    if not target.exists():
        compiler = system_compiler() or zig_compiler()
        if compiler is None:
            pytest.skip("no C compiler to compile kernels with")
        mine = folder / f"{os.getpid()}-{target.name}"  # another process may compile it as well
        options = [OPTIMISATION, "-DHOLONOM_WITHOUT=holonom_without", "-include", str(CHOICE)]
        options += ["-DHOLONOM_ENERGY_DECIDES=holonom_energy_decides"]
        options += [*(WRAPPED if sys.platform == "linux" else ["-DUNWRAPPED"]), str(COUNTER)]
        options += [str(PROBE)]
        compile_library(compiler, FOLDER, Kind(dimension), mine, *options)
        mine.replace(target)
    return target


@functools.cache
def kernel_without(bits: int, dimension: int, *, energy_decides: bool = True) -> ctypes.CDLL:
    """Kernel of a dimension without the skips of these bits (`enum skip` of internal.h).

    Or one whose steps count though their energy does not.
    """
    # A library that is loaded cannot be deleted on every system.
    with tempfile.TemporaryDirectory(ignore_cleanup_errors=True) as folder:
        with COMPILING:
            compiled = _compiled(dimension)
        copy = shutil.copy(compiled, Path(folder, f"without{bits}.library"))
        library = load_library(dimension, str(copy))
    ctypes.c_int.in_dll(library, "holonom_without").value = bits
    ctypes.c_int.in_dll(library, "holonom_energy_decides").value = energy_decides
    return library


class Counts(NamedTuple):
    """Factorisations, solves, and the products of both, since the kernel was loaded."""

    factorisations: int
    products_of_factors: int
    solves: int
    products_of_solves: int


def counted(bits: int, dimension: int) -> Counts:
    """What a kernel has counted."""
    return Counts(*(ctypes.c_int64 * 4).in_dll(kernel_without(bits, dimension), "counted"))


def integrator_with(
    library: ctypes.CDLL, model: Model, **settings: float | str | bool
) -> Integrator:
    """Integrator of one of these kernels, at the start of its run."""
    integrator = Integrator(model, log=lambda _: None, library=library)
    for name, value in settings.items():
        integrator[f"solver.{name}"] = value
    integrator.initialise()
    return integrator


def integrator_without(bits: int, model: Model, **settings: float | str | bool) -> Integrator:
    """Integrator without the skips of these bits, at the start of its run."""
    return integrator_with(kernel_without(bits, model.sizes["dim"]), model, **settings)
