"""The package as a whole: types, examples, and what the compiled module shows of itself."""

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
PACKAGE = os.path.dirname(meetc.__file__)
EXAMPLES = os.path.join(SOURCE, "docs/examples/python")


def run(*words, **options):
    done = subprocess.run(words, capture_output=True, text=True, **options)
    return done.returncode, done.stdout + done.stderr


class Package(unittest.TestCase):
    @unittest.skipUnless(shutil.which("mypy"), "mypy is not installed")
    def test_mypy_accepts_the_package_and_the_examples_and_bites(self):
        examples = [os.path.join(EXAMPLES, name) for name in sorted(os.listdir(EXAMPLES)) if name.endswith(".py")]
        with tempfile.TemporaryDirectory() as folder:
            wrong = os.path.join(folder, "wrong.py")
            with open(wrong, "w", encoding="ascii") as file:
                file.write('import meetc\nmeetc.pairs(1, 2, precision="fp16")\nx: str = meetc.count(3, 4)\n')
            environment = dict(os.environ, MYPYPATH=os.path.dirname(PACKAGE))
            command = ("mypy", "--strict", f"--cache-dir={folder}/cache")
            code, text = run(*command, "-p", "meetc", env=environment)
            self.assertEqual(code, 0, text)
            for example in examples:
                code, text = run(*command, example, env=environment)
                self.assertEqual(code, 0, text)
            code, text = run(*command, wrong, env=environment)
            self.assertEqual((code, len(re.findall(": error: ", text))), (1, 6), text)

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
