#!/usr/bin/env python3
"""test_heavy.py BUILD: a heavy test is run again whenever something has changed that it consists of, and else not."""

import json
import os
import shutil
import subprocess
import sys
import tempfile
import unittest
from unittest import mock

import closure
import declared
import heavy

BUILD = ""
COPIED = (".json", ".hxx", ".cxx", ".cpp", ".hpp", ".h", ".cu", ".gappa", ".toml")


def write(path, text):
    os.makedirs(os.path.dirname(path), exist_ok=True)
    with open(path, "w", encoding="utf-8") as file:
        file.write(text)


def read_by_compilers(build):
    """The files that compilers have read, as they told ninja: object -> files. An object that is older than one of them, or
    than a file that is gone, is compiled anew before it is run, and is not among them."""
    said = subprocess.run(["ninja", "-C", build, "-t", "deps"], capture_output=True, text=True, check=True).stdout
    found, current = {}, None
    for line in said.splitlines():
        if line.startswith("    "):
            path = os.path.normpath(os.path.join(build, line.strip()))
            current.append(os.path.realpath(path))
        elif ": #deps" in line:
            current = found.setdefault(line.split(": #deps")[0], []) if "(VALID)" in line else []

    def is_made(output, files):
        made = os.path.getmtime(os.path.join(build, output))
        return all(os.path.exists(f) and os.path.getmtime(f) <= made for f in files)

    return {output: files for output, files in found.items() if is_made(output, files)}


def copy_of(build, to):
    """The project and what the build has generated, elsewhere."""
    source, folder = os.path.join(to, "source"), os.path.join(to, "source", "a build")
    names = subprocess.run(["git", "ls-files", "-z", "--cached", "--others", "--exclude-standard"], cwd=build.source,
                           capture_output=True, text=True, check=True).stdout.split("\0")
    for name in filter(None, names):
        if os.path.isfile(os.path.join(build.source, name)):
            os.makedirs(os.path.dirname(os.path.join(source, name)), exist_ok=True)
            shutil.copy(os.path.join(build.source, name), os.path.join(source, name))
    for at, folders, files in os.walk(build.folder):
        folders[:] = [f for f in folders if f not in ("room", "Testing", "_deps") and not f.startswith("room of ")]
        for link in (os.path.join(at, f) for f in folders if os.path.islink(os.path.join(at, f))):
            there = os.path.relpath(os.path.realpath(link), build.source)
            if not there.startswith(".."):  # such as the folder by whose name the runtime is included
                here = os.path.join(folder, os.path.relpath(link, build.folder))
                os.makedirs(os.path.dirname(here), exist_ok=True)
                os.symlink(os.path.join(source, there), here)
        for file in files:
            path = os.path.join(at, file)
            if file.endswith(COPIED) or os.path.join("heavy", "declared") in at:
                with open(path, encoding="utf-8", errors="surrogateescape") as old:
                    text = old.read()
                if path.startswith(os.path.join(build.folder, "compile_commands")):
                    entries = json.loads(text)
                    for e in entries:  # of the name's blank
                        e["command"] = e["command"].replace(build.folder, "'" + folder + "'").replace(build.source, source)
                        for key in ("directory", "file"):
                            e[key] = e[key].replace(build.folder, folder).replace(build.source, source)
                    text = json.dumps(entries)
                else:
                    text = text.replace(build.folder, folder).replace(build.source, source)
                target = os.path.join(folder, os.path.relpath(path, build.folder))
                os.makedirs(os.path.dirname(target), exist_ok=True)
                with open(target, "w", encoding="utf-8", errors="surrogateescape") as new:
                    new.write(text)
    return declared.Build(folder)


class Includes(unittest.TestCase):
    def setUp(self):
        self.root = os.path.realpath(tempfile.mkdtemp())
        self.addCleanup(shutil.rmtree, self.root)

    def of(self, files, flags=""):
        for name, text in files.items():
            write(os.path.join(self.root, name), text)
        unit = closure.Unit({"directory": self.root, "file": os.path.join(self.root, "a.cpp"),
                             "command": f"ccache g++ {flags} -o a.o -c {self.root}/a.cpp"})
        self.assertEqual((unit.compiler, unit.output), ("g++", "a.o"))
        return {os.path.relpath(f, self.root) for f in unit.files(closure.Closure([self.root]))}

    def test_every_include_counts_whatever_it_depends_on(self):
        files = {"a.cpp": '#if 0\n#  include "b.hpp"\n#endif\n #include <in/c.hpp>\n#include <vector>\n', "b.hpp": "",
                 "x/in/c.hpp": '#include "d.hpp"\n', "x/in/d.hpp": "#include \\\n  <e.hpp>\n", "e.hpp": "", "f.hpp": "",
                 "x/g.hpp": ""}
        self.assertEqual(self.of(files, f"-isystem {self.root}/x -I{self.root} -include f.hpp -include g.hpp"),
                         {"a.cpp", "b.hpp", "x/in/c.hpp", "x/in/d.hpp", "e.hpp", "f.hpp", "x/g.hpp"})

    def test_the_first_folder_with_a_header_counts(self):
        files = {"a.cpp": '#include "b.hpp"\n#include <c.hpp>\n', "b.hpp": "", "x/b.hpp": "", "x/c.hpp": "", "y/c.hpp": ""}
        self.assertEqual(self.of(files, f"-I {self.root}/x -I{self.root}/y"), {"a.cpp", "b.hpp", "x/c.hpp"})

    def test_a_computed_include_is_refused(self):
        with self.assertRaises(SystemExit):
            self.of({"a.cpp": "#include HEADER\n"})


class Declared(unittest.TestCase):
    """The tests of this build."""

    @classmethod
    def setUpClass(cls):
        cls.build = declared.Build(BUILD)
        heavy.prepare(cls.build)
        cls.inputs = {name: cls.build.inputs(name) for name in cls.build.tests}

    def test_what_the_compilers_read_is_among_the_inputs(self):
        read, compared = read_by_compilers(self.build.folder), 0
        for name in self.build.tests:
            for unit in self.build.compilations(name):
                files = {f for f in read.get(unit.output, []) if self.build.closure.is_ours(f) and not f.endswith(".gch")}
                self.assertLessEqual(files, self.inputs[name], f"{name}: {unit.output}")
                compared += len(files)
        self.assertGreater(compared, 1000)

    def test_the_hash_is_the_same_elsewhere_and_changes_with_each_input(self):
        with tempfile.TemporaryDirectory() as folder:
            copy = copy_of(self.build, os.path.realpath(folder))
            inputs = {name: copy.inputs(name) for name in copy.tests}
            for name in copy.tests:
                self.assertEqual(copy.hash(name), self.build.hash(name), name)
                self.assertEqual({copy.relative(f) for f in inputs[name]}, {self.build.relative(f) for f in self.inputs[name]})
            # The flags stay, and so do the names of what is included.
            with mock.patch.object(copy, "inputs", inputs.get), mock.patch.object(copy, "compilations", lambda _: []):
                before = {name: copy.hash(name) for name in copy.tests}
                for path in set().union(*inputs.values()):
                    with open(path, "ab") as file:
                        file.write(b"\n")
                    known = copy.digests.pop(path)
                    for name in copy.tests:
                        changes = self.assertNotEqual if path in inputs[name] else self.assertEqual
                        changes(copy.hash(name), before[name], f"{name}: {path}")
                    copy.digests[path] = known

    def test_the_hash_changes_with_flags_and_tools(self):
        for name in self.build.tests:
            before, units = self.build.hash(name), self.build.compilations(name)
            for unit in units[:3]:
                unit.flags.append("-DANOTHER")
                self.assertNotEqual(self.build.hash(name), before, name)
                unit.flags.remove("-DANOTHER")
            for tool in self.build.of(name, "tools") + [u.compiler for u in units[:1]]:
                other = lambda asked, tool=tool, real=declared.version: "another" if asked == tool else real(asked)
                with mock.patch.object(declared, "version", other):
                    self.assertNotEqual(self.build.hash(name), before, f"{name}: {tool}")
            self.assertTrue(units or self.build.of(name, "tools"), name)
            self.assertEqual(self.build.hash(name), before)


class Choice(unittest.TestCase):
    """Which tests are run, in a project of two."""

    def setUp(self):
        self.root = os.path.realpath(tempfile.mkdtemp())
        self.addCleanup(shutil.rmtree, self.root)
        self.folder = os.path.join(self.root, "build")
        write(os.path.join(self.folder, "compile_commands.json"), "[]")
        for name, command in (("good", "true"), ("slow", "sleep 9"), ("wrong", "false")):
            write(os.path.join(self.root, name + ".txt"), name)
            words = "".join(f"command {w}\n" for w in command.split())
            write(os.path.join(self.folder, "heavy", "declared", name),
                  f"source {self.root}\n{words}inputs {self.root}/{name}.txt\ntools {sys.executable}\ntimeout 1\n")

    def call(self, *words, **environment):
        said = subprocess.run([sys.executable, heavy.__file__, *words], capture_output=True, text=True, check=False,
                              env={**os.environ, "MEETC_HEAVY_UNTIL": "", **environment})
        return said.returncode, said.stdout + said.stderr

    def chosen(self, *options):
        status, said = self.call("select", self.folder, *options)
        self.assertEqual(status, 0, said)
        with open(os.path.join(self.folder, "heavy", "selected.cmake"), encoding="utf-8") as file:
            return [line.split("[=[")[1].split("]=]")[0] for line in file if line.startswith("add_test(")]

    def test_what_has_passed_is_chosen_again_when_it_changes(self):
        self.assertEqual(self.chosen(), ["good", "slow", "wrong"])
        self.assertEqual(self.call("one", self.folder, "good")[0], 0)
        self.assertEqual(self.chosen(), ["slow", "wrong"])
        self.assertEqual(self.chosen("--all"), ["good", "slow", "wrong"])
        write(os.path.join(self.root, "good.txt"), "other")
        self.assertEqual(self.chosen(), ["good", "slow", "wrong"])

    def test_what_fails_or_takes_too_long_does_not_pass(self):
        self.chosen()
        self.assertNotEqual(self.call("one", self.folder, "wrong")[0], 0)
        status, said = self.call("one", self.folder, "slow")
        self.assertNotEqual(status, 0)
        self.assertIn("took too long", said)
        self.assertEqual(self.chosen(), ["good", "slow", "wrong"])
        os.makedirs(os.path.join(self.root, "tests"))
        self.assertEqual(self.call("one", self.folder, "good")[0], 0)
        status, said = self.call("write", self.folder)
        self.assertEqual((status, said.strip()), (1, "2 heavy tests have not passed as they are: slow wrong"))
        with open(os.path.join(self.root, "tests", "heavy.txt"), encoding="utf-8") as file:
            self.assertEqual([line.split()[2] for line in file if not line.startswith("#")], ["good"])

    def test_what_is_too_late_is_named(self):
        self.chosen()
        self.assertEqual(self.call("one", self.folder, "good", MEETC_HEAVY_UNTIL="1")[0], heavy.SKIPPED)
        self.assertIn("1 heavy tests are left", self.call("left", self.folder)[1])
        self.assertIn("good", self.chosen())

    def test_the_list_is_what_is_known_of_other_builds(self):
        for name in ("slow", "wrong"):
            os.remove(os.path.join(self.folder, "heavy", "declared", name))
        os.makedirs(os.path.join(self.root, "tests"))
        write(os.path.join(self.root, "tests", "heavy.txt"), "0123456789abcdef 7 sanitize.other\n0 1 gone\n0 1 good\n")
        self.assertEqual(self.chosen(), ["good"])
        self.assertEqual(self.call("one", self.folder, "good")[0], 0)
        self.assertEqual(self.call("write", self.folder)[0], 0)
        with open(os.path.join(self.root, "tests", "heavy.txt"), encoding="utf-8") as file:
            self.assertEqual([line.split()[2] for line in file if not line.startswith("#")], ["good", "sanitize.other"])
        shutil.rmtree(os.path.join(self.folder, "heavy", "passed"))
        self.assertEqual(self.chosen(), [])

    def test_a_file_that_is_not_there_is_an_error(self):
        os.remove(os.path.join(self.root, "good.txt"))
        self.assertIn("good.txt is not there", self.call("select", self.folder)[1])


if __name__ == "__main__":
    BUILD = sys.argv.pop(1)
    unittest.main()
