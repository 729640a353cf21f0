#!/usr/bin/env python3
"""The emitted module gives the bytes of the emitted C header, which is compiled without fused multiply-adds.

test_module.py FOLDER COMPILER: FOLDER has what meetc wrote for scene.toml."""

import ctypes
import importlib.util
import os
import subprocess
import sys
import tempfile
import unittest

import numpy as np

SPACE = "shapes_py"
# name, kinds of the operands, the result: a number, or a type
FORMULAS = [
    ("meet_sphere_sphere", "sphere", "sphere", "circle_blade"),
    ("meet_sphere_line", "sphere", "line", "point_pair_blade"),
    ("norm2_meet_sphere_line", "sphere", "line", None),
    ("norm2_meet_sphere_sphere", "sphere", "sphere", None),
    ("meet_circle_plane", "circle", "plane", "point_pair_blade"),
    ("meet_line_line", "line", "line", "lambda_blade"),
    ("half_lambda_lambda", "lambda", "lambda", "half_lambda_lambda_result"),
]
DECISIONS = [
    ("side_triangle_point", "triangle", "point"),
    ("segment_triangle", "segment", "triangle"),
    ("triangle_triangle", "triangle", "triangle"),
    ("ball_ball", "sphere", "sphere"),
]


def python_name(name):
    return name + "_" if name == "lambda" else name


def compiled(folder, compiler, temporary):
    """The C functions on rows: out(name, a, b, n, result)."""
    text = f'#include "{SPACE}/{SPACE}.h"\n#include <string.h>\n'
    call = (
        "void run_{f}(const {r} *a, const {r} *b, int n, {o} *out) {{\n"
        "  for (int i = 0; i < n; ++i) {{\n    {A} x; {B} y;\n"
        "    memcpy(&x, a + i * (int)(sizeof x / sizeof *a), sizeof x);\n"
        "    memcpy(&y, b + i * (int)(sizeof y / sizeof *b), sizeof y);\n"
        "    {R} r = {c}(&x, &y);\n    memcpy(out + i * (int)(sizeof r / sizeof *out), &r, sizeof r);\n  }}\n}}\n"
    )
    for name, a, b, result in FORMULAS:
        value = f"{SPACE}_{result}" if result else "double"
        for suffix, part in (("", ""), ("_blades", "_blade")):
            text += call.format(f=name + suffix, r="double", o="double", A=f"{SPACE}_{a}{part}", B=f"{SPACE}_{b}{part}",
                                R=value, c=f"{SPACE}_{name}{suffix}")
    for name, a, b in DECISIONS:
        text += call.format(f=name, r="float", o="int", A=f"{SPACE}_{a}f", B=f"{SPACE}_{b}f", R="int",
                            c=f"{SPACE}_{name}_fp64")
    source, library = os.path.join(temporary, "run.c"), os.path.join(temporary, "run.so")
    with open(source, "w", encoding="utf-8") as file:
        file.write(text)
    subprocess.run([compiler, "-std=c99", "-O1", "-ffp-contract=off", "-mno-fma", "-shared", "-fPIC", "-I", folder, source, "-o",
                    library, "-lm"] if os.uname().machine == "x86_64" else
                   [compiler, "-std=c99", "-O1", "-ffp-contract=off", "-shared", "-fPIC", "-I", folder, source, "-o",
                    library, "-lm"], check=True)
    return ctypes.CDLL(library)


def by_c(library, name, a, b, width, real, out):
    result = np.empty((len(a), width), out)
    a, b = np.ascontiguousarray(a, real), np.ascontiguousarray(b, real)
    pointer = lambda x: x.ctypes.data_as(ctypes.c_void_p)
    getattr(library, "run_" + name)(pointer(a), pointer(b), ctypes.c_int(len(a)), pointer(result))
    return result


class Module(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.temporary = tempfile.TemporaryDirectory()
        cls.library = compiled(FOLDER, COMPILER, cls.temporary.name)
        spec = importlib.util.spec_from_file_location(SPACE, os.path.join(FOLDER, SPACE, SPACE + ".py"))
        cls.module = importlib.util.module_from_spec(spec)
        spec.loader.exec_module(cls.module)
        cls.random = np.random.default_rng(1)

    @classmethod
    def tearDownClass(cls):
        cls.temporary.cleanup()

    def kind(self, name):
        return getattr(self.module, python_name(name))

    def numbers(self, kind):
        """How many numbers a row of the kind has: its message says so."""
        try:
            kind.from_rows(np.zeros(0))
        except ValueError as error:
            return int(str(error).split(" has ")[1].split()[0])
        self.fail("an array without numbers was taken")

    def rows(self, kind, many):
        return self.random.normal(size=(many, self.numbers(kind))) * 10.0 ** self.random.integers(-3, 4, (many, 1))

    def test_formulas(self):
        for name, a, b, result in FORMULAS:
            for suffix, part in (("", ""), ("_blades", "_blade")):
                with self.subTest(name + suffix):
                    A, B = self.kind(a + part), self.kind(b + part)
                    x, y = self.rows(A, 500), self.rows(B, 500)
                    value = getattr(self.module, name)(A.from_rows(x), B.from_rows(y))
                    mine = value.rows() if result else np.reshape(value, (-1, 1))
                    theirs = by_c(self.library, name + suffix, x, y, mine.shape[1], np.float64, np.float64)
                    self.assertEqual(mine.dtype, np.float64)
                    self.assertTrue(np.any(theirs != 0))
                    np.testing.assert_array_equal(mine, theirs)

    def test_mixed_operands_and_one_against_many(self):
        sphere, line = self.kind("sphere"), self.kind("line")
        x, y = self.rows(sphere, 1), self.rows(line, 50)
        one = sphere.from_rows(x[0])
        value = self.module.norm2_meet_sphere_line(self.module.blade_of_sphere(one), line.from_rows(y))
        self.assertEqual(value.shape, (50,))
        each = [self.module.norm2_meet_sphere_line(self.module.blade_of_sphere(one), line.from_rows(r)) for r in y]
        np.testing.assert_array_equal(value, each)

    def test_decisions(self):
        for name, a, b in DECISIONS:
            with self.subTest(name):
                A, B = self.kind(a), self.kind(b)
                x = self.random.integers(0, 3, (4000, self.numbers(A))).astype(np.float32)
                y = self.random.integers(0, 3, (4000, self.numbers(B))).astype(np.float32)
                mine = getattr(self.module, name)(A.from_rows(x.astype(float)), B.from_rows(y.astype(float)))
                theirs = by_c(self.library, name, x, y, 1, np.float32, np.int32)[:, 0]
                self.assertGreater(len(np.unique(theirs)), 1)
                np.testing.assert_array_equal(mine, theirs)

    def test_float32_stays_float32(self):
        sphere = self.kind("sphere")
        rows = self.rows(sphere, 9).astype(np.float32)
        value = self.module.norm2_meet_sphere_sphere(sphere.from_rows(rows), sphere.from_rows(rows[::-1]))
        self.assertEqual(value.dtype, np.float32)

    def test_rows_go_there_and_back(self):
        for name in ("sphere", "line", "triangle", "circle", "lambda"):
            kind = self.kind(name)
            rows = self.rows(kind, 7)
            np.testing.assert_array_equal(kind.from_rows(rows).rows(), rows)

    def test_wrong_shapes_are_told(self):
        for rows in (np.zeros((3, 5)), np.zeros(3), 1.0):
            with self.assertRaisesRegex(ValueError, "a row of sphere has 4 numbers, and the array has the shape"):
                self.kind("sphere").from_rows(rows)


if __name__ == "__main__":
    FOLDER, COMPILER = sys.argv[1:3]
    unittest.main(argv=sys.argv[:1] + sys.argv[3:])
