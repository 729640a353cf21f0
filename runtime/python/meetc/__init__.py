"""Which elements of two sets touch, with proved answers.

    import meetc
    a = meetc.Set(vertices, faces)       # or Set(mesh), Set.segments, Set.spheres, Set.read, ...
    meetc.pairs(a, b)                    # (k, 2) int32, sorted
    meetc.touches(a, b.at(pose))         # bool

A set is a meetc.Set, which is prepared once and collided often, or a mesh: an object with vertices and faces (trimesh),
one with points and faces (PyVista), or a tuple (vertices, faces), which is prepared for this call.

    pairs, count, touches, hits, counts   what touches, as a list, a number, a bool, flags or numbers for each element
    contacts                              where they meet: points, segments, polygons, and the lines that these make
    self_pairs                            where a mesh crosses itself
    first, hit_points                     the triangle that a segment or a ray meets first, and where; all points of hits
    over_poses                            one set against another one in many poses
    DeviceSet, devices                    arrays that lie on a CUDA device, in a build with CUDA
    World                                 many bodies that move, and which of them touch or lie inside others
    report                                a page that shows what touches: save() writes it, and Jupyter shows it
    evaluate, formula, formulas           the values of a formula of the geometric algebra
    meetc.trimesh                         a CollisionManager with the signatures of trimesh's

Answers are exact for the float32 numbers of a set. Bad input raises InputError, a ValueError whose one line names the
array, the row and the value; TypeError for what is no array of numbers; IndexError for rows of evaluate() that are not
there. Ctrl-C ends a call. Queries release the interpreter's lock, and a set may be used by several threads.
"""

from meetc._contacts import Contacts, Lines, Root, contacts
from meetc._device import DeviceSet, devices
from meetc._errors import DeviceError, InputError, MeetError, MeetWarning, RoundedWarning
from meetc._evaluate import evaluate, formula, formulas
from meetc._hits import HitPoints, first, hit_points
from meetc._native import version as __version__
from meetc._queries import count, counts, hits, over_poses, pairs, touches
from meetc._report import Report, report
from meetc._self import self_pairs
from meetc._set import Set
from meetc._types import Formula, Kind, Meshlike, OnDevice, Precision, Rounded
from meetc._world import Nested, World

__all__ = [
    "Contacts",
    "DeviceError",
    "DeviceSet",
    "Formula",
    "HitPoints",
    "InputError",
    "Kind",
    "Lines",
    "MeetError",
    "MeetWarning",
    "Meshlike",
    "Nested",
    "OnDevice",
    "Precision",
    "Report",
    "Root",
    "Rounded",
    "RoundedWarning",
    "Set",
    "World",
    "__version__",
    "contacts",
    "count",
    "counts",
    "devices",
    "evaluate",
    "first",
    "formula",
    "formulas",
    "hit_points",
    "hits",
    "over_poses",
    "pairs",
    "report",
    "self_pairs",
    "touches",
]

for _public in (DeviceError, DeviceSet, InputError, MeetError, MeetWarning, RoundedWarning, Contacts, Formula, HitPoints,
                Lines, Nested, Report, Root, Rounded, Set, World, contacts, devices, evaluate, formula, formulas, count, counts,
                first, hit_points, hits, over_poses, pairs, report, self_pairs, touches):
    _public.__module__ = __name__
del _public
