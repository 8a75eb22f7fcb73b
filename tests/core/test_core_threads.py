"""Instances of one model in many threads share nothing that changes (thread sanitizer).

In space; the kernel for the plane is watched in FMUs, tests/fmu/test_cpp_host.py.
"""

from __future__ import annotations

import subprocess
from pathlib import Path

import pytest

import solver
from build_kernel.compiler import includes, kernel_sources
from tests.sanitize import has_thread_sanitizer

HERE = Path(__file__).parents[1]
KERNEL = HERE.parent / "solver" / "kernel"
SCENES = HERE.parent / "scenes"
THREADS = 16


@pytest.mark.skipif(not has_thread_sanitizer(), reason="gcc has no thread sanitizer here")
def test_threads_on_one_model_end_with_the_same_bits(tmp_path):
    model = solver.assemble(solver.load(SCENES / "heavy_top.toml"))
    file, program = tmp_path / "model.bin", tmp_path / "threads"
    file.write_bytes(model.file)
    flags = ["-std=gnu99", "-O0", "-g", "-fsanitize=thread", f"-DDIM={model.sizes['dim']}"]
    sources = [
        str(HERE / "support" / "kernel" / "core_threads.c"),
        *map(str, kernel_sources(KERNEL)),
    ]
    command = ["gcc", *flags, *includes(KERNEL), *sources, "-o", str(program), "-lm", "-lpthread"]
    subprocess.run(command, check=True)
    numbers = len(model.variables), model.experiment.step_size
    hashes = []
    for threads in (1, THREADS):
        arguments = [str(program), str(file), *map(str, numbers), str(threads)]
        run = subprocess.run(arguments, capture_output=True, text=True)
        assert run.returncode == 0, run.stderr[-3000:]
        hashes += run.stdout.split()
    assert len(hashes) == 1 + THREADS
    assert len(set(hashes)) == 1
