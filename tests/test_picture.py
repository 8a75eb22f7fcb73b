"""The picture and the page that travel with an FMU: a sound PNG file of what the scene draws."""

from __future__ import annotations

import struct
import zipfile
import zlib

import numpy as np
import pytest

import solver
from build_fmu.canvas import Canvas
from build_fmu.export import compile_scene
from build_fmu.picture import HEIGHT, MARGIN, WIDTH, picture
from build_fmu.trial import trial
from tests.fmu_instance import SCENES, scene_fmu

ALL_SCENES = sorted(path.stem for path in SCENES.glob("*.toml"))


def pixels(png: bytes) -> np.ndarray:
    """Colours of a PNG file with a palette and no filters, shape (height, width, 3)."""
    assert png.startswith(b"\x89PNG\r\n\x1a\n")
    blocks, place = {}, 8
    while place < len(png):
        length, kind = struct.unpack(">I4s", png[place : place + 8])
        data = png[place + 8 : place + 8 + length]
        (checksum,) = struct.unpack(">I", png[place + 8 + length : place + 12 + length])
        assert checksum == zlib.crc32(kind + data)
        blocks[kind], place = data, place + 12 + length
    assert [*blocks] == [b"IHDR", b"PLTE", b"IDAT", b"IEND"]
    width, height, *rest = struct.unpack(">IIBBBBB", blocks[b"IHDR"])
    assert rest == [8, 3, 0, 0, 0]
    rows = np.frombuffer(zlib.decompress(blocks[b"IDAT"]), np.uint8).reshape(height, -1)
    assert not rows[:, 0].any()
    assert rows.shape == (height, 1 + width)
    return np.frombuffer(blocks[b"PLTE"], np.uint8).reshape(-1, 3)[rows[:, 1:]]


def test_a_disc_covers_its_area_and_a_line_its_length_times_its_width():
    canvas = Canvas(100, 80)
    canvas.disc((30.0, 40.0), 10.0, (0.0, 0.0, 0.0))
    ink = (255 - pixels(canvas.png())[:, :, 0].astype(float)).sum() / 255
    assert ink == pytest.approx(np.pi * 10.0**2, rel=0.01)
    canvas = Canvas(100, 80)
    canvas.line((20.0, 20.0), (70.0, 55.0), 4.0, (0.0, 0.0, 0.0))
    ink = (255 - pixels(canvas.png())[:, :, 0].astype(float)).sum() / 255
    assert ink == pytest.approx(4.0 * np.hypot(50.0, 35.0) + np.pi * 2.0**2, rel=0.01)


def test_a_picture_of_very_many_colours_is_rounded_to_a_palette():
    canvas = Canvas(100, 90)
    drawn = np.random.default_rng(0).random((90, 3))
    for row, colour in enumerate(drawn):
        for column in range(0, 100, 10):
            shade = (colour * (1.0 - column / 100)).tolist()
            canvas.line((column + 2.0, row + 0.5), (column + 8.0, row + 0.5), 1.0, tuple(shade))
    seen = pixels(canvas.png())[:, ::10]
    assert len(np.unique(seen.reshape(-1, 3), axis=0)) <= 256
    seen = pixels(canvas.png())[:, 5::10] / 255
    wanted = drawn[:, None] * (1.0 - np.arange(0.0, 1.0, 0.1))[:, None]
    # 51 of 255 to 85 of 255 lie between neighbouring shades; half of it is the error.
    assert np.abs(seen - wanted).max() <= 0.5 * 85 / 255 + 1e-9


def test_what_lies_beside_the_canvas_is_left_out():
    canvas = Canvas(20, 20)
    canvas.line((-50.0, -50.0), (-10.0, 100.0), 3.0, (0.0, 0.0, 0.0))
    canvas.ring((500.0, 5.0), 10.0, 2.0, (0.0, 0.0, 0.0))
    assert (pixels(canvas.png()) == 255).all()


@pytest.mark.parametrize("name", ALL_SCENES)
def test_every_scene_has_a_picture_that_fills_its_frame(name):
    seen = pixels(picture(solver.load(SCENES / f"{name}.toml")))
    assert seen.shape == (HEIGHT, WIDTH, 3)
    rows, columns = np.nonzero((seen < 250).any(axis=2))
    room = (np.ptp(columns) / (WIDTH - 2 * MARGIN), np.ptp(rows) / (HEIGHT - 2 * MARGIN))
    assert max(room) >= 0.9
    assert max(room) <= 1.3  # with what is drawn around a place
    assert len({*map(tuple, seen[rows, columns])}) > 3


def test_points_are_drawn_where_they_are():
    # O, A, B at 0, 1 and 2 m on a level line: they share the width less its margins.
    seen = pixels(picture(solver.load(SCENES / "double_pendulum.toml")))
    for place in (MARGIN, WIDTH // 2, WIDTH - MARGIN):
        disc = seen[HEIGHT // 2 - 4 : HEIGHT // 2 + 4, place - 4 : place + 4].astype(int)
        assert disc.min() < 60
    assert (seen[:100] == 255).all()


def test_a_body_that_nothing_holds_is_seen_too():
    text = """
    name = "free"
    [bodies]
    stone = { position = [1, 2, 3], mass = 2.0, inertia = [1, 2, 2] }
    """
    assert (pixels(picture(solver.loads(text))) < 200).any()


def test_the_archive_has_picture_and_page_with_how_exact_a_run_was():
    with zipfile.ZipFile(scene_fmu("four_bar")) as archive:
        assert pixels(archive.read("model.png")).shape == (HEIGHT, WIDTH, 3)
        page = archive.read("documentation/index.html").decode()
    seen = trial(compile_scene(SCENES / "four_bar.toml"))
    assert seen.energy < 1e-12
    assert f"{seen.energy:.1e}" in page
    assert f"{seen.position_error:.1e} m" in page
    assert "conserving-al" in page
    assert 'src="../model.png"' in page
