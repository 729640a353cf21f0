"""Files, and the answers of the program `meet` for the same ones."""

import os
import tempfile
import unittest
import warnings

import meetc
import numpy as np
from meetc import Set
from shapes import MEET, run_meet

DART = "v 0 0 0\nv 2 1 0\nv 4 0 0\nv 2 4 0\nv 2 0.25 0\nf 1 2 3 4\nf 1 5 3\n"


class Files(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)

    def file(self, name, text):
        path = os.path.join(self.folder.name, name)
        with open(path, "w", encoding="ascii") as file:
            file.write(text)
        return path

    def test_answers_are_about_the_faces_of_the_file(self):
        a = Set.read(self.file("dart.obj", DART))
        self.assertEqual((len(a), len(a._source.corners), a.kind, a.name), (2, 3, "triangle", "dart.obj"))
        ball = Set.spheres([[2, 3, 0]], [0.25])
        self.assertEqual(meetc.pairs(ball, a).tolist(), [[0, 0]])
        self.assertEqual(meetc.hits(a, ball)[0].tolist(), [True, False])
        self.assertEqual(meetc.counts(a, a)[0].tolist(), [2, 2])
        self.assertEqual(meetc.over_poses(ball, a, [np.eye(4)]).tolist(), [1])

    def test_notes_and_rounding_warn(self):
        path = self.file("quad.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0.5\nv 0 1 0\nv 16777217 0 0\nf 1 2 3 4\nf 1 2 5\n")
        with warnings.catch_warnings(record=True) as caught:
            warnings.simplefilter("always")
            a = Set.read(path)
        self.assertEqual(a.rounded, (1, 1.0))
        self.assertEqual([w.category for w in caught], [meetc.MeetWarning, meetc.RoundedWarning])
        self.assertTrue(all(w.filename == __file__ for w in caught))
        self.assertIn("not planar", a.notes[0])
        self.assertIn("not planar", a._repr_html_())

    def test_kinds(self):
        path = self.file("balls.csv", "x,y,z,r\n0,0,0,1\n3,0,0,1\n")
        self.assertEqual(Set.read(path).kind, "ball")
        self.assertEqual(len(Set.read(os.fsencode(path), threads=10**12)), 2)
        self.assertEqual(Set.read(path, "sphere").kind, "sphere")
        points = self.file("points.obj", "v 0 0 0\nv 1 1 1\np 1\np 2\n")
        self.assertEqual((Set.read(points).kind, len(Set.read(points))), ("point", 2))

    @unittest.skipUnless(MEET, "the program meet is not built")
    def test_the_same_pairs_as_meet_collide(self):
        made = os.path.join(self.folder.name, "demo")
        run_meet("demo", "-o", made)
        animal, figure = (os.path.join(made, name) for name in ("animal.ply", "figure.ply"))
        a, b = Set.read(animal), Set.read(figure)
        table = os.path.join(self.folder.name, "pairs.csv")

        def listed(*arguments):
            run_meet("collide", *arguments, "--pairs", table)
            return np.loadtxt(table, dtype=np.int32, delimiter=",", skiprows=1, ndmin=2).reshape(-1, 2)

        wanted = listed(animal, figure)
        self.assertGreater(len(wanted), 100)
        self.assertTrue(np.array_equal(meetc.pairs(a, b), wanted))
        self.assertTrue(np.array_equal(meetc.pairs(b, a), listed(figure, animal)))
        turn = [[0.8, -0.6, 0, 0.01], [0.6, 0.8, 0, -0.02], [0, 0, 1, 0.03]]
        numbers = ",".join(map(repr, np.ravel(turn).tolist()))
        moved = listed(animal, figure, "--matrix-b", numbers)
        self.assertFalse(np.array_equal(moved, wanted))
        self.assertTrue(np.array_equal(meetc.pairs(a, b.at(turn)), moved))
        self.assertEqual(meetc.over_poses(a, b, [np.eye(3, 4), turn]).tolist(), [len(wanted), len(moved)])
        for precision in ("exact", "fp32"):
            self.assertTrue(
                np.array_equal(meetc.pairs(a, b, precision=precision), listed(animal, figure, "--precision", precision))
            )
        rng = np.random.default_rng(5)
        low, high = a.bounds
        ends = (low + (high - low) * rng.random((500, 2, 3))).astype(np.float32)
        rows = os.path.join(self.folder.name, "segments.csv")
        np.savetxt(rows, ends.reshape(-1, 6), "%.9g", ",", header="x0,y0,z0,x1,y1,z1", comments="")
        first = os.path.join(self.folder.name, "first.csv")
        run_meet("collide", rows, animal, "--first", first)
        met = np.loadtxt(first, dtype=np.int32, delimiter=",", skiprows=1)
        found = meetc.first(Set.segments(ends[:, 0], ends[:, 1]), a)
        self.assertGreater(len(met), 50)
        self.assertTrue(np.array_equal(np.stack([np.flatnonzero(found >= 0), found[found >= 0]], 1), met))


if __name__ == "__main__":
    unittest.main()
