"""Write the table of docs/importers.md: `python -m tests.importers.page`, after the tests passed.

The row of a tool that $IMPORTERS does not name stays as it is; the date is that of the first run in
which a version passed, so a run that finds nothing new changes nothing.
"""

from __future__ import annotations

import datetime
import re
import sys

from tests.importers.tools import REQUIRED, ROOT, TOOLS, Tool, version

PAGE = ROOT / "docs" / "importers.md"
HEAD = (
    "| tool | version | our FMUs | what is run | result | remarks | since |\n"
    "|---|---|---|---|---|---|---|\n"
)
ROW = re.compile(r"^\| (?P<name>\S+) \| (?P<version>\S+) \| .* \| (?P<date>[\d-]+) \|$", re.M)


def rows(page: str) -> dict[str, re.Match[str]]:
    """Rows of the page's table by tool."""
    return {row["name"]: row for row in ROW.finditer(page)}


def row_text(tool: Tool, number: str, date: str) -> str:
    """One row of the table."""
    cells = (tool.name, number, tool.fmus, tool.ran, "passed", tool.remark, date)
    return f"| {' | '.join(cells)} |"


def renewed(tool: Tool, old: re.Match[str] | None) -> str:
    """Row of a tool, as of today."""
    if tool.name not in REQUIRED:
        assert old, f"{tool.name} has never been run"
        return row_text(tool, old["version"], old["date"])
    number = version(tool)
    today = datetime.datetime.now(tz=datetime.timezone.utc).date().isoformat()
    return row_text(tool, number, old["date"] if old and old["version"] == number else today)


if __name__ == "__main__":
    text = PAGE.read_text(encoding="utf-8")
    before, _, after = text.partition(HEAD)
    rest = after.partition("\n\n")[2]
    known = rows(text)
    table = "\n".join(renewed(tool, known.get(tool.name)) for tool in TOOLS)
    written = f"{before}{HEAD}{table}\n\n{rest}"
    PAGE.write_text(written, encoding="utf-8")
    what = "as it was" if written == text else "new versions are in its table"
    sys.stdout.write(f"docs/importers.md: {what}\n")
