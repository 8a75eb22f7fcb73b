"""`holonom variants SCENE`: one FMU for each row of a grid or table, and a manifest of them."""

from __future__ import annotations

import argparse
import sys
import time
from pathlib import Path

from build_fmu.errors import UsageError
from build_fmu.printing import count_bar, print_json
from build_fmu.study.settings import study_arguments
from build_fmu.target import is_fmu


def run(arguments: argparse.Namespace) -> int:
    """Export; exit code 0."""
    from build_fmu.study.variants import variants
    from solver.scene import SceneError

    scene = arguments.scene
    if is_fmu(scene):
        text = f"{scene}: an FMU, not a scene; sweep runs one FMU with many values"
        raise UsageError(text)
    given = study_arguments(arguments)
    given |= {x: getattr(arguments, x) for x in ("native", "fmi", "platforms", "sources")}
    begin = time.perf_counter()
    try:
        name = Path(scene).stem
        folder = Path(arguments.output or f"{name}_variants")
        with count_bar(f"variants of {name}", "FMUs") as progress:
            made = variants(scene, folder, manifest=arguments.manifest, progress=progress, **given)
    except SceneError as error:
        raise UsageError(str(error)) from None
    if arguments.report:
        from build_fmu.run_page import report_rows

        rows = [(str(folder / v.fmu), {}, v.parameters) for v in made]
        sys.stderr.write(f"{report_rows(arguments.report, rows, scene)}\n")
    manifest = folder / arguments.manifest
    if arguments.json:
        rows = [{"fmu": str(folder / v.fmu), "parameters": v.parameters} for v in made]
        warnings = {"warnings": arguments.warnings}
        print_json({"manifest": str(manifest), "variants": rows} | warnings)
    else:
        sys.stdout.write(f"{manifest}\n")
        sys.stderr.write(f"{len(made)} FMUs in {time.perf_counter() - begin:.1f} s\n")
    return 0
