// Families derived from others: at another scale, in another place, in another order.
#include "tests/extremes/families/families.hpp"

#include <cmath>
#include <cstring>
#include <limits>
#include <stdexcept>

namespace meetc::extremes_test {
namespace {

constexpr float most = std::numeric_limits<float>::max();

const generated_test::family &generated_family(const char *name) {
  for (const generated_test::family &f : generated_test::families())
    if (std::strcmp(f.name, name) == 0)
      return f;
  throw std::invalid_argument(name);
}

pair_of_rows generated(const char *name, shape a, shape b, random_numbers &random) {
  return generated_family(name).make(a, b, random);
}

bool several_corners(shape a, shape b) {
  return corners(a) + corners(b) >= 4;
}
bool an_edge(shape a, shape b) {
  return corners(a) > 1 || corners(b) > 1;
}
bool a_sphere(shape a, shape) {
  return padded(a);
}
bool always(shape, shape) {
  return true;
}

// The row's corners in another order.
row reordered(shape kind, const row &r, random_numbers &random) {
  row out = r;
  for (std::size_t i = corners(kind); i > 1; --i) {
    const auto j = static_cast<std::ptrdiff_t>(3 * (random.bits() % i)),
               last = static_cast<std::ptrdiff_t>(3 * (i - 1));
    if (j != last)
      std::swap_ranges(out.begin() + last, out.begin() + last + 3, out.begin() + j);
  }
  return out;
}

const family all[] = {
    {"determinant_one", several_corners, determinant_one},
    {"kettner", an_edge, kettner},
    {"near_coplanar", an_edge, near_coplanar},
    {"tangent", a_sphere, tangent},
    {"scale", always, any_scale},
    {"permuted", always, permuted},
    {"degenerate", always, degenerate},
    {"mesh", always, mesh_on_itself},
    {"far", always, far},
    {"axis_magnitudes", always, axis_magnitudes},
    {"palette", always, palette},
    {"placed", always, placed},
    {"near_overflow", always, near_overflow},
    {"cluster", always, cluster},
    {"bent", always, bent},
    {"flat_subnormal", always, flat_subnormal},
    {"plane_binades", always, plane_binades},
    {"at_exact_steps", always, at_exact_steps},
    {"long_lattice", an_edge, long_lattice},
};

} // namespace

std::span<const family> families() {
  return all;
}

const family &family_named(const char *name) {
  for (const family &f : all)
    if (std::strcmp(f.name, name) == 0)
      return f;
  throw std::invalid_argument(name);
}

pair_of_rows any_at_home(shape a, shape b, random_numbers &random) {
  for (;;) {
    switch (random.integer(0, 6)) {
    case 0:
      return generated("ordinary", a, b, random);
    case 1:
      return degenerate(a, b, random);
    case 2:
      return mesh_on_itself(a, b, random);
    default:
      if (const family &f = all[random.integer(0, 3)]; f.applies(a, b))
        return f.make(a, b, random);
    }
  }
}

pair_of_rows degenerate(shape a, shape b, random_numbers &random) {
  static constexpr const char *names[] = {"lattice", "shared",      "computed_on", "coplanar",
                                          "flat",    "solid_frame", "collinear"};
  return generated(names[random.integer(0, 6)], a, b, random);
}

pair_of_rows any_scale(shape a, shape b, random_numbers &random) {
  static constexpr float special[] = {0.0F, -0.0F, 0x1p-149F, -0x1p-149F, 0x1p-126F, 0x1.fffffcp-127F,
                                      most, -most, 1.0F,      -1.0F,      0x1p127F,  0x1.000002p0F};
  if (random.one_in(64))
    return generated("patterns", a, b, random);
  pair_of_rows p = any_at_home(a, b, random);
  const int k = random.one_in(4) ? (random.one_in(2) ? random.integer(-149, -100) : random.integer(90, 127))
                                 : random.integer(-149, 127);
  if (!random.one_in(16))
    return {generated_test::scaled(p.a, k), generated_test::scaled(p.b, k)};
  if (random.one_in(2)) // one body huge, the other tiny
    return {generated_test::scaled(p.a, k), generated_test::scaled(p.b, random.integer(-149, 127))};
  for (auto [kind, r] : {std::pair(a, &p.a), std::pair(b, &p.b)})
    for (std::size_t i = 0; i < r->size(); ++i)
      if (random.one_in(4)) {
        const float f = special[random.integer(0, 11)];
        (*r)[i] = padded(kind) && i == 3 ? std::abs(f) : f;
      }
  return p;
}

pair_of_rows far(shape a, shape b, random_numbers &random) {
  static constexpr float offsets[] = {1e4F, 1e6F, 1e7F};
  const pair_of_rows p = any_at_home(a, b, random);
  float t[3];
  for (float &c : t)
    c = random.one_in(4) ? 0 : offsets[random.integer(0, 2)] * (random.one_in(2) ? 1.0F : -1.0F);
  const int k = random.one_in(2) ? 0 : random.integer(-2, 6);
  return {moved(a, generated_test::scaled(p.a, k), t), moved(b, generated_test::scaled(p.b, k), t)};
}

pair_of_rows permuted(shape a, shape b, random_numbers &random) {
  const pair_of_rows p = any_at_home(a, b, random);
  pair_of_rows out{reordered(a, p.a, random), reordered(b, p.b, random)};
  if (a == b && random.one_in(2))
    std::swap(out.a, out.b);
  return out;
}

} // namespace meetc::extremes_test
