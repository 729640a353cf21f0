# Bodies that move, and which of them touch.
import meetc
import numpy as np
from numpy.typing import NDArray

corners = np.array([[x, y, z] for x in (0, 1) for y in (0, 1) for z in (0, 1)], np.float32)
faces = [[0, 1, 3], [0, 3, 2], [4, 6, 7], [4, 7, 5], [0, 4, 5], [0, 5, 1],
         [2, 3, 7], [2, 7, 6], [0, 2, 6], [0, 6, 4], [1, 5, 7], [1, 7, 3]]
cube = meetc.Set(corners, faces)


def shifted(x: float) -> NDArray[np.float64]:
    pose = np.eye(4)
    pose[0, 3] = x
    return pose


world = meetc.World()
world.add("left", cube)
world.add("right", cube, shifted(1))
world.add("ball", meetc.Set.spheres([[0, 0.5, 0.5]], 0.25), shifted(3))
print(world.touching())
world.allow("left", "right")
print(world.any())
frames = np.array([[shifted(x)] for x in (3, 2.25, 2.1)])
print(world.over(frames, ["ball"]).tolist())
