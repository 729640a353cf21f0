"""meetc.trimesh.CollisionManager against the names, signatures and results of trimesh.collision's."""

import inspect
import unittest
from types import SimpleNamespace

import meetc
import numpy as np
from meetc.trimesh import CollisionManager, ContactData
from shapes import SQUARE, SQUARE_FACES, lifted, sphere_mesh

# The signatures of trimesh 3 and 4, without annotations.
SIGNATURES = {
    "add_object": ["name", "mesh", "transform=None"],
    "remove_object": ["name"],
    "set_transform": ["name", "transform"],
    "in_collision_single": ["mesh", "transform=None", "return_names=False", "return_data=False"],
    "in_collision_internal": ["return_names=False", "return_data=False"],
    "in_collision_other": ["other_manager", "return_names=False", "return_data=False"],
    "min_distance_single": ["mesh", "transform=None", "return_name=False", "return_data=False"],
    "min_distance_internal": ["name=None", "return_names=False", "return_data=False"],
    "min_distance_other": ["other_manager", "return_names=False", "return_data=False"],
}


def mesh(radius=1.0):
    v, f = sphere_mesh(12, radius)
    return SimpleNamespace(vertices=v, faces=f)


def shifted(x):
    pose = np.eye(4)
    pose[0, 3] = x
    return pose


class Manager(unittest.TestCase):
    def setUp(self):
        self.manager = CollisionManager()
        for i, name in enumerate(("b", "a", "c")):
            self.manager.add_object(name, mesh(), shifted(1.75 * i))

    def test_signatures(self):
        for name, wanted in SIGNATURES.items():
            found = inspect.signature(getattr(CollisionManager, name)).parameters.values()
            plain = [p.name + ("" if p.default is p.empty else f"={p.default}") for p in found]
            self.assertEqual(plain, ["self", *wanted], name)

    def test_internal(self):
        m = self.manager
        self.assertIs(m.in_collision_internal(), True)
        hit, names = m.in_collision_internal(return_names=True)
        self.assertEqual((hit, names), (True, {("a", "b"), ("a", "c")}))
        hit, data = m.in_collision_internal(return_data=True)
        wanted = meetc.pairs(mesh_at("b"), mesh_at("a"))
        first = [d for d in data if d.names == {"a", "b"}]
        self.assertEqual([[d.index("b"), d.index("a")] for d in first], wanted.tolist())
        self.assertEqual(m.in_collision_internal(True, True)[:2], (True, names))
        m.remove_object("a")
        self.assertEqual(m.in_collision_internal(return_names=True), (False, set()))
        self.assertIs(m.in_collision_internal(), False)

    def test_moving(self):
        m = self.manager
        m.set_transform("a", lifted(10))
        self.assertIs(m.in_collision_internal(), False)
        m.set_transform("a", shifted(5))
        self.assertEqual(m.in_collision_internal(return_names=True), (True, {("a", "c")}))
        m.add_object("a", mesh(), lifted(10))  # in the place of the first one
        self.assertIs(m.in_collision_internal(), False)

    def test_single(self):
        m = self.manager
        self.assertIs(m.in_collision_single(mesh()), True)
        self.assertIs(m.in_collision_single(mesh(), lifted(50)), False)
        hit, names, data = m.in_collision_single(mesh(0.5), shifted(-1), return_names=True, return_data=True)
        self.assertEqual((hit, names), (True, {"b"}))
        self.assertTrue(data)
        self.assertTrue(all(d.names == {"b", "__external"} for d in data))
        self.assertIsInstance(data[0], ContactData)
        self.assertIs(m.in_collision_single(mesh(0.5)), False)  # inside a surface

    def test_other(self):
        other = CollisionManager()
        other.add_object("x", mesh(), shifted(5))
        other.add_object("b", mesh(), shifted(-1.5))
        hit, names = self.manager.in_collision_other(other, return_names=True)
        self.assertEqual((hit, names), (True, {("c", "x"), ("b", "b")}))
        self.assertEqual(other.in_collision_other(self.manager, True)[1], {("x", "c"), ("b", "b")})
        self.assertIs(CollisionManager().in_collision_other(other), False)

    def test_errors(self):
        m = self.manager
        for call in (lambda: m.remove_object("q"), lambda: m.set_transform("q", np.eye(4))):
            with self.assertRaisesRegex(ValueError, "'q' is not in the collision manager; there are: 'b', 'a', 'c'"):
                call()
        with self.assertRaisesRegex(ValueError, "faces"):
            m.add_object("bad", (SQUARE, SQUARE_FACES + 9))
        self.assertEqual(m.in_collision_internal(return_names=True)[1], {("a", "b"), ("a", "c")})
        with self.assertRaisesRegex(NotImplementedError, "call in_collision_single"):
            m.min_distance_single(mesh())
        with self.assertRaisesRegex(NotImplementedError, "call in_collision_internal"):
            m.min_distance_internal()
        with self.assertRaisesRegex(NotImplementedError, "call in_collision_other"):
            m.min_distance_other(m)
        data = m.in_collision_internal(return_data=True)[1][0]
        for name in ("point", "normal", "depth"):
            with self.assertRaisesRegex(NotImplementedError, r"call index\(name\)"):
                getattr(data, name)


def mesh_at(name):
    return meetc.Set(mesh(), pose=shifted(1.75 * ("b", "a", "c").index(name)))


if __name__ == "__main__":
    unittest.main()
