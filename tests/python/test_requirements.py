"""What tests need is not passed over silently where all of it is required."""

import os
import pathlib
import re
import subprocess
import sys

import pytest
from conftest import needed


def test_what_is_missing_skips_a_test_and_fails_where_it_is_required(monkeypatch):
    monkeypatch.setenv("ALGAE_REQUIRE", "0")
    with pytest.raises(pytest.skip.Exception, match="no_such_module is not installed"):
        needed("no_such_module")
    monkeypatch.setenv("ALGAE_REQUIRE", "1")
    with pytest.raises(pytest.fail.Exception, match="ALGAE_REQUIRE=1 requires it"):
        needed("no_such_module")
    assert needed("sys") is sys


def test_the_required_run_of_a_missing_module_fails(tmp_path):
    """A run of pytest of its own, in which `mypy` cannot be imported."""
    (tmp_path / "mypy.py").write_text("raise ImportError('hidden')\n")
    here = pathlib.Path(__file__).parent
    for required, outcome in (("0", "1 skipped"), ("1", "1 failed")):
        done = subprocess.run([sys.executable, "-m", "pytest", "-q", "-p", "no:cacheprovider", str(here / "test_docs.py"), "-k", "test_types"],
                              capture_output=True, text=True, timeout=120, cwd=tmp_path,
                              env={**os.environ, "ALGAE_REQUIRE": required,
                                   "PYTHONPATH": f"{tmp_path}:{os.environ.get('PYTHONPATH', '')}"})
        assert outcome in done.stdout, done.stdout


def test_no_test_skips_by_itself():
    """Each test that needs a module asks `needed`, which ALGAE_REQUIRE governs."""
    for path in pathlib.Path(__file__).parent.glob("*.py"):
        if path != pathlib.Path(__file__):
            assert not re.search(r"importorskip|skipif", path.read_text()), path.name


def test_the_tools_install_what_the_tests_need(source):
    asked = {one for path in (source / "tests" / "python").glob("test_*.py") if path != pathlib.Path(__file__)
             for one in re.findall(r'needed\("(\w+)"', path.read_text())}
    assert asked >= {"mypy", "nbclient", "sympy", "networkx", "pandas"}
    tool = (source / "tools" / "python").read_text()
    assert "ALGAE_REQUIRE=1" in tool
    for name in asked:
        assert re.search(rf"(python3-)?{name}\b", tool), name
