"""The picture and the page that travel with an FMU: a sound PNG file of what the scene draws."""

from __future__ import annotations

import math
import struct
import sysconfig
import zipfile
import zlib

import numpy as np
import pytest
from fmpy.validation import validate_fmu

import solver
from build_fmu import build
from build_fmu.documentation import documentation, page
from build_fmu.self_check import self_check
from tests.support.fmus.fmu_instance import SCENES, scene_fmu
from tests.support.mechanisms.scene_files import ALL
from viewer.canvas import Canvas
from viewer.drawing import AZIMUTH, ELEVATION, drawing
from viewer.picture import HEIGHT, MARGIN, WIDTH, picture

BLACK = (0.0, 0.0, 0.0)
ALL_SCENES = [path.stem for path in ALL]


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
    canvas.disc((30.0, 40.0), radius=10.0, colour=BLACK)
    ink = (255 - pixels(canvas.png())[:, :, 0].astype(float)).sum() / 255
    assert ink == pytest.approx(np.pi * 10.0**2, rel=0.01)
    canvas = Canvas(100, 80)
    canvas.path((20.0, 20.0), (70.0, 55.0), width=4.0, colour=BLACK)
    ink = (255 - pixels(canvas.png())[:, :, 0].astype(float)).sum() / 255
    assert ink == pytest.approx(4.0 * np.hypot(50.0, 35.0) + np.pi * 2.0**2, rel=0.02)


def test_a_picture_of_very_many_colours_is_rounded_to_a_palette():
    canvas = Canvas(100, 90)
    drawn = np.random.default_rng(0).random((90, 3))
    for row, colour in enumerate(drawn):
        for column in range(0, 100, 10):
            shade = (colour * (1.0 - column / 100)).tolist()
            ends = (column + 2.0, row + 0.5), (column + 8.0, row + 0.5)
            canvas.path(*ends, width=1.0, colour=tuple(shade))
    seen = pixels(canvas.png())[:, ::10]
    assert len(np.unique(seen.reshape(-1, 3), axis=0)) <= 256
    seen = pixels(canvas.png())[:, 5::10] / 255
    wanted = drawn[:, None] * (1.0 - np.arange(0.0, 1.0, 0.1))[:, None]
    # 51 of 255 to 85 of 255 lie between neighbouring shades; half of it is the error.
    assert np.abs(seen - wanted).max() <= 0.5 * 85 / 255 + 1e-9
    canvas.disc((50.0, 45.0), radius=10.0, colour=(0.4, 0.5, 0.6))
    assert pixels(canvas.png())[45, 50].tolist() == [102, 128, 153]  # what is large stays exact


def test_what_lies_beside_the_canvas_is_left_out():
    canvas = Canvas(20, 20)
    canvas.path((-50.0, -50.0), (-10.0, 100.0), width=3.0, colour=BLACK)
    canvas.ring((500.0, 5.0), radius=10.0, width=2.0, colour=BLACK)
    assert (pixels(canvas.png()) == 255).all()


def test_points_are_drawn_where_they_are():
    # O, A, B at 0, 1 and 2 m on a level line: they share the width less its margins.
    seen = pixels(picture(drawing(solver.load(SCENES / "double_pendulum.toml"))))
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
    assert (pixels(picture(drawing(solver.loads(text)))) < 200).any()


def test_the_archive_has_picture_and_page_with_how_exact_a_run_was():
    with zipfile.ZipFile(scene_fmu("four_bar")) as archive:
        assert pixels(archive.read("model.png")).shape == (HEIGHT, WIDTH, 3)
        page = archive.read("documentation/index.html").decode()
    seen = self_check(solver.assemble(solver.load(SCENES / "four_bar.toml")))
    assert seen.energy < 1e-12
    assert f"{seen.energy:.1e}" in page
    assert f"{seen.position_error:.1e} m" in page
    assert 'src="../model.png"' in page


def test_a_picture_of_many_parts_shows_some_from_end_to_end_and_the_page_says_so(tmp_path):
    """Of a line of 1000 links at most 200 are drawn; the last point is at the right margin."""
    points = "\n".join(f"P{i} = {{ position = [{i}, 0], mass = 1 }}" for i in range(1, 1001))
    rods = "\n".join(
        f'r{i} = {{ type = "distance", points = ["P{i - 1}", "P{i}"] }}' for i in range(1, 1001)
    )
    text = f"""
    name = "line"
    dimension = 2
    gravity = [0, -9.81]
    [points]
    P0 = {{ position = [0, 0], fixed = true }}
    {points}
    [joints]
    {rods}
    """
    path = build(solver.loads(text), tmp_path / "line.fmu", native=True)
    with zipfile.ZipFile(path) as archive:
        page = archive.read("documentation/index.html").decode()
        seen = pixels(archive.read("model.png"))
    assert "The picture shows some of its many parts" in page
    assert "too large for a second, finer run" in page
    line = seen[HEIGHT // 2 - 4 : HEIGHT // 2 + 4].min(axis=(0, 2))
    drawn = np.flatnonzero(line < 100)
    assert abs(drawn[0] - MARGIN) < 8
    assert abs(drawn[-1] - (WIDTH - MARGIN)) < 8
    assert np.diff(drawn).max() < 8  # no gap that one sees


PLACES = {2: "model.png", 3: "terminalsAndIcons/icon.png"}
"""Of the picture, by FMI 2.0.5, 2.3, and FMI 3.0.1, 2.5.1."""
TOP = {
    2: {"binaries", "documentation", "model.png", "modelDescription.xml", "resources"},
    3: {"binaries", "documentation", "modelDescription.xml", "resources", "terminalsAndIcons"},
}
"""What stands at the top of an archive without sources; both versions know it by these names."""


@pytest.mark.parametrize("fmi", PLACES)
def test_the_picture_is_where_the_version_of_the_standard_has_it(fmi, tmp_path):
    path = build(SCENES / "four_bar.toml", tmp_path / "a.fmu", native=True, fmi=fmi)
    with zipfile.ZipFile(path) as archive, zipfile.ZipFile(scene_fmu("four_bar")) as python:
        assert archive.read(PLACES[fmi]) == python.read("model.png")
        assert [name for name in archive.namelist() if name.endswith(".png")] == [PLACES[fmi]]
        assert {name.partition("/")[0] for name in archive.namelist()} == TOP[fmi]
        page = archive.read("documentation/index.html").decode()
    assert f'src="../{PLACES[fmi]}"' in page
    assert page.count(".png") == 1
    assert validate_fmu(str(path)) == []


SLIDE = """
name = "slide"
dimension = 2
[bodies]
box = {{ position = [1, 1], mass = 1.0, inertia = 1.0 }}
[joints]
guide = {{ type = "{type}", bodies = ["ground", "box"], position = [1, 1]{axis} }}
"""


def drawn_beside_the_middle(text: str) -> tuple[bool, bool]:
    """Whether there is ink 20 pixels left or right of the middle, and as far above it."""
    dark = pixels(picture(drawing(solver.loads(text)))).max(axis=2) < 100
    y, x = HEIGHT // 2, WIDTH // 2
    beside = dark[y - 10 : y + 10, [x - 20, x + 20]].any()
    return bool(beside), bool(dark[y - 20, x - 10 : x + 10].any())


@pytest.mark.parametrize(
    ("axis", "beside", "above"), [([3, 0], True, False), ([0, 0.1], False, True)]
)
def test_a_prismatic_joint_is_drawn_as_a_rail_along_its_axis(axis, beside, above):
    text = SLIDE.format(type="prismatic", axis=f", axis = {axis}")
    assert drawn_beside_the_middle(text) == (beside, above)


def test_a_hinge_has_no_rail():
    assert drawn_beside_the_middle(SLIDE.format(type="revolute", axis="")) == (False, False)


@pytest.mark.parametrize("kind", ["prismatic", "cylindrical"])
def test_a_rail_towards_the_eye_is_a_point(kind):
    level = math.cos(ELEVATION)
    eye = [level * math.cos(AZIMUTH), level * math.sin(AZIMUTH), math.sin(ELEVATION)]
    text = SLIDE.format(type=kind, axis=f", axis = {eye}").replace("dimension = 2", "")
    text = text.replace("[1, 1]", "[1, 1, 1]").replace("inertia = 1.0", "inertia = [1, 1, 1]")
    assert drawn_beside_the_middle(text) == (False, False)


TOUCHING = """
name = "touching"
dimension = 2
[bodies]
box = { position = [1, 1], mass = 1.0, inertia = 1.0 }
[contacts]
floor = { type = "%s", axis = [0, 1], %s }
"""


@pytest.mark.parametrize(
    ("contact", "ratio"),
    [
        (("corners", 'body = "box", size = [4, 1]'), 4.0),
        (("corners", 'body = "box", corners = [[-1, -1], [1, -1], [0, 0]]'), 2.0),
        (("plane", 'point = "box", radius = 1.0'), 1.0),
    ],
)
def test_what_touches_is_drawn_in_its_proportions(contact, ratio):
    seen = pixels(picture(drawing(solver.loads(TOUCHING % contact)))).astype(int)
    ink = seen[:, :, 2] - seen[:, :, 0] > 40  # the body is blue
    width, height = np.ptp(np.flatnonzero(ink.any(0))), np.ptp(np.flatnonzero(ink.any(1)))
    assert width / height == pytest.approx(ratio, rel=0.05)


RANGED = """
name = "ranged"
dimension = 2
[parameters]
whole = { value = 20, unit = "1" }
[inputs]
low = { unit = "N", min = 0.01, start = 1 }
high = { unit = "N", max = 3 }
both = { unit = "N", min = -1, max = 3 }
[points]
A = { position = [0, 0], mass = "1 + 0*whole" }
[forces]
push = { type = "force", point = "A", value = ["low + high", "both"] }
"""


def test_the_page_has_the_mechanism_first_ranges_in_words_and_whole_numbers_without_a_point():
    model = solver.assemble(solver.loads(RANGED))
    text = page(model, self_check(model))
    places = [
        text.index(f"<h2>{title}") for title in ("Inputs", "Parameters", "Outputs", "Settings")
    ]
    assert places == sorted(places)
    assert text.index("<code>whole") < places[2]
    assert text.index("<code>solver.max_newton") > places[3]
    for cell in ("at least 0.01", "at most 3", "-1 to 3", "1 to 1000"):
        assert f'<td class="number">{cell}</td>' in text
    assert 'class="number">20</td>' in text
    assert ".0</td>" not in text


def test_page_and_dependencies_name_libpython_and_the_platform_of_the_kernel():
    model = solver.assemble(solver.loads(RANGED))
    files = documentation(model, self_check(model))
    needs = files["documentation/externalDependencies.txt"].decode().strip()
    assert "libpython" in needs
    assert sysconfig.get_platform() in needs
    assert needs in files["documentation/index.html"].decode()


def test_a_floor_below_what_falls_is_in_the_picture():
    text = 'name = "falling"\n[points]\nball = { position = [0, 0, 1], mass = 1 }\n'
    text += '[contacts]\nfloor = { type = "plane", point = "ball", axis = [0, 0, 1] }\n'
    for height in ("1", "0.001", "1000"):
        seen = pixels(picture(drawing(solver.loads(text.replace("1]", f"{height}]", 1)))))
        ball = np.flatnonzero((seen.max(axis=2) < 60).any(axis=1))
        pale = np.flatnonzero((seen.min(axis=2) == 237).any(axis=1))  # of the floor
        assert ball.max() < pale.mean() < HEIGHT
