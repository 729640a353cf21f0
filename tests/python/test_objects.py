"""Objects with a mesh, pages for people, and help()."""

import inspect
import io
import pickle
import pydoc
import unittest
from types import SimpleNamespace

import meetc
import numpy as np
from meetc import Set
from shapes import SPIKE, SPIKE_FACES, SQUARE, SQUARE_FACES


class Objects(unittest.TestCase):
    def test_what_looks_like_a_mesh_is_one(self):
        class Tracked(np.ndarray):  # as trimesh has its arrays
            pass

        wanted = [[0, 0], [1, 0]]
        spike = Set(SPIKE, SPIKE_FACES)
        vertices, faces = SQUARE.astype(np.float64).view(Tracked), SQUARE_FACES.astype(np.int64).view(Tracked)
        trimesh = SimpleNamespace(vertices=vertices, faces=faces)
        flat = np.hstack([np.full((2, 1), 3), SQUARE_FACES]).ravel()
        pyvista = SimpleNamespace(points=SQUARE, faces=flat)
        regular = SimpleNamespace(points=SQUARE, faces=SQUARE_FACES)
        for mesh in (trimesh, pyvista, regular, (SQUARE, SQUARE_FACES), (SQUARE.tolist(), SQUARE_FACES.tolist())):
            self.assertEqual(meetc.pairs(mesh, spike).tolist(), wanted)
            self.assertEqual(meetc.pairs(spike, mesh).tolist(), [[0, 0], [0, 1]])
        self.assertEqual(len(Set(trimesh)), 2)
        self.assertEqual(len(Set(pyvista, name="square")), 2)

    def test_flat_faces_are_polygons(self):
        dart = np.array([[0, 0, 0], [2, 1, 0], [4, 0, 0], [2, 4, 0], [2, 0.25, 0]], np.float32)
        for type_ in (np.int32, np.int64, np.uint8):
            mesh = Set(SimpleNamespace(points=dart, faces=np.array([4, 0, 1, 2, 3, 3, 0, 4, 2], type_)))
            self.assertEqual((len(mesh), len(mesh._source.corners), mesh.notes), (2, 3, ()))
            ball = Set.spheres([[2, 3, 0]], [0.25])
            self.assertEqual(meetc.pairs(ball, mesh).tolist(), [[0, 0]])
            self.assertEqual(meetc.pairs(Set.points([[2, 0.5, 0]]), mesh).tolist(), [])  # in the notch
        again = pickle.loads(pickle.dumps(mesh))
        self.assertEqual((len(again), meetc.hits(again, ball)[0].tolist()), (2, [True, False]))
        bent = dart * np.float32([1, 1, 0]) + np.float32([0, 0, 1]) * (np.arange(5) == 3)[:, None]
        with self.assertWarnsRegex(meetc.MeetWarning, "^faces: 1 of 1 polygons is not planar") as caught:
            mesh = Set(SimpleNamespace(points=bent, faces=np.array([4, 0, 1, 2, 3])))
        self.assertEqual((caught.filename, len(mesh.notes), len(mesh)), (__file__, 1, 1))

    def test_an_array_of_the_host_comes_by_dlpack(self):
        class Array:
            def __init__(self, of):
                self.of = of

            def __dlpack__(self, stream=None):
                return self.of.__dlpack__()

            def __dlpack_device__(self):
                return self.of.__dlpack_device__()

        mesh = Set(Array(SQUARE), Array(SQUARE_FACES))
        self.assertEqual(meetc.count(mesh, mesh), 4)
        self.assertTrue(np.shares_memory(mesh._source.numbers, SQUARE))

    def test_pages(self):
        a = Set(SQUARE, SQUARE_FACES, name="a <b> & c", pose=[[1, 0, 0, 2], [0, 1, 0, 0], [0, 0, 1, 0]])
        self.assertEqual(repr(a), "<meetc.Set 'a <b> & c': 2 triangles in [2.0, 0.0, 0.0] to [3.0, 1.0, 0.0]>")
        page = a._repr_html_()
        self.assertIn("a &lt;b&gt; &amp; c", page)
        self.assertIn("<tr><th>elements</th><td>2 triangles</td></tr>", page)
        self.assertIn("<td>1, 0, 0, 2</td>", page)
        self.assertIn("1 box ", repr(Set.boxes([[0, 0, 0]], [[1, 1, 1]])))

    def test_help_helps(self):
        for name in meetc.__all__:
            thing = getattr(meetc, name)
            if not (inspect.isclass(thing) or inspect.isfunction(thing)):
                continue
            with self.subTest(name):
                self.assertTrue(inspect.getdoc(thing))
                self.assertEqual(thing.__module__, "meetc")
                out = io.StringIO()
                pydoc.Helper(output=out).help(thing)
                self.assertGreater(len(out.getvalue()), 100)
        for name, method in inspect.getmembers(Set):
            if not name.startswith("_") and name != "name":
                self.assertTrue(inspect.getdoc(method), name)
        self.assertIn("precision: 'Precision' = 'certified'", str(inspect.signature(meetc.pairs)))
        self.assertIn("meetc.pairs(a, b)", meetc.__doc__)

    def test_the_version_is_that_of_the_project(self):
        self.assertRegex(meetc.__version__, r"^[0-9]+[.][0-9]+[.][0-9]+$")


if __name__ == "__main__":
    unittest.main()
