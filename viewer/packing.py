"""Numbers of a run as text for an HTML file: deflated columns in base64.

Poses are integers of 16 bits, of which the second differences are stored: a smooth motion is then
nearly all zeros in its high bytes. Positions count in 1/65000 of the space that a run takes, parts
of quaternions in 2/65000, angles in 2 pi/65536, which wrap by themselves. Where a mechanism travels
so far that this is too coarse for it, positions are of single precision. All other values are of
single precision, each of their four bytes apart; a variable that changes little against its size
is stored as its change from the start.
"""

from __future__ import annotations

import base64
import zlib
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any

import numpy as np

if TYPE_CHECKING:
    from numpy.typing import NDArray

STEPS = 65000
"""Of the largest extent of positions, and of a part of a quaternion from -1 to 1."""
TURN = 2.0 * np.pi / 65536.0
FARTHEST = 5000.0
"""Sizes of itself that a mechanism travels before its positions are of single precision."""
LEVEL = 6
"""Of deflate: 9 takes four times as long for 1 % less."""
BUDGET = 10_000_000
"""Characters of a page."""
FEWEST_ROWS = 9
"""That a page shows, however large a row is."""
BASE64 = 1.34
"""Characters for each byte, as many as they are where deflate finds nothing to save."""
CLOSE = 1e-3
"""Part of the size of the mechanism by which rows between others may be off and left out."""
LITTLE = 1e-3
"""Change over size of a variable of which the change is stored: a potential energy, say."""
MOST_IMPORTANT = ("energy.", "constraint.")


@dataclass
class Packed:
    """A run as the page has it: what describes its blocks, the blocks, and what was left out."""

    meta: dict[str, Any]
    blocks: list[str]
    notes: list[str] = field(default_factory=list)


def channels(drawing: Mapping[str, Any]) -> tuple[list[str], list[str]]:
    """Names of what moves the frames of a drawing, and the kind of each: x, q or angle."""
    names = [name for frame in drawing["frames"] for name in frame["variables"]]
    return names, [_kind(name) for name in names]


def _kind(name: str) -> str:
    last = name.rpartition(".")[2]
    return "angle" if last == "angle" else "q" if last.startswith("q") else "x"


def packed(
    drawing: Mapping[str, Any],
    times: NDArray[np.float64],
    columns: Mapping[str, NDArray[np.float64]],
    order: Sequence[str],
    budget: int = BUDGET,
) -> Packed:
    """Pack one run.

    Parameters
    ----------
    drawing
        Its drawing, whose frames name their columns.
    times, columns
        Ascending times in s, and values by name.
    order
        Names of the columns to keep, the most important first.
    budget
        Characters that its blocks may have.
    """
    names, kinds = channels(drawing)
    times, keep = np.unique(np.asarray(times, float), return_index=True)
    poses = _continuous([np.asarray(columns[n], float)[keep] for n in names], names, len(times))
    size = _size(drawing, poses, kinds)
    stride = _stride(poses, kinds, size, len(times), len(order), budget)
    while True:  # a motion that no line between fewer rows follows is coarse, but the page opens
        rows = np.unique(np.append(np.arange(0, len(times), stride), len(times) - 1))
        poses_then = poses if stride == 1 else poses[:, rows]
        table = {name: np.asarray(columns[name], float)[keep][rows] for name in order}
        run = _of_rows(times[rows], poses_then, kinds, size, table, budget)
        if stride > 1:
            text = f"shows every {stride}th of {len(times)} rows; they are left out of its CSV"
            run.notes.insert(0, text)
        over = sum(map(len, run.blocks)) / max(budget, 1)
        if over <= 1.0 or len(rows) <= FEWEST_ROWS:
            return run
        fewest = max((len(times) - 1) // (FEWEST_ROWS - 1), 1)
        stride = max(min(stride * max(2, round(over)), fewest), stride + 1)


def _of_rows(
    times: NDArray[np.float64], poses: NDArray[np.float64], kinds: Sequence[str], size: float,
    columns: Mapping[str, NDArray[np.float64]], budget: int,
) -> Packed:  # fmt: skip
    """Pack these rows, with as many columns, the most important first, as have room."""
    notes, order = [], [*columns]
    meta, pose_bytes = _pose_block(poses, kinds, size)
    blocks = [text_of(times.astype("<f8").tobytes()), text_of(pose_bytes)]
    room = int(max(budget - len(blocks[0]) - len(blocks[1]), 0) / (BASE64 * 4 * len(times)))
    kept = order[:room]
    if len(kept) < len(order):
        kept = [*dict.fromkeys([*[n for n in order if n.startswith(MOST_IMPORTANT)], *kept])]
        notes.append(f"{len(order) - len(kept)} of {len(order)} variables were left out")
    values = np.array([columns[name] for name in kept]).reshape(len(kept), len(times))
    little = np.ptp(values, axis=1) < LITTLE * abs(values[:, 0])
    levels = np.where(little, values[:, 0], 0.0)
    blocks.append(text_of(_planes((values - levels[:, None]).astype("<f4"))))
    about = {"values": kept, "levels": {kept[k]: levels[k] for k in np.flatnonzero(levels)}}
    return Packed({"n": len(times), "poses": meta, **about}, blocks, notes)


def _stride(
    poses: NDArray[np.float64], kinds: Sequence[str], size: float, rows: int, columns: int,
    budget: int,
) -> int:  # fmt: skip
    """Rows to leave out while the page would be too large and the motion stays as it is."""
    stride, cost = 1, 8 + 2 * len(kinds) + 4 * columns
    while (
        cost * rows / stride > 2 * budget
        and rows // stride > 8
        and _close(poses, kinds, size, 2 * stride)
    ):
        stride *= 2
    return stride


def _close(poses: NDArray[np.float64], kinds: Sequence[str], size: float, stride: int) -> bool:
    """Whether straight lines between each `stride` rows lead as good as through those between."""
    ends = poses[:, ::stride]
    middle = poses[:, stride // 2 :: stride][:, : ends.shape[1] - 1]
    off = abs(middle - 0.5 * (ends[:, :-1] + ends[:, 1:])[:, : middle.shape[1]])
    scale = np.array([size if kind == "x" else 1.0 for kind in kinds])
    return bool((off.max(axis=1, initial=0.0) <= CLOSE * scale).all())


def _continuous(
    poses: Sequence[NDArray[np.float64]], names: Sequence[str], count: int
) -> NDArray[np.float64]:
    """Poses as rows; a quaternion and its negative are the same turn, and here do not alternate."""
    table = np.array(poses).reshape(len(names), count)
    for k, name in enumerate(names):
        if name.endswith(".qw"):
            turned = table[k : k + 4]
            back = np.sum(turned[:, 1:] * turned[:, :-1], axis=0) < 0.0
            turned[:, 1:] *= np.where(np.cumsum(back) % 2, -1.0, 1.0)
    return table


def _size(drawing: Mapping[str, Any], poses: NDArray[np.float64], kinds: Sequence[str]) -> float:
    """Size of the mechanism [m], roughly: how far apart its parts begin, or its largest part."""
    first = [poses[k, 0] for k, kind in enumerate(kinds) if kind == "x"] if poses.size else []
    largest = max(first, default=0.0) - min(first, default=0.0) if len(first) > 3 else 0.0
    for solid in drawing.get("solids", ()):
        sizes = [*solid.get("size", ()), solid.get("radius", 0.0), solid.get("length", 0.0)]
        largest = max(largest, *(float(x) for x in sizes))
    return largest


def _pose_block(
    poses: NDArray[np.float64], kinds: Sequence[str], size: float
) -> tuple[dict[str, Any], bytes]:
    """Scale and bytes of poses: integers first, then positions of single precision."""
    places = poses[[kind == "x" for kind in kinds]]
    low, high = float(places.min(initial=np.inf)), float(places.max(initial=-np.inf))
    low, high = (low, high) if low < high else (0.0, 1.0) if low > high else (low, low + 1.0)
    wide = size > 0.0 and high - low > FARTHEST * size
    scales = {"x": ((high - low) / STEPS, low), "q": (2.0 / STEPS, -1.0), "angle": (TURN, 0.0)}
    counted = [k for k, kind in enumerate(kinds) if not (wide and kind == "x")]
    steps = np.array([scales[kinds[k]] for k in counted]).reshape(-1, 2)
    numbers = np.rint((poses[counted] - steps[:, 1:]) / steps[:, :1])
    bits = np.mod(numbers, 65536).astype("<u2")
    for _ in range(2):  # modulo 65536, as integers of 16 bits do by themselves
        bits[:, 1:] = bits[:, 1:] - bits[:, :-1]
    content = _planes(bits) + (_planes(places.astype("<f4")) if wide else b"")
    return {"low": low, "step": scales["x"][0], "wide": wide}, content


def _planes(table: NDArray[Any]) -> bytes:
    """All first bytes of the numbers, then all second ones, and so on."""
    numbers = np.ascontiguousarray(table).reshape(-1)
    return np.ascontiguousarray(
        numbers.view(np.uint8).reshape(-1, table.dtype.itemsize).T
    ).tobytes()


def text_of(content: bytes) -> str:
    """Block of a page: bytes deflated, in base64."""
    return base64.b64encode(zlib.compress(content, LEVEL)).decode()
