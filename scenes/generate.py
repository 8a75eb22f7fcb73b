"""Scenes of any size, written as text: `python -m scenes.generate hanging_chain 1000 > chain.toml`.

Nothing of the solver is used here; what comes out is a scene as anybody would write it.
"""

from __future__ import annotations

import argparse
import math
from collections.abc import Callable, Iterable


def n_four_bar(n: int) -> str:
    """Text of n loops of uniform unit bars on n + 1 cranks, moving at 1 m/s (IFToMM A02)."""
    return _scene(
        [f'name = "n_four_bar_{n}"', f'description = "{n} four-bar loops in a row"'],
        ["dimension = 2", "gravity = [0, -9.81]", "", "[points]"],
        [f"A{i} = {{ position = [{i}, 0], fixed = true }}" for i in range(n + 1)],
        [f"B{i} = {{ position = [{i}, 1], velocity = [1, 0] }}" for i in range(n + 1)],
        ["", "[bodies]"],
        [_bar(f"crank{i}", f"A{i}", f"B{i}", 1.0) for i in range(n + 1)],
        [_bar(f"coupler{i}", f"B{i}", f"B{i + 1}", 1.0) for i in range(n)],
        _times(0.005, 10.0),
    )


def hanging_chain(n: int) -> str:
    """Text of a chain of n uniform bars, 3.14 m and 1 kg, let go from a half circle."""
    turn = [math.pi * i / n for i in range(n + 1)]
    places = [f"position = [{-math.cos(a)!r}, {-math.sin(a)!r}]" for a in turn]
    places[0] = "position = [-1, 0], fixed = true"
    places[n] = "position = [1, 0], fixed = true"
    return _scene(
        [f'name = "hanging_chain_{n}"', f'description = "Chain of {n} links between two nails"'],
        ["dimension = 2", "gravity = [0, -9.81]", "", "[points]"],
        [f"P{i} = {{ {place} }}" for i, place in enumerate(places)],
        ["", "[bodies]"],
        [_bar(f"link{i + 1}", f"P{i}", f"P{i + 1}", 1.0 / n) for i in range(n)],
        _times(0.002, 2.0),
    )


def rigid_chain(n: int, dimension: int = 3) -> str:
    """Text of n hinged links of 0.1 m and 0.1 kg, let go from the horizontal.

    In space each hinge turns across the one before: about y, z, y, ...
    """
    space = dimension == 3
    rest = [0, 0] if space else [0]
    links, hinges = ["", "[bodies]"], ["", "[joints]"]
    weight = "mass = 0.1, " + (
        'shape = { type = "box", size = [0.1, 0.02, 0.02] }'
        if space
        else 'shape = { type = "rod", length = 0.1 }'
    )
    for i in range(n):
        links.append(f"link{i + 1} = {{ position = {[(2 * i + 1) / 20, *rest]}, {weight} }}")
        pair = f'["{f"link{i}" if i else "ground"}", "link{i + 1}"]'
        axis = f", axis = {[0, 1, 0] if i % 2 == 0 else [0, 0, 1]}" if space else ""
        place = f"position = {[i / 10, *rest]}{axis}"
        hinges.append(f'hinge{i + 1} = {{ type = "revolute", bodies = {pair}, {place} }}')
    return _scene(
        [f'name = "rigid_chain_{n}"', f'description = "Chain of {n} hinged rigid bodies"'],
        [f"dimension = {dimension}", f"gravity = {[*rest, -9.81]}"],
        links,
        hinges,
        _times(0.002, 2.0),
    )


GENERATORS: dict[str, Callable[[int], str]] = {
    "n_four_bar": n_four_bar,
    "hanging_chain": hanging_chain,
    "rigid_chain": rigid_chain,
}


def _bar(name: str, first: str, second: str, mass: float) -> str:
    return f'{name} = {{ type = "bar", points = ["{first}", "{second}"], mass = {mass!r} }}'


def _times(step: float, stop: float) -> list[str]:
    solver = ["", "[solver]", f"step_size = {step}"]
    return [*solver, "", "[experiment]", f"stop_time = {stop}", "step_size = 0.02"]


def _scene(*blocks: Iterable[str]) -> str:
    return "\n".join(line for block in blocks for line in block) + "\n"


def main() -> None:
    """Print the scene that the command line asks for."""
    parser = argparse.ArgumentParser(description="Print a scene of any size.")
    parser.add_argument("scene", choices=GENERATORS)
    parser.add_argument("n", type=int, help="number of loops or links, from 2")
    asked = parser.parse_args()
    if asked.n < 2:
        parser.error(f"n must be at least 2, got {asked.n}")
    print(GENERATORS[asked.scene](asked.n), end="")  # noqa: T201


if __name__ == "__main__":
    main()
