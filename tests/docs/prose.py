"""prose.py TREE: the rules of prose and of files that a program can check. A line for each fault; the exit code is 1 if there is one.

- No sentence of a page, a comment or a message begins with "Of", and none but a question or a heading with "What".
- A comment, and a line of a page outside of tables, code and links, has at most 128 characters; measured pages are a program's.
- A file of code has at most 400 lines."""

import os
import re
import sys

FOLDERS = ("algebra_spec", "docs", "gen", "runtime", "tests")
PAGES = ("README.md", "CHANGELOG.md", "dev")
ENDINGS = (".awk", ".c", ".cmake", ".cpp", ".cu", ".cuh", ".gp", ".h", ".hpp", ".md", ".py", ".sh", ".toml", ".txt", ".v")
CODE = (".awk", ".c", ".cmake", ".cpp", ".cu", ".cuh", ".h", ".hpp", ".py", ".sh")
LONGEST_LINE, LONGEST_FILE = 128, 400

START = r'(?:^|[.:;!?|] |// |# |- |\(\* |"|\*\* )'
OF = re.compile(START + "Of" + r" [^ ]")
WHAT = re.compile(START + "What" + r" [^ ]")


def mark_of(path):
    if path.endswith((".awk", ".sh", ".py", ".cmake", ".txt", ".toml", ".gp")) or path == "dev":
        return "#"
    return "(*" if path.endswith(".v") else "//"


def faults(path, text):
    """(line, fault) for each fault of the file with this path and text."""
    lines = text.split("\n")
    page, fenced = path.endswith(".md"), False
    for number, line in enumerate(lines, 1):
        if page and line.startswith("```"):
            fenced = not fenced
        if page and (fenced or line.startswith("#")):
            continue
        if OF.search(line):
            yield number, 'a sentence begins with "Of"'
        if WHAT.search(line) and "?" not in line:
            yield number, 'a relative clause begins a sentence: "What"'
        if path.startswith("docs/measured/"):
            prose = False
        elif page:
            prose = not line.startswith(("|", "!", "<!--")) and not re.search(r"https?:", line)
        else:
            prose = line.lstrip().startswith(mark_of(path))
        if prose and len(line) > LONGEST_LINE:
            yield number, f"a line of {len(line)} characters"
    if path.endswith(CODE) and text.count("\n") > LONGEST_FILE:
        yield LONGEST_FILE + 1, f"a file of {text.count(chr(10))} lines"


def paths_of(tree):
    yield from (p for p in PAGES if os.path.exists(os.path.join(tree, p)))
    for top in FOLDERS:
        for folder, folders, files in os.walk(os.path.join(tree, top)):
            folders[:] = sorted(f for f in folders if f != "__pycache__")
            for name in sorted(files):
                path = os.path.relpath(os.path.join(folder, name), tree)
                if name.endswith(ENDINGS) and name != "test_prose.py": # which plants faults
                    yield path


def main():
    tree = sys.argv[1]
    count = read = 0
    for path in paths_of(tree):
        read += 1
        with open(os.path.join(tree, path), encoding="utf-8") as file:
            for number, fault in faults(path, file.read()):
                print(f"{path}:{number}: {fault}")
                count += 1
    print(f"{count} faults in the prose of {read} files")
    return 1 if count or read < 500 else 0


if __name__ == "__main__":
    sys.exit(main())
