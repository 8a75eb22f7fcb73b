"""Numbers of a run come back from the text of a page, as exact as they need to be."""

from __future__ import annotations

import base64
import zlib

import numpy as np
import pytest

from viewer.packing import FARTHEST, packed

T = np.linspace(0.0, 10.0, 501)
BODY = ["b.x", "b.y", "b.z", "b.qw", "b.qx", "b.qy", "b.qz"]


def drawing(*names: str, size: float = 1.0) -> dict:
    frames = [{"variables": []}, {"variables": [*names]}]
    return {"frames": frames, "solids": [{"radius": size}]}


def bytes_of(block: str) -> bytes:
    return zlib.decompress(base64.b64decode(block))


def unpacked(run, kinds: str) -> np.ndarray:
    """Poses as the page reads them; `kinds` has a letter for each."""
    n, meta = run.meta["n"], run.meta["poses"]
    counted = [k for k, kind in enumerate(kinds) if not (meta["wide"] and kind == "x")]
    content, end = bytes_of(run.blocks[1]), 2 * n * len(counted)
    planes = np.frombuffer(content[:end], np.uint8).reshape(2, -1).T
    bits = np.ascontiguousarray(planes).view("<u2").reshape(len(counted), n)
    for _ in range(2):
        bits = np.cumsum(bits, axis=1, dtype=np.uint16)
    scales = {"x": (meta["step"], meta["low"]), "q": (2 / 65000, -1), "a": (np.pi / 32768, 0)}
    found = np.zeros((len(kinds), n))
    for row, k in enumerate(counted):
        step, low = scales[kinds[k]]
        found[k] = low + step * bits[row]
    rest = np.frombuffer(content[end:], np.uint8).reshape(4, -1).T
    wide = [k for k in range(len(kinds)) if k not in counted]
    found[wide] = np.ascontiguousarray(rest).view("<f4").reshape(len(wide), n)
    return found


def test_positions_and_turns_come_back_to_a_65000th():
    half = 0.3 * T
    turn = [np.cos(half), 0 * T, np.sin(half), 0 * T]
    poses = [np.sin(T), np.cos(T), 0.1 * T, *turn]
    run = packed(drawing(*BODY), T, dict(zip(BODY, poses, strict=True)), [])
    off = abs(unpacked(run, "xxxqqqq") - poses).max(axis=1)
    assert off[:3].max() <= 2.0 / 65000
    assert off[3:].max() <= 1.01 / 65000


def test_an_angle_wraps():
    angle = 3.0 * T
    run = packed(drawing("b.x", "b.y", "b.angle"), T, {"b.x": T, "b.y": T, "b.angle": angle}, [])
    off = np.angle(np.exp(1j * (unpacked(run, "xxa")[2] - angle)))
    assert abs(off).max() < 1e-4


def test_a_quaternion_that_changes_its_sign_is_made_continuous():
    turn = np.array([np.cos(0.3 * T), np.sin(0.3 * T), 0 * T, 0 * T])
    jumping = turn * np.where(np.arange(len(T)) % 7 < 3, 1.0, -1.0)
    run = packed(drawing(*BODY), T, dict(zip(BODY, [T, T, T, *jumping], strict=True)), [])
    assert abs(np.diff(unpacked(run, "xxxqqqq")[3:], axis=1)).max() < 0.01


@pytest.mark.parametrize("far", [0.5, 2.0])
def test_positions_of_what_travels_far_are_of_single_precision(far):
    x = far * FARTHEST * T / T[-1]
    run = packed(drawing("b.x", "b.y"), T, {"b.x": x, "b.y": 0 * T}, [])
    assert run.meta["poses"]["wide"] == (far > 1.0)
    assert abs(unpacked(run, "xx")[0] - x).max() < 1e-3 * (0.5 + far)


@pytest.mark.parametrize("bodies", [1, 40])
def test_a_run_of_any_length_and_roughness_keeps_to_its_budget(bodies):
    """Noise is not deflated, and no line between fewer rows follows it."""
    rng, budget = np.random.default_rng(1), 200_000
    times = np.linspace(0.0, 1.0, 20_000)
    names = [f"{name}{k}" for k in range(bodies) for name in ("b.x", "b.y", "energy.")]
    columns = {name: rng.standard_normal(len(times)) for name in names}
    places = [name for name in names if not name.startswith("energy")]
    run = packed(drawing(*places), times, columns, names, budget)
    assert sum(map(len, run.blocks)) <= budget
    assert run.notes[0].startswith("shows every ")
    assert run.meta["n"] >= 9


def test_values_come_back_as_single_precision():
    column = np.exp(T) - 1e-12
    run = packed(drawing(), T, {"e": column}, ["e"])
    planes = np.frombuffer(bytes_of(run.blocks[2]), np.uint8).reshape(4, -1).T
    assert (np.ascontiguousarray(planes).view("<f4").ravel() == column.astype("<f4")).all()


def test_small_changes_of_large_values_come_back():
    column = 2389.5 + 1e-5 * np.sin(T)
    run = packed(drawing(), T, {"e": column, "x": T}, ["e", "x"])
    planes = np.frombuffer(bytes_of(run.blocks[2]), np.uint8).reshape(4, -1).T
    change = np.ascontiguousarray(planes).view("<f4").reshape(2, -1)[0]
    assert run.meta["levels"] == {"e": column[0]}
    assert abs(column[0] + change.astype(float) - column).max() < 1e-11


def test_repeated_times_are_one_row():
    times = np.array([0.0, 1.0, 1.0, 2.0])
    assert packed(drawing("b.x", "b.y"), times, {"b.x": times, "b.y": times}, []).meta["n"] == 3


def test_what_does_not_fit_is_left_out_and_said():
    noise = np.random.default_rng(1).normal(size=(40, len(T)))
    columns = {f"v{k}": row for k, row in enumerate(noise)} | {"energy.error": noise[0]}
    run = packed(drawing(), T, columns, [*columns], budget=30_000)
    assert "energy.error" in run.meta["values"]
    assert len(run.meta["values"]) < len(columns)
    assert sum(map(len, run.blocks)) <= 30_000
    assert any("left out" in note for note in run.notes)


def test_rows_of_a_slow_motion_are_thinned_before_columns():
    times = np.linspace(0.0, 10.0, 20_001)
    columns = {"b.x": np.sin(times), "b.y": np.cos(times), "e": times}
    run = packed(drawing("b.x", "b.y"), times, columns, ["e"], budget=120_000)
    assert run.meta["n"] <= 10_001
    assert run.meta["values"] == ["e"]
    assert "rows" in run.notes[0]
