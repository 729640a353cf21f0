#!/usr/bin/env python3
"""page.py PAGE FOLDER [--cuda] [--write]: runs the commands of a page in a folder, and compares what they print.

A fenced block behind `<!-- run -->` holds commands, which must succeed; one behind `<!-- run with CUDA -->` is run with --cuda
alone, and may say `device: ...` and exit with 3 where there is no device. If the next block stands behind `<!-- prints -->`, it
is the standard output of the commands. --write puts the output there instead of comparing it."""

import argparse
import subprocess
import sys

RUN, RUN_CUDA, PRINTS = "<!-- run -->", "<!-- run with CUDA -->", "<!-- prints -->"


def blocks(lines):
    """(mark, first line, line behind the last) of each fenced block that follows a mark."""
    found, mark, begin = [], None, None
    for i, line in enumerate(lines):
        if begin is None and line.startswith("```"):
            mark, begin = (lines[i - 1] if i > 0 else ""), i + 1
        elif begin is not None and line.startswith("```"):
            if mark in (RUN, RUN_CUDA, PRINTS):
                found.append((mark, begin, i))
            begin = None
    return found


def run(commands, folder):
    """Runs the commands. Returns their standard output and exit status."""
    done = subprocess.run(["bash", "-euo", "pipefail", "-c", commands], cwd=folder, capture_output=True, text=True,
                          stdin=subprocess.DEVNULL)
    if done.returncode != 0:
        sys.stderr.write(done.stdout + done.stderr)
    return done.stdout, done.returncode


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("page")
    parser.add_argument("folder")
    parser.add_argument("--cuda", action="store_true")
    parser.add_argument("--write", action="store_true")
    asked = parser.parse_args()
    with open(asked.page, encoding="utf-8") as file:
        lines = file.read().split("\n")
    said, ran, compared, changes = None, 0, 0, []
    no_device = False
    for mark, begin, end in blocks(lines):
        if mark == PRINTS:
            if said is None:
                continue
            text = said.rstrip("\n").split("\n")
            if asked.write:
                changes.append((begin, end, text))
            elif text != lines[begin:end]:
                sys.exit(f"{asked.page}:{begin + 1}: the commands above print\n" + "\n".join(text))
            said, compared = None, compared + 1
            continue
        if mark == RUN_CUDA and not asked.cuda:
            said = None
            continue
        said, status = run("\n".join(lines[begin:end]), asked.folder)
        ran += 1
        if mark == RUN_CUDA and status == 3 and said.startswith("device: "):
            print(said.rstrip())
            said, no_device = None, True
        elif status != 0:
            sys.exit(f"{asked.page}:{begin + 1}: these commands fail")
    for begin, end, text in reversed(changes):
        lines[begin:end] = text
    if asked.write:
        with open(asked.page, "w", encoding="utf-8") as file:
            file.write("\n".join(lines))
    print(f"{asked.page}: {ran} blocks of commands ran, {compared} outputs compared")
    if ran == 0 or (compared == 0 and not no_device):
        sys.exit(f"{asked.page}: nothing was compared")


if __name__ == "__main__":
    main()
