// A mesh against itself: a bumpy ball, of an octahedron whose faces are split in four, four times over.
// Neighbours share corners bit for bit; moved by one ulp, they almost do.
#include "tests/extremes/families/families.hpp"

#include <cmath>

namespace meetc::extremes_test {
namespace {

using generated_test::stepped;
using vec = std::array<float, 3>;

// Only sums, products and roots, which are the same on every machine.
vec on_ball(const vec &p) {
  const float bump = 1 + 0.125F * p[0] * p[1] - 0.25F * p[2] * p[2] * p[0];
  const float length = std::sqrt(p[0] * p[0] + p[1] * p[1] + p[2] * p[2]) * bump;
  return {p[0] / length, p[1] / length, p[2] / length};
}
vec middle(const vec &a, const vec &b) {
  return {(a[0] + b[0]) / 2, (a[1] + b[1]) / 2, (a[2] + b[2]) / 2};
}

// Faces that lie close together are close in the list.
void split(const vec &a, const vec &b, const vec &c, int times, std::vector<row> &out) {
  if (times == 0) {
    row face;
    for (const vec &p : {on_ball(a), on_ball(b), on_ball(c)})
      face.insert(face.end(), p.begin(), p.end());
    out.push_back(face);
    return;
  }
  const vec ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
  split(a, ab, ca, times - 1, out);
  split(b, bc, ab, times - 1, out);
  split(c, ca, bc, times - 1, out);
  split(ab, bc, ca, times - 1, out);
}

std::vector<row> bumpy_ball() {
  std::vector<row> out;
  for (int octant = 0; octant < 8; ++octant) {
    const auto sign = [&](int axis) { return octant >> axis & 1 ? -1.0F : 1.0F; };
    split({sign(0), 0, 0}, {0, sign(1), 0}, {0, 0, sign(2)}, 4, out);
  }
  return out;
}

// An element of the mesh: a face, one of its edges or corners, or a ball about a corner as large as an edge.
row element(shape kind, const row &face, random_numbers &random) {
  const auto first = static_cast<std::size_t>(random.integer(0, 2));
  row out;
  for (std::size_t i = 0; i < corners(kind); ++i)
    for (std::size_t k = 0; k < 3; ++k)
      out.push_back(face[3 * ((first + i) % 3) + k]);
  if (padded(kind)) {
    float square = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const float d = face[3 * ((first + 1) % 3) + k] - face[3 * first + k];
      square += d * d;
    }
    out.push_back(std::sqrt(square) * (random.one_in(2) ? 1.0F : 0.5F));
  }
  return out;
}

} // namespace

std::span<const row> mesh_faces() {
  static const std::vector<row> faces = bumpy_ball();
  return faces;
}

pair_of_rows mesh_on_itself(shape a, shape b, random_numbers &random) {
  const auto faces = mesh_faces();
  const std::size_t i = random.bits() % faces.size();
  const std::size_t j = random.one_in(8)   ? random.bits() % faces.size()
                        : random.one_in(8) ? i
                                           : i ^ random.bits() % 16; // in the same corner of the ball
  pair_of_rows p{element(a, faces[i], random), element(b, faces[j], random)};
  if (random.one_in(2)) { // the second, by one ulp along one axis or all
    const int axis = random.integer(0, 3), steps = random.one_in(2) ? 1 : -1;
    for (std::size_t k = 0; k < 3 * corners(b); ++k)
      if (axis == 3 || k % 3 == static_cast<std::size_t>(axis))
        p.b[k] = stepped(p.b[k], steps);
  }
  return p;
}

} // namespace meetc::extremes_test
