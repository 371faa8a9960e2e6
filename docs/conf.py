"""The documentation as a site: `scripts/docs` puts pages and notebooks together in target/docs-source and has Sphinx build them into target/docs.

The pages are read on their own as well, so that their links are those of the repository; `_links` says what becomes of them.
"""

import os
import re
from pathlib import Path
from typing import Any

import flankwright
from flankwright import plots
from sphinx.application import Sphinx
from sphinx.environment import BuildEnvironment
from sphinx.util import logging

ROOT = Path(__file__).resolve().parents[1]

project = "flankwright"
author = "flankwright contributors"
copyright = "2026 flankwright contributors; MIT or Apache-2.0"
version = release = flankwright.__version__

extensions = ["myst_nb", "sphinx.ext.autodoc", "sphinx.ext.mathjax", "sphinx.ext.napoleon"]
exclude_patterns = ["conf.py", "requirements.txt", "_static"]

# Pages are Markdown as in the repository: sections are linked by their titles, formulas stand between dollars.
myst_enable_extensions = ["amsmath", "dollarmath"]
myst_fence_as_directive = ["math"]
myst_heading_anchors = 4
highlight_language = "none"

# Notebooks have been carried out by `scripts/notebooks`.
nb_execution_mode = "off"

autodoc_default_options = {"members": True, "member-order": "bysource"}
autodoc_typehints_format = "short"
python_maximum_signature_line_length = 88
autodoc_type_aliases = {name: name for name in ("ArrayLike", "Output", "Outputs")}
napoleon_numpy_docstring = False
napoleon_use_rtype = False
python_use_unqualified_type_names = True
toc_object_entries_show_parents = "hide"

# Nothing is loaded from elsewhere: MathJax lies beside the pages, without the menu that would fetch more of it.
mathjax_path = "tex-svg-full.js"
mathjax3_config = {"options": {"enableMenu": False}}
html_static_path = ["_static", "../target/mathjax/static"]
html_css_files = ["flankwright.css"]

html_theme = "furo"
pygments_dark_style = "a11y-high-contrast-dark"
html_title = f"flankwright {version}"
html_copy_source = False

# Pages that stand outside docs/ in the repository.
PAGES = {"architecture": "ARCHITECTURE.md", "contributing": "CONTRIBUTING.md", "changelog": "CHANGELOG.md"}


def _links(app: Sphinx, docname: str, source: list[str]) -> None:
    """A link of the repository leads to the page of the site; where there is none, to the file, which goes with the site; a folder stays a name."""
    page = ROOT / PAGES.get(docname, f"docs/{docname}.md")
    if not page.exists():
        return
    pages = {path: f"/{path.relative_to(ROOT / 'docs')}" for path in (ROOT / "docs").rglob("*.md")}
    pages |= {ROOT / path: f"/{name}.md" for name, path in PAGES.items()}
    pages |= {path: f"/notebooks/{path.stem}.ipynb" for path in (ROOT / "notebooks").glob("*.py")}

    def led(match: re.Match[str]) -> str:
        text, link, anchor = match.groups()
        there = (page.parent / link).resolve()
        if there.is_dir():
            return text
        if not there.exists() or there.suffix in (".svg", ".png"):
            return match[0]
        if there in pages:
            return f"[{text}]({pages[there]}{anchor or ''})"
        name = text.replace("`", "")
        return f"{{download}}`{name} </{os.path.relpath(there, app.srcdir)}>`"

    source[0] = re.sub(r"\[([^\]]*)\]\(([^)\s#:]+)(#[^)\s]*)?\)", led, source[0])


def _complete(app: Sphinx, env: BuildEnvironment) -> None:
    """Every public name of the package has its place on a page."""
    public = {f"flankwright.{name}" for name in flankwright.__all__ if name != "sweep"}
    public |= {f"flankwright.sweep.{name}" for name in flankwright.sweep.__all__}
    public |= {f"flankwright.plots.{name}" for name in plots.__all__}
    for name in sorted(public - set(env.domaindata["py"]["objects"])):
        logging.getLogger(__name__).warning("%s is public, but on no page of docs/python", name)


# What only the package itself makes: how it does so is of no use to readers.
MADE_HERE = {"Derived", "Flanks", "FlankValues", "Preview", "Result", "Worm", "sweep.Swept"}
MADE_HERE |= {"CutterPath", "DressedWorm", "Evaluation", "Meridian", "Pulses", "Tracks"}
MADE_HERE |= {"BadInput", "FlankwrightError", "InternalError", "NotProducible"}
ARRAY = re.compile(r"~?(?:numpy\.)?ndarray\[tuple\[~?(?:typing\.)?Any, \.\.\.\], ~?(?:numpy\.)?dtype\[~?(?:\w+\.)?(\w+)\]\]")
ALIAS = re.compile(r"TypeAliasForwardRef\('(\w+)'\)")


def _signature(app: Sphinx, what: str, name: str, of: Any, options: Any, signature: str | None, returned: str | None) -> tuple[str | None, ...]:
    """Types of NumPy by the names that the sources have for them."""
    if name.removeprefix("flankwright.") in MADE_HERE:
        return "", None
    return tuple(part and ALIAS.sub(r"\1", ARRAY.sub(r"NDArray[\1]", part)) for part in (signature, returned))


def setup(app: Sphinx) -> dict[str, Any]:
    app.connect("autodoc-process-signature", _signature)
    app.connect("source-read", _links)
    app.connect("env-check-consistency", _complete)
    return {"parallel_read_safe": True}
