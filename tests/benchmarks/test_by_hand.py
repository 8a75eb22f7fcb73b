"""Steps written by hand are a fair yardstick: the same motion, by as many iterations."""

from __future__ import annotations

import subprocess
import sys

import numpy as np
import pytest

from benchmarks.measuring import by_hand
from benchmarks.problems.mechanisms import start
from benchmarks.sections.instructions import HANDWRITTEN, STEP, mechanisms
from build_kernel.compiler import system_compiler, zig_compiler

STEPS = 200
BEGIN = len(by_hand.FIRST) + len(by_hand.COUNTS)

pytestmark = pytest.mark.skipif(
    not (system_compiler() or zig_compiler()), reason="no C compiler to compile them"
)


def motion_of(name, folder, step, steps):
    """Integrator at its start, and block of the chain after steps by hand."""
    function, *numbers = HANDWRITTEN[name]
    integrator = start(mechanisms()[name][0], step_size=step)
    block = by_hand.block_of(integrator, *numbers)
    solves = by_hand.advance(by_hand.build(function, folder), function, block, step, steps)
    assert solves == 2 * steps
    return integrator, np.array(block)


@pytest.mark.parametrize("name", HANDWRITTEN)
def test_steps_written_by_hand_move_a_chain_as_the_kernel_does(name, tmp_path):
    integrator, block = motion_of(name, tmp_path, STEP, STEPS)
    integrator.advance(0.0, STEPS * STEP)
    q, v = (np.asarray(integrator.state.vectors[vector]) for vector in ("q", "v"))
    n = len(q)
    # Every half step leaves rounding errors of its own: 400 of them, and 5e-4 s to divide by in v.
    assert block[BEGIN : BEGIN + n] == pytest.approx(q, abs=1e-14 * abs(q).max(), rel=0)
    moved = block[BEGIN + 2 * n : BEGIN + 3 * n]
    # Both may leave 6e-17 of its square in a rod, over 5e-4 s 1e-13 of v; a random walk of 400.
    assert moved == pytest.approx(v, abs=4e-12 * abs(v).max(), rel=0)
    # Fair: neither stops earlier than the other.
    by_kernel = integrator["solver.newton_iterations"]
    assert block[BEGIN - 1] == pytest.approx(by_kernel, rel=0.1)


def test_a_step_that_converges_badly_is_refused(tmp_path):
    with pytest.raises(RuntimeError, match="does not converge with h = 1 s"):
        motion_of("double pendulum", tmp_path, 1.0, 10)


def test_what_valgrind_watches_takes_the_steps_it_says(tmp_path):
    name = "double pendulum"
    function, *numbers = HANDWRITTEN[name]
    block = tmp_path / "block.bin"
    drawn = start(mechanisms()[name][0], step_size=STEP)
    block.write_bytes(by_hand.block_of(drawn, *numbers).tobytes())
    library = by_hand.build(function, tmp_path)
    command = [
        sys.executable,
        "-m",
        "benchmarks.measuring.by_hand",
        library,
        function,
        block,
        STEP,
        7,
    ]
    run = subprocess.run(
        [str(part) for part in command], capture_output=True, text=True, check=False
    )
    assert run.stdout.split() == ["14"], run.stderr
