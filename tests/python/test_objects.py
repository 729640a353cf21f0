"""Objects with a mesh, pages for people, and help()."""

import inspect
import io
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
