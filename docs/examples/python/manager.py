# Named meshes in poses, with the calls of trimesh's CollisionManager.
import numpy as np
from meetc.trimesh import CollisionManager
from numpy.typing import NDArray

corners = np.array([[x, y, z] for x in (0, 1) for y in (0, 1) for z in (0, 1)], np.float32)
faces = [[0, 1, 3], [0, 3, 2], [4, 6, 7], [4, 7, 5], [0, 4, 5], [0, 5, 1],
         [2, 3, 7], [2, 7, 6], [0, 2, 6], [0, 6, 4], [1, 5, 7], [1, 7, 3]]
cube = (corners, faces)


def shifted(x: float) -> NDArray[np.float64]:
    pose = np.eye(4)
    pose[0, 3] = x
    return pose


manager = CollisionManager()
manager.add_object("left", cube)
manager.add_object("right", cube, shifted(1))
manager.add_object("far", cube, shifted(3))
print(manager.in_collision_internal(return_names=True))
manager.set_transform("right", shifted(1.0000002))
print(manager.in_collision_internal())
hit, names, data = manager.in_collision_single(cube, shifted(2.5), return_names=True, return_data=True)
print(hit, sorted(names), len(data), data[0].index("far"))
