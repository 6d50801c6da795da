"""The examples in the documentation are run, and mypy checks the types."""

import doctest
import importlib
import pathlib
import pkgutil
import subprocess
import sys

import pytest

import algae
from conftest import needed

MODULES = ["algae"] + [f"algae.{one.name}" for one in pkgutil.iter_modules(algae.__path__) if one.name != "_algae"]


@pytest.mark.parametrize("name", MODULES)
def test_examples(name):
    found = doctest.testmod(importlib.import_module(name))
    assert found.failed == 0


def test_there_are_examples():
    finder = doctest.DocTestFinder()
    examples = sum(len(test.examples) for name in MODULES for test in finder.find(importlib.import_module(name)))
    assert examples >= 60


def test_everything_that_is_public_is_documented():
    missing = []
    for name in algae.__all__:
        thing = getattr(algae, name)
        if not getattr(thing, "__doc__", None) and callable(thing):
            missing.append(name)
        if isinstance(thing, type):
            for member, value in vars(thing).items():
                if member.startswith("_") or not (callable(value) or isinstance(value, property)):
                    continue
                if not value.__doc__ and not any(getattr(base, member, None) for base in thing.__mro__[1:]):
                    missing.append(f"{name}.{member}")
    assert not missing


def test_types(source, tmp_path):
    needed("mypy", "mypy")
    folder = source / "src" / "python"
    done = subprocess.run([sys.executable, "-m", "mypy", "--config-file", str(folder / "mypy.ini"), "--cache-dir", str(tmp_path),
                           str(folder / "algae")], capture_output=True, text=True, timeout=600)
    assert done.returncode == 0, done.stdout


def test_the_stub_has_what_the_module_has():
    import ast

    from algae import _algae

    text = (pathlib.Path(algae.__file__).parent / "_algae.pyi").read_text()
    said = {}
    for node in ast.parse(text).body:
        if isinstance(node, ast.FunctionDef):
            said[node.name] = None
        elif isinstance(node, ast.ClassDef):
            said[node.name] = {one.name if isinstance(one, ast.FunctionDef) else one.target.id for one in node.body
                               if isinstance(one, (ast.FunctionDef, ast.AnnAssign))}
    for name in dir(_algae):
        thing = getattr(_algae, name)
        if name.startswith("_") or not callable(thing):
            continue
        assert name in said, name
        if isinstance(thing, type):
            assert {one for one in vars(thing) if not one.startswith("_")} == {one for one in said[name] if not one.startswith("_")}
