"""NumPy arrays go in and out without copies where they can, and what rounding moves is told."""

import pickle
import unittest
import warnings

import meetc
import numpy as np
from meetc import Set
from shapes import SQUARE, SQUARE_FACES, sphere_mesh


class Arrays(unittest.TestCase):
    def test_float32_of_any_positive_stride_goes_in_without_a_copy(self):
        v, f = sphere_mesh(10)
        wanted = meetc.pairs(Set(v, f), Set(SQUARE, SQUARE_FACES))
        self.assertGreater(len(wanted), 0)
        records = np.zeros(len(v), np.dtype([("tag", "u1"), ("xyz", "<f4", (3,))]))  # rows of 13 bytes
        records["xyz"] = v
        wide = np.zeros((len(v), 8), np.float32)
        wide[:, 2:5] = v
        every_other = np.repeat(v, 2, axis=0)[::2]
        for rows in (v, records["xyz"], wide[:, 2:5], every_other):
            with self.subTest(strides=rows.strides):
                a = Set(rows, f)
                self.assertTrue(np.shares_memory(a._source.numbers, rows))
                self.assertTrue(np.array_equal(meetc.pairs(a, Set(SQUARE, SQUARE_FACES)), wanted))
        self.assertEqual(records["xyz"].strides, (13, 4))

    def test_other_layouts_are_copied_and_answer_the_same(self):
        v, f = sphere_mesh(10)
        floor = Set(SQUARE, SQUARE_FACES)
        wanted = meetc.pairs(Set(v, f), floor)
        for rows in (np.asfortranarray(v), v[::-1][::-1], v.astype(">f4"), v.astype(np.float64), v.tolist()):
            self.assertTrue(np.array_equal(meetc.pairs(Set(rows, f), floor), wanted))
        backwards = Set(v[::-1], len(v) - 1 - f)
        self.assertTrue(np.array_equal(meetc.pairs(backwards, floor), wanted))

    def test_indices(self):
        v, f = sphere_mesh(10)
        floor = Set(SQUARE, SQUARE_FACES)
        wanted = meetc.pairs(Set(v, f), floor)
        for same in (f, f.astype(np.uint32)):
            a = Set(v, same)
            self.assertTrue(np.shares_memory(a._source.corners, same))
        for other in (np.int64, np.uint64, np.int16, ">i4"):
            self.assertTrue(np.array_equal(meetc.pairs(Set(v, f.astype(other)), floor), wanted))
        self.assertTrue(np.array_equal(meetc.pairs(Set(v, np.asfortranarray(f)), floor), wanted))

    def test_pairs_own_the_memory_in_which_they_were_found(self):
        v, f = sphere_mesh(20)
        a = Set(v, f)
        found = meetc.pairs(a, a)
        self.assertFalse(found.flags.owndata)  # a capsule owns it
        self.assertTrue(found.flags.c_contiguous and found.flags.writeable)
        kept = found[5:9].copy()
        part = found[5:9]
        del found, a
        self.assertTrue(np.array_equal(part, kept))

    def test_what_rounding_moves_is_told(self):
        v = SQUARE.astype(np.float64)
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            self.assertEqual(Set(v, SQUARE_FACES).rounded, (0, 0.0))
        v[1, 0], v[3, 2] = 0.1, 1e-60
        with self.assertWarns(meetc.RoundedWarning) as caught:
            a = Set(v, SQUARE_FACES)
        self.assertEqual(a.rounded, (2, float(abs(np.float64(np.float32(0.1)) - 0.1))))
        self.assertEqual(str(caught.warning), "vertices: float32 moved 2 of 12 numbers, by at most 1.49e-09")
        self.assertEqual(caught.filename, __file__)
        with self.assertWarns(meetc.RoundedWarning) as caught:
            meetc.count((v, SQUARE_FACES), (v, SQUARE_FACES))
        self.assertEqual(caught.filename, __file__)  # the line that called, not one of the package
        with self.assertWarnsRegex(meetc.RoundedWarning, "centres and radii: float32 moved 1 of 4 numbers"):
            Set.spheres([[0, 0, 0]], [0.1])
        with self.assertWarnsRegex(meetc.RoundedWarning, "moved 1 of 3 numbers, by at most 1$"):
            Set.points([[2**24 + 1, 0, 0]])

    def test_a_pickle_has_the_arrays(self):
        v, f = sphere_mesh(10)
        pose = np.eye(4)
        pose[0, 3] = 0.25
        sets = [
            Set(v, f, pose=pose, name="ball"),
            Set.spheres([[0, 0, 0]], [1], solid=False),
            Set.segments([[0, 0, 5]], [[0, 0, -5]]),
        ]
        for a in sets:
            b = pickle.loads(pickle.dumps(a))
            self.assertEqual((repr(a), a.kind, len(a), a.rounded), (repr(b), b.kind, len(b), b.rounded))
            self.assertTrue(np.array_equal(a._source.numbers, b._source.numbers))
        self.assertTrue(np.array_equal(pickle.loads(pickle.dumps(sets[0])).pose, pose))
        square = Set(SQUARE, SQUARE_FACES)
        self.assertTrue(np.array_equal(meetc.pairs(pickle.loads(pickle.dumps(sets[0])), square), meetc.pairs(sets[0], square)))

    def test_a_pose_is_that_of_the_arrays(self):
        pose = np.eye(4)
        pose[2, 3] = 2
        a = Set(SQUARE, SQUARE_FACES)
        b = a.at(pose)
        self.assertTrue(np.array_equal(b.at(pose).bounds, b.bounds))  # it replaces, and does not add
        self.assertEqual(b.at(None).bounds.tolist(), [[0, 0, 0], [1, 1, 0]])
        self.assertEqual(b.bounds.tolist(), [[0, 0, 2], [1, 1, 2]])
        self.assertIsNone(a.pose)
        self.assertIs(a.at(None), a)


if __name__ == "__main__":
    unittest.main()
