"""A wheel is built from the clone by pip without a network, and works where it is installed."""

import os
import pathlib
import subprocess
import sys

import pytest

import algae
from conftest import needed

BUILD = pathlib.Path(algae.__file__).resolve().parents[2]  # of the package that is tested, BUILD/python/algae


def test_pip_installs_a_wheel_without_a_network(source, tmp_path):
    for module in ("setuptools", "pip", "wheel"):  # setuptools replaces a module that pip imports
        needed(module)
    if not (BUILD / "CMakeCache.txt").exists():
        pytest.skip("the package is not in the folder that it was built in")
    environment = {**os.environ, "ALGAE_BUILD": str(BUILD), "PIP_NO_INDEX": "1", "PIP_DISABLE_PIP_VERSION_CHECK": "1"}
    environment.pop("PYTHONPATH", None)
    place = tmp_path / "installed"
    done = subprocess.run([sys.executable, "-m", "pip", "install", "--no-build-isolation", "--no-deps", "--target", str(place), "."],
                          cwd=source, env=environment, capture_output=True, text=True, timeout=3000)
    assert done.returncode == 0, done.stdout + done.stderr
    script = "import algae; print(algae.__version__, algae.__file__, algae.LSystem('a -> ab, b -> a').derive(5))"
    run = subprocess.run([sys.executable, "-c", script], env={**environment, "PYTHONPATH": str(place)}, cwd=tmp_path,
                         capture_output=True, text=True, timeout=120)
    assert run.returncode == 0, run.stderr
    version, file, word = run.stdout.split()
    assert version == algae.__version__ and file.startswith(str(place)) and word == "abaababaabaab"
    assert list(place.glob(f"algae-{algae.__version__}.dist-info"))
