"""Sets that lie on a CUDA device, and queries there. Tests that need a device are skipped where there is none."""

import ctypes
import ctypes.util
import glob
import unittest
from concurrent.futures import ThreadPoolExecutor

import meetc
import numpy as np
from meetc import DeviceSet, Set
from shapes import SQUARE, SQUARE_FACES, lattice_triangles, lifted, sphere_mesh

HERE = "cuda" in meetc.devices()


class OnVulkan:
    def __dlpack_device__(self):
        return (7, 0)

    def __dlpack__(self, stream=None):
        raise AssertionError("nothing may be read")


class Producer:
    """An array on the device, as CuPy has one, made by the CUDA runtime alone."""

    def __init__(self, values, stride=None):
        self.runtime = runtime()
        self.host = np.ascontiguousarray(values)
        wide = self.host.dtype.itemsize * self.host.shape[1]
        self.stride = stride or wide
        self.address = ctypes.c_void_p()
        self.call("cudaMalloc", ctypes.byref(self.address), ctypes.c_size_t(self.stride * len(self.host)))
        self.call("cudaMemcpy2D", self.address, ctypes.c_size_t(self.stride), self.host.ctypes.data_as(ctypes.c_void_p),
                  ctypes.c_size_t(wide), ctypes.c_size_t(wide), ctypes.c_size_t(len(self.host)), ctypes.c_int(1))

    def call(self, name, *arguments):
        error = getattr(self.runtime, name)(*arguments)
        if error:
            raise RuntimeError(f"{name}: error {error}")

    def __del__(self):
        self.runtime.cudaFree(self.address)


class ByInterface(Producer):
    stream = 1

    @property
    def __cuda_array_interface__(self):
        strides = (self.stride, self.host.dtype.itemsize)
        packed = self.stride == self.host.dtype.itemsize * self.host.shape[1]
        return {"version": 3, "shape": self.host.shape, "typestr": self.host.dtype.str, "data": (self.address.value, False),
                "strides": None if packed else strides, "stream": self.stream}


class Tensor(ctypes.Structure):
    _fields_ = [("data", ctypes.c_void_p), ("device_kind", ctypes.c_int32), ("device", ctypes.c_int32),
                ("dimensions", ctypes.c_int32), ("type", ctypes.c_uint8), ("bits", ctypes.c_uint8),
                ("lanes", ctypes.c_uint16), ("shape", ctypes.POINTER(ctypes.c_int64)),
                ("strides", ctypes.POINTER(ctypes.c_int64)), ("offset", ctypes.c_uint64)]


NAME = ctypes.create_string_buffer(b"dltensor")
DELETER = ctypes.CFUNCTYPE(None, ctypes.c_void_p)


class Managed(ctypes.Structure):
    _fields_ = [("of", Tensor), ("context", ctypes.c_void_p), ("deleter", DELETER)]


lent = []  # a producer lives until its tensors are given back


class ByDLPack(Producer):
    deleted = 0
    streams = ()

    def __dlpack_device__(self):
        return (2, 0)

    def __dlpack__(self, stream=None):
        self.streams += (stream,)
        item = self.host.dtype.itemsize
        shape = (ctypes.c_int64 * 2)(*self.host.shape)
        strides = (ctypes.c_int64 * 2)(self.stride // item, 1)
        kind = {"i": 0, "u": 1, "f": 2}[self.host.dtype.kind]
        tensor = Tensor(self.address, 2, 0, 2, kind, 8 * item, 1, shape, strides, 0)
        managed = Managed(tensor, None, DELETER(self.delete))
        new = ctypes.pythonapi.PyCapsule_New
        new.restype, new.argtypes = ctypes.py_object, [ctypes.c_void_p, ctypes.c_char_p, ctypes.c_void_p]
        lent.append((self, managed, shape, strides))
        return new(ctypes.addressof(managed), NAME, None)

    def delete(self, _):
        self.deleted += 1


def runtime():
    names = [ctypes.util.find_library("cudart"), "libcudart.so", "libcudart.so.12", "libcudart.so.13"]
    names += glob.glob("/usr/local/cuda*/lib64/libcudart.so") + glob.glob("/usr/local/cuda*/targets/*/lib/libcudart.so*")
    for name in filter(None, names):
        try:
            return ctypes.CDLL(name)
        except OSError:
            pass
    raise unittest.SkipTest("libcudart is not found")


class Anywhere(unittest.TestCase):
    def test_the_host_is_always_a_device(self):
        self.assertIn(meetc.devices(), (["cpu"], ["cpu", "cuda"]))

    def test_bad_input(self):
        square = Set(SQUARE, SQUARE_FACES)
        with self.assertRaisesRegex(meetc.InputError, "^device: 'gpu' is unknown; known: cpu, cuda$"):
            meetc.pairs(square, square, device="gpu")
        self.assertTrue(issubclass(meetc.DeviceError, meetc.MeetError) and issubclass(meetc.DeviceError, RuntimeError))

    @unittest.skipIf(HERE, "there is a device")
    def test_without_a_device_one_line_says_so(self):
        square = Set(SQUARE, SQUARE_FACES)
        for call in (lambda: meetc.pairs(square, square, device="cuda"), lambda: DeviceSet(SQUARE, SQUARE_FACES)):
            with self.assertRaises((meetc.DeviceError, TypeError)) as raised:
                call()
            self.assertNotIn("\n", str(raised.exception))


@unittest.skipUnless(HERE, "no CUDA device, or a build without CUDA")
class There(unittest.TestCase):
    def test_host_sets_give_the_same_answers_there(self):
        rng = np.random.default_rng(31)
        a, b = Set.triangles(lattice_triangles(rng, 500, 4)), Set.triangles(lattice_triangles(rng, 400, 4))
        balls = Set.spheres(rng.integers(0, 4, (100, 3)), 0.5)
        for first, second in ((a, b), (a, a), (a, balls), (balls, a)):
            wanted = meetc.pairs(first, second)
            self.assertGreater(len(wanted), 100)
            self.assertTrue(np.array_equal(meetc.pairs(first, second, device="cuda"), wanted))
            self.assertEqual(meetc.count(first, second, device="cuda"), len(wanted))
            self.assertIs(meetc.touches(first, second, device="cuda"), True)
            for there, here in zip(meetc.hits(first, second, device="cuda"), meetc.hits(first, second)):
                self.assertTrue(np.array_equal(there, here))
            for there, here in zip(meetc.counts(first, second, device="cuda"), meetc.counts(first, second)):
                self.assertTrue(np.array_equal(there, here))

    def test_arrays_there_are_read_where_they_lie(self):
        vertices, faces = sphere_mesh(24)
        wanted = meetc.pairs(Set(vertices, faces), Set(vertices, faces, pose=lifted(0.25)))
        self.assertGreater(len(wanted), 100)
        for kind in (ByInterface, ByDLPack):
            for stride in (None, 20):
                numbers, index = kind(vertices, stride), kind(faces)
                here = DeviceSet(numbers, index)
                moved = DeviceSet(numbers, index, pose=lifted(0.25))
                self.assertEqual((len(here), here.kind), (len(faces), "triangle"))
                self.assertEqual(repr(here), f"<meetc.DeviceSet: {len(faces):,} of kind triangle>")
                self.assertTrue(np.array_equal(meetc.pairs(here, moved), wanted))
                self.assertTrue(np.array_equal(meetc.pairs(here, here.at(lifted(0.25))), wanted))
                self.assertEqual(meetc.count(here, Set(vertices, faces, pose=lifted(0.25))), len(wanted))
                self.assertFalse(meetc.touches(here, here.at(lifted(9))))
            unsigned = DeviceSet(kind(vertices), kind(faces.astype(np.uint32)))
            self.assertTrue(np.array_equal(meetc.pairs(unsigned, moved), wanted))
        rows = vertices[faces].reshape(-1, 9)
        self.assertTrue(np.array_equal(meetc.pairs(DeviceSet(ByInterface(rows)), moved), wanted))

    def test_faces_of_64_bits_are_narrowed_there(self):
        vertices, faces = sphere_mesh(24)
        mesh = DeviceSet(ByInterface(vertices), ByDLPack(faces.astype(np.int64)))
        moved = Set(vertices, faces, pose=lifted(0.25))
        self.assertTrue(np.array_equal(meetc.pairs(mesh, moved), meetc.pairs(Set(vertices, faces), moved)))
        self.assertTrue(np.array_equal(meetc.pairs(mesh.at(lifted(0.25)), mesh), meetc.pairs(moved, Set(vertices, faces))))

    def test_first_hits_there(self):
        rng = np.random.default_rng(32)
        mesh = Set.triangles(lattice_triangles(rng, 500, 4))
        start, end = rng.integers(-2, 6, (2, 300, 3)).astype(np.float32)
        segments = Set.segments(start, end)
        wanted = meetc.first(segments, mesh)
        self.assertGreater((wanted >= 0).sum(), 50)
        self.assertTrue(np.array_equal(meetc.first(segments, mesh, device="cuda"), wanted))
        for there, here in zip(meetc.first(segments, mesh, points=True, device="cuda"),
                               meetc.first(segments, mesh, points=True)):
            self.assertTrue(np.array_equal(there, here, equal_nan=True))
        rows = DeviceSet(ByInterface(np.concatenate([start, end], axis=1)), kind="segment")
        self.assertTrue(np.array_equal(meetc.first(rows, mesh), wanted))

    def test_many_poses_there(self):
        rng = np.random.default_rng(33)
        mesh, other = (Set.triangles(lattice_triangles(rng, n, 4)) for n in (300, 200))
        balls = Set.spheres(rng.integers(0, 4, (50, 3)), 0.5)
        poses = np.tile(np.eye(4), (40, 1, 1))
        poses[:, :3, 3] = rng.integers(-12, 13, (40, 3)) / 2
        for a, b in ((mesh, other), (mesh, balls), (balls, mesh), (mesh, mesh)):
            for want in ("count", "any"):
                here = meetc.over_poses(a, b, poses, want=want)
                self.assertTrue(0 < (here > 0).sum() < len(poses))
                self.assertTrue(np.array_equal(meetc.over_poses(a, b, poses, want=want, device="cuda"), here))
        self.assertTrue(np.array_equal(meetc.pairs(mesh, mesh, device="cuda"), meetc.pairs(mesh, mesh)))

    def test_formulas_there(self):
        rng = np.random.default_rng(34)
        centres = rng.normal(size=(1000, 3)).astype(np.float32)
        a, b = Set.spheres(centres[:500], 0.7), Set.spheres(centres[500:], 0.5)
        text = "norm2(meet(sphere, sphere))"
        pairs = meetc.pairs(a, b)
        self.assertGreater(len(pairs), 1000)
        rows = [np.concatenate([centres[:500], np.full((500, 1), 0.7, np.float32)], axis=1),
                np.concatenate([centres[500:], np.full((500, 1), 0.5, np.float32)], axis=1)]
        for type_ in (np.float32, np.float64):
            for operands, at in (((a, b), pairs), (rows, pairs), (rows, None), ((rows[0], rows[1][0]), None)):
                here = meetc.evaluate(text, *operands, rows=at, dtype=type_)
                there = meetc.evaluate(text, *operands, rows=at, dtype=type_, device="cuda")
                for name, values in here.items():
                    self.assertEqual(values.dtype, there[name].dtype)
                    scale = np.abs(values).max() * np.finfo(type_).eps  # a processor may have no fused multiply-add
                    self.assertTrue(np.allclose(values, there[name], rtol=0, atol=64 * scale))

    def test_a_world_there(self):
        vertices, faces = sphere_mesh(24)
        small = Set(vertices * 0.25, faces)
        worlds = [meetc.World(device=device) for device in ("cpu", "cuda")]
        for world in worlds:
            world.add("a", Set(vertices, faces))
            world.add("b", Set(vertices, faces), lifted(9))
            world.add("c", small, lifted(30))
        for height, place in ((9, 30), (0.25, 30), (9, 0), (9, 8.5), (1.5, 1)):
            for world in worlds:
                world.move("b", lifted(height))
                world.move("c", lifted(place))
            here, there = worlds
            self.assertEqual(there.touching(), here.touching())
            self.assertEqual(there.any(), here.any())
            self.assertEqual(there.nested(), here.nested())
            self.assertTrue(np.array_equal(there.matrix(), here.matrix()))
            self.assertTrue(np.array_equal(there.pairs("a", "b"), here.pairs("a", "b")))
        frames = np.stack([np.stack([lifted(h)]) for h in (0.1, 5, 1, 40)])
        self.assertTrue(np.array_equal(worlds[1].over(frames, ["b"]), worlds[0].over(frames, ["b"])))
        worlds[1].remove("a")
        self.assertEqual(worlds[1].touching(), [])

    def test_dlpack_is_given_our_stream_and_its_memory_back(self):
        vertices, faces = ByDLPack(SQUARE), ByDLPack(SQUARE_FACES)
        mesh = DeviceSet(vertices, faces)
        self.assertEqual((vertices.streams, vertices.deleted), ((1,), 0))
        self.assertEqual(meetc.count(mesh, mesh), 4)
        del mesh
        self.assertEqual((vertices.deleted, faces.deleted), (1, 1))

    def test_threads_take_turns(self):
        vertices, faces = sphere_mesh(24)
        numbers, index = ByInterface(vertices), ByInterface(faces)
        moved = DeviceSet(numbers, index, pose=lifted(0.25))
        wanted = meetc.pairs(DeviceSet(numbers, index), moved)
        with ThreadPoolExecutor(4) as pool:
            results = list(pool.map(lambda _: meetc.pairs(DeviceSet(numbers, index), moved), range(32)))
        for found in results:
            self.assertTrue(np.array_equal(found, wanted))

    def test_bad_input_there(self):
        numbers, index = ByInterface(SQUARE), ByInterface(SQUARE_FACES)
        for call, error, text in (
            (lambda: DeviceSet(ByInterface(SQUARE.astype(float)), index), TypeError,
             "vertices: on a device, numbers are of type <f4, not <f8"),
            (lambda: DeviceSet(numbers, ByInterface(SQUARE_FACES.astype(np.int16))), TypeError,
             "faces: on a device, numbers are of type <i4 or <u4 or <i8, not <i2"),
            (lambda: meetc.count(DeviceSet(numbers, ByInterface(SQUARE_FACES.astype(np.int64) - (1 << 32))), Set(SQUARE, SQUARE_FACES)),
             meetc.InputError, "element 0"),
            (lambda: meetc.first(DeviceSet(numbers, index), Set(SQUARE, SQUARE_FACES)), meetc.InputError,
             "first: it is asked of segments and triangles, not of triangle and triangle"),
            (lambda: meetc.over_poses(Set(SQUARE, SQUARE_FACES), Set(SQUARE, SQUARE_FACES), lifted(1e300)[None],
                                      device="cuda"), meetc.InputError, "pose 0: "),
            (lambda: DeviceSet(numbers), meetc.InputError, "vertices: its shape is (4, 3), not (n, 9)"),
            (lambda: DeviceSet(SQUARE, index), TypeError, "vertices: an array on the device is needed, not ndarray"),
            (lambda: DeviceSet(OnVulkan(), index), TypeError, "vertices: it lies on a device of kind 7"),
            (lambda: DeviceSet(numbers, index, pose=np.zeros((4, 4))), meetc.InputError, "pose"),
            (lambda: DeviceSet(ByInterface(np.ones((1, 4), np.float32)), kind="ball", pose=np.diag([1, 2, 1, 1])),
             meetc.InputError, "pose: the pose is no similarity"),
            (lambda: meetc.pairs(DeviceSet(numbers, ByInterface(SQUARE_FACES + 2)), Set(SQUARE, SQUARE_FACES)),
             meetc.InputError, "element 0"),
            (lambda: meetc.contacts(DeviceSet(numbers, index), Set(SQUARE, SQUARE_FACES)), TypeError, "a: "),
            (lambda: Set(numbers, index), TypeError, "vertices: it lies on a device"),
        ):
            with self.subTest(text), self.assertRaises(error) as raised:
                call()
            self.assertIn(text, str(raised.exception))
            self.assertNotIn("\n", str(raised.exception))


if __name__ == "__main__":
    unittest.main()
