"""The notebooks of the lessons are executed, and cells and objects show themselves."""

import contextlib
import json
import os
import pathlib
import signal
import socket
import subprocess
import sys
import time

import pytest

import algae
from algae import LSystem, magics
from conftest import needed, program


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


def test_pictures_of_one_page_have_names_of_their_own():
    """The letters of a caption are names within SVG, and those of the first picture stood in the others."""
    import re

    pictures = [LSystem("koch").draw(n, captions=True) for n in (1, 2)] + [LSystem("fibonacci").growth_graph(), LSystem("koch").tree(1)]
    shown = [one._repr_svg_() for one in pictures]
    names = [set(re.findall(r'\bid="([^"]+)"', one)) for one in shown]
    assert all(names) and not any(a & b for i, a in enumerate(names) for b in names[:i])
    for own, text in zip(names, shown):
        assert set(re.findall(r'(?:href="#|url\(#)([^")]+)', text)) <= own
    assert pictures[0].text != shown[0] and LSystem("koch").draw(1, captions=True)._repr_svg_() == shown[0]


def test_a_bar_in_a_notebook_leaves_nothing(tmp_path):
    """It wrote blanks to standard error, which is a red band below the cell."""
    nbclient, nbformat = needed("nbclient"), needed("nbformat")
    needed("ipykernel")
    notebook = nbformat.v4.new_notebook(cells=[nbformat.v4.new_code_cell(
        "import algae\ntry:\n    algae.LSystem('a -> ab, b -> a').growth().values(10**7, timeout=2.5)\nexcept algae.Timeout:\n    print('late')")])
    nbclient.NotebookClient(notebook, timeout=120, resources={"metadata": {"path": str(tmp_path)}}).execute()
    outputs = notebook.cells[0].outputs
    assert [one.get("text") for one in outputs if one.output_type == "stream"] == ["late\n"]
    bars = [one for one in outputs if one.output_type == "display_data"]
    assert len(bars) == 1 and bars[0].data["text/html"] == ""


def test_sliders_without_widgets(monkeypatch):
    import sys

    monkeypatch.setitem(sys.modules, "ipywidgets", None)
    shown = magics.sliders(LSystem("koch"), generations=(0, 3))
    assert [said for said, _ in shown.pictures] == ["n = 1", "n = 2", "n = 3", "angle = 30", "angle = 90"]
    assert shown._repr_html_().count("<svg") == 5
    with pytest.raises(TypeError, match="system: expected an LSystem"):
        magics.sliders("koch")


RUN_ALL = """
define(['base/js/events', 'base/js/namespace'], function (events, Jupyter) {
    let left = -1;
    events.on('kernel_ready.Kernel', function () {
        if (left >= 0) return;
        left = Jupyter.notebook.get_cells().filter(cell => cell.cell_type == 'code').length;
        Jupyter.notebook.execute_all_cells();
    });
    events.on('finished_execute.CodeCell', function () {
        if (--left == 0) setTimeout(() => Jupyter.notebook.save_notebook(), 500);
    });
});
"""


@contextlib.contextmanager
def running(arguments, **options):
    """A program that is ended when the block is left."""
    process = subprocess.Popen(arguments, stdout=subprocess.DEVNULL, start_new_session=True, **options)
    try:
        yield process
    finally:
        os.killpg(process.pid, signal.SIGTERM)
        process.wait(timeout=60)


def waited(what, until, seconds=150):
    end = time.monotonic() + seconds
    while time.monotonic() < end:
        found = what()
        if found:
            return found
        time.sleep(0.2)
    pytest.fail(f"no {until} within {seconds} s")


def test_the_page_of_jupyter_runs_a_notebook(source, tmp_path):
    """Chromium opens the page of the Notebook's server, which runs all cells of the last notebook and saves it; opened again, the page has
    figures, formulas, a figure in space in a frame, and a tree. ALGAE_PICTURES names a folder for a picture of the page."""
    needed("notebook", "jupyter-notebook")
    chromium = program("chromium")
    path = notebooks(source)[5]
    folder, settings, runtime = (tmp_path / name for name in ("notebooks", "settings", "runtime"))
    (settings / "custom").mkdir(parents=True)
    folder.mkdir()
    copy = folder / path.name
    copy.write_text(path.read_text())
    environment = {**os.environ, "HOME": str(tmp_path), "JUPYTER_CONFIG_DIR": str(settings), "JUPYTER_RUNTIME_DIR": str(runtime),
                   "JUPYTER_DATA_DIR": str(tmp_path / "data"), "IPYTHONDIR": str(tmp_path / "ipython")}
    with socket.create_server(("127.0.0.1", 0)) as free:
        port = free.getsockname()[1]
    server = [sys.executable, "-m", "notebook", "--no-browser", "--allow-root", "--ip=127.0.0.1", f"--port={port}", "--NotebookApp.token=",
              "--NotebookApp.password=", "--notebook-dir", str(folder)]
    browser = [chromium, "--headless", "--no-sandbox", "--disable-gpu", "--hide-scrollbars", f"--user-data-dir={tmp_path / 'chromium'}"]
    (settings / "custom" / "custom.js").write_text(RUN_ALL)
    with open(tmp_path / "server.log", "wb") as log, running(server, env=environment, stderr=log):
        def address():
            found = list(runtime.glob("nbserver-*.json"))
            return json.loads(found[0].read_text())["url"] if found else None

        page = waited(address, "server") + f"notebooks/{copy.name}"
        with running([*browser, "--remote-debugging-port=0", page], env=environment, stderr=subprocess.DEVNULL):
            def cells():
                try:
                    code = [one for one in json.loads(copy.read_text())["cells"] if one["cell_type"] == "code"]
                except ValueError:  # it is being saved
                    return None
                return code if all(one["execution_count"] for one in code) else None

            for cell in waited(cells, "executed cell"):
                for output in cell["outputs"]:
                    assert output["output_type"] != "error", output
                    assert output.get("name") != "stderr" or "\r" not in "".join(output["text"])  # a bar is not left in it
        (settings / "custom" / "custom.js").write_text("")
        look = [*browser, "--window-size=1100,6000", "--virtual-time-budget=20000"]
        shown = subprocess.run([*look, "--dump-dom", page], env=environment, capture_output=True, text=True, timeout=120).stdout
        if "ALGAE_PICTURES" in os.environ:
            picture = pathlib.Path(os.environ["ALGAE_PICTURES"]) / "notebook.png"
            subprocess.run([*look, f"--screenshot={picture}", page], env=environment, capture_output=True, timeout=120)
    outputs = shown.split('class="output_area"')[1:]
    assert sum("<svg" in one for one in outputs) >= 3 and any("<iframe" in one and "srcdoc" in one for one in outputs)
