# TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.
"""The manual as HTML, by Sphinx: ./tmsph doc. Pages of LAMMPS's own manual that ours refer to are
links to it; they must be in its sources, where these are at hand. Files of the package that are no
pages are links into this checkout."""

import os
import re
from pathlib import Path

from docutils import nodes
from pygments.lexer import RegexLexer
from pygments.token import Comment, Keyword, Name, String, Text

project = "TMSPH"
author = "the TMSPH developers"
extensions = ["sphinx.ext.mathjax", "myst_parser"]
root_doc = "index"
html_theme = "sphinx_rtd_theme"
html_theme_options = {"navigation_depth": 2}
html_show_copyright = html_show_sourcelink = False
myst_heading_anchors = 4

DOC = Path(__file__).resolve().parent
LAMMPS = "https://docs.lammps.org"


class InputLexer(RegexLexer):
    """LAMMPS inputs: a command, then its words."""

    name, aliases = "LAMMPS", ["LAMMPS", "lammps"]
    tokens = {"root": [(r"#.*", Comment), (r"^[ \t]*[\w/]+", Keyword),
                       (r"\$\{\w+\}|\$\(.*?\)", Name.Variable),
                       (r"'[^'\n]*'|\"[^\"\n]*\"", String), (r"&\n", Text),
                       (r"[^#$'\"&\n]+|\n|.", Text)]}


def lammps_page(app, env, node, contnode):
    """A page of LAMMPS's manual for a :doc: that is none of ours."""
    if node.get("reftype") != "doc":
        return None
    page = node["reftarget"].rsplit("/", 1)[-1]
    tree = Path(app.config.lammps_tree)
    if "tmsph" in page.lower() or (tree.is_dir() and not (tree / f"{page}.rst").exists()):
        return None
    return nodes.reference("", "", contnode, internal=False, refuri=f"{LAMMPS}/{page}.html")


def link_to_checkout(app, page, text):
    """Links of Markdown pages to files that are no pages of the manual."""
    if not app.env.doc2path(page).endswith(".md"):
        return
    folder = Path(app.env.doc2path(page)).parent

    def linked(found):
        target = found[2].partition("#")[0]
        path = (folder / target).resolve()
        inside = DOC in path.parents and path.suffix in (".md", ".rst", ".png")
        if not target or "://" in target or inside or not path.exists():
            return found[0]
        return f'<a href="{path.as_uri()}">{found[1]}</a>'    # Markdown refuses links to files

    text[0] = re.sub(r"(?<!!)\[([^][]*)\]\(([^)\s]+)\)", linked, text[0])


def setup(app):
    tree = os.environ.get("LAMMPS_SOURCE_DIR", "")
    app.add_config_value("lammps_tree", str(Path(tree, "doc/src")) if tree else "", "env")
    app.add_lexer("LAMMPS", InputLexer)
    app.add_lexer("lammps", InputLexer)
    app.connect("missing-reference", lammps_page)
    app.connect("source-read", link_to_checkout)
