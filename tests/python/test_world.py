"""Many bodies: names, poses, pairs that may touch."""

import unittest

import meetc
import numpy as np
from meetc import InputError, Set, World
from shapes import SQUARE, SQUARE_FACES, sphere_mesh


def at(x: float, y: float = 0, z: float = 0):
    pose = np.eye(4)
    pose[:3, 3] = x, y, z
    return pose


class Worlds(unittest.TestCase):
    def row(self) -> World:
        world = World()
        vertices, faces = sphere_mesh(8)
        for i, name in enumerate("abcd"):
            world.add(name, Set(vertices, faces), at(1.75 * i))  # neighbours overlap
        return world

    def test_who_touches_whom(self):
        world = self.row()
        self.assertEqual(world.touching(), [("a", "b"), ("b", "c"), ("c", "d")])
        self.assertEqual(world.touching("b"), [("a", "b"), ("b", "c")])
        world.move("b", at(100))
        self.assertEqual(world.touching(), [("c", "d")])
        self.assertTrue(world.any())
        world.move("d", at(-100))
        self.assertFalse(world.any())
        self.assertEqual((len(world), list(world), "a" in world, "x" in world), (4, list("abcd"), True, False))
        self.assertEqual(world.pose("d").tolist(), at(-100).tolist())
        self.assertEqual(repr(world), "<meetc.World: 4 bodies>")

    def test_the_numbers_are_those_of_sets_in_their_poses(self):
        world, rng = self.row(), np.random.default_rng(3)
        for _ in range(5):
            poses = {}
            for name in world:
                q, _ = np.linalg.qr(rng.normal(size=(3, 3)))
                poses[name] = at(*rng.uniform(-1, 1, 3))
                poses[name][:3, :3] = q
                world.move(name, poses[name])
            matrix = world.matrix()
            names = list(world)
            for i, a in enumerate(names):
                for j, b in enumerate(names[:i]):
                    found = world.pairs(a, b)
                    self.assertEqual((matrix[i, j], matrix[j, i]), (len(found), len(found)))
            self.assertTrue((np.diag(matrix) == 0).all())
            self.assertGreater(matrix.sum(), 0)

    def test_poses_are_as_they_were_where_a_frame_fails(self):
        world = self.row()
        before = world.pose("b").tolist()
        far = np.array([[at(0.5)], [at(1e39)]])
        for ask in (world.over, world.report):
            try:
                ask(far, ["b"])
                self.fail("a pose beyond float32 was taken")
            except InputError:
                self.assertEqual(world.pose("b").tolist(), before)
                self.assertTrue(world.any())
        with self.assertRaisesRegex(InputError, "poses: it has no frame"):
            world.report(np.empty((0, 1, 4, 4)), ["b"])

    def test_pairs_that_may_touch(self):
        world = self.row()
        world.allow("a", "b")
        self.assertEqual(world.touching(), [("b", "c"), ("c", "d")])
        world.allow(["c"], ["b", "d"])
        self.assertEqual(world.touching(), [])
        world.allow("b", "c", allowed=False)
        self.assertEqual(world.touching(), [("b", "c")])
        world.allow("b")
        self.assertEqual(world.touching(), [])
        world.allow("later")
        world.add("later", Set(SQUARE, SQUARE_FACES))
        self.assertEqual(world.touching(), [])

    def test_frames(self):
        world = self.row()
        world.allow("b", "c")
        world.allow("c", "d")
        poses = np.array([[at(0)], [at(-10)], [at(1.75 * 3)]])
        self.assertEqual(world.over(poses, ["a"]).tolist(), [True, False, True])
        self.assertEqual(world.touching(), [("a", "b")])  # a is where it was
        self.assertEqual(world.over(poses[:, :, :3], ["a"]).dtype, np.bool_)

    def test_bodies_inside_others(self):
        world = World()
        for name, radius, x in (("outer", 4, 0), ("middle", 2, 1), ("inner", 0.5, 0), ("beside", 1, 9)):
            world.add(name, sphere_mesh(12, radius), at(x))
        self.assertEqual(world.touching(), [])
        self.assertEqual(world.nested().inside, [("middle", "outer"), ("inner", "outer"), ("inner", "middle")])
        self.assertEqual(world.nested("middle").inside, [("middle", "outer"), ("inner", "middle")])
        world.move("inner", at(8.75))
        world.allow("outer", "middle")
        self.assertEqual(world.nested(), ([("inner", "beside")], [], []))
        vertices, faces = sphere_mesh(12)
        world.add("open", (vertices, faces[1:]), at(-20))
        world.add("turned", (vertices, faces[:, ::-1].copy()), at(-30))
        world.add("seed", Set.spheres([[0, 0, 0], [10, 0, 0]], [0.25, 0.25]), at(-30))
        unknown = world.nested().unknown
        self.assertEqual([(a, b) for a, b, _ in unknown], [("open", "seed"), ("turned", "seed")])
        self.assertIn("of open has an edge where the surface is open or not oriented", unknown[0][2])
        self.assertEqual(unknown[1][2], "turned goes around element 0 of seed -1 times, so that its normals point inwards")
        world.move("inner", at(100))
        world.move("seed", at(8.5))
        self.assertEqual(world.nested().overlapping, [("beside", "seed")])
        for other in (World(mode="surface"), World(precision="fp32")):
            with self.assertRaises(InputError) as caught:
                other.nested()
            self.assertIn("nested: ", str(caught.exception))

    def test_bodies_come_and_go(self):
        world = self.row()
        world.remove("b")
        self.assertEqual(world.touching(), [("c", "d")])
        world.add("ball", Set.spheres([[0, 0, 0]], [1]), at(0.5))
        self.assertEqual(world.touching(), [("a", "ball"), ("c", "d")])
        world.add("posed", Set(SQUARE, SQUARE_FACES, pose=at(40)))
        world.add("near", Set(SQUARE, SQUARE_FACES), at(41))
        self.assertEqual(world.touching("posed"), [("posed", "near")])
        skins = World(mode="surface")
        skins.add("inner", Set.spheres([[0, 0, 0]], [1], solid=False))
        skins.add("outer", Set.spheres([[0, 0, 0]], [2], solid=False))
        self.assertFalse(skins.any())

    def test_bad_input_is_one_line(self):
        world = self.row()
        for call, text in (
            (lambda: world.add("a", Set(SQUARE, SQUARE_FACES)), "name: 'a' is taken"),
            (lambda: world.move("x", at(0)), "there is no body 'x'; there are: a, b, c, d"),
            (lambda: world.remove("x"), "there is no body 'x'"),
            (lambda: world.pairs("a", "x"), "there is no body 'x'"),
            (lambda: world.touching("x"), "there is no body 'x'"),
            (lambda: world.move("a", np.zeros((4, 4))), "pose"),
            (lambda: world.move("a", [1, 2]), "pose: its shape is (2,)"),
            (lambda: world.over(np.zeros((2, 4, 4)), ["a"]), "poses: its shape is (2, 4, 4), not (frames, 1, 4, 4)"),
            (lambda: world.add("s", Set.spheres([[0, 0, 0]], [1], solid=False)), "s: it has elements of kind sphere"),
            (lambda: World(mode="soft"), "mode: 'soft' is unknown; known: solid, surface"),
            (lambda: World(precision="fp16"), "precision: 'fp16' is unknown"),
        ):
            with self.subTest(text), self.assertRaises(InputError) as caught:
                call()
            self.assertIn(text, str(caught.exception))
            self.assertNotIn("\n", str(caught.exception))
        with self.assertRaises(TypeError):
            world.add("", Set(SQUARE, SQUARE_FACES))
        world.move("a", at(1e39))
        with self.assertRaises(InputError) as caught:
            world.touching()
        self.assertIn("body a, element 0", str(caught.exception))
        world.move("a", at(0))
        self.assertTrue(world.any())


if __name__ == "__main__":
    unittest.main()
