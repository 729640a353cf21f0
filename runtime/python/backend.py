"""The build backend of the package meetc, as PEP 517 has it: CMake compiles and installs, and the rest is a zip file.

It writes nothing into the source tree. Settings, as in `python3 -m build --wheel -C build-dir=build-python`:
build-dir         the folder to compile in, which is kept; without it a temporary one
cuda              ON: with queries on CUDA devices; by default OFF, or what the folder has
instruction-sets  those of x86-64 that are compiled beside the baseline; by default avx2;avx512, or what the folder has
"""

from __future__ import annotations

import os
import re
import subprocess
import sys
import sysconfig
import tarfile
import tempfile
from io import BytesIO
from pathlib import Path

SOURCE = Path(__file__).resolve().parents[2]
METADATA = """\
Metadata-Version: 2.1
Name: meetc
Version: {version}
Summary: Which triangles, segments, spheres and boxes of two models touch, with proved answers
License: MIT
Requires-Python: >=3.9
Requires-Dist: numpy >=1.21
Description-Content-Type: text/markdown

"""


def _version() -> str:
    found = re.search(r"project\(meetc VERSION ([0-9.]+)", (SOURCE / "CMakeLists.txt").read_text(encoding="utf-8"))
    if not found:
        raise RuntimeError("CMakeLists.txt names no version")
    return found[1]


def _metadata() -> str:
    return METADATA.format(version=_version()) + (SOURCE / "docs/python.md").read_text(encoding="utf-8")


def _compile(folder: Path, into: Path, settings: dict[str, str]) -> None:
    """Compiles in `folder` and installs the package below `into`."""
    import pybind11

    options = {
        "CMAKE_BUILD_TYPE": "Release",
        "MEETC_BUILD_PYTHON": "ON",
        "MEETC_BUILD_GENERATOR": "OFF",
        "MEETC_BUILD_TESTS": "OFF",
        "Python_EXECUTABLE": sys.executable,
        "pybind11_DIR": pybind11.get_cmake_dir(),
    }
    if "cuda" in settings or not (folder / "CMakeCache.txt").exists():
        options["MEETC_CUDA"] = settings.get("cuda", "OFF")
    if "instruction-sets" in settings:
        options["MEETC_INSTRUCTION_SETS"] = settings["instruction-sets"]
    words = [f"-D{name}={value}" for name, value in options.items()]
    subprocess.run(["cmake", "-S", SOURCE, "-B", folder, *words], check=True)
    subprocess.run(["cmake", "--build", folder, "--target", "meetc_python", "--parallel", str(os.cpu_count())], check=True)
    subprocess.run(["cmake", "--install", folder, "--component", "meetc_python", "--prefix", into], check=True)


def build_wheel(
    wheel_directory: str, config_settings: dict[str, str] | None = None, metadata_directory: str | None = None
) -> str:
    from wheel.wheelfile import WheelFile

    settings = config_settings or {}
    python = f"cp{sys.version_info.major}{sys.version_info.minor}"
    tag = f"{python}-{python}-{re.sub('[-.]', '_', sysconfig.get_platform())}"
    name = f"meetc-{_version()}-{tag}.whl"
    with tempfile.TemporaryDirectory() as temporary:
        stage = Path(temporary, "stage")
        _compile(Path(settings.get("build-dir", Path(temporary, "build"))).resolve(), stage, settings)
        info = stage / f"meetc-{_version()}.dist-info"
        info.mkdir()
        (info / "METADATA").write_text(_metadata(), encoding="utf-8")
        lines = ("Wheel-Version: 1.0", "Generator: meetc", "Root-Is-Purelib: false", f"Tag: {tag}", "")
        (info / "WHEEL").write_text("\n".join(lines), encoding="ascii")
        (info / "LICENSE").write_bytes((SOURCE / "LICENSE").read_bytes())
        with WheelFile(Path(wheel_directory, name), "w") as wheel:
            wheel.write_files(stage)
    return name


def build_sdist(sdist_directory: str, config_settings: dict[str, str] | None = None) -> str:
    """The files that git tracks."""
    root = f"meetc-{_version()}"
    listed = subprocess.run(["git", "ls-files", "-z"], cwd=SOURCE, check=True, capture_output=True, text=True).stdout
    with tarfile.open(Path(sdist_directory, f"{root}.tar.gz"), "w:gz", format=tarfile.PAX_FORMAT) as archive:
        for path in filter(None, listed.split("\0")):
            archive.add(SOURCE / path, f"{root}/{path}", recursive=False)
        text = _metadata().encode()
        entry = tarfile.TarInfo(f"{root}/PKG-INFO")
        entry.size = len(text)
        archive.addfile(entry, BytesIO(text))
    return f"{root}.tar.gz"
