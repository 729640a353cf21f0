"""Where a mesh crosses itself, against known numbers."""

import os
import tempfile
import unittest
import warnings

import meetc
import numpy as np
from meetc import Set
from shapes import SQUARE, SQUARE_FACES, sphere_mesh


def eight_torus(r, around, across):
    """A torus whose tube crosses itself: its section is a figure of eight."""
    i, j = np.meshgrid(np.arange(around), np.arange(across), indexing="ij")
    b, a = 2 * np.pi * i / around, 2 * np.pi * j / across
    ring = 1 - r * np.cos(a)
    vertices = np.stack([ring * np.cos(b), ring * np.sin(b), r * np.sin(2 * a)], axis=2).reshape(-1, 3)

    def number(i, j):
        return (i % around) * across + j % across

    one = np.stack([number(i, j), number(i + 1, j), number(i + 1, j + 1)], axis=2).reshape(-1, 3)
    two = np.stack([number(i, j), number(i + 1, j + 1), number(i, j + 1)], axis=2).reshape(-1, 3)
    return vertices.astype(np.float32), np.stack([one, two], axis=1).reshape(-1, 3)


class SelfPairs(unittest.TestCase):
    def test_a_torus_whose_tube_crosses_itself_has_the_known_numbers(self):
        for r, around, across, pairs, touched in ((0.2, 32, 16, 160, 128), (0.1, 16, 16, 80, 64)):
            found = meetc.self_pairs(eight_torus(r, around, across))
            self.assertEqual((found.shape, found.dtype, len(np.unique(found))), ((pairs, 2), np.int32, touched))
            self.assertTrue((found[:, 0] < found[:, 1]).all())
            self.assertTrue((np.lexsort((found[:, 1], found[:, 0])) == np.arange(pairs)).all())
            for threads in (1, 3):
                self.assertTrue(np.array_equal(meetc.self_pairs(eight_torus(r, around, across), threads=threads), found))

    def test_neighbours_do_not_count(self):
        self.assertEqual(meetc.self_pairs(sphere_mesh(16)).shape, (0, 2))
        self.assertEqual(meetc.self_pairs(Set(SQUARE, SQUARE_FACES)).shape, (0, 2))
        folded = ([[0, 0, 0], [1, 0, 0], [0, 1, 0], [1, 1, 0]], [[0, 1, 2], [0, 2, 3]])
        self.assertEqual(meetc.self_pairs(folded).tolist(), [[0, 1]])

    def test_corners_are_one_by_their_coordinates_or_by_their_vertex(self):
        apart = Set([[0, 0, 0], [1, 0, 0], [0, 1, 0], [1, 0, 0], [-0.0, 1, 0], [1, 1, 0]], [[0, 1, 2], [3, 5, 4]])
        self.assertEqual(meetc.self_pairs(apart).tolist(), [])
        self.assertEqual(meetc.self_pairs(apart, merge=False).tolist(), [[0, 1]])
        rows = Set.triangles(SQUARE[SQUARE_FACES])
        self.assertEqual((len(meetc.self_pairs(rows)), len(meetc.self_pairs(rows, merge=False))), (0, 1))

    def test_a_pose_moves_the_mesh_before_it_is_asked(self):
        vertices, faces = eight_torus(0.2, 32, 16)
        pose = np.array([[0, 2, 0, 0], [0, 0, 2, 0], [2, 0, 0, 0], [0, 0, 0, 1]])  # which rounds nothing
        self.assertEqual(len(meetc.self_pairs(Set(vertices, faces, pose=pose))), 160)
        flat = np.eye(4)
        flat[2] = (0, 0, 2.0**-149, 0)  # each height becomes 0
        wanted = meetc.self_pairs((vertices * np.float32([1, 1, 0]), faces))
        self.assertGreater(len(wanted), 500)
        self.assertTrue(np.array_equal(meetc.self_pairs(Set(vertices, faces, pose=flat)), wanted))

    def test_faces_without_area_are_told_and_count(self):
        corners = [[0, 0, 0], [4, 0, 0], [0, 4, 0], [2, 0, 0], [6, 0, 0], [1, 1, 0]]
        mesh = Set(corners, [[0, 1, 2], [0, 3, 1], [0, 1, 4], [5, 5, 5]])
        with self.assertWarnsRegex(meetc.MeetWarning, "^mesh: 3 faces have no area: 1, 2, 3; .* that they are$") as caught:
            self.assertEqual(meetc.self_pairs(mesh).tolist(), [[0, 3]])
        self.assertEqual(caught.filename, __file__)
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            pairs, without_area = meetc.self_pairs(mesh, return_without_area=True)
            self.assertEqual((pairs.tolist(), without_area.tolist()), ([[0, 3]], [1, 2, 3]))
            _, none = meetc.self_pairs(sphere_mesh(4), return_without_area=True)
            self.assertEqual((none.shape, none.dtype), ((0,), np.int32))

    def test_rounding_is_told(self):
        vertices, faces = sphere_mesh(6)
        with self.assertWarnsRegex(meetc.RoundedWarning, "float32 moved"):
            meetc.self_pairs((vertices.astype(float) + 1e-12, faces))

    def test_answers_are_about_the_faces_of_a_file(self):
        # A quad across a quad, which is cut into triangles of which both meet the other's, and one without area.
        text = "".join(f"v {x} {y} {z}\n" for x, y, z in (
            (0, 0, 0), (4, 0, 0), (4, 4, 0), (0, 4, 0), (1, 1, -1), (3, 2, -1), (3, 2, 1), (1, 1, 1), (9, 9, 9)))
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "quads.obj")
            with open(path, "w", encoding="ascii") as file:
                file.write(text + "f 1 2 3 4\nf 5 6 7 8\nf 9 9 9 9\n")
            mesh = Set.read(path)
        pairs, without_area = meetc.self_pairs(mesh, return_without_area=True)
        self.assertEqual((pairs.tolist(), without_area.tolist()), ([[0, 1]], [2]))

    def test_bad_input(self):
        with self.assertRaisesRegex(meetc.InputError, "^mesh: its elements are of kind point, not triangles$"):
            meetc.self_pairs(Set.points([[0, 0, 0]]))
        with self.assertRaisesRegex(TypeError, "^mesh: a meetc.Set, a mesh"):
            meetc.self_pairs(3)
        with self.assertRaisesRegex(meetc.InputError, "threads: -1 is negative"):
            meetc.self_pairs(sphere_mesh(4), threads=-1)


if __name__ == "__main__":
    unittest.main()
