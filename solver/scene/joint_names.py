"""References to joints: which of them have an angle, which a displacement."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from solver.scene.fields import BROKEN
from solver.scene.geometry import Geometry
from solver.scene.quantities import SHARED_POINT, WITH_ANGLE, WITH_DISPLACEMENT
from solver.scene.report import Path
from solver.scene.schema import ONLY_IN_SPACE
from solver.scene.words import a, did_you_mean


class JointNames:
    """Judge of references to joints."""

    def __init__(self, geometry: Geometry, types: Mapping[str, str]) -> None:
        self.geometry = geometry
        self.draft = geometry.draft
        self.types = types
        """Type of each joint in the file, "" where it is unknown."""

    def with_angle(self, path: Path, name: Any) -> bool:
        """Report a name that is no joint with an angle."""
        return self._has(path, name, WITH_ANGLE, "angle")

    def with_displacement(self, path: Path, name: Any) -> bool:
        """Report a name that is no joint with a displacement."""
        return self._has(path, name, WITH_DISPLACEMENT, "displacement")

    def _has(self, path: Path, name: Any, kinds: tuple[str, ...], what: str) -> bool:
        if name is BROKEN:
            return False
        kind, part = self.types.get(name, ""), self.geometry.known.parts.get(name)
        if part == "joint":
            if kind in kinds or kind == "":  # a joint of unknown type is reported already
                return kind != ""
            self.draft.error(path, *self._without(name, kind, kinds, what))
            return False
        known = [joint for joint, kind in self.types.items() if kind in kinds]
        help = did_you_mean(name, known, f"joints with {a(what)}")
        message = f"'{name}' is {a(part)}, not a joint" if part else f"unknown joint '{name}'"
        self.draft.error(path, message, help)
        return False

    def _without(
        self, name: str, kind: str, kinds: tuple[str, ...], what: str
    ) -> tuple[str, str | None]:
        """Words for a joint that has no angle, or no displacement."""
        if kind == SHARED_POINT and what == "angle":
            help = "give it 'bodies' and 'position' instead of 'points'"
            return f"'{name}' joins points, and has no angle", help
        planar = self.geometry.dimension == 2
        possible = [word for word in kinds if not (planar and word in ONLY_IN_SPACE)]
        help = f"types of joints with {a(what)}: {', '.join(possible)}"
        return f"'{name}' is a {kind.replace('_', ' ')} joint, which has no {what}", help
