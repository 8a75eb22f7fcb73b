"""Model files and states, damaged, in the library of native FMUs with sanitizers: refused or run.

The host is ``native.c``, one process for many cases; a sanitizer that speaks ends it.
"""

from __future__ import annotations

import functools
import os
import subprocess
from pathlib import Path

import solver
from build_kernel.compiler import SOURCES, includes
from solver.scene.meshes import LIBRARIES
from tests.hostile.calls import SCENE
from tests.sanitize import OPTIONS, ROOT, SETTINGS, copy_with_sanitizers, sanitized_library

HERE = Path(__file__).parent
NEEDS = ("gcc", *LIBRARIES)
NAMES = (
    *("double_pendulum", "four_bar", "cam_and_follower", "slider_crank_with_clearance"),
    *("woodpecker_toy", "heavy_top", "ball_on_hills", "bowling_ball", "stewart", "die_in_a_bowl"),
    *("bricard", "double_wishbone", "slider_crank"),
)
"""In the plane and in space; with inputs, functions, rigid bodies, contacts and a mesh."""


def prepare(folder: Path) -> None:
    """Compile libraries, where they are not there yet, and the host; write good models."""
    if not (folder / "solver").exists():
        copy_with_sanitizers(folder, "-O1")
    command = ["gcc", "-std=c99", "-O1", "-Wall", "-Wextra", "-Wpedantic", "-Werror", *OPTIONS]
    command += [*includes(ROOT / SOURCES), str(HERE / "native.c")]
    subprocess.run([*command, "-o", str(folder / "native"), "-ldl", "-lm"], check=True)
    models = {name: solver.load(ROOT / "scenes" / f"{name}.toml") for name in NAMES}
    words = []
    for name, scene in (models | {"calls": solver.loads(SCENE)}).items():
        model, file = solver.assemble(scene), folder / f"{name}.bin"
        file.write_bytes(model.file)
        names = [variable.name for variable in model.variables]
        steps = (str(names.index(f"solver.{name}")) for name in ("step_size", "longest_step"))
        words += [str(sanitized_library(folder, model.sizes["dim"])), str(file), *steps]
    (folder / "targets").write_text("\n".join(words), encoding="utf-8")


def host(seed: str, folder: Path) -> list[str]:
    """Command of the host, which reads numbers of cases."""
    words = (folder / "targets").read_text(encoding="utf-8").splitlines()
    return [str(folder / "native"), seed, str(folder), *words]


@functools.cache
def _running(seed: str, folder: Path) -> subprocess.Popen[str]:
    settings = dict(os.environ) | SETTINGS
    pipe = subprocess.PIPE
    command = host(seed, folder)
    return subprocess.Popen(
        command, env=settings, text=True, bufsize=1, stdin=pipe, stdout=pipe, stderr=pipe
    )


def case(seed: str, number: int, folder: Path) -> str | None:
    """Run a damaged model, or from a damaged state of a good one."""
    run = _running(seed, folder)
    assert run.stdin
    assert run.stdout
    run.stdin.write(f"{number}\n")
    answer = run.stdout.readline().strip()
    if answer:
        return answer if answer.startswith("!") else None
    _running.cache_clear()
    told = [line for line in run.communicate()[1].splitlines() if line.strip()][:6]
    return f"the host ended with {run.returncode}: {' | '.join(told)[:600]}"
