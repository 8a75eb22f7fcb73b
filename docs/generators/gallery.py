"""The gallery: a moving picture, the text and the report of each scene.

Groups and their order are those of the table in scenes/README.md.
"""

from __future__ import annotations

import re
from pathlib import Path

import holonom
from generators import moving  # pyright: ignore[reportMissingImports]
from viewer.drawing import drawing
from viewer.picture import picture
from viewer.report import ReportRun, write_report

SCENES = Path(__file__).resolve().parents[2] / "scenes"


def groups() -> dict[str, list[Path]]:
    """Files of the scenes of each group, as scenes/README.md has them."""
    table = (SCENES / "README.md").read_text(encoding="utf-8")
    rows = re.findall(r"^\| ([a-z][^|]*) \| (.*) \|$", table, re.MULTILINE)
    found = {
        name: [SCENES / f"{x}.toml" for x in re.findall(r"`(\w+)`", row)] for name, row in rows
    }
    kept = {name: [path for path in paths if path.is_file()] for name, paths in found.items()}
    return {name: paths for name, paths in kept.items() if paths}


def write(folder: Path) -> None:
    """Write gallery.md, and a page and a picture of each scene, into a folder."""
    pages, reports = folder / "scenes", folder / "reports"
    for path in (pages, reports):
        path.mkdir(parents=True, exist_ok=True)
    parts = [
        "# Gallery",
        "The scenes of the repository, in `scenes/`. Run one with `holonom simulate "
        "scenes/NAME.toml`, or build its FMU with `holonom build scenes/NAME.toml`.",
    ]
    _side_by_side(reports / "four_bar_formulations_report.html")
    shown: list[Path] = []
    for name, paths in groups().items():
        parts.append(f"## {name[0].upper()}{name[1:]}")
        cards = []
        for path in paths:
            scene = holonom.load(path)
            (reports / f"{path.stem}.png").write_bytes(picture(drawing(scene)))
            trajectory = holonom.simulate(path)
            trajectory.report(reports / f"{path.stem}_report.html")
            moving.write(reports / f"{path.stem}.gif", moving.states(trajectory))
            _write(pages / f"{path.stem}.md", _page(path, scene).encode())
            seen = f'<a href="scenes/{path.stem}.html">{_picture(path, "..")}</a>'
            link = f"[{title(path)}](scenes/{path.stem}.md)"
            cards.append(f"{seen}\n\n{link}\n\n{scene.description}.")
            shown.append(path)
        parts.append(
            ":::::{container} cards\n"
            + "".join(f":::{{container}} card\n{x}\n:::\n" for x in cards)
            + ":::::"
        )
    tree = "\n".join(f"scenes/{path.stem}" for path in shown)
    parts.append(f"```{{toctree}}\n:hidden:\n\n{tree}\n```\n")
    _write(folder / "gallery.md", "\n\n".join(parts).encode())


def _side_by_side(path: Path) -> None:
    """Write the page of two formulations, of which one gains energy without end."""
    scene, runs = holonom.load(SCENES / "four_bar.toml"), []
    model, drawn = holonom.assemble(scene), drawing(scene)
    for name in ("conserving-al", "midpoint-al"):
        run = holonom.simulate(model, formulation=name)
        columns, spent = dict(run.items()), run.wall_time
        runs.append(ReportRun(drawn, run.t, columns, label=name, wall_time=spent))
    known = {"name": model.name, "description": model.description, "variables": model.variables}
    write_report(path, runs, compare=True, **known)


def title(path: Path) -> str:
    """Name of a scene in words."""
    words = re.sub(r"^(newton|euler)s\b", r"\1's", path.stem.replace("_", " "))
    return words[0].upper() + words[1:]


def _picture(path: Path, top: str) -> str:
    """HTML of the moving picture, which stands still for readers who asked for that."""
    start = f'<source srcset="{top}/{path.stem}.png" media="(prefers-reduced-motion: reduce)">'
    size = f'width="480" height="360" loading="lazy" alt="{title(path)} in motion"'
    moves = f'<img src="{top}/{path.stem}.gif" {size}>'
    return f"<picture>{start}{moves}</picture>"


def _page(path: Path, scene: holonom.Scene) -> str:
    return f"""# {title(path)}

{scene.description}.

{_picture(path, "../..")}

<a href="../../{path.stem}_report.html">Its report</a> shows the run with plots, forces and numbers.

Run it with `holonom simulate scenes/{path.name} --report {path.stem}.html`, or live with
`holonom view scenes/{path.name}`.

```{{literalinclude}} ../../../scenes/{path.name}
:language: toml
:caption: scenes/{path.name}
```
"""


def _write(path: Path, content: bytes) -> None:
    """Leave a file that is as it should be alone, so that Sphinx does not read it again."""
    if not path.is_file() or path.read_bytes() != content:
        path.write_bytes(content)
