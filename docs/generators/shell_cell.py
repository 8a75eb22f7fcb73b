"""The cell %%bash of the site's pages: output in one piece, without colours; a failure raises.

IPython's own hands on what arrives bit by bit, which Sphinx then breaks into lines.
"""

import os
import subprocess

from IPython.core.magic import register_cell_magic  # pyright: ignore[reportMissingImports]


@register_cell_magic
def bash(line, cell):  # noqa: ARG001
    """Run a cell in bash."""
    plain = {name: x for name, x in os.environ.items() if name not in ("FORCE_COLOR", "CLICOLOR")}
    plain |= {"NO_COLOR": "1", "TERM": "dumb", "COLUMNS": "96"}
    done = subprocess.run(
        ["bash", "-ec", cell], env=plain, text=True,
        stdout=subprocess.PIPE, stderr=subprocess.STDOUT, check=False,
    )  # fmt: skip
    print(done.stdout, end="")  # noqa: T201
    done.check_returncode()
