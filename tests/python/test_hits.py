"""First hits and all points of hits, against exact arithmetic."""

import unittest

import meetc
import numpy as np
from exact import between, exact_rows, interval, normal
from meetc import Set
from shapes import SQUARE, SQUARE_FACES, lattice_triangles, sphere_mesh


def nearest(place):
    return [float(x) for x in place]  # Python rounds a fraction once, to the nearest, ties to even


class Hits(unittest.TestCase):
    def check(self, ends, triangles):
        """All points and the first ones, against the intervals of each segment and triangle."""
        segments, mesh = Set.segments(*ends), Set.triangles(triangles)
        faces, places = meetc.first(segments, mesh, points=True)
        self.assertTrue(np.array_equal(faces, meetc.first(segments, mesh)))
        found = meetc.hit_points(segments, mesh)
        exact = exact_rows(triangles)
        wanted = []
        for i, (start, end) in enumerate(zip(*ends)):
            p, q = exact_rows(start), exact_rows(end)
            at = {}
            for j, triangle in enumerate(exact):
                for t in interval(p, q, triangle) or ():
                    at.setdefault(t, j)
            for t in sorted(at):
                wanted.append((nearest(between(p, q, t)), i, at[t]))
            if at:
                self.assertEqual(places[i].tolist(), nearest(between(p, q, min(at))))
            else:
                self.assertEqual(faces[i], -1)
                self.assertTrue(np.isnan(places[i]).all())
        self.assertEqual(list(zip(found.points.tolist(), found.segments.tolist(), found.triangles.tolist())), wanted)
        self.assertEqual((places.dtype, found.points.dtype, found.segments.dtype, found.triangles.dtype),
                         (np.float64, np.float64, np.int32, np.int32))
        return found

    def test_lattices_where_segments_run_through_edges_and_in_planes(self):
        rng = np.random.default_rng(21)
        for size in (3, 6):
            triangles = lattice_triangles(rng, 50, size)
            triangles = np.array([t for t in triangles if any(normal(exact_rows(t)))], np.float32)
            ends = rng.integers(0, size, (2, 60, 3)).astype(np.float32)
            found = self.check(ends[:, (ends[0] != ends[1]).any(axis=1)], triangles)
            self.assertGreater(len(found.points), 100)

    def test_random_segments(self):
        rng = np.random.default_rng(22)
        found = self.check(rng.normal(size=(2, 50, 3)).astype(np.float32), rng.normal(size=(40, 3, 3)).astype(np.float32))
        self.assertGreater(len(found.points), 100)

    def test_points_that_differ_by_less_than_a_double_are_two_and_in_order(self):
        # Two faces of the plane x = 1, and between them in number one that is 2^-64 behind it where the segment is.
        triangles = np.array([
            [[1, -4, -4], [1, 8, -4], [1, -4, 8]],
            [[1 + 2.0**-23, -(2.0**40), -4], [1, 1, -4], [1, 1, 4]],
            [[1, -4, -5], [1, 8, -5], [1, -4, 8]],
        ], np.float32)
        ends = np.array([[[0, 0.5, 0]], [[3, 0.5, 0]]], np.float32)
        found = self.check(ends, triangles)
        self.assertEqual(found.triangles.tolist(), [0, 1])
        self.assertEqual(found.points[0].tolist(), found.points[1].tolist())

    def test_rays_in_the_shape_of_trimesh(self):
        vertices, faces = sphere_mesh(12)
        mesh = Set(vertices, faces)
        origins = np.array([[-3, 0.1, 0.2], [0, 0, 0], [9, 9, 9]], np.float32)
        rays = Set.rays(origins, [[1, 0, 0]] * 3, through=mesh)
        locations, index_ray, index_tri = meetc.hit_points(rays, mesh)
        self.assertEqual(index_ray.tolist(), [0, 0, 1])
        self.assertTrue(locations[0, 0] < -0.9 and locations[1, 0] > 0.9)
        self.assertTrue(np.abs(locations[0, 1:] - [0.1, 0.2]).max() < 1e-7)
        first, places = meetc.first(rays, mesh, points=True)
        self.assertEqual(first.tolist(), [index_tri[0], index_tri[2], -1])
        self.assertEqual(places[:2].tolist(), locations[[0, 2]].tolist())
        none = meetc.hit_points(Set.rays([[9, 9, 9]], [[1, 0, 0]], length=2), mesh)
        self.assertEqual((none.points.shape, none.segments.shape, none.triangles.shape), ((0, 3), (0,), (0,)))

    def test_poses_and_faces_of_polygons(self):
        class Mesh:
            points = SQUARE
            faces = np.array([3, 0, 1, 2, 4, 0, 1, 2, 3])

        pose = np.eye(4)
        pose[2, 3] = 5
        mesh = Set(Mesh(), pose=pose)
        segments = Set.segments([[0.25, 0.75, 9], [0.75, 0.25, 9]], [[0.25, 0.75, 0], [0.75, 0.25, 0]])
        faces, places = meetc.first(segments, mesh, points=True)
        self.assertEqual(faces.tolist(), [1, 0])
        self.assertEqual(places.tolist(), [[0.25, 0.75, 5], [0.75, 0.25, 5]])
        self.assertEqual(faces.tolist(), meetc.first(segments, mesh).tolist())
        found = meetc.hit_points(segments, mesh)
        self.assertEqual((found.segments.tolist(), found.triangles.tolist()), ([0, 1], [1, 0]))

    def test_bad_input(self):
        square = Set(SQUARE, SQUARE_FACES)
        with self.assertRaisesRegex(meetc.InputError, "^hit_points: it is asked of segments and triangles, not of triangle"):
            meetc.hit_points(square, square)
        with self.assertRaisesRegex(TypeError, "^b: a meetc.Set"):
            meetc.hit_points(square, 3)


if __name__ == "__main__":
    unittest.main()
