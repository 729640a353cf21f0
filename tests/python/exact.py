"""Triangles and segments in exact arithmetic: the judge of points."""

from fractions import Fraction

import numpy as np


def exact_rows(numbers):
    """Nested lists of fractions."""
    if np.ndim(numbers):
        return [exact_rows(x) for x in numbers]
    return Fraction(float(numbers))


def minus(a, b):
    return [x - y for x, y in zip(a, b)]


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def normal(t):
    return cross(minus(t[1], t[0]), minus(t[2], t[0]))


def between(p, q, t):
    return tuple(x + t * (y - x) for x, y in zip(p, q))


def interval(p, q, triangle):
    """The part of p + t (q - p), 0 <= t <= 1, in a triangle with area: the first and the last t, or None."""
    n = normal(triangle)
    low, high = Fraction(0), Fraction(1)
    above_p, above_q = dot(n, minus(p, triangle[0])), dot(n, minus(q, triangle[0]))
    if above_p != above_q:
        low = high = above_p / (above_p - above_q)
    elif above_p != 0:
        return None
    for i in range(3):
        inward = cross(n, minus(triangle[(i + 1) % 3], triangle[i]))
        at_p, at_q = dot(inward, minus(p, triangle[i])), dot(inward, minus(q, triangle[i]))
        slope = at_q - at_p
        if slope == 0:
            if at_p < 0:
                return None
        elif slope > 0:
            low = max(low, -at_p / slope)
        else:
            high = min(high, -at_p / slope)
    return (low, high) if 0 <= low <= high <= 1 else None


def on_triangle(x, triangle):
    """Whether a point is on a triangle with area."""
    n = normal(triangle)
    return dot(n, minus(x, triangle[0])) == 0 and all(
        dot(cross(n, minus(triangle[(i + 1) % 3], triangle[i])), minus(x, triangle[i])) >= 0 for i in range(3)
    )


def is_rounded_once(number, exact):
    """Whether no number of this type is nearer than `number`."""
    off = abs(Fraction(float(number)) - exact)
    to = number.dtype.type(np.inf)
    return all(off <= abs(Fraction(float(np.nextafter(number, way))) - exact) for way in (to, -to))
