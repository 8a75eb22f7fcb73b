"""`holonom assemble SCENE -o FILE`: close a mechanism drawn inexactly, and write its pose."""

from __future__ import annotations

import argparse
import sys
from dataclasses import asdict
from typing import TYPE_CHECKING

from build_fmu.errors import UsageError
from build_fmu.printing import number, print_json, print_table
from build_fmu.study.settings import given_on_the_command_line, scene_overrides

if TYPE_CHECKING:
    from solver.closing import Closing

ROUND_OFF = 1e-12
"""Of ways [m] and angles [rad]."""


def run(arguments: argparse.Namespace) -> int:
    """Close it, say what moved, and write the scene; exit code 0."""
    from build_fmu.export import load_scene
    from solver import OptionError, SceneError, close

    entries = given_on_the_command_line(arguments.parameters, arguments.settings)
    try:
        scene = load_scene(arguments.scene, scene_overrides(arguments.scene, entries))
        closing = close(scene, arguments.output)
    except (OptionError, SceneError) as error:
        raise UsageError(str(error)) from None
    if arguments.json:
        document = {k: v for k, v in asdict(closing).items() if k != "text"}
        print_json(document | {"warnings": arguments.warnings})
        return 0
    print_table(arguments.scene, ("", ""), _rows(closing))
    rows = [(name, *map(_shown, move)) for name, move in closing.moved.items()]
    print_table("moved from the drawing", ("part", "m", "rad"), rows)
    for remark in closing.remarks:
        sys.stderr.write(f"holonom: {remark}\n")
    if arguments.output:
        sys.stdout.write(f"{arguments.output}: the scene with the closed pose\n")
    return 0


def _shown(value: float) -> str:
    """Value for reading; what rounding makes is shown as 0."""
    return number(value if abs(value) > ROUND_OFF else 0.0)


def _rows(closing: Closing) -> list[tuple[str, str]]:
    searched = "none found" if closing.tries else "not searched, since nothing moved far"
    tries = f"{closing.tries} shaken drawings tried" if closing.tries else ""
    near = "yes: turn a body towards the one that is meant, and close it again"
    return [
        ("closed", ", ".join(filter(None, [closing.method, tries]))),
        ("another pose as near", near if closing.others else searched),
        (
            "degrees of freedom",
            "not counted" if closing.freedoms is None else str(closing.freedoms),
        ),
        (
            "redundant rows",
            f"among those of {', '.join(closing.redundant)}" if closing.redundant else "0",
        ),
    ]
