"""The scene format: every table, type and field, from the JSON Schema that the parts declare."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

from solver.scene import json_schema

HEAD = """# Scene format

Every table, type and field of a scene, written from the same declarations that check it. How to
use them, with examples, is in [how to write a scene](../scene.md); the same as JSON Schema for
editors is [scene.schema.json](../scene.schema.json).

*Number* means a number or an expression as text; *vector* one number for each dimension.
"""

Schema = dict[str, Any]


def write(folder: Path) -> None:
    """Write scene_format.md into a folder."""
    schema = json_schema()
    plain = {name: x for name, x in schema["properties"].items() if not _types(x)}
    parts = [HEAD, "## The file itself\n", _fields({**schema, "properties": plain})]
    for table, field in schema["properties"].items():
        names = _types(field)
        if names:
            parts.append(f"## `[{table}]`\n")
        for name in names:
            parts += _part(schema["$defs"][name])
    folder.mkdir(parents=True, exist_ok=True)
    (folder / "scene_format.md").write_text("\n".join(parts), encoding="utf-8")


def _types(field: Schema) -> list[str]:
    """Names of the definitions that a table's entries may have."""
    if "$ref" in field:
        return [field["$ref"].rpartition("/")[2]]
    entries = field.get("additionalProperties", {})
    choices = entries.get("anyOf", [entries]) if isinstance(entries, dict) else []
    return [x["$ref"].rpartition("/")[2] for x in choices if "$ref" in x]


def _part(part: Schema) -> list[str]:
    kind = part["properties"].get("type", {}).get("const")
    heading = [f"### `{kind}`\n"] if kind else []
    return [*heading, f"{part.get('description', '')}\n", _fields(part)]


def _fields(part: Schema) -> str:
    rows = ["| field | value | meaning | default |", "|---|---|---|---|"]
    needed = part.get("required", [])
    for name, field in part["properties"].items():
        if name == "type":
            continue
        default = "required" if name in needed else _default(field)
        rows.append(f"| `{name}` | {_value(field)} | {_meaning(field)} | {default} |")
    return "\n".join(rows) + "\n" if len(rows) > 2 else "It has no fields.\n"


def _default(field: Schema) -> str:
    value = field.get("default")
    if value is None or value in ("", {}, []):
        return ""
    return f"`{value:g}`" if isinstance(value, float) else f"`{json.dumps(value)}`"


def _meaning(field: Schema) -> str:
    text = field.get("description", "").replace("a number, or an expression as text", "")
    text = text.replace("|", "\\|").replace("[", "\\[")
    examples = ", ".join(f"`{json.dumps(x)}`" for x in field.get("examples", []))
    return f"{text}{'; ' if text and examples else ''}{f'such as {examples}' if examples else ''}"


def _value(field: Schema) -> str:
    """What one writes, in words."""
    if "oneOf" in field or "anyOf" in field:
        return " or ".join(dict.fromkeys(_value(x) for x in field.get("oneOf") or field["anyOf"]))
    if "enum" in field:
        return ", ".join(f"`{json.dumps(x)}`" for x in field["enum"])
    if "const" in field:
        return f"`{json.dumps(field['const'])}`"
    kind = field.get("type", "")
    if kind == "array":
        item = _value(field.get("items", {}))
        if item == "number" and "maxItems" in field:
            return "vector"
        return f"list of {item}s" if item else "list"
    words = {
        "boolean": "true or false",
        "integer": "whole number",
        "string": "text",
        "object": "table",
    }
    return "number" if "number" in kind else words.get(kind, "")
