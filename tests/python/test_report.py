"""Pages: the program's own for the same sets, written whole or not at all, and shown by Jupyter."""

import html
import json
import os
import pickle
import re
import subprocess
import tempfile
import unittest
import warnings

import meetc
import numpy as np

import shapes

MEET = os.environ.get("MEETC_MEET", "")


def shifted(x, y=0.0, z=0.0):
    pose = np.eye(4)
    pose[:3, 3] = x, y, z
    return pose


class Reports(unittest.TestCase):
    def setUp(self):
        self.ball = meetc.Set(*shapes.sphere_mesh(24))
        self.other = meetc.Set(*shapes.sphere_mesh(16), pose=shifted(0.7), name="other <b>")

    def test_a_report_says_what_the_queries_say(self):
        page = meetc.report(self.ball, self.other)
        pairs = meetc.pairs(self.ball, self.other)
        of_a, of_b = meetc.hits(self.ball, self.other)
        self.assertGreater(len(pairs), 10)
        self.assertIn(f"{len(pairs)} pairs touch: {of_a.sum()} faces of A, {of_b.sum()} faces of B", page.html)
        self.assertIn('["B","other \\u003cb>, moved"]', page.html)
        self.assertIn("Contacts", page.html)
        self.assertEqual(page.title, "A and other <b>")
        self.assertEqual(page.html, meetc.report(self.ball, self.other, threads=1).html)
        self.assertNotEqual(page.html, meetc.report(self.ball, self.other.at(shifted(0.8))).html)
        self.assertEqual(pickle.loads(pickle.dumps(page)), page)

    def test_every_kind(self):
        ball = meetc.Set.spheres([[0, 0, 0.875]], 0.5)
        for other in (meetc.Set.spheres([[0, 0, 0.875]], 0.5, solid=False), ball, meetc.Set.points([[0, 0, 1]]),
                      meetc.Set.segments([[0, 0, 0.5]], [[0, 0, 2]])):
            for a, b in ((self.ball, other), (other, self.ball)):
                with self.subTest(a=a.kind, b=b.kind):
                    self.assertIn(f"{meetc.count(a, b):,} pairs touch", meetc.report(a, b).html)
        self.assertIn("1 pair touches", meetc.report(ball, meetc.Set.spheres([[0, 0, 1]], 0.125)).html)
        box = meetc.Set.boxes([[0, 0, 0]], [[1, 1, 1]])
        self.assertIn("1 pair touches", meetc.report(box, box.at(shifted(1.0))).html)
        self.assertIn("Nothing touches", meetc.report(box, box.at(shifted(2.0))).html)

    def test_jupyter_gets_the_whole_page_in_a_frame(self):
        page = meetc.report(self.ball, self.other)
        cell = page._repr_html_()
        found = re.fullmatch(r'<iframe srcdoc="([^"]*)" title="[^"<>]*" style="[^"]*" allowfullscreen></iframe>', cell, re.S)
        self.assertTrue(found)
        self.assertEqual(html.unescape(found[1]), page.html)
        self.assertRegex(repr(page), r"^<meetc.Report: A and .*, \d+\.\d MB>$")

    def test_a_page_is_saved_whole_or_not_at_all(self):
        page = meetc.report(self.ball, self.other)
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "out.html")
            page.save(path)
            with open(path, encoding="utf-8", newline="") as file:
                self.assertEqual(file.read(), page.html)
            with self.assertRaisesRegex(meetc.InputError, "name it 'out.html'"):
                page.save("out.png")
            with self.assertRaises(OSError):
                page.save(os.path.join(folder, "none", "out.html"))
            os.mkdir(os.path.join(folder, "is.html"))
            with self.assertRaises(OSError):
                page.save(os.path.join(folder, "is.html"))
            self.assertEqual(sorted(os.listdir(folder)), ["is.html", "out.html"])

    def test_bad_input_is_one_line(self):
        with self.assertRaisesRegex(meetc.InputError, "a: its elements are of kind point, not triangles"):
            meetc.report(meetc.Set.points([[0, 0, 0]]))
        with self.assertRaisesRegex(meetc.InputError, "precision: 'fp32' goes with two sets"):
            meetc.report(self.ball, precision="fp32")
        with self.assertRaisesRegex(meetc.InputError, "precision: 'fp16' is unknown"):
            meetc.report(self.ball, self.other, precision="fp16")

    @unittest.skipUnless(os.path.exists(MEET), "the program meet is not there")
    def test_pages_are_those_of_the_program(self):
        with tempfile.TemporaryDirectory() as folder:
            a, b, out = (os.path.join(folder, name) for name in ("a.obj", "b.obj", "out.html"))
            square = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0.1\nf 1 2 3 4\n"
            with open(a, "w", encoding="ascii") as file:
                file.write(square + "v 0.3 0.3 -1\nv 0.4 0.4 1\nv 0.35 0.3 1\nf 5 6 7\n")
            with open(b, "w", encoding="ascii") as file:
                file.write("v 0.5 0.5 -1\nv 0.6 0.5 1\nv 0.5 0.6 1\nf 1 2 3\n")
            with warnings.catch_warnings():
                warnings.simplefilter("ignore")
                sets = [meetc.Set.read(path) for path in (a, b)]

            def program(*words):
                done = subprocess.run([MEET, "collide", *words, "--report", out], capture_output=True, text=True)
                self.assertEqual(done.returncode, 0, done.stderr)
                with open(out, encoding="utf-8", newline="") as file:
                    return file.read()

            self.assertEqual(meetc.report(*sets).html, program(a, b))
            self.assertEqual(meetc.report(*sets[::-1], precision="exact").html, program(b, a, "--precision", "exact"))
            self.assertEqual(meetc.report(sets[0], sets[0]).html, program(a, a))
            self.assertEqual(meetc.report(sets[0]).html, program("--self", a))
            self.assertEqual(meetc.report(sets[0], merge=False).html, program("--self", a, "--no-merge"))

    @unittest.skipUnless(os.path.exists(MEET), "the program meet is not there")
    def test_pages_of_bodies_are_those_of_the_program(self):
        with tempfile.TemporaryDirectory() as folder:
            paths = {name: os.path.join(folder, name) for name in ("ball.obj", "open.obj", "cell.json", "poses.npy", "out.html")}
            vertices, faces = shapes.sphere_mesh(8)
            for name, some in (("ball.obj", faces), ("open.obj", faces[2:])):
                with open(paths[name], "w", encoding="ascii") as file:
                    file.writelines(f"v {x!r} {y!r} {z!r}\n" for x, y, z in np.float32(vertices).tolist())
                    file.writelines(f"f {a} {b} {c}\n" for a, b, c in (some + 1).tolist())
            poses = np.tile(np.eye(4), (3, 3, 1, 1))
            poses[0, :, 0, 3] = 0, 1.5, 3
            poses[1, :, 0, 3] = 0, 5, 10
            poses[2, :, 0, 3], poses[2, 1, :3, :3], poses[2, 2, :3, :3] = (0, 0, 20), np.eye(3) / 4, np.eye(3) / 8
            np.save(paths["poses.npy"], poses)
            bodies = [("a", "ball.obj"), ("b", "ball.obj"), ("c", "open.obj")]
            with open(paths["cell.json"], "w", encoding="ascii") as file:
                json.dump({"bodies": [{"name": n, "file": f} for n, f in bodies], "allow": [["a", "c"]]}, file)
            world = meetc.World()
            sets = {name: meetc.Set.read(paths[name]) for name in ("ball.obj", "open.obj")}
            for name, file in bodies:
                world.add(name, sets[file])
            world.allow("a", "c")
            before = world.pose("b").tolist()
            for words, page in (
                ([], world.report()), (["--poses", paths["poses.npy"]], world.report(poses, ["a", "b", "c"]))
            ):
                command = [MEET, "collide", "--world", paths["cell.json"], *words, "--report", paths["out.html"]]
                done = subprocess.run(command, capture_output=True, text=True)
                self.assertEqual(done.returncode, 0, done.stderr)
                with open(paths["out.html"], encoding="utf-8", newline="") as file:
                    self.assertEqual(page.html, file.read())
            self.assertEqual(world.pose("b").tolist(), before)
            self.assertIn("in 2 of 3 frames some bodies touch or lie in one another", page.html)
            self.assertIn("<iframe", world._repr_html_())
            with self.assertRaisesRegex(meetc.InputError, "names: the bodies of no poses"):
                world.report(names=["a"])
            self.assertIn('"title":"0 bodies"', meetc.World().report().html)


if __name__ == "__main__":
    unittest.main()
