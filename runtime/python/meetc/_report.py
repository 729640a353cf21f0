"""Pages for a browser, and for a cell of Jupyter."""

from __future__ import annotations

import html
import json
import os
import re
import secrets
from collections.abc import Sequence
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from meetc import _arrays, _native
from meetc._asked import ask
from meetc._errors import InputError
from meetc._set import Set, as_set
from meetc._types import Doubles, Meshlike, Precision


@dataclass(frozen=True, repr=False)
class Report:
    """A page that shows a collision: one HTML file, which needs no network. In Jupyter a cell shows it."""

    html: str  #: the page

    @property
    def title(self) -> str:
        """The names of the sets."""
        found = re.search(r'"title":("(?:[^"\\]|\\.)*")', self.html)
        return str(json.loads(found[1])) if found else ""

    def save(self, path: str | os.PathLike[str]) -> None:
        """Writes the page. Where that fails, there is no new file, and an old one is as it was."""
        name = os.fsdecode(path)
        if os.path.splitext(name)[1].lower() not in (".html", ".htm"):
            better = os.path.splitext(name)[0] + ".html"
            raise InputError(f"path: {name!r} is no name of a page; name it {better!r}", array="path", value=name)
        temporary = os.path.join(os.path.dirname(name), f".meet-{secrets.token_hex(8)}")
        handle = os.open(temporary, os.O_WRONLY | os.O_CREAT | os.O_EXCL, 0o666)
        try:
            with open(handle, "w", encoding="utf-8", newline="") as file:
                file.write(self.html)
            os.replace(temporary, name)
        except BaseException:
            os.unlink(temporary)
            raise

    def __repr__(self) -> str:
        return f"<meetc.Report: {self.title}, {len(self.html.encode()) / 1e6:.1f} MB>"

    def _repr_html_(self) -> str:
        return (
            f'<iframe srcdoc="{html.escape(self.html)}" title="{html.escape(self.title)}" '
            'style="width: 100%; height: 600px; border: 0" allowfullscreen></iframe>'
        )


def report(
    a: Meshlike, b: Meshlike | None = None, *, precision: Precision = "certified", merge: bool = True, threads: int = 0
) -> Report:
    """A page on which a collision is looked at: both sets, the elements that touch, where they meet, the list of pairs.

    Without `b` it shows where the mesh `a` crosses itself, as self_pairs(a, merge=merge) finds it. The page is that of
    `meet collide --report`. World.report() is that of many bodies.

        page = meetc.report(a, b)
        page                            # in Jupyter
        page.save("touching.html")
    """
    if b is None:
        return _of_one(a, precision, merge, threads)
    asked = ask(a, b, precision, threads)
    parts = asked.of_elements().question().pairs(False)
    items = asked.question().pairs(asked.turned)
    other = None if asked.b is asked.a else _as_side(asked.b, "B")
    page = _native.page_of_two(
        _as_side(asked.a, "A"), other, asked.predicate, asked.turned, precision, items, parts, asked.threads
    )
    return Report(page.decode())


def _of_one(mesh: Meshlike, precision: Precision, merge: bool, threads: int) -> Report:
    if precision != "certified":
        raise InputError(f"precision: {precision!r} goes with two sets; a mesh with itself is certified", value=precision)
    threads = _arrays.require_threads(threads)
    of = as_set(mesh, "a", threads)
    if of.kind != "triangle":
        raise InputError(f"a: its elements are of kind {of.kind}, not triangles; name a second set", array="a", value=of.kind)
    source = of._source
    parts, _ = _native.self_pairs(of._ready, source.numbers, source.corners, source.owner, bool(merge), threads)
    items = parts if source.owner is None else np.unique(source.items_of(parts), axis=0)
    return Report(_native.page_of_one(_as_side(of, "A"), bool(merge), items, parts, threads).decode())


class BodiesFrame(NamedTuple):
    """A frame of a page of bodies, which are named by their numbers."""

    name: str
    moved: list[tuple[int, Doubles]]
    touching: list[tuple[int, int, int]]  #: with the number of pairs
    nested: list[tuple[int, int, str, str]]


def of_bodies(
    names: Sequence[str], sets: Sequence[Set], poses: Sequence[Doubles], frames: list[BodiesFrame], precision: Precision
) -> Report:
    """The page of many bodies; those of one source have one shape."""
    shapes: dict[int, int] = {}
    sides: list[_native._Side] = []
    bodies: list[tuple[str, int, Doubles]] = []
    for name, of, at in zip(names, sets, poses):
        if id(of._source) not in shapes:
            shapes[id(of._source)] = len(sides)
            sides.append(_as_side(of, name))
        bodies.append((_text(name), shapes[id(of._source)], at))
    rows = [(f.name, f.moved, f.touching, f.nested) for f in frames]
    return Report(_native.page_of_bodies(sides, bodies, rows, precision).decode())


def _as_side(of: Set, letter: str) -> _native._Side:
    s = of._source
    return (
        s.native_kind(), s.numbers, s.corners, s.owner, s.items, of._pose, _text(of.name or letter), s.rounded.numbers,
        s.rounded.largest, [_text(note) for note in s.notes],
    )


def _text(name: str) -> str:
    """The name, with U+FFFD for bytes of a file's name that are no UTF-8."""
    return os.fsencode(name).decode("utf-8", "replace")
