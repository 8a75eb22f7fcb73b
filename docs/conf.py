"""Settings of the documentation site, which `make docs` builds with Sphinx.

The pages are those that a code host shows, `docs/**/*.md`. Before they are read, `generators/`
writes the gallery, the scene format and the commands to `generated/`. Pages with code cells are
run, and a cell that fails, or any warning, fails the build.
"""

import os
import shutil
import sys
from pathlib import Path

DOCS = Path(__file__).resolve().parent
sys.path.insert(0, str(DOCS))
# Code cells run the command `holonom` of this environment, not one that happens to be on the path.
os.environ["PATH"] = os.pathsep.join([str(Path(sys.executable).parent), os.environ["PATH"]])

# The kernel of code cells starts with generators/shell_cell.py, which has the cell %%bash.
os.environ["IPYTHONDIR"] = str(DOCS / "generated" / "ipython")

from generators import commands, gallery, scene_format  # noqa: E402

from build_fmu.version import VERSION  # noqa: E402

project = "holonom"
author = "holonom contributors"
copyright = author
version = release = VERSION

extensions = ["myst_nb", "sphinx.ext.autodoc", "sphinx.ext.napoleon"]
exclude_patterns = ["generators", "generated/ipython"]
templates_path = []

html_theme = "furo"
html_title = f"holonom {VERSION}"
html_static_path = ["static"]
html_css_files = ["site.css"]
html_extra_path = ["generated/reports"]
"""Reports of the gallery's scenes are pages of their own, which keep their names; and pictures."""
html_copy_source = False

highlight_language = "none"
smartquotes = False
"""Of --option they would make a dash."""
myst_enable_extensions = ["colon_fence"]
myst_heading_anchors = 4
"""The anchors of headings are those of code hosts."""
nb_execution_mode = "force"
nb_execution_in_temp = True
nb_execution_raise_on_error = True
nb_execution_timeout = 120
nb_merge_streams = True

autodoc_member_order = "bysource"
autodoc_typehints = "signature"
python_use_unqualified_type_names = True
napoleon_google_docstring = False

linkcheck_timeout = 20

ELSEWHERE = {"../scenes/README.md": "generated/gallery.md"}
"""Links that leave docs/, and the page that has the same on the site."""


def _stay_on_the_site(app, docname, source):  # noqa: ARG001
    for link, page in ELSEWHERE.items():
        source[0] = source[0].replace(f"]({link})", f"]({page})")


def _generate(app):  # noqa: ARG001
    start = DOCS / "generated" / "ipython" / "profile_default" / "startup"
    start.mkdir(parents=True, exist_ok=True)
    shutil.copy(DOCS / "generators" / "shell_cell.py", start)
    gallery.write(DOCS / "generated")
    scene_format.write(DOCS / "generated")
    commands.write(DOCS / "generated")


def setup(app):
    """Write the generated pages first, then follow links that leave the folder."""
    app.connect("config-inited", lambda app, config: _generate(app))  # noqa: ARG005
    app.connect("source-read", _stay_on_the_site)
