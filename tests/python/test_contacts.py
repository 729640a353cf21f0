"""Where pairs meet, against exact arithmetic and known curves."""

import os
import pickle
import tempfile
import unittest
from fractions import Fraction

import meetc
import numpy as np
from exact import exact_rows, interval, is_rounded_once, normal, on_triangle
from meetc import Set
from shapes import MEET, SQUARE, SQUARE_FACES, lattice_triangles, run_meet, sphere_mesh


def with_area(triangles):
    return np.array([t for t in triangles if any(normal(exact_rows(t)))], np.float32)


def node_lists(found):
    return [found.corners[i:j].tolist() for i, j in zip(found.offsets, found.offsets[1:])]


class Pairs(unittest.TestCase):
    def check(self, found, a, b, wanted_pairs):
        """Corners lie on both triangles; points are the exact ones, rounded once; names belong to their elements."""
        self.assertTrue(np.array_equal(found.pairs, wanted_pairs))
        sizes = len(found.codes), len(found.offsets) - 1, len(found)
        self.assertEqual(sizes, (len(found.pairs),) * 3)
        exact_a, exact_b = exact_rows(a), exact_rows(b)
        exact = [found.exact(i) for i in range(len(found.points))]
        for number, place in zip(found.points, exact):
            for x, wanted in zip(number, place):
                self.assertTrue(is_rounded_once(x, wanted))
        for (i, j), nodes, shape in zip(found.pairs.tolist(), node_lists(found), found.shape.tolist()):
            self.assertEqual(shape, min(len(nodes), 3))
            self.assertEqual(len({exact[n] for n in nodes}), len(nodes))
            for n in nodes:
                self.assertTrue(on_triangle(exact[n], exact_a[i]) and on_triangle(exact[n], exact_b[j]))
        for part, of in ((found.on_a, exact_a), (found.on_b, exact_b)):
            for place, (element, dimension, carrier) in zip(exact, part.tolist()):
                triangle = of[element]
                if dimension == 0:
                    self.assertEqual(list(place), triangle[carrier])
                else:
                    on = triangle if dimension == 2 else [triangle[carrier - 3], triangle[(carrier - 2) % 3]]
                    at = on_triangle(place, on) if dimension == 2 else on_line(place, *on)
                    self.assertTrue(at)

    def test_lattice_triangles_are_as_exact_arithmetic_says(self):
        rng = np.random.default_rng(11)
        a, b = (with_area(lattice_triangles(rng, n, 4)) for n in (40, 30))
        found = meetc.contacts(Set.triangles(a), Set.triangles(b))
        self.check(found, a, b, meetc.pairs(Set.triangles(a), Set.triangles(b)))
        self.assertEqual(set(found.shape), {1, 2, 3})
        flat = found.coplanar
        self.assertTrue(0 < flat.sum() < len(flat))
        self.assertTrue(flat[found.shape == 3].all())

    def test_random_triangles_in_both_types(self):
        rng = np.random.default_rng(12)
        a, b = (rng.random((30, 3, 3), np.float32) for _ in range(2))
        sets = Set.triangles(a), Set.triangles(b)
        for type_ in (np.float64, np.float32):
            found = meetc.contacts(*sets, dtype=type_)
            self.assertEqual(found.points.dtype, type_)
            self.check(found, a, b, meetc.pairs(*sets))
        self.assertGreater(len(found), 100)
        self.assertEqual(len(found.pieces), len(found))  # in general position

    def test_segments_and_triangles_in_either_order(self):
        rng = np.random.default_rng(13)
        triangles = with_area(lattice_triangles(rng, 60, 4))
        ends = rng.integers(0, 4, (2, 80, 3)).astype(np.float32)
        ends = ends[:, (ends[0] != ends[1]).any(axis=1)]
        segments, mesh = Set.segments(*ends), Set.triangles(triangles)
        found, turned = meetc.contacts(segments, mesh), meetc.contacts(mesh, segments)
        self.assertTrue(np.array_equal(found.pairs, meetc.pairs(segments, mesh)))
        self.assertTrue(np.array_equal(turned.pairs, meetc.pairs(mesh, segments)))
        exact = exact_rows(triangles)
        for (i, j), nodes in zip(found.pairs.tolist(), node_lists(found)):
            p, q = exact_rows(ends[0, i]), exact_rows(ends[1, i])
            wanted = [tuple(x + t * (y - x) for x, y in zip(p, q)) for t in sorted(set(interval(p, q, exact[j])))]
            self.assertEqual([found.exact(n) for n in nodes], wanted)
        places = {tuple(p): {found.exact(n) for n in nodes} for p, nodes in zip(found.pairs.tolist(), node_lists(found))}
        for (j, i), nodes in zip(turned.pairs.tolist(), node_lists(turned)):
            self.assertEqual({turned.exact(n) for n in nodes}, places[i, j])
        self.assertTrue((turned.on_b["carrier"] <= 3).all())
        self.assertTrue((found.on_a["carrier"] <= 3).all())
        self.assertTrue((turned.on_a["carrier"] > 3).any())

    def test_poses_move_the_sets_before_they_meet(self):
        vertices, faces = sphere_mesh(10)
        pose = np.eye(4)
        pose[:3, 3] = 0.3, 0.2, 0.1
        moved = (vertices.astype(np.float64) + pose[:3, 3]).astype(np.float32)
        a = Set(vertices, faces)
        for found, wanted in (
            (meetc.contacts(a, a.at(pose)), meetc.contacts(a, Set(moved, faces))),
            (meetc.contacts(a.at(pose), a), meetc.contacts(Set(moved, faces), a)),
        ):
            self.assertGreater(len(found), 20)
            self.assertTrue(np.array_equal(found.points, wanted.points))
            self.assertTrue(np.array_equal(found.codes, wanted.codes))

    def test_faces_of_a_file_and_their_triangles(self):
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "dart.obj")
            with open(path, "w", encoding="ascii") as file:
                file.write("v 9 9 9\nv 0 0 0\nv 2 1 0\nv 4 0 0\nv 2 4 0\nf 1 1 1\nf 2 3 4 5\n")
            dart = Set.read(path)
        wall = Set.triangles([[[-9, 2, -1], [9, 2, -1], [0, 2, 9]]])
        found = meetc.contacts(dart, wall)
        self.assertEqual((found.pairs.tolist(), found.faces.tolist()), ([[1, 0], [2, 0]], [[1, 0], [1, 0]]))
        self.assertEqual(meetc.pairs(dart, wall).tolist(), [[1, 0]])
        self.assertEqual(sorted(found.points[:, 0].tolist()), [1, 2, 3])
        self.assertIs((plain := meetc.contacts(wall, wall)).faces, plain.pairs)

    def test_bad_input(self):
        square, ball = Set(SQUARE, SQUARE_FACES), Set.spheres([[0, 0, 0]], [1])
        boxes = Set.boxes([[0, 0, 0]], [[1, 1, 1]])
        with self.assertRaisesRegex(meetc.InputError, "^contacts: it is asked of two meshes, .* not of box and box"):
            meetc.contacts(boxes, boxes)
        with self.assertRaisesRegex(meetc.InputError, "^check_embedded: it is asked of two meshes, not of ball and triangle"):
            meetc.contacts(ball, square, check_embedded=True)
        with self.assertRaisesRegex(TypeError, "^dtype: points are float32 or float64, not int64$"):
            meetc.contacts(square, square, dtype=int)
        with self.assertRaisesRegex(IndexError, "^exact: there is no point 99; there are 4$"):
            meetc.contacts(square, square).exact(99)
        self.assertEqual(len(meetc.contacts(square, Set(SQUARE + 9, SQUARE_FACES)).points), 0)


    def test_embedded_meshes_are_told(self):
        square, twice = Set(SQUARE, SQUARE_FACES), Set(SQUARE, np.concatenate([SQUARE_FACES, SQUARE_FACES[:1]]))
        self.assertIsNone(meetc.contacts(square, square).embedded)
        self.assertIs(meetc.contacts(square, square, check_embedded=True).embedded, True)
        self.assertIs(meetc.contacts(square, twice, check_embedded=True).embedded, False)


class Round(unittest.TestCase):
    def test_balls_and_segments_meet_in_roots(self):
        balls, lines = Set.spheres([[5, 5, 5], [0, 0, 0]], [1, 1]), Set.segments([[0, 0, 0]], [[2, 2, 0]])
        for found, on in ((meetc.contacts(balls, lines), "on_a"), (meetc.contacts(lines, balls), "on_b")):
            self.assertEqual(len(found), 1)
            self.assertEqual(getattr(found, on)["dimension"].tolist(), [3, 2])
            self.assertEqual(found.points.tolist(), [[0, 0, 0], [0.5**0.5, 0.5**0.5, 0]])
            self.assertEqual(found.exact(0), (0, 0, 0))
            x, y, z = found.exact(1)
            self.assertEqual((x, z), (y, 0))
            self.assertEqual(x.rational**2 + x.factor**2 * x.radicand, Fraction(1, 2))
            self.assertEqual(float(x), 0.5**0.5)
            self.assertEqual(pickle.loads(pickle.dumps(found)).exact(1), (x, y, z))

    def test_roots_are_rounded_once(self):
        rng = np.random.default_rng(5)
        ends = rng.normal(size=(200, 2, 3)).astype(np.float32)
        for solid in (True, False):
            found = meetc.contacts(Set.spheres([[0.125, 0.25, 0.375]], [0.875], solid=solid), Set.segments(ends[:, 0], ends[:, 1]))
            self.assertGreater(len(found.points), 50)
            for i, at in enumerate(found.points):
                self.assertEqual([float(x) for x in found.exact(i)], at.tolist())

    def test_witnesses_lie_on_both(self):
        balls, mesh = Set.spheres([[0.25, 0.25, 0.5], [9, 9, 9]], [1, 1]), Set(SQUARE, SQUARE_FACES)
        found = meetc.contacts(balls, mesh)
        self.assertEqual((len(found.points), found.witness_pairs.tolist()), (0, list(range(len(found)))))
        self.assertTrue(0 < len(found) == len(found.witnesses))
        for x, y, z in found.witnesses:
            self.assertTrue(abs(z) < 1e-12 and (x - 0.25) ** 2 + (y - 0.25) ** 2 + 0.25 <= 1 + 1e-12)
        self.assertIn("witness", repr(found))
        self.assertIn("witnesses", found._repr_html_())


def on_line(x, p, q):
    """Whether a point is inside a segment."""
    k = max(range(3), key=lambda k: abs(q[k] - p[k]))
    t = (x[k] - p[k]) / (q[k] - p[k])
    return 0 < t < 1 and all(p[i] + t * (q[i] - p[i]) == x[i] for i in range(3))


class Curves(unittest.TestCase):
    def test_a_sphere_and_a_plane_meet_in_one_loop(self):
        vertices, faces = sphere_mesh(30)
        plane = (np.array([[-2, -2, 0.5], [2, -2, 0.5], [2, 2, 0.5], [-2, 2, 0.5]], np.float32), SQUARE_FACES)
        found = meetc.contacts((vertices, faces), plane)
        lines = found.lines()
        self.assertEqual((len(lines), lines.closed.tolist(), len(found.patches())), (1, [True], 0))
        nodes = lines[0]
        self.assertEqual(sorted(nodes.tolist()), list(range(len(found.points))))
        self.assertEqual({frozenset(p) for p in found.pieces.tolist()},
                         {frozenset(p) for p in zip(nodes.tolist(), np.roll(nodes, -1).tolist())})
        loop = found.points[nodes]
        self.assertTrue((loop[:, 2] == 0.5).all())
        square = (loop[:, :2] ** 2).sum(axis=1)
        self.assertTrue((square < 0.7501).all() and (square > 0.73).all())
        self.assertEqual(len(found.single_nodes), 0)

    def test_three_planes_and_a_vertical_one_meet_in_three_chains(self):
        layers = np.vstack([SQUARE + np.float32([0, 0, z]) for z in (1, 2, 3)])
        faces = np.vstack([SQUARE_FACES + 4 * i for i in range(3)])
        wall = [[[0.25, -9, -9], [0.25, 20, -9], [0.25, 0, 30]]]
        found = meetc.contacts((layers, faces), Set.triangles(wall))
        lines = found.lines()
        self.assertEqual((len(lines), lines.closed.tolist()), (3, [False] * 3))
        self.assertEqual([found.points[line][0, 2] for line in lines], [1, 2, 3])
        self.assertEqual(lines[-1].tolist(), lines[2].tolist())
        with self.assertRaises(IndexError):
            lines[3]

    def test_squares_in_one_plane_overlap_in_patches(self):
        found = meetc.contacts((SQUARE, SQUARE_FACES), (SQUARE + np.float32([0.25, 0.5, 0]), SQUARE_FACES))
        patches = found.patches()
        self.assertTrue(len(patches) > 1 and patches.closed.all())
        area = 0.0
        for nodes, pair in zip(patches, found.patch_pairs):
            x, y = found.points[nodes][:, :2].T
            piece = (x * np.roll(y, -1) - y * np.roll(x, -1)).sum() / 2
            self.assertGreater(piece, 0)  # counter-clockwise from the tip of a's normal
            self.assertEqual(found.corners[found.offsets[pair] : found.offsets[pair + 1]].tolist(), nodes.tolist())
            area += piece
        self.assertEqual(area, 0.75 * 0.5)

    @unittest.skipUnless(MEET, "the program meet is not built")
    def test_the_same_as_meet_collide_writes(self):
        with tempfile.TemporaryDirectory() as folder:
            run_meet("demo", "-o", os.path.join(folder, "demo"))
            names = [os.path.join(folder, "demo", name) for name in ("animal.ply", "figure.ply")]
            out = os.path.join(folder, "contacts.obj")
            run_meet("collide", *names, "--contacts", out)
            with open(out, encoding="ascii") as file:
                rows = [line.split() for line in file]
            found = meetc.contacts(Set.read(names[0]), Set.read(names[1]), dtype=np.float32)
        points = np.array([row[1:] for row in rows if row[0] == "v"], np.float32)
        self.assertGreater(len(points), 50)
        self.assertTrue(np.array_equal(points, found.points))
        written = [[int(n) - 1 for n in row[1:]] for row in rows if row[0] == "l"]
        lines = found.lines()
        self.assertEqual(written, [n.tolist() + n[:1].tolist() * bool(c) for n, c in zip(lines, lines.closed)])


class Objects(unittest.TestCase):
    def setUp(self):
        rng = np.random.default_rng(14)
        sets = [Set.triangles(rng.random((20, 3, 3), np.float32)) for _ in range(2)]
        self.found = meetc.contacts(*sets)

    def test_arrays_are_the_memory_in_which_contacts_were_found(self):
        f = self.found
        for array, type_, wide in (
            (f.points, np.float64, (3,)), (f.codes, np.uint64, ()), (f.corners, np.int32, ()), (f.offsets, np.int64, ()),
            (f.pieces, np.int32, (2,)), (f.lines().nodes, np.int32, ()), (f.lines().closed, np.bool_, ()),
            (f.single_nodes, np.int32, ()), (f.patch_pairs, np.int32, ()),
        ):
            self.assertEqual((array.dtype, array.shape[1:]), (type_, wide))
            self.assertEqual(type(array.base).__name__ == "PyCapsule", array.size > 0)
        self.assertEqual(len(f.patch_pairs), 0)
        self.assertEqual(f.on_a.dtype.names, ("element", "dimension", "carrier"))
        self.assertIn("PyCapsule", type(f.on_a.base).__name__)

    def test_pickles(self):
        again = pickle.loads(pickle.dumps(self.found))
        for name in ("pairs", "codes", "points", "corners", "on_a", "on_b", "pieces"):
            self.assertTrue(np.array_equal(getattr(again, name), getattr(self.found, name)), name)
        self.assertEqual([line.tolist() for line in again.lines()], [line.tolist() for line in self.found.lines()])
        self.assertEqual(again.exact(-1), self.found.exact(len(self.found.points) - 1))
        self.assertIsInstance(again.exact(0)[0], Fraction)

    def test_pages(self):
        f = self.found
        self.assertEqual(
            repr(f), f"<meetc.Contacts: {len(f)} pairs, {len(f.points)} points, {len(f.lines())} lines, 0 patches>"
        )
        square = (SQUARE, SQUARE_FACES[:1])
        self.assertIn("1 pair, 3 points, 0 lines, 1 patch>", repr(meetc.contacts(square, square)))
        self.assertIn(f"<tr><th>points</th><td>{len(f.points)} in float64</td></tr>", f._repr_html_())
        self.assertRegex(repr(f.lines()), "^<meetc.Lines: [0-9]+ of [0-9]+ nodes, [0-9]+ closed>$")

    def test_threads_and_repetition_give_the_same_bytes(self):
        v, f = sphere_mesh(20)
        a, b = Set(v, f), Set(v + np.float32(0.25), f)
        wanted = pickle.dumps(meetc.contacts(a, b))
        for threads in (1, 3):
            self.assertEqual(pickle.dumps(meetc.contacts(a, b, threads=threads)), wanted)


if __name__ == "__main__":
    unittest.main()
