"""The answers of the queries, against one another and against simple judges."""

import unittest

import meetc
import numpy as np
from meetc import Set
from shapes import SPIKE, SPIKE_FACES, SQUARE, SQUARE_FACES, lattice_triangles, lifted, sphere_mesh


class Queries(unittest.TestCase):
    def test_the_page_of_the_library(self):
        floor, spike = Set(SQUARE, SQUARE_FACES), Set(SPIKE, SPIKE_FACES)
        found = meetc.pairs(floor, spike)
        self.assertEqual((found.tolist(), found.dtype, found.shape), ([[0, 0], [1, 0]], np.int32, (2, 2)))
        lifted_pairs = meetc.pairs(floor, spike.at(lifted(1e-30)))
        self.assertEqual((lifted_pairs.shape, lifted_pairs.dtype), ((0, 2), np.int32))
        self.assertTrue(meetc.touches(floor, spike))
        self.assertFalse(meetc.touches(floor, spike.at(lifted(1e-30))))

    def test_the_answers_agree_for_every_precision(self):
        rng = np.random.default_rng(1)
        a, b = Set.triangles(lattice_triangles(rng, 300)), Set.triangles(lattice_triangles(rng, 200))
        wanted = meetc.pairs(a, b, precision="exact")
        self.assertGreater(len(wanted), 1000)
        order = np.lexsort((wanted[:, 1], wanted[:, 0]))
        self.assertTrue((order == np.arange(len(wanted))).all())
        self.assertTrue(np.array_equal(meetc.pairs(a, b), wanted))
        for threads in (1, 3):
            self.assertTrue(np.array_equal(meetc.pairs(a, b, threads=threads), wanted))
        self.assertEqual(meetc.count(a, b), len(wanted))
        hit_a, hit_b = meetc.hits(a, b)
        self.assertEqual((hit_a.dtype, hit_a.shape, hit_b.shape), (np.bool_, (300,), (200,)))
        self.assertTrue(np.array_equal(np.flatnonzero(hit_a), np.unique(wanted[:, 0])))
        self.assertTrue(np.array_equal(np.flatnonzero(hit_b), np.unique(wanted[:, 1])))
        count_a, count_b = meetc.counts(a, b)
        self.assertTrue(np.array_equal(count_a, np.bincount(wanted[:, 0], minlength=300)))
        self.assertTrue(np.array_equal(count_b, np.bincount(wanted[:, 1], minlength=200)))
        back = meetc.pairs(b, a)
        self.assertTrue(np.array_equal(back[np.lexsort((back[:, 0], back[:, 1]))][:, ::-1], wanted))
        for plain in ("fp32", "fp64", "fp64x2"):
            self.assertEqual(meetc.pairs(a, b, precision=plain).shape[1], 2)

    def test_spheres_against_distances_in_either_order(self):
        rng = np.random.default_rng(2)
        centres, radii = rng.integers(0, 20, (100, 3)), rng.integers(0, 5, 100)
        more, others = rng.integers(0, 20, (80, 3)), rng.integers(0, 5, 80)
        square = ((centres[:, None] - more[None]) ** 2).sum(axis=2)
        near = square <= (radii[:, None] + others[None]) ** 2
        a, b = Set.spheres(centres, radii), Set.spheres(more, others)
        self.assertTrue(np.array_equal(meetc.pairs(a, b), np.argwhere(near)))
        far = square >= (radii[:, None] - others[None]) ** 2
        skins = meetc.pairs(Set.spheres(centres, radii, solid=False), Set.spheres(more, others, solid=False))
        self.assertTrue(np.array_equal(skins, np.argwhere(near & far)))
        self.assertEqual((a.kind, Set.spheres(centres, radii, solid=False).kind), ("ball", "sphere"))

    def test_a_predicate_that_takes_the_kinds_in_the_other_order(self):
        ball, mesh = Set.spheres([[0.5, 0.5, 1]], [1]), Set(SQUARE, SQUARE_FACES)
        self.assertEqual(meetc.pairs(mesh, ball).tolist(), [[0, 0], [1, 0]])
        self.assertEqual(meetc.pairs(ball, mesh).tolist(), [[0, 0], [0, 1]])
        of_mesh, of_ball = meetc.hits(mesh, ball)
        self.assertEqual((of_mesh.tolist(), of_ball.tolist()), ([True, True], [True]))
        of_mesh, of_ball = meetc.counts(mesh, ball)
        self.assertEqual((of_mesh.tolist(), of_ball.tolist()), ([1, 1], [2]))

    def test_boxes_points_and_segments(self):
        low = np.array([[0, 0, 0], [2, 2, 2], [5, 5, 5]])
        boxes = Set.boxes(low, low + 2)
        self.assertEqual(meetc.pairs(boxes, boxes).tolist(), [[0, 0], [0, 1], [1, 0], [1, 1], [2, 2]])
        square = Set(SQUARE, SQUARE_FACES)
        points = Set.points([[0.5, 0.5, 0], [0.5, 0.25, 0], [2, 2, 0], [0.5, 0.5, 2.0**-149]])
        self.assertEqual(meetc.pairs(points, square).tolist(), [[0, 0], [0, 1], [1, 0]])
        edges = Set(SQUARE, [[0, 2], [1, 3]], kind="segment")
        self.assertEqual(meetc.pairs(edges, edges).tolist(), [[0, 0], [0, 1], [1, 0], [1, 1]])
        self.assertEqual(meetc.pairs(Set.segments([[0, 0, 1]], [[0, 0, -1]]), square).tolist(), [[0, 0], [0, 1]])

    def test_first_names_the_nearest_triangle_or_none(self):
        layers = np.vstack([SQUARE + np.float32([0, 0, z]) for z in (0, 3, 1)])
        faces = np.vstack([SQUARE_FACES + 4 * i for i in range(3)])
        mesh = Set(layers, faces)
        start = [[0.75, 0.25, 5], [0.75, 0.25, -1], [2, 2, 5], [0.5, 0.5, 2]]
        end = [[0.75, 0.25, -5], [0.75, 0.25, 9], [2, 2, 0], [0.5, 0.5, 0]]
        found = meetc.first(Set.segments(start, end), mesh)
        self.assertEqual((found.tolist(), found.dtype), ([2, 0, -1, 4], np.int32))
        origins, directions = [start[0], start[1], start[0]], [[0, 0, -1e-30], [0, 0, 1e30], [0, 0, 1]]
        rays = Set.rays(origins, directions, through=mesh)
        self.assertEqual(meetc.first(rays, mesh).tolist(), [2, 0, -1])
        short = Set.rays([[0.75, 0.25, 5]], [[0, 0, -1]], length=1.5)
        self.assertEqual(meetc.first(short, mesh).tolist(), [-1])

    def test_rays_reach_all_of_a_mesh(self):
        v, f = sphere_mesh(24)
        rng = np.random.default_rng(3)
        away = rng.normal(size=(2000, 3))
        origins = 50 * away / np.linalg.norm(away, axis=1)[:, None]
        mesh = Set(v, f)
        with self.assertWarns(meetc.RoundedWarning):
            rays = Set.rays(origins, -origins * rng.uniform(1e-3, 1e3, (2000, 1)), through=mesh)
        found = meetc.first(rays, mesh)
        self.assertTrue((found >= 0).all())
        # The first hit lies on the side of the origin.
        self.assertTrue(((v[f[found]].mean(axis=1) * origins).sum(axis=1) > 0).all())

    def test_over_poses_is_the_query_in_each_pose(self):
        v, f = sphere_mesh(12)
        a, b = Set(v, f), Set(v, f, pose=lifted(7))
        poses = np.tile(np.eye(4), (40, 1, 1))
        poses[:, 0, 3] = np.linspace(-3, 3, 40)
        poses[:, 2, 3] = 0.125
        wanted = [meetc.count(a, b.at(p)) for p in poses]
        self.assertGreater(sum(1 for w in wanted if w), 10)
        self.assertEqual(wanted[0], 0)
        for threads in (0, 1, 3):
            found = meetc.over_poses(a, b, poses, threads=threads)
            self.assertEqual((found.tolist(), found.dtype), (wanted, np.int64))
        few = meetc.over_poses(a, b, poses[19:21, :3])
        self.assertEqual(few.tolist(), wanted[19:21])
        any_ = meetc.over_poses(a, b, poses, want="any")
        self.assertEqual((any_.tolist(), any_.dtype), ([w > 0 for w in wanted], np.bool_))
        balls = Set.spheres([[0, 0, 0]], [0.5])
        self.assertEqual(
            meetc.over_poses(balls, b, poses).tolist(), [meetc.count(balls, b.at(p)) for p in poses]
        )  # the predicate takes them in the other order
        self.assertEqual(meetc.over_poses(b, balls, poses * 1.0).tolist(), [meetc.count(b, balls.at(p)) for p in poses])


if __name__ == "__main__":
    unittest.main()
