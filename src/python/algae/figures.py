"""Pictures, trees and meshes: what is drawn of a system."""

from __future__ import annotations

import json
import os
from collections.abc import Iterable
from typing import Any, Optional, Union

import numpy

from . import _algae, arguments, pages
from .budget import Budget, limits

__all__ = ["Mesh", "Picture", "Tree"]

FORMATS = ("svg", "pdf", "png", "ps", "eps", "gif", "webp", "mp4", "webm", "tex", "typ", "csv", "geojson", "dxf", "html", "abc", "mid",
           "glb", "obj", "ply", "stl", "x3d", "wrl", "vrml1", "pov")

WISHES = ("width", "height", "margin", "line_width", "font_size", "frame_time", "colours", "background", "caption",
          "captions", "scale_bar", "common_scale", "panels", "camera", "facets")


def wishes_of(given: dict[str, Any]) -> _algae.Wishes:
    """What a caller of `draw` says of a picture."""
    arguments.unknown("draw", given, WISHES)
    wishes = _algae.Wishes()
    for name in ("width", "height", "line_width", "font_size", "frame_time"):
        if given.get(name) is not None:
            setattr(wishes, name, arguments.real(name, given[name], "a number above 0", 0))
    if given.get("margin") is not None:
        margin = arguments.real("margin", given["margin"], "a number from 0 on")
        if margin < 0:
            raise arguments.wrong_value("margin", "a number from 0 on", given["margin"])
        wishes.margin = margin
    colours = given.get("colours")
    if isinstance(colours, str):
        colours = [one.strip() for one in colours.split(",")]
    if colours is not None:
        wishes.colours = arguments.texts("colours", colours, "names of colours")
    if given.get("background") is not None:
        wishes.background = arguments.text("background", given["background"], "a colour")
    if given.get("caption") is not None:
        wishes.caption = arguments.text("caption", given["caption"])
    for name in ("captions", "scale_bar", "common_scale", "panels"):
        if given.get(name) is not None:
            setattr(wishes, name, arguments.truth(name, given[name]))
    camera = given.get("camera")
    if camera is not None:
        if isinstance(camera, str) or not isinstance(camera, Iterable):
            raise arguments.wrong_type("camera", "(azimuth, elevation) or (azimuth, elevation, opening)", camera)
        angles = [arguments.real(f"camera[{i}]", one, "degrees") for i, one in enumerate(camera)]
        if len(angles) not in (2, 3):
            raise arguments.wrong_value("camera", "(azimuth, elevation) or (azimuth, elevation, opening)", camera)
        wishes.camera = (angles[0], angles[1], len(angles) == 3, angles[2] if len(angles) == 3 else 40.0)
    if given.get("facets") is not None:
        wishes.facets = arguments.count("facets", given["facets"], 3, 256)
    return wishes


def format_of(path: Optional[str], format: Optional[str]) -> str:
    """The format of a picture, by its name or by the end of a path."""
    if format is not None:
        return arguments.choice("format", format, FORMATS)
    if path is None:
        return "svg"
    end = os.path.splitext(path)[1][1:].lower()
    if end not in FORMATS:
        raise arguments.wrong_value("path", "a name that ends in ." + ", .".join(FORMATS), path)
    return end


def write(path: str, data: bytes) -> None:
    """A file that appears whole or not at all."""
    temporary = f"{path}.{os.getpid()}.part"
    try:
        with open(temporary, "wb") as out:
            out.write(data)
        os.replace(temporary, path)
    except OSError as error:  # about the path that was asked for
        if os.path.exists(temporary):
            os.unlink(temporary)
        raise type(error)(error.errno, error.strerror, path) from None
    except BaseException:
        if os.path.exists(temporary):
            os.unlink(temporary)
        raise


class Picture:
    """A picture: its bytes, its format, and what is known of the figures in it.

    >>> import algae
    >>> picture = algae.LSystem("koch").draw(3)
    >>> picture.format, picture.facts["segments"], picture.facts["bounding_box"]["max"][0]
    ('svg', 64, 27.0)
    """

    def __init__(self, data: bytes, format: str, facts: list[dict[str, Any]], page: Optional[str] = None) -> None:
        if not isinstance(data, bytes):
            raise arguments.wrong_type("data", "bytes", data)
        self.data = data
        self.format = arguments.choice("format", format, FORMATS + ("dot",))
        self.figures = facts
        self._page = page

    @property
    def facts(self) -> dict[str, Any]:
        """Segments, bounding box and end of the only or the last figure."""
        return self.figures[-1] if self.figures else {}

    @property
    def text(self) -> str:
        """The picture as text, where its format is one: svg, tex, csv and so on."""
        return self.data.decode("utf-8")

    def save(self, path: Union[str, "os.PathLike[str]"]) -> None:
        """Writes the bytes; the file appears whole or not at all."""
        write(arguments.path("path", path), self.data)

    def __repr__(self) -> str:
        return f"Picture({self.format}, {len(self.data)} bytes)"

    def _repr_svg_(self) -> Optional[str]:
        return pages.distinct(self.text) if self.format == "svg" and self._page is None else None

    def _repr_png_(self) -> Optional[bytes]:
        return self.data if self.format == "png" else None

    def _repr_html_(self) -> Optional[str]:
        import base64

        if self._page is not None:
            return pages.framed(self._page)
        if self.format == "html":
            return pages.framed(self.text)
        data = base64.b64encode(self.data).decode("ascii")
        if self.format in ("gif", "webp"):
            return f'<img src="data:image/{self.format};base64,{data}" alt="an animation">'
        if self.format in ("mp4", "webm"):
            return f'<video controls loop src="data:video/{self.format};base64,{data}"></video>'
        return None


class Tree:
    """A derivation tree, or a graph of a system: ``draw`` makes a picture of it.

    >>> import algae
    >>> tree = algae.LSystem("a -> ab, b -> a").tree(3)
    >>> len(tree.nodes), tree.edges[0]
    (11, (0, 1, ''))
    """

    def __init__(self, tree: _algae.Tree) -> None:
        self._tree = tree
        self._parts: Optional[dict[str, list[Any]]] = None

    def _all(self) -> dict[str, list[Any]]:
        if self._parts is None:
            self._parts = self._tree.parts()
        return self._parts

    @property
    def nodes(self) -> list[tuple[str, int]]:
        """The label of each node and its generation."""
        return self._all()["nodes"]

    @property
    def edges(self) -> list[tuple[int, int, str]]:
        """Pairs of nodes, by their places in `nodes`, with a label, from above to below."""
        return self._all()["edges"]

    def draw(self, path: Union[str, "os.PathLike[str]", None] = None, *, format: Optional[str] = None,
             width: Optional[float] = None, timeout: Optional[float] = None, budget: Optional[Budget] = None) -> Picture:
        """A picture: svg, pdf, png, ps or eps, tex for LaTeX, dot for Graphviz."""
        known = ("svg", "pdf", "png", "ps", "eps", "tex", "dot")
        file = None if path is None else arguments.path("path", path)
        if format is None and file is not None:
            format = os.path.splitext(file)[1][1:].lower()
        chosen = arguments.choice("format", format or "svg", known)
        with limits(timeout, budget, "tree") as bounds:
            data = self._tree.bytes(chosen, arguments.optional_real("width", width, "a number above 0", 0), bounds)
        picture = Picture(data, chosen, [{"nodes": len(self.nodes), "edges": len(self.edges)}])
        if file is not None:
            picture.save(file)
        return picture

    def to_networkx(self) -> Any:
        """A `networkx.DiGraph` whose nodes have `label` and `generation`."""
        from .exchange import networkx_graph

        return networkx_graph(self)

    def __repr__(self) -> str:
        return f"Tree({len(self.nodes)} nodes, {len(self.edges)} edges)"

    def _repr_svg_(self) -> str:
        with limits(None, None, "tree") as bounds:
            return pages.distinct(self._tree.bytes("svg", None, bounds).decode("utf-8"))


class Mesh:
    """The surface of a figure in space as triangles: arrays of points, normals and triangles.

    >>> import algae
    >>> mesh = algae.LSystem("bush-3d").mesh(2)
    >>> mesh.points.shape[1], int(mesh.triangles.max()) < len(mesh.points)
    (3, True)
    """

    def __init__(self, arrays: dict[str, Any], system: _algae.System, shown: _algae.Shown) -> None:
        self.points: "numpy.ndarray[Any, Any]" = arrays["points"]
        self.normals: "numpy.ndarray[Any, Any]" = arrays["normals"]
        self.triangles: "numpy.ndarray[Any, Any]" = arrays["triangles"]
        self._system, self._shown = system, shown

    def save(self, path: Union[str, "os.PathLike[str]"], *, timeout: Optional[float] = None, budget: Optional[Budget] = None,
             **wishes: Any) -> None:
        """Writes glb, obj, ply, stl, x3d, wrl, vrml1 or pov, by the end of the path."""
        file = arguments.path("path", path)
        chosen = format_of(file, None)
        wanted = wishes_of(wishes)
        with limits(timeout, budget, "mesh") as bounds:
            data, _ = _algae.draw(self._system, self._shown, wanted, chosen, bounds)
        write(file, data)

    def __repr__(self) -> str:
        return f"Mesh({len(self.points)} points, {len(self.triangles)} triangles)"

    def _repr_html_(self) -> str:
        with limits(None, None, "mesh") as bounds:
            return pages.framed(page_to_turn(self._system, self._shown, _algae.Wishes(), bounds))


def page_to_turn(system: _algae.System, shown: _algae.Shown, wishes: _algae.Wishes, bounds: _algae.Limits) -> str:
    """The page of HTML in which a figure in space is turned with the mouse."""
    data, _ = _algae.draw(system, shown, wishes, "html", bounds)
    return data.decode("utf-8")


def facts_of(texts: list[str]) -> list[dict[str, Any]]:
    return [json.loads(one) for one in texts]
