# Where two meshes meet, where rays hit a mesh, and where a mesh crosses itself.
import meetc
import numpy as np

floor = meetc.Set(np.array([[0, 0, 0], [3, 0, 0], [3, 3, 0], [0, 3, 0]], np.float32), [[0, 1, 2], [0, 2, 3]])
spire = meetc.Set(np.array([[1, 2, -1], [2, 1, -1], [2, 2, -1], [2, 2, 2]], np.float32),
                  [[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]])

found = meetc.contacts(floor, spire)
print(found)
for line, closed in zip(found.lines(), found.lines().closed):
    print("a loop" if closed else "a chain", found.points[line].tolist())
print(*found.exact(int(found.lines()[0][0])))

rays = meetc.Set.rays([[1.75, 1.75, 9.0], [7.0, 7.0, 9.0]], [[0, 0, -1], [0, 0, -1]], through=spire)
faces, points = meetc.first(rays, spire, points=True)
print(faces.tolist(), points.tolist())
points, ray, face = meetc.hit_points(rays, spire)
print(ray.tolist(), face.tolist(), points[:, 2].tolist())

print(meetc.self_pairs(spire).tolist())
