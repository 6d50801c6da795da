"""What the tests of the Python package share: where the sources are, and the built command to compare with."""

import json
import os
import pathlib
import subprocess

import hypothesis
import pytest

hypothesis.settings.register_profile("algae", database=None, deadline=None)
hypothesis.settings.load_profile("algae")

SOURCE = pathlib.Path(__file__).resolve().parents[2]
COMMAND = os.environ.get("ALGAE_COMMAND", str(SOURCE / "build" / "release" / "algae"))


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
