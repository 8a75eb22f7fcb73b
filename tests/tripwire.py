"""Hashes of every value of many runs: what a change of the core must leave as it is, to the bit.

python -m tests.tripwire FILE       writes the hashes of this checkout where FILE is missing, and
                                    otherwise lists the runs whose values or sentence differ

Bits depend on the machine's mathematics: compare only files made on the same machine.
"""

from __future__ import annotations

import hashlib
import itertools
import json
import struct
import sys
import warnings
from collections.abc import Iterator
from concurrent.futures import ProcessPoolExecutor
from pathlib import Path

import solver
from solver.options import ORDERS
from tests.support.kernel.twins import EVERYTHING
from tests.support.mechanisms.scene_files import SMOOTH

Settings = dict[str, str | float | bool]

STEPS = 120

SETTINGS: list[Settings] = [{"order": order} for order in ORDERS]
SETTINGS += [{"tolerance": 1e-6}]


def moved(model: solver.Model, settings: Settings) -> Iterator[bytes]:
    """Values after each of some steps with changing inputs, across a save and a restore."""
    run = solver.Integrator(model, log=lambda _: None)
    for name, value in settings.items():
        run[f"solver.{name}"] = value
    indices = range(len(model.variables))
    inputs = [v for v in model.variables if v.causality == "input"]
    h, saved = model.experiment.step_size, b""
    for i in range(STEPS):
        for variable in inputs if i % 7 == 3 else ():
            run[variable.name] = float(variable.start) + 1e-3 * (i % 5)
        run.advance(run.time, 0.37 * h if i == 20 else h)
        if i == 30:
            saved = run.save()
        elif i == 50:
            run.restore(saved)
        numbers = [x for x in run.get(indices) if isinstance(x, float)]
        yield struct.pack(f"<{len(numbers)}d", *numbers)


def hash_of(text: str, settings: Settings) -> str:
    """Hash of a run, or the sentence that ended it and the hash of what came before."""
    warnings.simplefilter("ignore")
    digest, end = hashlib.sha256(), ""
    try:
        for part in moved(solver.assemble(solver.loads(text)), settings):
            digest.update(part)
    except (solver.SceneError, solver.StepError, solver.AssemblyError, solver.OptionError) as error:
        end = f" {error}"
    return digest.hexdigest()[:16] + end


def main(path: Path) -> int:
    """Write or compare the hashes; 1 where one differs."""
    scenes = {path.stem: path.read_text("utf-8") for path in SMOOTH}
    cases = list(itertools.product((scenes | EVERYTHING).items(), SETTINGS))
    names = [f"{name} {json.dumps(settings)}" for (name, _), settings in cases]
    with ProcessPoolExecutor(2) as pool:
        texts, settings = [text for (_, text), _ in cases], [settings for _, settings in cases]
        hashes = dict(zip(names, pool.map(hash_of, texts, settings, chunksize=4), strict=True))
    if not path.exists():
        path.write_text(json.dumps(hashes, indent=1), "utf-8")
        print(f"{len(hashes)} runs written to {path}")
        return 0
    before = json.loads(path.read_text("utf-8"))
    changed = [name for name in hashes.keys() | before if hashes.get(name) != before.get(name)]
    for name in sorted(changed):
        print(f"{name}: {before.get(name)} -> {hashes.get(name)}")
    print(f"{len(hashes)} runs, {len(changed)} differ")
    return 1 if changed else 0


if __name__ == "__main__":
    sys.exit(main(Path(sys.argv[1])))
