"""Quantities that the reader of a scene knows, by its file alone."""

from __future__ import annotations

import sys

from solver.scene.draft import Draft
from solver.scene.mistakes import Source
from solver.scene.names import offered
from solver.scene.quantities import quantities
from tests.support.mechanisms.scene_files import touches

if sys.version_info >= (3, 11):
    import tomllib
else:
    import tomli as tomllib


def quantities_of(text):
    """Names of all quantities of a scene in TOML, each with its level."""
    data = tomllib.loads(text)
    return quantities(offered(Draft(data, Source(), [])), data.get("dimension", 3), touches(text))
