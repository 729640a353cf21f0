# Which triangles of two meshes touch.
import meetc
import numpy as np

# A square floor of two triangles, and a spike of one triangle whose tip is on the floor's diagonal.
floor = meetc.Set(np.array([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]], np.float32), [[0, 1, 2], [0, 2, 3]])
spike = meetc.Set(np.array([[0.25, 0.25, 0], [0, 1, 5], [1, 0, 5]], np.float32), [[0, 1, 2]])
print(meetc.pairs(floor, spike).tolist())

lifted = np.eye(4)
lifted[2, 3] = 1e-30
print(meetc.touches(floor, spike.at(lifted)))

poses = np.tile(np.eye(4), (5, 1, 1))
poses[:, 0, 3] = np.linspace(0, 1, 5)
print(meetc.over_poses(floor, spike, poses).tolist())

rays = meetc.Set.rays([[0.75, 0.25, 3], [2.5, 2.5, 3]], [[0, 0, -1], [0, 0, -1]], through=floor)
print(meetc.first(rays, floor).tolist())

lines = [[0, 0, 0, 1, 0, 0], [0, 2, 0, 1, 2, 0], [0, 3, 0, 1, 3, 0]]  # through two points each
print(meetc.evaluate("norm2(meet(sphere, line))", [5, 0, 0, 2], lines)["norm2_meet"].tolist())

try:
    meetc.Set(np.zeros((4, 3)), [[0, 1, 2], [0, 2, 4]])
except meetc.InputError as error:
    print(error)
