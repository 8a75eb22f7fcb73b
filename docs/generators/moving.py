"""Pictures of mechanisms in motion, drawn from runs: those of the gallery and of the README.

`python -m docs.generators.moving` draws the one of the README again.
"""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
from PIL import Image  # pyright: ignore[reportMissingImports]

import holonom
from viewer.drawing import drawing
from viewer.picture import canvases

ROOT = Path(__file__).resolve().parents[2]
README, SCENE = ROOT / "docs" / "jansen.gif", ROOT / "scenes" / "jansen.toml"
FRAMES, PAUSE = 48, 50
"""Of a picture, and the time that each is shown [ms]."""


def states(trajectory: holonom.Trajectory, first: int = 0) -> list[dict[str, Any]]:
    """Drawings of a run from one of its rows on, at equal distances of time."""
    model: Any = trajectory.model
    drawn = drawing(model.scene)
    drawn["solids"] += [_path(trace["name"], trajectory) for trace in drawn["view"]["traces"]]
    rows = np.linspace(first, len(trajectory.t) - 1, FRAMES).round().astype(int)
    return [
        drawn | {"frames": [_moved(frame, trajectory, row) for frame in drawn["frames"]]}
        for row in rows
    ]


def turn() -> list[dict[str, Any]]:
    """Drawings of one turn of the README's crank, which turns steadily after its first."""
    length = 2.0 * np.pi / 5.0
    run = holonom.simulate(SCENE, stop_time=2.0 * length, step_size=length / FRAMES)
    return states(run, FRAMES + 1)


def _path(name: str, trajectory: holonom.Trajectory) -> dict[str, Any]:
    axes = (trajectory[f"{name}.{x}"] for x in "xyz" if f"{name}.{x}" in trajectory.names)
    points = np.pad(np.stack([*axes], axis=1), ((0, 0), (0, 3)))[:, :3]
    still = {"kind": "look", "frame": 0, "at": [0, 0, 0], "turn": [1, 0, 0, 0], "opacity": 1.0}
    return still | {"shape": "curve", "points": points.tolist()}


def _moved(frame: dict[str, Any], trajectory: holonom.Trajectory, row: int) -> dict[str, Any]:
    now = [float(trajectory[name][row]) for name in frame["variables"]]
    return frame | {"start": now or frame["start"]}


def write(path: Path, drawings: list[dict[str, Any]]) -> None:
    """Write a GIF of drawings."""
    images = [Image.fromarray(canvas.rgb()) for canvas in canvases(drawings)]
    few = images[:: max(1, len(images) // 6)]
    strip = Image.new("RGB", (images[0].width, images[0].height * len(few)))
    for k, image in enumerate(few):
        strip.paste(image, (0, k * image.height))
    palette = strip.quantize(48)
    first, *rest = (x.quantize(palette=palette, dither=Image.Dither.NONE) for x in images)
    first.save(path, save_all=True, append_images=rest, duration=PAUSE, loop=0, optimize=False)


if __name__ == "__main__":
    write(README, turn())
