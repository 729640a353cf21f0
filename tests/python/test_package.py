"""The package as a whole: examples, and what the compiled module shows of itself."""

import os
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

import meetc
from meetc import _native

SOURCE = os.environ["MEETC_SOURCE"]
EXAMPLES = os.path.join(SOURCE, "docs/examples/python")


def run(*words, **options):
    done = subprocess.run(words, capture_output=True, text=True, **options)
    return done.returncode, done.stdout + done.stderr


class Package(unittest.TestCase):
    def test_numpy_2_needs_pybind11_2_12(self):
        program = "import numpy; numpy.__version__ = '2.1.0'; import meetc"
        code, text = run(sys.executable, "-c", program)
        found = re.search(r"compiled with pybind11 2\.(\d+), which does not know NumPy 2\.1\.0: take pybind11 2\.12", text)
        if found:
            self.assertLess(int(found[1]), 12)
            self.assertEqual((code, "ImportError" in text), (1, True), text)
        else:
            self.assertEqual(code, 0, text)
            self.assertGreaterEqual(_native.pybind11, (2, 12))

    def test_the_page_shows_the_examples_and_what_they_print(self):
        with open(os.path.join(SOURCE, "docs/python.md"), encoding="utf-8") as file:
            page = file.read()
        for name in ("touching.py", "contacts.py", "page.py", "bodies.py", "manager.py"):
            path = os.path.join(EXAMPLES, name)
            with open(path, encoding="utf-8") as file:
                self.assertIn(f"<!-- docs/examples/python/{name} -->\n```python\n{file.read()}```\n", page)
            with tempfile.TemporaryDirectory() as folder:
                code, text = run(sys.executable, "-W", "error", path, cwd=folder)
            self.assertEqual(code, 0, text)
            self.assertIn(f"It prints:\n\n```\n{text}```\n", page)

    def test_every_public_name_is_on_the_page(self):
        with open(os.path.join(SOURCE, "docs/python.md"), encoding="utf-8") as file:
            page = file.read()
        for name in meetc.__all__:
            self.assertIn(name, page)

    @unittest.skipUnless(shutil.which("nm") and shutil.which("readelf"), "binutils are not installed")
    def test_the_module_shows_one_symbol_and_needs_the_system_alone(self):
        code, text = run("nm", "-D", "--defined-only", _native.__file__)
        self.assertEqual(code, 0, text)
        names = [line.split()[-1] for line in text.splitlines()]
        self.assertEqual(names, ["PyInit__native"])
        code, text = run("readelf", "-d", _native.__file__)
        needed = re.findall(r"NEEDED.*\[(.*?)\]", text)
        self.assertTrue(needed)
        for library in needed:
            self.assertRegex(library, r"^(libstdc\+\+|libm|libgcc_s|libc|libdl|librt|libpthread|ld-linux.*)[.]so")


if __name__ == "__main__":
    unittest.main()
