#!/usr/bin/env python3
"""Which heavy tests are to be run, and what they said.

tests/heavy.txt holds the hash, the seconds and the name of each heavy test, as the long mode ran it. A test whose hash
differs is run; one that has passed in this build since, with the hash that it has now, is not run again."""

import argparse
import fcntl
import os
import subprocess
import sys
import time

from declared import Build

SKIPPED = 77


def list_file(build):
    return os.path.join(build.source, "tests", "heavy.txt")


def listed(build):
    """name -> (hash, seconds) of the checked-in list."""
    if not os.path.exists(list_file(build)):
        return {}
    with open(list_file(build), encoding="utf-8") as file:
        lines = [line.split() for line in file if line.strip() and not line.startswith("#")]
    return {name: (digest, int(seconds)) for digest, seconds, name in lines}


def passed(build, name):
    """(hash, seconds) of the last time that the test passed in this build."""
    if not os.path.exists(build.path("passed", name)):
        return None
    with open(build.path("passed", name), encoding="utf-8") as file:
        digest, seconds = file.read().split()
    return digest, int(seconds)


def make(build, targets):
    """Builds the targets, one call at a time."""
    if not targets:
        return 0
    with open(build.path("lock"), "w", encoding="utf-8") as lock:
        fcntl.flock(lock, fcntl.LOCK_EX)
        return subprocess.call(["cmake", "--build", build.folder, "--target"] + sorted(set(targets)))


def prepare(build):
    """Emits what the hashes are of."""
    targets = [t for name in build.tests for t in build.of(name, "prepare")]
    if make(build, targets) != 0:
        raise SystemExit("what the heavy tests read could not be generated")


def differing(build):
    """The tests whose hash differs, with it: first the new ones, then from the shortest to the longest."""
    known = listed(build)
    found = []
    for name in build.tests:
        digest, before = build.hash(name), passed(build, name)
        if digest != known.get(name, ("", 0))[0] and not (before and digest == before[0]):
            found.append((known.get(name, ("", 0))[1], name, digest))
    return [(name, digest) for _, name, digest in sorted(found)]


def select(build, everything, at_once):
    prepare(build)
    chosen = [(n, build.hash(n)) for n in build.tests] if everything else differing(build)
    os.makedirs(build.path("selected"), exist_ok=True)
    for name in os.listdir(build.path("selected")):
        os.remove(build.path("selected", name))
    lines = []
    for number, (name, digest) in enumerate(chosen):
        with open(build.path("selected", name), "w", encoding="utf-8") as file:
            file.write(digest)
        words = [sys.executable, os.path.abspath(__file__), "one", build.folder, name]
        lines.append(f"add_test([=[{name}]=] " + " ".join(f"[=[{w}]=]" for w in words) + ")")
        lines.append(f"set_tests_properties([=[{name}]=] PROPERTIES LABELS heavy SKIP_RETURN_CODE {SKIPPED} TIMEOUT 7200 "
                     f"PROCESSORS {build.value(name, 'processors', '1')} COST -{number + 1} "
                     f"FIXTURES_REQUIRED \"{build.value(name, 'fixture', '')}\")")
    with open(build.path("selected.cmake"), "w", encoding="utf-8") as file:
        file.write("\n".join(lines) + "\n")
    if os.path.exists(build.path("left")):
        os.remove(build.path("left"))
    print(f"{len(chosen)} of {len(build.tests)} heavy tests " + ("are chosen" if everything else "have changed") +
          ("" if everything or not chosen else ": " + " ".join(n for n, _ in chosen)))
    if at_once and make(build, [t for n, _ in chosen for t in build.of(n, "build")]) != 0:
        raise SystemExit("the heavy tests could not be built")


def one(build, name):
    """Builds and runs a test that was selected, unless it is too late. A selected test must pass."""
    until = os.environ.get("MEETC_HEAVY_UNTIL")
    if until and time.time() + listed(build).get(name, ("", 0))[1] >= float(until):
        with open(build.path("left"), "a", encoding="utf-8") as file:
            file.write(name + "\n")
        print(f"SKIPPED: no time was left for {name}")
        return SKIPPED
    with open(build.path("selected", name), encoding="utf-8") as file:
        digest = file.read()
    begin = time.time()
    if make(build, build.of(name, "build")) != 0:
        print(f"FAILED: {name} could not be built")
        return 1
    folder = build.path("room", name)
    os.makedirs(folder, exist_ok=True)
    try:
        status = subprocess.call(build.of(name, "command"), cwd=folder, timeout=int(build.value(name, "timeout", "1500")))
    except subprocess.TimeoutExpired:
        print(f"FAILED: {name} took too long")
        return 1
    if status == 0:
        if build.hash(name) != digest:
            print(f"FAILED: what {name} consists of has changed while it ran")
            return 1
        os.makedirs(build.path("passed"), exist_ok=True)
        with open(build.path("passed", name), "w", encoding="utf-8") as file:
            file.write(f"{digest} {round(time.time() - begin)}\n")
    return status


def left(build):
    if os.path.exists(build.path("left")):
        with open(build.path("left"), encoding="utf-8") as file:
            names = file.read().split()
        print(f"{len(names)} heavy tests are left, which `./dev test --long` runs: " + " ".join(sorted(names)))


def write(build, sanitized):
    """Writes the list of what has passed as it is, in which the tests under sanitizers are those of another build. Returns 1
    where something has not passed."""
    prepare(build)
    old, new, missing = listed(build), {}, []
    for name in build.tests:
        digest = build.hash(name)
        entry = next((e for e in (passed(build, name), old.get(name)) if e and e[0] == digest), None)
        if entry:
            new[name] = entry
        else:
            missing.append(name)
    new.update({n: e for n, e in old.items() if n.startswith("sanitize.") != sanitized})
    with open(list_file(build) + ".new", "w", encoding="utf-8") as file:
        file.write("# Written by `./dev test --long`: the hash of all that a heavy test consists of, when it passed; its "
                   "seconds; its name.\n")
        for name, (digest, seconds) in sorted(new.items()):
            file.write(f"{digest} {seconds:5} {name}\n")
    os.rename(list_file(build) + ".new", list_file(build))
    if missing:
        print(f"{len(missing)} heavy tests have not passed as they are: " + " ".join(missing))
    return 1 if missing else 0


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    commands = parser.add_subparsers(dest="command", required=True)
    for name, text in [("select", "choose what CTest runs"), ("one", "build and run one test"),
                       ("left", "say for which tests no time was left"), ("write", "write tests/heavy.txt"),
                       ("facts", "print what the hash of a test is of")]:
        commands.add_parser(name, help=text).add_argument("build")
    commands.choices["select"].add_argument("--all", action="store_true", help="whatever the hashes are")
    commands.choices["select"].add_argument("--build", action="store_true", dest="at_once", help="build them at once")
    commands.choices["write"].add_argument("--sanitized", action="store_true")
    for name in ("one", "facts"):
        commands.choices[name].add_argument("name")
    asked = parser.parse_args()
    build = Build(asked.build)
    if asked.command == "select":
        select(build, asked.all, asked.at_once)
    elif asked.command == "one":
        sys.exit(one(build, asked.name))
    elif asked.command == "left":
        left(build)
    elif asked.command == "write":
        sys.exit(write(build, asked.sanitized))
    else:
        print("\n".join(build.facts(asked.name)))


if __name__ == "__main__":
    main()
