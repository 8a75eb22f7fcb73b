"""The files in `scenes/`, and which of them touch or rub.

What holds for any formulation, order or tolerance, or needs smooth motion, is tested on `SMOOTH`.
Scenes with contacts or friction of joints have tests of their own, tests/physics/
test_contact_scenes.py; all that reads, builds or runs a scene as it is takes `ALL`.
"""

from __future__ import annotations

import sys
from pathlib import Path

if sys.version_info >= (3, 11):
    import tomllib
else:
    import tomli as tomllib

SCENES = Path(__file__).resolve().parents[3] / "scenes"
ALL = sorted(SCENES.glob("*.toml"))


def touches(text: str) -> bool:
    """Whether a scene has contacts, or friction or backlash in a joint."""
    scene = tomllib.loads(text)
    joints = scene.get("joints", {}).values()
    return bool(scene.get("contacts")) or any(
        "friction" in joint or "backlash" in joint for joint in joints
    )


TOUCHING = [path for path in ALL if touches(path.read_text(encoding="utf-8"))]
SMOOTH = [path for path in ALL if path not in TOUCHING]
