"""Meshes and judges for the tests of the package for Python."""

import os
import subprocess

import numpy as np

SQUARE = np.array([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]], np.float32)
SQUARE_FACES = np.array([[0, 1, 2], [0, 2, 3]], np.int32)
SPIKE = np.array([[0.25, 0.25, 0], [0, 1, 5], [1, 0, 5]], np.float32)
SPIKE_FACES = np.array([[0, 1, 2]], np.int32)
MEET = os.environ.get("MEETC_MEET", "")  # the program meet, where it is built


def lifted(z):
    pose = np.eye(4)
    pose[2, 3] = z
    return pose


def sphere_mesh(n, radius=1.0, centre=(0.0, 0.0, 0.0)):
    """A sphere of latitude and longitude: 2 n (n - 1) faces."""
    theta = np.linspace(0, np.pi, n + 1)[1:-1]
    phi = np.linspace(0, 2 * np.pi, n, endpoint=False)
    t, p = np.meshgrid(theta, phi, indexing="ij")
    ring = np.stack([np.sin(t) * np.cos(p), np.sin(t) * np.sin(p), np.cos(t)], axis=2).reshape(-1, 3)
    vertices = np.vstack([ring, [[0, 0, 1], [0, 0, -1]]]) * radius + np.array(centre)
    i, j = np.meshgrid(np.arange(n - 2), np.arange(n), indexing="ij")
    a, b = i * n + j, i * n + (j + 1) % n
    quads = np.concatenate([np.stack([a, a + n, b], 2).reshape(-1, 3), np.stack([b, a + n, b + n], 2).reshape(-1, 3)])
    j, last = np.arange(n), (n - 2) * n
    top = np.stack([np.full(n, (n - 1) * n), j, (j + 1) % n], 1)
    low = np.stack([np.full(n, (n - 1) * n + 1), last + (j + 1) % n, last + j], 1)
    return vertices.astype(np.float32), np.concatenate([quads, top, low]).astype(np.int32)


def lattice_triangles(rng, n, size=3):
    """Triangles on a small lattice, so that many are degenerate and touch at corners."""
    return rng.integers(0, size, (n, 3, 3)).astype(np.float32)


def run_meet(*arguments):
    return subprocess.run([MEET, *map(str, arguments)], check=True, capture_output=True, text=True).stdout
