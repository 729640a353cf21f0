"""Bad input: one exception, of one line that names array, row and value."""

import os
import pickle
import tempfile
import unittest
import warnings
from types import SimpleNamespace

import meetc
import numpy as np
from meetc import Set
from shapes import SQUARE, SQUARE_FACES, lifted

SET = Set(SQUARE, SQUARE_FACES)
BALLS = Set.spheres([[0, 0, 0]], [1])
LINE = "norm2(meet(sphere, line))"


def changed(array, index, value):
    out = np.array(array)
    out[index] = value
    return out


def pose(index, value):
    return changed(np.eye(4), index, value)


class OnDevice:
    __cuda_array_interface__ = {"version": 3}


class OnDeviceByDLPack:
    def __dlpack_device__(self):
        return (2, 0)

    def __dlpack__(self, stream=None):
        raise AssertionError("nothing may be read")


def flat(*numbers, points=SQUARE):
    """An object with flat faces, as PyVista has them."""
    return SimpleNamespace(points=points, faces=np.array(numbers))


INPUT, TYPE, INDEX = meetc.InputError, TypeError, IndexError
nan = np.nan
# The call, the exception, and a part of its line.
CASES = [
    # shapes
    (lambda: Set(SQUARE[:, :2], SQUARE_FACES), INPUT, "vertices: its shape is (4, 2), not (n, 3)"),
    (lambda: Set(SQUARE, SQUARE_FACES.ravel()), INPUT, "faces: its shape is (6,), not (n, 3)"),
    (lambda: Set(SQUARE, [[0, 1, 2, 3]]), INPUT, "faces: its shape is (1, 4), not (n, 3)"),
    (lambda: Set(SQUARE), INPUT, "vertices: its shape is (4, 3), not (n, 3, 3) or (n, 9)"),
    (lambda: Set(3.0, SQUARE_FACES), INPUT, "vertices: its shape is ()"),
    (lambda: Set([[1, 2], [3]], SQUARE_FACES), INPUT, "vertices: its rows have different lengths"),
    (lambda: Set.segments([[0, 0, 0]], [[0, 0, 0]] * 2), INPUT, "end: it has 2 rows, and start has 1"),
    (lambda: Set.spheres([[0, 0, 0]] * 2, [1, 2, 3]), INPUT, "radii: it has 3 rows, and centres has 2"),
    (lambda: Set.rays([[0, 0, 0]], [0, 0, 1], length=1), INPUT, "directions: its shape is (3,), not (1, 3)"),
    (lambda: Set(flat(4, 0, 1, 2, 3, 2, 0, 1)), INPUT, "faces[5] is 2, and a face has 3 corners or more"),
    (lambda: Set(flat(-3, 0, 1, 2)), INPUT, "faces[0] is -3, and a face has 3 corners or more"),
    (lambda: Set(flat(3, 0, 1, 2, 4, 0, 1, 2)), INPUT, "faces[4] is 4, and 3 numbers follow it"),
    (lambda: Set(flat(3, 0, 1, 2, 2**62, 0, 1, 2)), INPUT, "faces[4] is 4611686018427387904, and 3 numbers follow it"),
    (lambda: Set(flat(4, 0, 1, 2, 3, 3, 0, 1, 4)), INPUT, "faces[8] is 4, and vertices has 4 rows"),
    (lambda: Set(flat(3, 0, 1, 2, 3, 0, -1, 2)), INPUT, "faces[6] is -1, and an index is at least 0"),
    (lambda: Set(flat(3.0, 0, 1, 2)), TYPE, "faces: indices are integers, not float64"),
    (lambda: Set(SimpleNamespace(points=SQUARE, faces=np.zeros(0, int))), INPUT, "faces: it is empty"),
    (lambda: Set(flat(3, 0, 1, 2, 4, 0, 1, 2, 3, points=changed(SQUARE, (3, 1), nan))), INPUT,
     "vertices[3, 1] is nan (a corner of face 1)"),
    # types
    (lambda: Set(SQUARE.astype(complex), SQUARE_FACES), TYPE,
     "vertices: an array of numbers is needed, not of complex128"),
    (lambda: Set(np.array([["a"] * 3]), SQUARE_FACES), TYPE, "vertices: an array of numbers is needed, not of <U1"),
    (lambda: Set(SQUARE, SQUARE_FACES.astype(float)), TYPE, "faces: indices are integers, not float64"),
    (lambda: Set(SQUARE, SQUARE_FACES > 0), TYPE, "faces: an array of numbers is needed, not of bool"),
    (lambda: Set(OnDevice(), SQUARE_FACES), TYPE, "vertices: it lies on a device, and this build has the CPU alone"),
    (lambda: Set(SQUARE, OnDevice()), TYPE, "faces: it lies on a device"),
    (lambda: Set(OnDeviceByDLPack(), SQUARE_FACES), TYPE, "vertices: it lies on a device"),
    (lambda: meetc.pairs(SET, (SQUARE, OnDeviceByDLPack())), TYPE, "faces: it lies on a device"),
    (lambda: Set([[0, 0, 0, 1]], [[0, 0, 0]], kind="ball"), TYPE, "faces: elements of kind 'ball' have none"),
    (lambda: meetc.pairs(SET, 3), TYPE, "b: a meetc.Set, a mesh with vertices and faces, or a tuple"),
    (lambda: meetc.pairs((1, 2, 3), SET), TYPE, "a: a meetc.Set"),
    (lambda: meetc.pairs(SET, SET, threads=1.5), TYPE, "threads: a whole number is needed, not float"),
    # indices
    (lambda: Set(SQUARE, changed(SQUARE_FACES, (1, 2), -1)), INPUT, "faces[1, 2] is -1, and an index is at least 0"),
    (lambda: Set(SQUARE, SQUARE_FACES.astype(np.int64) - 1), INPUT, "faces[0, 0] is -1"),
    (lambda: Set(SQUARE, changed(SQUARE_FACES, (1, 0), 4)), INPUT, "faces[1, 0] is 4, and vertices has 4 rows"),
    (lambda: Set(SQUARE, changed(SQUARE_FACES.astype(np.int64), (1, 1), 2**32)), INPUT, "faces[1, 1] is 4294967296"),
    (lambda: Set(SQUARE, changed(SQUARE_FACES.astype(np.uint64), (0, 1), 2**64 - 1)), INPUT,
     "faces[0, 1] is 18446744073709551615"),
    # values
    (lambda: Set(changed(SQUARE, (2, 1), nan), SQUARE_FACES), INPUT, "vertices[2, 1] is nan (a corner of face 0)"),
    (lambda: Set(changed(SQUARE, (3, 0), np.inf), SQUARE_FACES), INPUT, "vertices[3, 0] is inf (a corner of face 1)"),
    (lambda: Set(changed(SQUARE.astype(float), (2, 1), nan), SQUARE_FACES), INPUT, "vertices[2, 1] is nan"),
    (lambda: Set(changed(SQUARE.astype(float), (2, 1), -1e39), SQUARE_FACES), INPUT,
     "vertices[2, 1] is -1e+39, beyond float32"),
    (lambda: Set.points(changed(np.zeros((2, 3), int), (1, 2), 2**60)), INPUT,
     "points[1, 2] is 1152921504606846976, beyond 2^53"),
    (lambda: Set.triangles(changed(np.zeros((2, 3, 3), np.float32), (1, 2, 0), nan)), INPUT, "corners[1, 2, 0] is nan"),
    (lambda: Set.segments([[0, 0, 0]], np.array([[0, nan, 0]], np.float32)), INPUT, "end[0, 1] is nan"),
    (lambda: Set.spheres(np.zeros((2, 3)), np.array([1, nan], np.float32)), INPUT, "radii[1] is nan"),
    (lambda: Set.spheres(np.zeros((2, 3)), [1, -2]), INPUT,
     "centres[1] is [0.0, 0.0, 0.0], radii[1] is -2.0: a ball needs r >= 0"),
    (lambda: Set.boxes([[0, 0, 0]], [[1, -1, 1]]), INPUT,
     "low[0] is [0.0, 0.0, 0.0], high[0] is [1.0, -1.0, 1.0]: a box needs"),
    (lambda: Set.rays([[0, 0, 0]] * 2, [[0, 0, 1], [0, 0, 0]], length=1), INPUT, "directions[1] is zero"),
    (lambda: Set.rays([[0, 0, 0]], [[0, 0, 1]], length=-1), INPUT, "length: -1 is no length above 0"),
    # empty arrays
    (lambda: Set([], SQUARE_FACES), INPUT, "vertices: it is empty"),
    (lambda: Set(SQUARE, []), INPUT, "faces: it is empty"),
    (lambda: Set(SQUARE, SQUARE_FACES[:0]), INPUT, "faces: it is empty"),
    (lambda: Set.points(np.zeros((0, 3))), INPUT, "points: it is empty"),
    # poses
    (lambda: SET.at(np.eye(3)), INPUT, "pose: its shape is (3, 3), not (4, 4) or (3, 4)"),
    (lambda: SET.at(pose((1, 2), nan)), INPUT, "pose[1, 2] is nan"),
    (lambda: SET.at(pose((3, 0), 5)), INPUT,
     "pose[3] is [5.0, 0.0, 0.0, 1.0], and the last row of a pose is [0, 0, 0, 1]"),
    (lambda: SET.at(pose((0, 0), 0)), INPUT, "pose is no motion: it flattens space"),
    (lambda: SET.at(pose((0, 0), 1e39)), INPUT, "vertices[1, 0] is 1.0, and inf under the pose (a corner of face 0)"),
    (lambda: BALLS.at(pose((0, 0), 2)), INPUT, "pose: the pose is no similarity"),
    (lambda: Set.boxes([[0, 0, 0]], [[1, 1, 1]]).at(pose((0, 1), 1)), INPUT,
     "pose: a pose does more than move and scale"),
    (lambda: meetc.over_poses(SET, SET, np.eye(4)), INPUT, "poses: its shape is (4, 4), not (n, 4, 4) or (n, 3, 4)"),
    (lambda: meetc.over_poses(SET, SET, [lifted(0), pose((2, 2), nan)]), INPUT, "poses[1, 2, 2] is nan"),
    (lambda: meetc.over_poses(SET, SET, [lifted(0), pose((3, 3), 2)]), INPUT, "poses[1, 3] is [0.0, 0.0, 0.0, 2.0]"),
    (lambda: meetc.over_poses(SET, SET, [lifted(0), pose((2, 2), 0)]), INPUT, "poses[1] is no motion"),
    (lambda: meetc.over_poses(SET, SET, [lifted(0), pose((0, 0), 1e39)]), INPUT, "pose 1: element 0: x1 becomes inf"),
    (lambda: meetc.over_poses(SET, BALLS, [pose((0, 0), 2)]), INPUT, "poses: the pose is no similarity"),
    # names
    (lambda: Set(SQUARE, SQUARE_FACES, kind="cone"), INPUT, "kind: 'cone' is unknown; known: triangle, segment"),
    (lambda: meetc.pairs(SET, SET, precision="fp16"), INPUT, "precision: 'fp16' is unknown; known: certified, exact"),
    (lambda: meetc.over_poses(SET, SET, [np.eye(4)], want="all"), INPUT, "want: 'all' is unknown; known: count, any"),
    (lambda: meetc.pairs(SET, Set.boxes([[0, 0, 0]], [[1, 1, 1]])), INPUT,
     "there is no predicate for triangle with box; there are:"),
    (lambda: meetc.pairs(BALLS, Set.spheres([[0, 0, 0]], [1], solid=False)), INPUT,
     "there is no predicate for ball with sphere"),
    (lambda: meetc.first(SET, SET), INPUT, "first: it is asked of segments and triangles"),
    (lambda: meetc.pairs(SET, SET, threads=-1), INPUT, "threads: -1 is negative"),
    # formulas
    (lambda: meetc.evaluate("norm(x)", [1]), INPUT, "formula: 'norm(x)' is unknown; known: meet(plane, line)"),
    (lambda: meetc.evaluate(LINE, [0, 0, 0, 1]), INPUT, "it takes 2 operands, and here are 1"),
    (lambda: meetc.evaluate(LINE, [0, 0, 0], [0] * 6), INPUT, "operand 0: its shape is (3,), not (n, 4): x, y, z, r"),
    (lambda: meetc.evaluate(LINE, np.zeros((2, 4)), np.zeros((3, 6))), INPUT, "different numbers of rows: [2, 3]"),
    (lambda: meetc.evaluate(LINE, {"x": 1}, [0] * 6), INPUT, "operand 0: its columns are x, not x, y, z, r"),
    (lambda: meetc.evaluate(LINE, [0, 0, 0, 1], [[0] * 6], rows=[[0, 0], [0, 1]]), INDEX,
     "rows[1, 1] is 1, and operand 1 has 1 rows"),
    (lambda: meetc.evaluate(LINE, [0, 0, 0, 1], [[0] * 6], rows=[[-1, 0]]), INDEX, "rows[0, 0] is -1"),
    (lambda: meetc.evaluate(LINE, [0, 0, 0, 1], [[0] * 6], rows=[[0.5, 0]]), TYPE,
     "rows: they are integers, not float64"),
    (lambda: meetc.evaluate(LINE, BALLS, [0] * 6), TYPE, "both are sets"),
    (lambda: meetc.evaluate(LINE, BALLS, BALLS, rows=[[0, 0]]), INPUT,
     "it takes a line, and the set has elements of kind ball"),
    (lambda: meetc.evaluate(LINE, [0, 0, 0, 1], [0] * 6, dtype=int), TYPE,
     "dtype: values are float32 or float64, not int64"),
]


class BadInput(unittest.TestCase):
    def test_each_case_is_one_line_that_names_it(self):
        for number, (call, expected, text) in enumerate(CASES):
            with self.subTest(number=number, text=text), warnings.catch_warnings():
                warnings.simplefilter("ignore", meetc.RoundedWarning)
                with self.assertRaises(expected) as raised:
                    call()
                line = str(raised.exception)
                self.assertIn(text, line)
                self.assertNotIn("\n", line)

    def test_the_attributes_say_the_same(self):
        with self.assertRaises(ValueError) as raised:
            Set(SQUARE, changed(SQUARE_FACES, (1, 2), 77))
        error = raised.exception
        self.assertEqual((error.array, error.row, error.element, error.value), ("faces", 1, 1, 77))
        self.assertIsInstance(error, meetc.MeetError)
        again = pickle.loads(pickle.dumps(error))
        self.assertEqual((str(again), again.row, again.value), (str(error), 1, 77))
        with self.assertRaises(meetc.InputError) as raised:
            Set(changed(SQUARE, (3, 1), np.inf), SQUARE_FACES)
        error = raised.exception
        self.assertEqual((error.array, error.row, error.element, error.value), ("vertices", 3, 1, np.inf))

    def test_files(self):
        with self.assertRaises(FileNotFoundError):
            Set.read("no such file.ply")
        with tempfile.TemporaryDirectory() as folder:
            for name, text, wanted in (
                ("bad.obj", "v 0 0 0\nv 1 0 0\nf 1 2 3\n", "bad.obj:3"),
                ("bad.ply", "ply\nformat none 1.0\n", "bad.ply:2"),
                ("bad.csv", "x,y,z,r\n0,0,0,-1\n", "bad.csv:2"),
                ("bad.xyz", "", "unknown extension"),
            ):
                path = os.path.join(folder, name)
                with open(path, "w", encoding="ascii") as file:
                    file.write(text)
                with self.subTest(name), self.assertRaises(meetc.InputError) as raised:
                    Set.read(path)
                self.assertIn(wanted, str(raised.exception))
                self.assertEqual(raised.exception.array, path)

    def test_what_no_face_names_may_be_anything(self):
        vertices = np.vstack([SQUARE, [[nan, nan, nan]]]).astype(np.float32)
        self.assertEqual(meetc.count(Set(vertices, SQUARE_FACES), SET), 4)


if __name__ == "__main__":
    unittest.main()
