"""`build-fmu build SCENE`: write an FMU; its path goes to stdout."""

from __future__ import annotations

import argparse
import sys

from build_fmu.errors import UsageError
from build_fmu.report import print_json
from build_fmu.target import is_fmu, scene_and_model


def run(arguments: argparse.Namespace) -> int:
    """Build; exit code 0."""
    from build_fmu.export import write_fmu

    if is_fmu(arguments.scene):
        text = f"{arguments.scene}: an FMU, not a scene; build takes a .toml or .json file"
        raise UsageError(text)
    scene, model = scene_and_model(arguments.scene, dict(arguments.settings))
    path = write_fmu(model, arguments.output, scene)
    size = path.stat().st_size
    if arguments.json:
        print_json({"fmu": str(path), "name": model.name, "bytes": size})
    else:
        sys.stdout.write(f"{path}\n")
        sys.stderr.write(f"{model.name}: {len(model.variables)} variables, {size / 1e3:.0f} kB\n")
    return 0
