"""How objects show themselves in notebooks: pieces of HTML."""

from __future__ import annotations

import hashlib
import html
import json
import re
from typing import Any

__all__: list[str] = []


def escaped(text: str) -> str:
    return html.escape(text, quote=True)


def distinct(document: str) -> str:
    """The SVG document with names of its own: those of all pictures in a page are in one space, and the letters of a caption are names."""
    if ' id="' not in document:
        return document
    mark = hashlib.sha256(document.encode()).hexdigest()[:8]
    return re.sub(r'(\bid="|href="#|url\(#)', rf"\g<1>p{mark}-", document)


def svg_element(document: str) -> str:
    """The element of an SVG document, to stand within HTML."""
    return document[max(0, document.find("<svg")):]


def preformatted(text: str) -> str:
    return f'<pre style="line-height:1.3">{escaped(text)}</pre>'


def formula(latex: str) -> str:
    """A formula on a line of its own, which MathJax of the notebook sets."""
    return f'<div class="formula">$${escaped(latex.strip())}$$</div>'


def folded(summary: str, text: str) -> str:
    """A text that opens when somebody clicks; dollar signs in it mean themselves."""
    return f'<details class="tex2jax_ignore mathjax_ignore"><summary>{escaped(summary)}</summary>{preformatted(text)}</details>'


def table(head: list[str], rows: list[list[Any]]) -> str:
    cells = "".join(f"<th>{escaped(one)}</th>" for one in head)
    lines = "".join("<tr>" + "".join(f"<td>{escaped(str(one))}</td>" for one in row) + "</tr>" for row in rows)
    return f"<table><thead><tr>{cells}</tr></thead><tbody>{lines}</tbody></table>"


VERDICT_COLOURS = {"proved": "#1a7f37", "holds": "#1a7f37", "checked": "#1a7f37", "examples": "#1a7f37",
                   "refuted": "#b42318", "fails": "#b42318", "WRONG": "#b42318"}


def verdict(text: str) -> str:
    colour = VERDICT_COLOURS.get(text, "#8a6d00")
    return f'<b style="color:{colour}">{escaped(text)}</b>'


def argument(lines: list[str]) -> str:
    return "".join(
        f'<p style="margin:0.2em 0 0.2em {2 if line.startswith(" ") else 0}em">{escaped(line.strip())}</p>' for line in lines)


def error(message: str) -> str:
    """The findings of a text, as a compiler prints them."""
    return f'<pre style="color:#b42318;line-height:1.3">{escaped(message)}</pre>'


def framed(page: str, height: int = 480) -> str:
    """A page within a cell of a notebook, which cannot reach the notebook."""
    return (f'<iframe srcdoc="{escaped(page)}" sandbox="allow-scripts" '
            f'style="width:100%;height:{height}px;border:1px solid #ddd"></iframe>')


def as_json(value: object) -> str:
    return json.dumps(value, ensure_ascii=False, indent=1)
