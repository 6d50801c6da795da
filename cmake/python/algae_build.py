"""How pip builds a wheel from a clone: CMake makes the package, and its folder is packed.

A backend of its own, as the sources are CMake's: setuptools would want to compile them itself. `ALGAE_BUILD` names a folder that is
configured already, so that nothing is compiled twice.
"""

import base64
import hashlib
import os
import pathlib
import re
import subprocess
import sys
import sysconfig
import tarfile
import zipfile

ROOT = pathlib.Path(__file__).resolve().parents[2]


def version():
    found = re.search(r"^project\(algae VERSION ([0-9.]+) ", (ROOT / "CMakeLists.txt").read_text(encoding="utf-8"), re.M)
    if found is None:
        raise SystemExit("CMakeLists.txt: expected a line `project(algae VERSION ...`")
    return found[1]


def tag():
    python = f"cp{sys.version_info.major}{sys.version_info.minor}"
    return f"{python}-{python}-{sysconfig.get_platform().replace('-', '_').replace('.', '_')}"


def metadata():
    readme = (ROOT / "README.md").read_text(encoding="utf-8")
    return (f"Metadata-Version: 2.1\nName: algae\nVersion: {version()}\n"
            "Summary: L-systems derived exactly, decided, measured and drawn\nLicense: MIT\nRequires-Python: >=3.9\n"
            "Requires-Dist: numpy\nDescription-Content-Type: text/markdown\n\n" + readme)


def built(folder):
    """Builds the package and gives the folder that holds it."""
    build = pathlib.Path(os.environ.get("ALGAE_BUILD", folder))
    if not (build / "CMakeCache.txt").exists():
        generator = ["-G", "Ninja"] if any((pathlib.Path(one) / "ninja").exists() for one in os.get_exec_path()) else []
        subprocess.run(["cmake", "-S", str(ROOT), "-B", str(build), *generator, "-D", "CMAKE_BUILD_TYPE=Release", "-D", "ALGAE_TESTS=OFF",
                        "-D", f"Python3_EXECUTABLE={sys.executable}"], check=True)
    if "ALGAE_PYTHON:BOOL=ON" not in (build / "CMakeCache.txt").read_text(encoding="utf-8"):
        raise SystemExit("Python's headers or pybind11 are missing. On Debian: apt-get install python3-dev pybind11-dev")
    subprocess.run(["cmake", "--build", str(build), "--parallel", str(os.cpu_count() or 1), "--target", "algae_python_package"], check=True)
    return build / "python"


def get_requires_for_build_wheel(config_settings=None):
    return []


def get_requires_for_build_sdist(config_settings=None):
    return []


def prepare_metadata_for_build_wheel(metadata_directory, config_settings=None):
    name = f"algae-{version()}.dist-info"
    folder = pathlib.Path(metadata_directory) / name
    folder.mkdir(parents=True, exist_ok=True)
    (folder / "METADATA").write_text(metadata(), encoding="utf-8")
    (folder / "WHEEL").write_text(wheel_text(), encoding="utf-8")
    return name


def wheel_text():
    return f"Wheel-Version: 1.0\nGenerator: algae\nRoot-Is-Purelib: false\nTag: {tag()}\n"


def build_wheel(wheel_directory, config_settings=None, metadata_directory=None):
    stage = built(ROOT / "build" / "wheel")
    name = f"algae-{version()}-{tag()}.whl"
    info = f"algae-{version()}.dist-info"
    files = {f"algae/{path.name}": path.read_bytes() for path in sorted((stage / "algae").iterdir()) if path.is_file()}
    files[f"{info}/METADATA"] = metadata().encode("utf-8")
    files[f"{info}/WHEEL"] = wheel_text().encode("utf-8")
    files[f"{info}/LICENSE"] = (ROOT / "LICENSE").read_bytes()
    record = []
    with zipfile.ZipFile(pathlib.Path(wheel_directory) / name, "w", zipfile.ZIP_DEFLATED) as out:
        for path, data in files.items():
            digest = base64.urlsafe_b64encode(hashlib.sha256(data).digest()).rstrip(b"=").decode("ascii")
            record.append(f"{path},sha256={digest},{len(data)}\n")
            out.writestr(zipfile.ZipInfo(path, (2020, 1, 1, 0, 0, 0)), data, zipfile.ZIP_DEFLATED)
        record.append(f"{info}/RECORD,,\n")
        out.writestr(zipfile.ZipInfo(f"{info}/RECORD", (2020, 1, 1, 0, 0, 0)), "".join(record))
    return name


def build_sdist(sdist_directory, config_settings=None):
    name = f"algae-{version()}"
    files = subprocess.run(["git", "-C", str(ROOT), "ls-files"], capture_output=True, text=True, check=True).stdout.splitlines()
    with tarfile.open(pathlib.Path(sdist_directory) / f"{name}.tar.gz", "w:gz") as out:
        for path in files:
            out.add(ROOT / path, f"{name}/{path}")
    return f"{name}.tar.gz"
