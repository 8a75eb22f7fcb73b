"""`python -m examples`: run the co-simulations of this folder and print what they show."""

from __future__ import annotations

import os
import sys
import tempfile
from pathlib import Path

from build_fmu import build

from . import balance, couple
from .unit import open_units

HERE = Path(__file__).parent
SCENES = {"swing": "swing", "rocker": "rocker", "spring": "coupling_spring"}
STEPS = (0.02, 0.01, 0.005, 0.0025)
"""Communication steps, s."""
STOP_TIME = 1.0
ROUND_OFF = 1e-12
"""J: some 7 J turn from potential to kinetic, and hundreds of steps add their last digits."""


def build_coupled(folder: Path, *, native: bool = False) -> dict[str, Path]:
    """FMUs of the two mechanisms and of the spring between them."""
    return {
        name: build(HERE / f"{scene}.toml", folder / f"{scene}.fmu", native=native)
        for name, scene in SCENES.items()
    }


def coupled_rows(paths: dict[str, Path]) -> list[str]:
    """Rows of the table of docs/co_simulation.md."""
    rows = []
    for h in STEPS:
        cells = [f"{1e3 * h:g}"]
        for scheme in couple.SCHEMES.values():
            with open_units(paths) as units:
                run = couple.run_coupled(units, scheme, h, round(STOP_TIME / h))
            cells.append(f"{run.drift:.2g}" if run.drift > ROUND_OFF else f"< {ROUND_OFF:g}")
        rows.append("| " + " | ".join(cells) + " |")
    return rows


def show(folder: Path) -> None:
    """Print both co-simulations."""
    print(f"swing, spring and rocker, {STOP_TIME:g} s: largest change of their energy, J\n")
    print("| H, ms | " + " | ".join(couple.SCHEMES) + " |\n|---|---|---|---|")
    print("\n".join(coupled_rows(build_coupled(folder))))
    cart = build(HERE / "cart_pole.toml", folder / "cart_pole.fmu")
    paths = {"cart": cart, "controller": balance.build_controller(folder)}
    with open_units(paths) as units:
        run = balance.run_balanced(units["cart"], units["controller"], 0.01, 1000)
    print(f"\npole on a cart, 10 s: leans {run.lean[0]:.3f} rad, at the end {run.lean[-1]:.1e} rad")
    print(f"work of the controller: {run.given[-1]:.6f} J by force and way, ", end="")
    print(f"{run.work[-1]:.6f} J in the cart's ledger")


if __name__ == "__main__":
    with tempfile.TemporaryDirectory() as scratch:
        show(Path(scratch))
    sys.stdout.flush()
    os._exit(0)  # pythonfmu's exit handlers read freed memory (docs/fmu.md, section 5)
