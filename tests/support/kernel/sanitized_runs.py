"""Runs of all scenes in all orders, for a kernel that checks itself.

`python -m tests.support.kernel.sanitized_runs EVERY` runs each EVERY-th case and prints how many
there were.
"""

from __future__ import annotations

import functools
import itertools
import sys
import tempfile
import warnings
from pathlib import Path

import solver
from solver.options import ORDERS
from tests.hostile import contacts, models
from tests.support.kernel.kernel_calls import kernel_of
from tests.support.kernel.twins import EVERYTHING
from tests.support.mechanisms.scene_files import ALL

DAMAGED = 20_000
"""Damaged models and states, each with a good checksum."""
ODD = 2_000
"""Scenes of odd contacts; ``make hostile`` asks what they do."""
STEPS = 8

SETTINGS: list[dict[str, str | float | bool]] = [{"order": order} for order in ORDERS]
SETTINGS += [{"tolerance": tolerance} for tolerance in (1e-1, 1e-3, 1e-8)]
SETTINGS += [
    {"assemble": True},
    {"start": "equilibrium", "assemble": True},
    {"order": 8.0, "tolerance": 1e-6, "absolute_tolerance": 1e-9},
    {"max_newton": 1.0, "max_uzawa": 1.0},
    {"penalty": 1e14},
    {"penalty": 1e6},
    {"newton_tolerance": 1e-300},
    {"step_size": 1e6},
    {"step_size": 1e-300},
]
"""Usual ones, and those at the ends of their ranges."""


@functools.lru_cache(maxsize=1)
def _model(scene: Path | str) -> solver.Model:
    read = solver.load if isinstance(scene, Path) else solver.loads
    return solver.assemble(read(scene))


def _move(model: solver.Model, settings: dict[str, str | float | bool]) -> None:
    """Take steps of two lengths with inputs that change, and go back to a saved state."""
    run = solver.Integrator(model, log=lambda _: None)
    for name, value in settings.items():
        run[f"solver.{name}"] = value
    saved = b""
    for i in range(STEPS):
        if i == 2:
            saved = run.save()
        elif i == 5:
            run.restore(saved)
        for variable in model.variables:
            if variable.causality == "input" and i in (1, 4):
                run[variable.name] = float(variable.start) + 1e-3 * i
        run.advance(run.time, 0.0137 if i == 6 else 0.02)
    run.get(range(len(model.variables)))
    kernel_of(run).residuals()


def main(every: int) -> None:
    """Run the cases; what ends with a sentence is as good as what goes on."""
    warnings.simplefilter("ignore")
    ran = ended = 0
    cases = itertools.product((*ALL, *EVERYTHING.values()), SETTINGS)
    for scene, settings in itertools.islice(cases, 0, None, every):
        ran += 1
        try:
            _move(_model(scene), settings)
        except (solver.StepError, solver.AssemblyError, solver.OptionError):
            ended += 1
    for number in range(DAMAGED // every):
        found = models.case("sanitized", number, Path())
        assert not found, (number, found)
    with tempfile.TemporaryDirectory() as folder:
        contacts.prepare(Path(folder))
        for number in range(ODD // every):
            contacts.case("sanitized", number, Path(folder))
    print(f"{ran} runs, of which {ended} ended with a sentence")


if __name__ == "__main__":
    main(int(sys.argv[1]))
