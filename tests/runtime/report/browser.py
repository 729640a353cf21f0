#!/usr/bin/env python3
"""browser.py MEET: pages of `meet collide --report` in Chromium without a window.

Each page, opened with #test, draws itself, counts its own pixels, chooses a pair in its list and tries its tools; it writes
what it saw into its own text (runtime/report/page/src/test.js). Exits with 77 where there is no Chromium."""

import html
import json
import math
import os
import re
import shutil
import subprocess
import sys

FLAGS = ["--headless=new", "--no-sandbox", "--use-gl=angle", "--use-angle=swiftshader", "--enable-unsafe-swiftshader",
         "--hide-scrollbars", "--window-size=1200,800"]


def browser():
    for name in ["chromium", "chromium-browser", "google-chrome"]:
        if shutil.which(name):
            return shutil.which(name)
    print("SKIPPED: there is no Chromium: install the package chromium")
    sys.exit(77)


def meet(*words):
    said = subprocess.run([sys.argv[1], *words], capture_output=True, text=True)
    if said.returncode != 0:
        sys.exit(f"meet {' '.join(words)}: {said.stderr}")
    return said.stdout


def tried(chromium, page):
    """The JSON that the page writes about itself.

    On a busy machine Chromium's virtual time may run out while a page is still being unpacked, which then says nothing.
    """
    profile = os.path.abspath("profile")
    address = "file://" + os.path.abspath(page) + "#test"
    command = [chromium, *FLAGS, f"--user-data-dir={profile}", "--virtual-time-budget=60000", "--dump-dom", address]
    for _ in range(5):
        shutil.rmtree(profile, ignore_errors=True)
        said = subprocess.run(command, capture_output=True, text=True, timeout=600)
        found = re.search(r'<pre id="test"[^>]*>(.*?)</pre>', said.stdout, re.S)
        if found:
            return json.loads(html.unescape(found.group(1)))
    sys.exit(f"{page}: the page has not tried itself\n{said.stderr[-2000:]}")


wrong = []


def check(page, what, holds, seen):
    print(f"{'ok' if holds else 'WRONG'}: {page}: {what}: {seen}")
    if not holds:
        wrong.append(f"{page}: {what}")


def check_tools(page, t, close=True):
    """close: a click flies so close that wires leave room between them."""
    p = t["pixels"]
    drawn = {name: c["all"] - c["back"] for name, c in p.items()}
    check(page, "no fault", t["faults"] == [], t["faults"])
    check(page, "there is a picture", drawn["whole"] > 0.05 * p["whole"]["all"], drawn["whole"])
    if close:
        check(page, "wireframe draws less", drawn["wireframe"] < drawn["near"], (drawn["wireframe"], drawn["near"]))
    check(page, "the plane cuts", drawn["clipped"] < 0.9 * drawn["solid"], drawn["clipped"])
    check(page, "dark is dark", max(p["dark"]["corner"]) < 60 < 200 < min(p["light"]["corner"]), p["dark"]["corner"])
    check(page, "at rest it draws nothing", t["frames_at_rest"] == 0, t["frames_at_rest"])


def check_pairs(page, t, pairs):
    """pairs: the texts of the list's rows."""
    p = t["pixels"]
    check(page, "every pair is listed", t["rows"]["all"] == len(pairs), t["rows"])
    check(page, "few rows are in the page", t["rows"]["shown"] < 60, t["rows"])
    check(page, "a click chooses", t["chosen"]["text"] == "3" + pairs[2], t["chosen"])
    check(page, "a click flies", t["chosen"]["moved"] and t["view_returns"], t["chosen"])
    check(page, "the next pair", t["next"] == "4" + pairs[3], t["next"])
    check(page, "the last pair", t["last"] == f"{len(pairs)}{pairs[-1]}", t["last"])
    whole = p["whole"]["yellow"] + p["whole"]["vermilion"]
    near = p["near"]["yellow"] + p["near"]["vermilion"]
    check(page, "what touches shows", whole > 50, whole)
    check(page, "what touches shows larger", near > 2 * whole, near)


def pairs_of(path, name_a, name_b):
    with open(path, encoding="utf-8") as file:
        rows = [line.strip().split(",") for line in file][1:]
    return [f"{name_a} {a} – {name_b} {b}" for a, b in rows]


def write_crossing(path):
    """A torus whose section is the figure eight, so that it crosses itself along a circle."""
    n, m = 32, 16
    with open(path, "w", encoding="utf-8") as file:
        for i in range(n):
            for j in range(m):
                b, a = 2 * math.pi * i / n, 2 * math.pi * j / m
                away = 1 - 0.2 * math.cos(a)
                file.write(f"v {away * math.cos(b)} {away * math.sin(b)} {0.2 * math.sin(2 * a)}\n")
        for i in range(n):
            for j in range(m):
                p, q, r, s = (1 + (i + u) % n * m + (j + v) % m for u, v in [(0, 0), (1, 0), (1, 1), (0, 1)])
                file.write(f"f {p} {q} {r}\nf {p} {r} {s}\n")


def main():
    chromium = browser()
    meet("demo", "-o", "demo")
    animal, figure = os.path.join("demo", "animal.ply"), os.path.join("demo", "figure.ply")
    t = tried(chromium, os.path.join("demo", "animal-figure.html"))
    meet("collide", animal, figure, "--pairs", "two.csv")
    check_tools("two", t)
    check_pairs("two", t, pairs_of("two.csv", "A", "B"))
    check("two", "contacts are there", t["contacts"]["pieces"] > 1000, t["contacts"])
    check("two", "contacts show", t["pixels"]["whole"]["curve"] > 20, t["pixels"]["whole"]["curve"])
    for name in ["knot-rods", "gear-balls", "balls-balls"]:
        t = tried(chromium, os.path.join("demo", name + ".html"))
        check_tools(name, t)
        check(name, "a click flies", t["chosen"]["moved"], t["chosen"])
    write_crossing("eight.obj")
    meet("collide", "eight.obj", "--self", "--pairs", "self.csv", "--report", "self.html")
    t = tried(chromium, "self.html")
    check_tools("self", t)
    check_pairs("self", t, pairs_of("self.csv", "A", "A"))
    with open("cell.json", "w", encoding="utf-8") as file:
        json.dump({"bodies": [{"name": "one", "file": animal}, {"name": "two", "file": figure}]}, file)
    with open("poses.csv", "w", encoding="utf-8") as file:
        file.write("frame,body,x,y,z,qw,qx,qy,qz\nnear,two,0,0,0,1,0,0,0\nfar,two,9,0,0,1,0,0,0\n")
    meet("collide", "--world", "cell.json", "--poses", "poses.csv", "--report", "world.html")
    t = tried(chromium, "world.html")
    check_tools("world", t, close=False)
    check("world", "a click flies", t["chosen"]["moved"] and "one – two" in t["chosen"]["text"], t["chosen"])
    p = t["pixels"]
    check("world", "what touches is coloured", p["whole"]["yellow"] > 1000, p["whole"]["yellow"])
    check("world", "the last frame has nothing that touches", p["last_frame"]["yellow"] == 0, p["last_frame"])
    check("world", "its name", t["frame"] == "Frame far" and t["count"] == "0 pairs of bodies", t["frame"])
    if wrong:
        sys.exit("\n".join(wrong))


main()
