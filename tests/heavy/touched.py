#!/usr/bin/env python3
"""touched.py BUILD HOST COMMIT NAME...: prints the objects of CUDA code in BUILD that what has changed since COMMIT may change,
and those of the sources with a NAME. Without a commit (an empty one) only those with a name. HOST is the build without CUDA;
what that has as well is left out."""

import os
import subprocess
import sys

import closure

OF_THE_DEVICE = os.path.join("runtime", "core", "device") + os.sep


def changed_since(commit, source):
    if not commit:
        return set()
    names = subprocess.run(["git", "diff", "--name-only", commit], cwd=source, capture_output=True, text=True, check=True)
    new = subprocess.run(["git", "ls-files", "--others", "--exclude-standard"], cwd=source, capture_output=True, text=True,
                         check=True)
    return {os.path.join(source, n) for n in (names.stdout + new.stdout).splitlines()}


def main():
    build, host, commit, names = os.path.realpath(sys.argv[1]), sys.argv[2], sys.argv[3], sys.argv[4:]
    there = {unit.output for units in closure.units_of(host).values() for unit in units}
    source = os.path.realpath(os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", ".."))
    changed, found = changed_since(commit, source), closure.Closure([source, build])
    for unit in (u for units in closure.units_of(build).values() for u in units):
        if not os.path.isfile(unit.source):
            continue
        files = unit.files(found)
        with open(unit.source, encoding="utf-8", errors="replace") as file:
            asks = "MEETC_WITH_CUDA" in file.read()
        by_nvcc = "nvcc" in os.path.basename(unit.compiler)
        of_the_device = any(f.startswith(os.path.join(source, OF_THE_DEVICE)) for f in files)
        if not (by_nvcc or asks or (of_the_device and unit.output not in there)):
            continue
        # Whole programs are built before what a test compiles for the host here. The long mode does that.
        if not by_nvcc and unit.source.startswith(os.path.join(source, "tests") + os.sep):
            continue
        # Flags are written where the target is; all of them are CUDA's only there.
        flags = os.path.join(source, unit.output.split("CMakeFiles")[0], "CMakeLists.txt")
        if os.path.basename(unit.source) in names or flags in changed or not changed.isdisjoint(files):
            print(unit.output)


if __name__ == "__main__":
    main()
