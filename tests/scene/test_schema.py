"""The JSON Schema of scenes."""

import dataclasses
import json
from pathlib import Path

from solver.scene import Scene, json_schema

ROOT = Path(__file__).parents[2]


def test_the_published_schema_is_current():
    """To renew it: python -m build_fmu schema -o docs/scene.schema.json."""
    published = (ROOT / "docs" / "scene.schema.json").read_text(encoding="utf-8")
    assert json.loads(published) == json_schema()


def test_the_schema_lists_every_table_and_field():
    schema = json_schema()
    fields = {field.name for field in dataclasses.fields(Scene)}
    assert set(schema["properties"]) == fields - {"source", "warnings", "fits_velocities"}
    assert "stiffness" in schema["$defs"]["Spring"]["properties"]
    assert "null" not in json.dumps(schema)
