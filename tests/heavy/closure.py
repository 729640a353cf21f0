"""Which files a compilation reads: the source, and all that it includes, found without running the compiler.

Every #include of a file is followed, whatever #if it stands under, so the result may hold more than the compiler reads and
never less (test_heavy.py compares them). Files outside the project are left to the versions of compilers and packages."""

import json
import os
import re
import shlex

INCLUDE = re.compile(rb'^[ \t]*#[ \t]*include(?:_next)?[ \t]*(?:"([^"\n]+)"|<([^>\n]+)>|(\S+))', re.MULTILINE)
INCLUDE_FOLDERS = ("-I", "-isystem", "-iquote")
SOURCES = (".c", ".cpp", ".cu", ".cxx", ".h", ".hpp", ".hxx")


class Closure:
    def __init__(self, roots):
        self.roots = tuple(os.path.realpath(r) + os.sep for r in roots)
        self.names = {}  # file -> what it includes, as written

    def is_ours(self, path):
        return path.startswith(self.roots)

    def includes(self, path):
        if path not in self.names:
            with open(path, "rb") as file:
                text = file.read().replace(b"\\\n", b"")
            found = []
            for quoted, pointed, other in INCLUDE.findall(text):
                if other:
                    raise SystemExit(f"{path}: includes what no reader of the text knows: {other.decode()}")
                found.append(((quoted or pointed).decode(), bool(quoted)))
            self.names[path] = found
        return self.names[path]

    @staticmethod
    def found(name, folders):
        return next((p for p in (os.path.join(folder, name) for folder in folders) if os.path.isfile(p)), None)

    def of(self, sources, folders):
        """The files of the project that `sources` consist of, when `folders` are searched for headers."""
        seen, todo = set(), [os.path.realpath(s) for s in sources]
        while todo:
            path = todo.pop()
            if path in seen or not self.is_ours(path):
                continue
            seen.add(path)
            if not path.endswith(SOURCES):
                continue
            for name, quoted in self.includes(path):
                header = self.found(name, ([os.path.dirname(path)] if quoted else []) + folders)
                if header:
                    todo.append(os.path.realpath(header))
        return seen


class Unit:
    """One line of compile_commands.json."""

    def __init__(self, entry):
        words = shlex.split(entry["command"])
        words = words[next(i for i, w in enumerate(words) if "ccache" not in os.path.basename(w)) :]
        self.folder, self.source, self.output = entry["directory"], entry["file"], ""
        self.compiler, self.flags = words[0], []
        self.folders, self.first = [], []  # searched for headers; included before all else
        rest = iter(words[1:])
        for word in rest:
            if word == "-o":
                self.output = next(rest)
            elif word == "-c":
                next(rest)
            elif word == "-include":
                self.first.append(next(rest))
                self.flags += [word, self.first[-1]]
            elif word in INCLUDE_FOLDERS:
                self.folders.append(self.path(next(rest)))
                self.flags += [word, self.folders[-1]]
            else:
                self.flags.append(word)
                for option in INCLUDE_FOLDERS:
                    if word.startswith(option) and word != option:
                        self.folders.append(self.path(word[len(option) :].lstrip("=")))

    def path(self, name):
        return os.path.normpath(os.path.join(self.folder, name))

    def files(self, closure):
        first = [closure.found(name, [self.folder] + self.folders) for name in self.first]
        return closure.of([self.source] + [f for f in first if f], self.folders)


def units_of(build):
    """The compilations of a build, by the folder of their objects: "gen/CMakeFiles/meetc.dir"."""
    units = {}
    with open(os.path.join(build, "compile_commands.json"), encoding="utf-8") as file:
        for entry in json.load(file):
            unit = Unit(entry)
            units.setdefault(re.match(r".*?CMakeFiles/[^/]+[.]dir", unit.output).group(), []).append(unit)
    return units
