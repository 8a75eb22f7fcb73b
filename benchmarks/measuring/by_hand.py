"""Chains of points whose steps are written by hand in C, for the least that a step takes.

`python -m benchmarks.measuring.by_hand LIBRARY NAME BLOCK STEPS`: advance one from a block of
doubles, and nothing else; it needs the standard library alone, as
`benchmarks.measuring.kernel_run` does, and prints the number of implicit solves.
"""

from __future__ import annotations

import ctypes
import platform
import sys
from array import array
from pathlib import Path

from solver.runtime import Integrator
from tests.support.kernel.kernel_calls import kernel_of

FOLDER = Path(__file__).resolve().parent / "handwritten"
FIRST = ("mass", "length", "gravity", "penalty", "tolerance", "reference", "floor")
COUNTS = ("known", "solves", "iterations")
ROUND_OFF = 32.0 * 2.3e-16
"""Of increments against the size of the mechanism, as in the kernel."""


def build(name: str, folder: Path) -> Path:
    """Compile `handwritten/<name>.c` with the kernel's flags; the library's path."""
    from benchmarks.measuring.processes import printed
    from build_kernel.compiler import any_compiler, flags

    library = folder / f"{name}.library"
    options = *flags(platform.system()), "-fvisibility=default", "-o", str(library)
    printed([*any_compiler(), *options, f"{name}.c", "-lm"], FOLDER)
    return library


def block_of(integrator: Integrator, mass: float, length: float, gravity: float) -> array[float]:
    """Numbers and motion of a chain, as `handwritten/point_chain.h` lays them out."""
    head, vectors, model = integrator.state.head, integrator.state.vectors, integrator.model
    extent = kernel_of(integrator).numbers[model.offsets["extent"] + 1]
    settings = (head["penalty"], head["newton_tolerance"], head["energy_reference"])
    block = array("d", (mass, length, gravity, *settings, ROUND_OFF * extent, 0.0, 0.0, 0.0))
    for vector in ("q", "q_low", "v", "v_low", "a_first", "mu_first", "a_second", "mu_second"):
        block.extend(vectors[vector])
    values = len(vectors["a_first"]) + len(vectors["mu_first"])
    block.extend([0.0] * (6 * values))  # of the pair before, and what was missed
    block.append(1.0)  # contraction
    return block


def advance(library: Path, name: str, block: array[float], step: float, steps: int) -> int:
    """Take internal steps of a pair of halves each; return the number of implicit solves.

    Raises
    ------
    RuntimeError
        When the iteration contracts badly: steps written by hand know only good ones.
    """
    function = getattr(ctypes.CDLL(str(library)), f"advance_{name}")
    function.argtypes = [ctypes.c_void_p, ctypes.c_double, ctypes.c_long]
    if function(block.buffer_info()[0], step, steps):
        text = f"{name}: the step written by hand does not converge with h = {step:g} s"
        raise RuntimeError(text)
    return round(block[len(FIRST) + COUNTS.index("solves")])


if __name__ == "__main__":
    start = array("d", Path(sys.argv[3]).read_bytes())
    print(advance(Path(sys.argv[1]), sys.argv[2], start, float(sys.argv[4]), int(sys.argv[5])))
