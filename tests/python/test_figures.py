"""Points and segments as arrays, pictures, meshes, trees."""

import xml.dom.minidom

import numpy
import pytest

import algae
from algae import LSystem


def walked(word, turn):
    """The segments of a word of F, + and - by a turtle in plain Python."""
    place, way, found = 0j, 1 + 0j, []
    rotation = complex(numpy.cos(numpy.radians(turn)), numpy.sin(numpy.radians(turn)))
    for letter in word:
        if letter == "F":
            found.append((place, place + way))
            place += way
        elif letter == "+":
            way *= rotation
        elif letter == "-":
            way /= rotation
    return found


@pytest.mark.parametrize("rule,turn", [("F+F--F+F", 60), ("F-F+F+F-F", 90), ("FF-F-F-F-F-F+F", 90), ("F+F", 36)])
def test_segments_are_those_of_a_plain_turtle(rule, turn):
    system = LSystem({"F": rule}, settings={"angle": turn})
    segments = system.segments(4)
    expected = walked(system.derive(4).letters, turn)
    assert segments.shape == (len(expected), 2, 2) and segments.dtype == numpy.float64
    for found, (start, end) in zip(segments, expected):
        assert abs(complex(*found[0]) - start) < 1e-9 and abs(complex(*found[1]) - end) < 1e-9
    points, begins = system.strokes(4)
    assert begins.tolist() == [0] and len(points) == len(expected) + 1
    assert numpy.allclose(points[:-1], segments[:, 0])


def test_strokes_begin_anew_where_the_pen_is_lifted():
    points, begins = LSystem("axiom FfF[+F]F").strokes(0)
    assert [len(one) for one in numpy.split(points, begins[1:])] == [2, 3, 2]
    assert len(LSystem("axiom FfF[+F]F").segments(0)) == 4


def test_arrays_are_not_copied_and_outlive_what_made_them():
    points = LSystem("dragon").points(12)
    assert not points.flags.owndata and points.flags.c_contiguous
    total = points.sum()
    [LSystem("dragon").points(12) for _ in range(5)]
    assert points.sum() == total


def test_space():
    system = LSystem("bush-3d")
    assert system.segments(2).shape[2] == 3
    mesh = system.mesh(2)
    assert mesh.triangles.max() < len(mesh.points) and numpy.allclose(numpy.linalg.norm(mesh.normals, axis=1), 1)
    with pytest.raises(algae.Error, match="leaves the plane"):
        system.points(2)
    picture = system.draw(3)
    assert "<iframe" in picture._repr_html_() and picture._repr_svg_() is None
    assert "<iframe" in mesh._repr_html_()
    page = system.draw(3, format="html")
    assert "drag to turn" in page.text and page.facts["segments"] == len(system.segments(3))
    assert "drag to turn" in picture._repr_html_()  # one page for all: that of `algae draw -o figure.html`
    assert system.draw(2, format="glb").data[:4] == b"glTF"


FORMATS = {"svg": b"<?xml", "pdf": b"%PDF", "png": b"\x89PNG", "ps": b"%!PS", "eps": b"%!PS", "gif": b"GIF8", "webp": b"RIFF",
           "html": b"<!DOCTYPE html"}


@pytest.mark.parametrize("format", list(FORMATS) + ["tex", "typ", "csv", "geojson", "dxf", "stl", "obj", "ply", "x3d", "wrl"])
def test_formats(format, tmp_path):
    path = tmp_path / f"figure.{format}"
    generations = (0, 2) if format in ("gif", "webp") else 2
    picture = LSystem("koch").draw(generations, path)
    data = path.read_bytes()
    assert data == picture.data and data.startswith(FORMATS.get(format, b"")) and len(data) > 50
    assert not list(tmp_path.glob("*.part"))


def test_pictures_show_themselves():
    picture = LSystem("koch").draw(3, width=300, colours="red", background="white", captions=True)
    xml.dom.minidom.parseString(picture._repr_svg_())
    assert LSystem("koch").draw(2, format="png")._repr_png_().startswith(b"\x89PNG")
    assert "<svg" in LSystem("koch")._repr_html_()
    assert "begin" in LSystem("koch")._repr_latex_()
    assert LSystem("koch").growth()._repr_latex_().count("$$") == 4
    assert "<svg" in LSystem("fibonacci").tree(3)._repr_svg_()
    assert "log" in LSystem("koch").dimension()._repr_latex_()
    several = LSystem("koch").draw((0, 3))
    assert [one["generation"] for one in several.figures] == [0, 1, 2, 3]


def test_trees():
    tree = LSystem("a -> ab, b -> a").tree(4)
    assert sum(1 for _, generation in tree.nodes if generation == 4) == 8
    assert all(tree.nodes[above][1] + 1 == tree.nodes[below][1] for above, below, _ in tree.edges)
    word = LSystem("a -> a, a -> aa").tree(word="aaa")
    assert word.nodes[0] == ("a", 0)
    with pytest.raises(algae.BoundReached, match="nodes") as caught:
        LSystem("koch").tree(12)
    assert caught.value.bound == "nodes"
    assert LSystem("fibonacci").growth_graph().edges
