"""Executes the notebooks of the lessons and writes a page of HTML for each, which needs no network: formulas become MathML, pictures and figures
in space stand in the page.

    notebooks.py TEMPLATE OUT NOTEBOOK...

tools/lessons calls it; it needs nbclient, an ipykernel, the package algae and pandoc. Prints the title of each notebook; its page is
OUT/notebook-NAME.html.
"""

import html
import pathlib
import re
import subprocess
import sys
import tempfile

import nbclient
import nbformat


def by_pandoc(text, *options):
    return subprocess.run(["pandoc", "--mathml", *options], input=text, capture_output=True, text=True, check=True).stdout


def formulas(markup):
    """The markup with each `<div class="formula">` set as MathML."""
    def one(match):
        return by_pandoc(f"$${html.unescape(match.group(1))}$$\n", "--from", "markdown", "--to", "html5")

    return re.sub(r'<div class="formula">\$\$(.*?)\$\$</div>', one, markup, flags=re.S)


def shown(output):
    """What a notebook shows of an output: the richest form that it has."""
    if output.output_type == "stream":
        if output.name == "stderr":  # bars of progress
            return ""
        return f'<pre class="output">{html.escape(output.text)}</pre>'
    if output.output_type == "error":
        raise SystemExit("a cell of the notebook raises " + output.ename + ": " + output.evalue)
    data = output.data
    if "text/html" in data:
        return f'<div class="output">{formulas(data["text/html"])}</div>'
    if "image/svg+xml" in data:
        markup = data["image/svg+xml"]
        return f'<figure>{markup[max(0, markup.find("<svg")):]}</figure>'
    if "image/png" in data:
        return f'<figure><img src="data:image/png;base64,{data["image/png"].strip()}" alt="a figure"></figure>'
    if "text/latex" in data:
        text = data["text/latex"].replace("\\allowbreak ", "")  # pandoc does not know it
        return f'<div class="output">{by_pandoc(text, "--from", "latex", "--to", "html5")}</div>'
    return f'<pre class="output">{html.escape(data.get("text/plain", ""))}</pre>'


def joined(outputs):
    """The outputs, where printed texts that came one after the other are one."""
    found = []
    for one in outputs:
        if found and one.output_type == found[-1].output_type == "stream" and one.name == found[-1].name:
            found[-1].text += one.text
        else:
            found.append(one)
    return found


def distinct(markup, number):
    """Names within SVG are those of a page: each picture gets its own."""
    names = set(re.findall(r'\bid="([^"]+)"', markup))
    for name in names:
        markup = re.sub(rf'(id="|href="#|url\(#){re.escape(name)}(["\)])', rf"\g<1>p{number}-{name}\2", markup)
    return markup


def executed(path):
    notebook = nbformat.read(path, as_version=4)
    # A page has no widgets, so sliders become pictures below each other.
    first = nbformat.v4.new_code_cell("import sys\nsys.modules['ipywidgets'] = None")
    notebook.cells.insert(0, first)
    with tempfile.TemporaryDirectory() as folder:
        nbclient.NotebookClient(notebook, timeout=600, resources={"metadata": {"path": folder}}).execute()
    return notebook.cells[1:]


def body(cells):
    parts = []
    for number, cell in enumerate(cells):
        if cell.cell_type == "markdown":
            parts.append(by_pandoc(cell.source, "--from", "markdown-auto_identifiers", "--to", "html5"))
            continue
        parts.append(f'<pre class="code"><code>{html.escape(cell.source)}</code></pre>')
        parts += [distinct(shown(one), f"{number}-{i}") for i, one in enumerate(joined(cell.outputs))]
    return "\n".join(parts)


def main():
    template, out = sys.argv[1], pathlib.Path(sys.argv[2])
    paths = [pathlib.Path(one) for one in sys.argv[3:]]
    titles = [re.search(r"^# (.*)", nbformat.read(path, as_version=4).cells[0].source, re.M).group(1) for path in paths]
    names = [f"notebook-{path.stem}.html" for path in paths]
    for i, path in enumerate(paths):
        around = ["--variable", "contents=yes"]
        if i > 0:
            around += ["--variable", f"before={names[i - 1]}", "--variable", f"before-title={titles[i - 1]}"]
        if i + 1 < len(paths):
            around += ["--variable", f"after={names[i + 1]}", "--variable", f"after-title={titles[i + 1]}"]
        page = by_pandoc("~~~~~~~~~~~~{=html}\n" + body(executed(path)) + "\n~~~~~~~~~~~~\n", "--from", "markdown", "--to", "html5",
                         "--template", template, "--metadata", f"pagetitle={titles[i]}", *around)
        (out / names[i]).write_text(page, encoding="utf-8")
        print(f"{names[i]}\t{titles[i]}", flush=True)


if __name__ == "__main__":
    main()
