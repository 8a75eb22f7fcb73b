"""A picture of a drawing at the start: solids, rods, springs, dampers, joints, names, a scale.

Everything is drawn layer by layer, in a layer what is far away first, in parallel projection.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Sequence
from typing import Any

import numpy as np

from viewer.canvas import DARK, PAPER, Array, Canvas, Colour, Pixel
from viewer.faces import faces_of, rotation
from viewer.letters import ADVANCE, write
from viewer.places import some

WIDTH, HEIGHT, MARGIN = 480, 360, 40
STEEL: Colour = (0.35, 0.40, 0.47)
PALE: Colour = (0.86, 0.88, 0.90)
FLOOR: Colour = (0.93, 0.94, 0.95)
SPRING, DAMPER, DRIVER = (0.10, 0.50, 0.35), (0.62, 0.42, 0.10), (0.80, 0.16, 0.16)
BODIES: tuple[Colour, ...] = (
    (0.16, 0.42, 0.70), (0.85, 0.45, 0.12), (0.35, 0.58, 0.24), (0.58, 0.33, 0.62),
    (0.20, 0.60, 0.63), (0.75, 0.30, 0.36),
)  # fmt: skip
HEMP: Colour = (0.55, 0.47, 0.35)
LIGHT = np.array((0.35, 0.55, 0.76))
"""Direction towards the light, to the right, up and to the eye."""
SHADES = 6
"""Of a colour: few, so that the file is small."""
ALOOF = np.array(((0.87, 0.5), (-0.5, 0.87)))
"""Turn of a plane against the view, so that it looks like one."""
MOST_NAMES = 16
MOST = {"solids": 200, "links": 200, "joints": 100}
"""Parts of a kind that are drawn: more cannot be told apart."""
SURFACES, SOLIDS, RODS, FORCES, JOINTS, DRIVEN, NAMES = range(7)
"""Layers."""


def picture(drawing: dict[str, Any]) -> bytes:
    """PNG file of a drawing (``viewer.drawing``)."""
    return next(canvases([drawing], names=True)).png()


def is_thinned(drawing: dict[str, Any]) -> bool:
    """Whether a picture shows some parts of a drawing alone."""
    return any(len(drawing[kind]) > most for kind, most in MOST.items())


def canvases(drawings: Sequence[dict[str, Any]], *, names: bool = False) -> Iterator[Canvas]:
    """Draw states of one mechanism, all at one scale."""
    with np.errstate(all="ignore"):
        pictures = [_Picture(drawing) for drawing in drawings]
        seen = np.concatenate([each.collected() for each in pictures])
    for each in pictures:
        with np.errstate(all="ignore"):
            canvas = each.canvas(seen.min(axis=0), seen.max(axis=0), names=names)
        yield canvas


def _mixed(first: Colour, second: Colour, share: float) -> Colour:
    """Return a colour with a share of another one."""
    r, g, b = (x + share * (y - x) for x, y in zip(first, second, strict=True))
    return r, g, b


class _Picture:
    """Places of a drawing, then strokes on a canvas."""

    def __init__(self, drawing: dict[str, Any]) -> None:
        self.drawing, self.flat = drawing, drawing["dimension"] == 2
        self._seen: list[Array] = []
        """Places that the picture must hold."""
        self._strokes: list[tuple[int, float, Callable[[Canvas], None]]] = []
        """Layer, distance towards the eye, and what draws it."""
        self._poses = [self._pose(frame) for frame in drawing["frames"]]
        towards = np.array(drawing["view"]["direction"], float)
        up = np.array(drawing["up"], float)
        right = np.cross(up, towards)
        if np.linalg.norm(right) < 1e-6:  # from above
            right = np.cross(np.roll(up, 1), towards)
        right = right / np.linalg.norm(right)
        self._view = np.array((right, np.cross(towards, right), towards))
        """Directions to the right, up and towards the eye."""

    def _pose(self, frame: dict[str, Any]) -> tuple[Array, Array]:
        """Origin and rotation of a frame at the start."""
        start, n = frame["start"], self.drawing["dimension"]
        origin = np.array([*start[:n], *[0.0] * (3 - min(n, len(start)))], float)
        if len(start) == 7:
            return origin, rotation(start[3:])
        if frame["kind"] == "body":
            c, s = math.cos(start[2]), math.sin(start[2])
            return origin, np.array(((c, -s, 0.0), (s, c, 0.0), (0.0, 0.0, 1.0)))
        return origin, np.eye(3)

    def _at(self, place: dict[str, Any]) -> Array:
        origin, turn = self._poses[place["frame"]]
        return origin + turn @ np.array(place["at"], float)

    # ----------------------------------------------------------------------------- strokes

    def _stroke(
        self, layer: int, places: Sequence[Array], shape: Callable[..., None], seen: bool = True,
        **style: Any,
    ) -> None:  # fmt: skip
        """Draw a shape of the canvas later: layer by layer, what is far away first."""
        if seen:
            self._seen.extend(places)
        depth = float(np.mean([place @ self._view[2] for place in places]))

        def draw(canvas: Canvas) -> None:
            shape(canvas, *map(self._pixel, places), **style)

        self._strokes.append((layer, depth, draw))

    def _pixel(self, place: Array) -> Pixel:
        x, y = (self._scale * (self._view[:2] @ place - self._middle)).tolist()
        return 0.5 * WIDTH + x, 0.5 * HEIGHT - y

    def collected(self) -> Array:
        """Collect all strokes but those of planes; places to be seen, along the view."""
        solids, links, joints = (some(self.drawing[kind], most) for kind, most in MOST.items())
        for solid in solids:
            if solid["shape"] != "plane":
                self._solid(solid)
        for link in links:
            self._link(link)
        for joint in joints:
            self._joint(joint)
        seen = np.array(self._seen or [np.zeros(3)])
        size, middle = float(np.linalg.norm(np.ptp(seen, axis=0))), seen.mean(axis=0)
        for solid in self.drawing["solids"]:  # a floor that is not far is seen
            if solid["shape"] == "plane":
                foot = self._foot(solid, middle)
                if not 0.0 < 1.5 * size < np.linalg.norm(foot - middle):
                    seen = np.vstack((seen, foot))
        return seen @ self._view.T

    def canvas(self, least: Array, most: Array, *, names: bool) -> Canvas:
        """Draw all strokes at the scale by which a space, along the view, is seen."""
        self._middle = 0.5 * (least + most)[:2]
        rooms = zip((WIDTH - 2 * MARGIN, HEIGHT - 2 * MARGIN), (most - least)[:2], strict=True)
        self._scale = min((room / span for room, span in rooms if span > 0.0), default=1.0)
        for solid in self.drawing["solids"]:
            if solid["shape"] == "plane":
                self._plane(solid, self._view.T @ (0.5 * (least + most)))
        canvas = Canvas(WIDTH, HEIGHT)
        for _, _, draw in sorted(self._strokes, key=lambda stroke: stroke[:2]):
            draw(canvas)
        if names:
            self._names(canvas)
        if (most - least)[:2].any():
            self._scale_bar(canvas)
        return canvas

    # ----------------------------------------------------------------------------- parts

    def _colour(self, solid: dict[str, Any]) -> Colour:
        colour = solid.get("colour", -1)
        if isinstance(colour, str):
            red, green, blue = (int(colour[k : k + 2], 16) / 255 for k in (1, 3, 5))
            return red, green, blue
        return BODIES[colour % len(BODIES)] if colour >= 0 else STEEL

    def _solid(self, solid: dict[str, Any]) -> None:
        frame, turn = self._poses[solid["frame"]], rotation(solid["turn"])
        colour, at, opacity = self._colour(solid), self._at(solid), solid["opacity"]
        layer = SURFACES if solid["kind"] == "surface" else SOLIDS
        axes = frame[1] @ turn

        def placed(points: Any) -> list[Array]:
            return [*(at + np.array(points, float).reshape(-1, 3) @ axes.T)]

        shape = solid["shape"]
        if shape == "sphere":
            self._ball(at, solid["radius"], colour, opacity)
        elif shape == "capsule":
            for end in placed([solid["from"], solid["to"]]):
                self._ball(end, solid["radius"], colour, opacity, draw=False)
            self._thick(SOLIDS, placed([solid["from"], solid["to"]]), solid["radius"], colour)
        elif shape == "struts":
            for end in solid["to"]:
                place = self._at({"frame": solid["frame"], "at": end})
                self._stroke(SOLIDS, (at, place), Canvas.path, width=6.0, colour=colour)
            self._stroke(SOLIDS, (at,), Canvas.disc, radius=5.0, colour=colour)
        elif shape == "curve":
            style = {"width": 2.0, "colour": STEEL}
            points = placed(solid["points"])
            middle, reach = self._poses[-1][0], self.drawing["size"]
            if float(np.ptp(points, axis=0).max()) > 3.0 * reach:  # a road
                self._seen += [x for x in points if np.linalg.norm(x - middle) < reach]
            else:
                self._seen += points
            self._stroke(SURFACES, points, Canvas.path, False, **style)
        for face in faces_of(solid):
            sharp = opacity == 1.0 and (shape in ("box", "prism") or len(face) > 4)
            outline = _mixed(colour, DARK, 0.6) if sharp else None
            if shape == "heights":
                outline = _mixed(colour, PAPER, 0.4)
            style: dict[str, Any] = {"opacity": opacity, "outline": outline}
            self._face(layer, np.array(placed(face)), colour, shape == "heights", **style)

    def _face(self, layer: int, corners: Array, colour: Colour, both: bool, **style: Any) -> None:
        """Draw a face that looks towards the eye, brighter where it looks towards the light."""
        after = np.roll(corners, -1, axis=0)
        normal = self._view @ np.cross(corners - corners[0], after - corners[0]).sum(axis=0)
        length = float(np.linalg.norm(normal))
        self._seen.extend(corners)
        if length == 0.0 or (normal[2] <= 1e-9 * length and not both):
            return
        towards = abs(float(normal @ LIGHT)) if both else float(normal @ LIGHT)
        bright = round(SHADES * max(0.0, towards) / length) / SHADES
        shade = _mixed(_mixed(colour, DARK, 0.5 - 0.5 * bright), PAPER, 0.1 + 0.25 * bright)
        self._stroke(layer, [*corners], Canvas.face, False, colour=shade, **style)

    def _ball(
        self, at: Array, radius: float, colour: Colour, opacity: float, draw: bool = True
    ) -> None:
        """Draw a ball with a gleam."""
        right, up, _ = self._view
        for x in (right, up):
            self._seen += [at + radius * x, at - radius * x]

        def shape(canvas: Canvas) -> None:
            x, y = self._pixel(at)
            size = radius * self._scale
            canvas.disc((x, y), radius=size, colour=_mixed(colour, DARK, 0.45), opacity=opacity)
            for share, light in ((0.0, 0.0), (0.25, 0.15), (0.45, 0.3)):
                shade = _mixed(colour, PAPER, light)
                size_of = max(0.0, (size - 1.0) * (1.0 - 1.6 * share))
                centre = (x - 0.6 * share * size, y - 0.6 * share * size)
                canvas.disc(centre, radius=size_of, colour=shade, opacity=opacity)

        if draw:
            self._strokes.append((SOLIDS, float(at @ self._view[2]), shape))

    def _thick(self, layer: int, places: list[Array], radius: float, colour: Colour) -> None:
        """Draw a line of a width that is a length of the mechanism."""

        def shape(canvas: Canvas, *pixels: Pixel) -> None:
            canvas.path(*pixels, width=max(2.0, 2.0 * radius * self._scale), colour=colour)

        self._stroke(layer, places, shape)

    def _normal(self, solid: dict[str, Any]) -> Array:
        return self._poses[solid["frame"]][1] @ np.array(solid["normal"], float)

    def _foot(self, solid: dict[str, Any], place: Array) -> Array:
        """Place on a plane that is next to another place."""
        normal = self._normal(solid)
        return place - ((place - self._at(solid)) @ normal) * normal

    def _plane(self, solid: dict[str, Any], middle: Array) -> None:
        """Draw a plane as far as the picture goes: seen from the side, a line and what is below."""
        normal, foot = self._normal(solid), self._foot(solid, middle)
        reach = 2.0 * (WIDTH + HEIGHT) / self._scale if self.flat else 0.45 * WIDTH / self._scale
        along = np.cross(self._view[2], normal)
        if np.linalg.norm(along) < 1e-6:
            along = self._view[0]
        along = along / np.linalg.norm(along) * reach
        across = np.cross(normal, along)
        if abs(normal @ self._view[2]) < 0.05:
            below = foot - 5.0 / self._scale * normal
            ends = [below - along, below + along]
            self._stroke(SURFACES, ends, Canvas.path, False, width=9.0, colour=PALE)
            ends = [foot - along, foot + along]
            self._stroke(SURFACES, ends, Canvas.path, False, width=1.6, colour=DARK)
            return
        along, across = ALOOF @ np.array((along, across))
        corners = [foot + a * along + b * across for a, b in ((1, 1), (-1, 1), (-1, -1), (1, -1))]
        style = {"colour": FLOOR, "opacity": 1.0, "outline": PALE}
        far = -1e9 if normal @ self._view[2] > 0.0 else 0.0
        self._stroke(SURFACES, corners, Canvas.face, False, **style)
        layer, _, draw = self._strokes.pop()
        self._strokes.append((layer, far, draw))

    def _link(self, link: dict[str, Any]) -> None:
        a, b = (self._at(end) for end in link["ends"])
        kind = link["kind"]
        for end in link["ends"] if kind != "rail" else ():
            if end["frame"] == 0:
                self._pin(self._at(end), ground=True, axis=None, turns=True)
        if kind == "bar":
            style = {"width": 6.0, "colour": self._colour(link)}
            self._stroke(SOLIDS, (a, b), Canvas.path, **style)
        elif kind == "spring":
            self._stroke(FORCES, (a, b), Canvas.coil, width=1.6, colour=SPRING)
        elif kind == "damper":
            self._stroke(FORCES, (a, b), Canvas.path, width=1.4, colour=DAMPER)
            cylinder = a + 0.38 * (b - a), a + 0.62 * (b - a)
            self._stroke(FORCES, cylinder, Canvas.path, width=6.0, colour=DAMPER)
        elif kind == "rail":
            along = self._poses[link["ends"][0]["frame"]][1] @ np.array(link["axis"], float)
            self._pin(b, ground=False, axis=along, turns=False, rail=True)
        else:
            colour = {"actuator": DRIVER, "rope": HEMP}.get(kind, STEEL)
            width = 1.2 if kind == "rope" else 2.5
            self._stroke(RODS, (a, b), Canvas.path, width=width, colour=colour)

    def _joint(self, joint: dict[str, Any]) -> None:
        place, kind = self._at(joint["place"]), joint["kind"]
        if kind == "point":
            radius = 3.0 + 4.0 * joint["share"]
            self._stroke(JOINTS, (place,), Canvas.disc, radius=radius, colour=DARK)
        elif kind == "driven":
            style = {"radius": 7.5, "width": 1.8, "colour": DRIVER}
            self._stroke(DRIVEN, (place,), Canvas.ring, **style)
        elif kind != "rolling":
            axis = None
            if joint["axis"] is not None and kind in ("prismatic", "cylindrical", "screw"):
                axis = self._poses[joint["place"]["frame"]][1] @ np.array(joint["axis"], float)
            self._pin(place, ground=joint["ground"], axis=axis, turns=kind != "prismatic")

    def _pin(
        self, place: Array, *, ground: bool, axis: Array | None, turns: bool,
        rail: bool = False,
    ) -> None:  # fmt: skip
        """Draw a joint, with the direction in the picture of an axis that does not point at it."""
        direction = None
        if axis is not None:
            x, y, _z = (self._view @ axis).tolist()
            length = math.hypot(x, y)
            if length > 1e-6:
                direction = (x / length, -y / length)
        if rail and direction is None:
            return
        style = {"ground": ground, "direction": direction, "turns": turns}
        self._stroke(JOINTS, (place,), Canvas.joint, **style)

    # ----------------------------------------------------------------------------- names

    def _names(self, canvas: Canvas) -> None:
        """Write names of points and bodies beside them, where there is room."""
        taken: list[tuple[float, float, float]] = []
        places = [
            (frame["name"], origin)
            for frame, (origin, _) in zip(self.drawing["frames"], self._poses, strict=True)
        ][1:]
        fixed = [x for x in self.drawing["joints"] if x["kind"] == "fixed"]
        for name, place in [*places, *((x["name"], self._at(x["place"])) for x in fixed)]:
            if len(taken) == MOST_NAMES:
                break
            x, y = self._pixel(place)
            x, y, width = x + 8.0, y - 7.0, ADVANCE * len(name)
            free = all(abs(y - v) > 11.0 or x > u + w or x + width < u for u, v, w in taken)
            if free and 2.0 < x < WIDTH - width and 10.0 < y < HEIGHT:
                taken.append((x, y, width))
                write(canvas, name, (x, y), STEEL)

    def _scale_bar(self, canvas: Canvas) -> None:
        """Draw a length of 1, 2 or 5 times a power of ten, of a fifth of the width at most."""
        most = 0.2 * WIDTH / self._scale
        power = 10.0 ** math.floor(math.log10(most))
        length = max(x * power for x in (1.0, 2.0, 5.0) if x * power <= most)
        left, low, right = 12.0, HEIGHT - 12.0, 12.0 + length * self._scale
        canvas.path((left, low - 3.0), (left, low), (right, low), (right, low - 3.0),
                    width=1.2, colour=STEEL)  # fmt: skip
        write(canvas, f"{length:g} m", (left + 4.0, low - 4.0), STEEL)
