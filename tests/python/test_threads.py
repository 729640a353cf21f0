"""Several threads of Python, the interpreter's lock, and Ctrl-C."""

import os
import signal
import subprocess
import sys
import threading
import time
import unittest
from concurrent.futures import ThreadPoolExecutor

import meetc
import numpy as np
from meetc import Set
from meetc._asked import ask
from meetc._contacts import contacts_of
from shapes import lattice_triangles, sphere_mesh

# Every pair of 40,000 triangles touches: a query of some minutes, which only a signal ends.
LONG = """
import meetc, numpy as np
t = np.random.default_rng(0).random((40000, 3, 3), np.float32)
a = meetc.Set.triangles(t)
print("begun", flush=True)
try:
    meetc.count(a, a, precision="exact")
except KeyboardInterrupt:
    print("interrupted", flush=True)
    print("still alive", meetc.count(meetc.Set.points([[9, 9, 9]]), a))
"""


class Threads(unittest.TestCase):
    def test_eight_threads_agree(self):
        rng = np.random.default_rng(7)
        a, b = Set.triangles(lattice_triangles(rng, 400, 4)), Set.triangles(lattice_triangles(rng, 400, 4))
        wanted = meetc.pairs(a, b)
        self.assertGreater(len(wanted), 1000)
        with ThreadPoolExecutor(8) as pool:
            results = list(pool.map(lambda i: meetc.pairs(a, b, threads=1 + i % 3), range(32)))
        for found in results:
            self.assertTrue(np.array_equal(found, wanted))

    def test_other_threads_run_during_a_query(self):
        rng = np.random.default_rng(8)
        a = Set.triangles(rng.random((4000, 3, 3), np.float32))
        ticks, stop = [], threading.Event()

        def tick():
            while not stop.is_set():
                ticks.append(time.perf_counter())
                time.sleep(0.001)

        other = threading.Thread(target=tick)
        other.start()
        try:
            start = time.perf_counter()
            meetc.count(a, a, threads=1, precision="exact")
            end = time.perf_counter()
        finally:
            stop.set()
            other.join()
        during = sum(start < t < end for t in ticks)
        self.assertGreater(end - start, 0.05)
        self.assertGreater(during, 5)

    def test_ctrl_c_ends_a_query(self):
        environment = dict(os.environ, PYTHONUNBUFFERED="1")
        with subprocess.Popen([sys.executable, "-c", LONG], stdout=subprocess.PIPE, text=True, env=environment) as child:
            self.assertEqual(child.stdout.readline(), "begun\n")
            time.sleep(1)
            child.send_signal(signal.SIGINT)
            sent = time.perf_counter()
            rest = child.stdout.read()
            took = time.perf_counter() - sent
        self.assertEqual(rest, "interrupted\nstill alive 0\n")
        self.assertEqual(child.returncode, 0)
        self.assertLess(took, 30)

    def test_a_handler_may_raise_what_it_likes(self):
        v, f = sphere_mesh(30)
        a = Set(v, f)
        crowd = Set.triangles(np.random.default_rng(9).random((40000, 3, 3), np.float32))

        class Enough(Exception):
            pass

        def handler(*_):
            raise Enough

        def many_poses():
            while True:
                meetc.over_poses(a, a, np.tile(np.eye(4), (2000, 1, 1)))

        before = signal.signal(signal.SIGALRM, handler)
        try:
            for call in (many_poses, lambda: meetc.self_pairs(crowd), lambda: meetc.contacts(crowd, crowd)):
                signal.setitimer(signal.ITIMER_REAL, 0.2)
                with self.assertRaises(Enough):
                    call()
        finally:
            signal.setitimer(signal.ITIMER_REAL, 0)
            signal.signal(signal.SIGALRM, before)
        self.assertGreater(meetc.count(a, a), len(f))

    def test_a_handler_ends_other_long_calls(self):
        rng = np.random.default_rng(10)
        numbers = rng.random((1000, 4), np.float32)
        spheres = Set.spheres(numbers[:, :3], numbers[:, 3], solid=False)
        rows = np.ascontiguousarray(rng.integers(0, 1000, (15_000_000, 2)), np.int32)
        corners = rng.random((20000, 3, 3), np.float32)
        asked = ask(Set.triangles(corners[:100]), Set.triangles(corners), "certified", 1)
        pairs = np.ascontiguousarray(np.tile(asked.question().pairs(False), (3, 1)))
        formula = {"dtype": np.float64, "threads": 1}
        many = rng.random((3_000_000, 3, 3), np.float32)
        crowd = Set.triangles(corners[:10000])
        world = meetc.World(threads=1)
        world.add("left", crowd)
        world.add("right", crowd, np.eye(4))
        poses = np.tile(np.eye(4), (4, 1, 1))

        class Enough(Exception):
            pass

        def handler(*_):
            raise Enough

        before = signal.signal(signal.SIGALRM, handler)
        try:
            for call in (
                lambda: meetc.evaluate("meet(sphere,sphere)", numbers, numbers, rows=rows, **formula),
                lambda: meetc.evaluate("meet(sphere,sphere)", spheres, spheres, rows=rows, **formula),
                lambda: contacts_of(asked, pairs, True),
                lambda: Set.triangles(many, threads=1),
                lambda: meetc.pairs(crowd, crowd.at(np.eye(4)), threads=1),
                world.touching,
                lambda: meetc.over_poses(crowd, crowd, poses, threads=1),
                lambda: meetc.self_pairs(crowd, threads=1),
            ):
                whole = min(seconds_of(call) for _ in range(2))
                stopped = []
                for _ in range(3):
                    signal.setitimer(signal.ITIMER_REAL, whole / 5)
                    start = time.perf_counter()
                    with self.assertRaises(Enough):
                        call()
                        time.sleep(1)
                    stopped.append(time.perf_counter() - start)
                self.assertLess(min(stopped), 0.8 * whole)
        finally:
            signal.setitimer(signal.ITIMER_REAL, 0)
            signal.signal(signal.SIGALRM, before)
        self.assertEqual(len(contacts_of(asked, pairs[:9], True)["codes"]), 9)


def seconds_of(call):
    start = time.perf_counter()
    call()
    return time.perf_counter() - start


if __name__ == "__main__":
    unittest.main()
