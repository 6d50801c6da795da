"""What the tests of the Python package share: where the sources are, the built command to compare with, and modules that some tests need.

tools/test installs the light ones of these modules; where one is missing its tests are skipped. tools/python installs all and sets
ALGAE_REQUIRE=1, with which a missing one fails.
"""

import importlib
import json
import os
import pathlib
import shutil
import subprocess

import hypothesis
import pytest

hypothesis.settings.register_profile("algae", database=None, deadline=None)
hypothesis.settings.load_profile("algae")

SOURCE = pathlib.Path(__file__).resolve().parents[2]
COMMAND = os.environ.get("ALGAE_COMMAND", str(SOURCE / "build" / "release" / "algae"))


def needed(name, package=None):
    """The module; the test is skipped where it is missing, or fails with ALGAE_REQUIRE=1."""
    try:
        return importlib.import_module(name)
    except ImportError:
        missing(name, package or "python3-" + name)


def program(name, package=None):
    """The path of a program, otherwise as for a module."""
    return shutil.which(name) or missing(name, package or name)


def missing(name, package):
    said = f"{name} is not installed (Debian: {package})"
    if os.environ.get("ALGAE_REQUIRE") == "1":
        pytest.fail(f"{said}, and ALGAE_REQUIRE=1 requires it")
    pytest.skip(said)


@pytest.fixture(scope="session")
def source():
    return SOURCE


@pytest.fixture(scope="session")
def command():
    """Runs the command and gives what it prints as JSON, or None where it ends with an error."""
    if not os.path.exists(COMMAND):
        pytest.fail(f"{COMMAND} is not built: ALGAE_COMMAND says where the command is")

    def run(*arguments, plain=False):
        done = subprocess.run([COMMAND, *arguments], capture_output=True, text=True, timeout=300)
        if done.returncode not in (0, 1, 3) or not done.stdout:
            return None
        return done.stdout if plain else json.loads(done.stdout)

    return run
