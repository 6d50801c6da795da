"""The notebooks of the lessons are executed, and cells and objects show themselves."""

import json

import pytest

import algae
from algae import LSystem, magics
from conftest import needed


def notebooks(source):
    return sorted((source / "lessons" / "notebooks").glob("*.ipynb"))


def test_there_are_six_and_none_keeps_outputs(source):
    paths = notebooks(source)
    assert len(paths) == 6
    for path in paths:
        for cell in json.loads(path.read_text())["cells"]:
            assert cell["cell_type"] == "markdown" or (cell["outputs"] == [] and cell["execution_count"] is None)


@pytest.mark.parametrize("number", range(6))
def test_a_notebook_runs(source, number, tmp_path):
    nbclient = needed("nbclient")
    nbformat = needed("nbformat")
    needed("ipykernel")
    path = notebooks(source)[number]
    notebook = nbformat.read(path, as_version=4)
    client = nbclient.NotebookClient(notebook, timeout=600, resources={"metadata": {"path": str(tmp_path)}})
    client.comm_open_handlers = {}  # sliders speak to a browser, of which there is none
    client.execute()
    for cell in notebook.cells:
        for output in cell.get("outputs", []):
            assert output.output_type != "error", output
    shown = json.dumps(notebook.cells)
    if path.name.startswith("2"):
        assert "claim:2:" in shown or "wrong:" in shown  # the finding of the cell with a slip
    if path.name.startswith("6"):
        assert "image/svg+xml" in shown and "<iframe" in shown


class Shell:
    """The part of IPython's shell that the magics ask."""

    def __init__(self):
        self.user_ns, self.magics = {}, {}

    def register_magic_function(self, function, kind, name):
        self.magics[name] = function


def test_cells_of_systems_and_claims():
    shell = Shell()
    algae.load_ipython_extension(shell)
    koch = shell.magics["lsys"]("koch", "axiom F\nF -> F+F--F+F\nangle 60\n")
    assert isinstance(koch, LSystem) and shell.user_ns["koch"] is koch
    wrong = shell.magics["lsys"]("wrong", "axiom F\nF -> F]\n")
    assert "wrong:2:7" in wrong.message and "^" in wrong.message and "<pre" in wrong._repr_html_()
    assert "wrong" not in shell.user_ns
    checked = shell.magics["claim"]("mine", "let K = D0L koch\nshow growth(K) ~ exponential\n")
    assert bool(checked) and shell.user_ns["mine"] is checked
    assert "claim:2:6: error: '{' is never closed" in shell.magics["claim"]("", "show {a").message
    assert "name of a variable" in shell.magics["lsys"]("a-b", "axiom F").message
    assert shell.magics["lsys"]("x --let c=3", "let c = 2; axiom A(c); A(x) -> A(x)").derive(0) == "A(3)"


WRONG_LINES = [
    ("lsys", "x --let 'c=3", "expected a quote that closes"),
    ("lsys", "x --timeout 3", "expected --let, found '--timeout'"),
    ("lsys", "x --let", "--let: expected a value behind it"),
    ("lsys", "x y", "expected one name of a variable, found x y"),
    ("claim", "x --timeout x", "--timeout: expected seconds, a number above 0, found 'x'"),
    ("claim", "x --timeout nan", "--timeout: expected seconds, a number above 0, found 'nan'"),
    ("claim", "x --timeout -1", "--timeout: expected seconds, a number above 0, found '-1'"),
    ("claim", 'x "y', "expected a quote that closes"),
    ("claim", "--colour red", "expected --timeout, found '--colour'"),
]


@pytest.mark.parametrize("magic,line,message", WRONG_LINES)
def test_a_wrong_line_of_a_cell_is_told_below_it(magic, line, message):
    """They raised ValueError or TypeError, with a traceback."""
    shell = Shell()
    algae.load_ipython_extension(shell)
    shown = shell.magics[magic](line, {"lsys": "axiom F\nF -> FF\n", "claim": "show {a} is 0L\n"}[magic])
    assert f"%%{magic}: {message}" in shown.message and not shell.user_ns
    assert "kock" in shell.magics["lsys"]("kock").message


def test_a_claim_in_a_cell_ends_with_its_time():
    shell = Shell()
    algae.load_ipython_extension(shell)
    assert bool(shell.magics["claim"]("x --timeout 20", "show {a} is 0L\n"))


WRONG_SLIDERS = [
    ({"generations": 5}, TypeError, r"generations: expected a pair \(first, last\), found 5 \(int\)"),
    ({"generations": (1, 2, 3)}, ValueError, r"generations: expected a pair \(first, last\)"),
    ({"generations": ("x", 2)}, TypeError, r"generations\[0\]: expected a generation"),
    ({"generations": (3, 2)}, ValueError, r"generations\[1\]: expected 3 or more"),
    ({"steps": 0}, ValueError, "steps: expected"),
    ({"width": "x"}, TypeError, "width: expected a number above 0"),
    ({"colour": "red"}, TypeError, "did you mean colours"),
]


@pytest.mark.parametrize("given,kind,message", WRONG_SLIDERS)
def test_sliders_name_what_is_wrong(given, kind, message):
    with pytest.raises(kind, match=message):
        magics.sliders(LSystem("koch"), **given)


def test_formulas_stand_in_the_html_which_notebooks_prefer():
    growth = LSystem("a -> ab, b -> a").growth()
    assert growth._repr_html_().count("$$") == 4 and r"\frac" in growth._repr_html_()
    assert "lengths" in growth._repr_html_().split("mathjax_ignore")[1]
    assert r"\frac{\log 4}{\log 3}" in LSystem("koch").dimension()._repr_html_()


def test_sliders_without_widgets(monkeypatch):
    import sys

    monkeypatch.setitem(sys.modules, "ipywidgets", None)
    shown = magics.sliders(LSystem("koch"), generations=(0, 3))
    assert [said for said, _ in shown.pictures] == ["n = 1", "n = 2", "n = 3", "angle = 30", "angle = 90"]
    assert shown._repr_html_().count("<svg") == 5
    with pytest.raises(TypeError, match="system: expected an LSystem"):
        magics.sliders("koch")
