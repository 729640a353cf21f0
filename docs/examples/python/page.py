# A page that shows what touches.
import meetc
import numpy as np

floor = meetc.Set(np.array([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]], np.float32), [[0, 1, 2], [0, 2, 3]], name="floor")
spike = meetc.Set(np.array([[0.25, 0.25, 0], [0, 1, 5], [1, 0, 5]], np.float32), [[0, 1, 2]], name="spike")
page = meetc.report(floor, spike)
page.save("touching.html")
print(page.title)
