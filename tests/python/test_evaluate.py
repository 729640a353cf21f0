"""The values of formulas: on columns, on rows, and on pairs of sets."""

import unittest

import meetc
import numpy as np
from meetc import Set

LINE = "norm2(meet(sphere, line))"
SPHERES = "norm2(meet(sphere, sphere))"


class Evaluate(unittest.TestCase):
    def test_the_page_of_the_library(self):
        lines = [[0, 0, 0, 1, 0, 0], [0, 2, 0, 1, 2, 0], [0, 3, 0, 1, 3, 0]]
        values = meetc.evaluate(LINE, [5, 0, 0, 2], lines)
        self.assertEqual(list(values), list(meetc.formula(LINE).values))
        (found,) = values.values()
        self.assertEqual((found.tolist(), found.dtype), ([256, 0, -320], np.float32))

    def test_formulas_name_their_numbers(self):
        found = meetc.formula(" norm2( meet(sphere,line) ) ")
        numbers = ("x", "y", "z", "r"), ("x0", "y0", "z0", "x1", "y1", "z1")
        self.assertEqual(found.operands, (("sphere", numbers[0]), ("line", numbers[1])))
        self.assertIn(found, meetc.formulas())
        circle = meetc.evaluate("meet(sphere,sphere)", [0, 0, 0, 1], [1, 0, 0, 1])
        self.assertEqual(tuple(circle), meetc.formula("meet(sphere, sphere)").values)

    def test_columns_of_any_stride_and_rows_are_the_same(self):
        rng = np.random.default_rng(3)
        spheres, lines = rng.random((5000, 4), np.float32), rng.random((5000, 6), np.float32)
        (wanted,) = meetc.evaluate(LINE, spheres, lines).values()
        columns = {name: np.repeat(spheres[:, i], 3)[::3] for i, name in enumerate("xyzr")}
        for operand in (spheres.copy(order="F"), spheres[::-1][::-1], spheres.astype(np.float64), columns):
            for threads in (1, 3):
                (found,) = meetc.evaluate(LINE, operand, lines, threads=threads).values()
                self.assertTrue(np.array_equal(found, wanted))
        (backwards,) = meetc.evaluate(LINE, spheres[::-1], lines[::-1]).values()
        self.assertTrue(np.array_equal(backwards[::-1], wanted))
        order = rng.integers(0, 5000, 700)
        (listed,) = meetc.evaluate(LINE, spheres, lines, rows=np.stack([order, order], 1)).values()
        self.assertTrue(np.array_equal(listed, wanted[order]))
        (one,) = meetc.evaluate(LINE, {"x": spheres[:, 0], "y": 0.5, "z": 0.5, "r": 1}, lines[0]).values()
        self.assertEqual(one.shape, (5000,))

    def test_double(self):
        rng = np.random.default_rng(4)
        spheres, lines = rng.random((100, 4), np.float32), rng.random((100, 6), np.float32)
        (single,) = meetc.evaluate(LINE, spheres, lines).values()
        (double,) = meetc.evaluate(LINE, spheres, lines, dtype=np.float64).values()
        self.assertEqual(double.dtype, np.float64)
        self.assertTrue(np.allclose(single, double, atol=1e-4))
        p, d = lines[:, :3].astype(float), (lines[:, 3:].astype(float) - lines[:, :3])
        c, r = spheres[:, :3].astype(float), spheres[:, 3].astype(float)
        b, c2 = (d * (p - c)).sum(1), ((p - c) ** 2).sum(1) - r**2
        self.assertTrue(np.allclose(double, 64 * (b**2 - (d * d).sum(1) * c2)))

    def test_pairs_of_sets_in_their_poses(self):
        rng = np.random.default_rng(5)
        rows, more = rng.random((60, 4), np.float32), rng.random((50, 4), np.float32)
        pose = np.eye(4)
        pose[0, 3] = 0.5
        a, b = Set.spheres(rows[:, :3], rows[:, 3]), Set.spheres(more[:, :3], more[:, 3], pose=pose)
        pairs = meetc.pairs(a, b)
        moved = more.copy()
        moved[:, 0] = (more[:, 0].astype(np.float64) + 0.5).astype(np.float32)
        for dtype in (np.float32, np.float64):
            (found,) = meetc.evaluate(SPHERES, a, b, rows=pairs, dtype=dtype).values()
            (wanted,) = meetc.evaluate(SPHERES, rows, moved, rows=pairs, dtype=dtype).values()
            self.assertEqual((found.dtype, len(found)), (dtype, len(pairs)))
            self.assertTrue(np.array_equal(found, wanted))
        (none,) = meetc.evaluate(SPHERES, a, b, rows=pairs[:0]).values()
        self.assertEqual(none.shape, (0,))

    def test_a_nan_stays_one(self):
        (found,) = meetc.evaluate(LINE, np.array([[0, 0, 0, 1], [np.nan, 0, 0, 1]], np.float32), [0, 0, 0, 1, 0, 0]).values()
        self.assertEqual(np.isnan(found).tolist(), [False, True])


if __name__ == "__main__":
    unittest.main()
