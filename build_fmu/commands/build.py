"""`holonom build SCENE`: write an FMU and its parameter set; its path goes to stdout."""

from __future__ import annotations

import argparse
import sys
from pathlib import Path

from build_fmu.errors import UsageError
from build_fmu.printing import print_json
from build_fmu.study.settings import given_on_the_command_line
from build_fmu.target import is_fmu, parts_and_model


def run(arguments: argparse.Namespace) -> int:
    """Build; exit code 0."""
    from build_fmu.export import fmu_path, write_fmu
    from build_fmu.package import chosen_package
    from build_fmu.ports import local_variables, summary

    package = chosen_package(
        arguments.native, arguments.fmi, arguments.platforms, arguments.sources
    )
    if is_fmu(arguments.scene):
        text = f"{arguments.scene}: an FMU, not a scene; build takes a .toml or .json file"
        raise UsageError(text)
    settings = list(arguments.settings)
    if arguments.outputs is not None:
        names = [name.strip() for name in arguments.outputs.split(",")]
        settings.append(("fmu.outputs", names))
    entries = given_on_the_command_line(arguments.parameters, settings)
    parts, model = parts_and_model(arguments.scene, entries)

    def tell(sentence: str) -> None:
        sys.stderr.write(f"{model.name}: {sentence}\n")

    path = fmu_path(arguments.output, Path(arguments.scene).stem)
    local = local_variables(model, parts.scene)
    write_fmu(parts, model, path, tell, package, local)
    size, beside = path.stat().st_size, str(path.with_suffix(".ssv"))
    if arguments.json:
        document = {"fmu": str(path), "name": model.name, "bytes": size, "parameters": beside}
        print_json(document | {"warnings": arguments.warnings})
    else:
        sys.stdout.write(f"{path}\n")
        sys.stderr.write(
            f"{model.name}: {summary(model, local)}; "
            f"{size / 1e3:.0f} kB; its parameter set is in {beside}\n"
        )
    return 0
