// Pictures of a collision: which triangles, spheres and segments touch, seen at a glance.
//
// Problem: touching triangles form a thin curve on a large mesh, partly hidden behind the other one; a plain rendering
// shows next to nothing of them.
// Method: a software renderer. Every shape is drawn twice into depth buffers of samples: all surfaces in calm colours,
// and the hit elements alone. A hit sample in front of (or barely behind) the surface is drawn in full, widened and
// outlined, so that even a triangle smaller than a pixel is visible. A hit sample behind a surface shines through it
// faintly.
// Limits: at most 63 shapes; hit elements are drawn up to a pixel or two wider than they are; occlusion within a pixel
// or two of the intersection curve is decided in favour of the hits. Elements with NaN or infinite coordinates, or with
// indices out of range, are left out.
#ifndef MEETC_PICTURE_RENDER_HPP
#define MEETC_PICTURE_RENDER_HPP

#include "meet/picture/camera.hpp"
#include "meet/picture/image.hpp"
#include "meet/picture/scene.hpp"

#include <span>

namespace meetc::picture {

// The scene as the camera shows it. Sizes are clamped to 16..8192.
image render(std::span<const shape> shapes, const camera &from, int width, int height);

// The scene in one large panel with a caption. If there are hits, smaller panels stand beside it: a close-up where the
// hits lie in a small part of the scene, and (for two shapes or more) the first two shapes alone, each seen from its
// hits.
image render_panels(std::span<const shape> shapes, const camera &from, int width, int height);

} // namespace meetc::picture

#endif
