// Meshes with themselves on a device, against the CPU's pairs.
#include "engine.hpp"

#include "meet/core/device/self_pairs.hpp"
#include "tests/runtime/self/made_meshes.hpp"

#include <neighbours/neighbours_cuda.hpp>
#include <numeric>
#include <stdexcept>

namespace cuda_test {
namespace {

using namespace meetc;
using self_test::mesh;

const predicate_info &touch() {
  return predicate_named("triangle_triangle");
}
self_predicates predicates() {
  return self_test::predicates();
}
device_self_result there(comparison &with, device_set &set, const device_self_options &o = {}) {
  return self_pairs(with.on(), set, predicates(), neighbours::cuda::catalogue(), o);
}

void require_same(comparison &with, const std::string &scene, const self_result &want, const device_self_result &have,
                  const std::string &what) {
  const auto fails = [&](const std::string &how) { with.require(scene, false, what + ": " + how); };
  with.require(scene, same_list(want.pairs, have.pairs),
               what + ": " + std::to_string(have.pairs.size()) + " pairs, and the CPU has " +
                   std::to_string(want.pairs.size()));
  if (want.degenerate != have.degenerate)
    fails("other elements without an extent");
  for (int k = 0; k < 3; ++k)
    if (want.neighbours[k] != have.neighbours[k])
      fails(std::to_string(have.neighbours[k]) + " neighbours with " + std::to_string(k + 1) +
            " common corners, and the CPU has " + std::to_string(want.neighbours[k]));
  if (have.candidates > want.candidates)
    fails(std::to_string(have.candidates) + " candidates, and the CPU has " + std::to_string(want.candidates));
}

// A set that was made on the device, one that was prepared, and a given one; merged, and by vertices.
void compare(comparison &with, const std::string &scene, const view &v, std::span<const std::uint32_t> owner = {},
             const pose &at = {}) {
  const prepared set = prepare(v, *touch().a, at);
  device_set made(with.on(), v, *touch().a, at), uploaded(with.on(), set),
      given = device_set::given(with.on(), v, *touch().a);
  given.move(at);
  for (const bool merge : {true, false}) {
    self_options o;
    o.merge = merge, o.owner = owner;
    const self_result want = self_pairs(set, v, predicates(), o);
    device_self_options with_device;
    with_device.merge = merge, with_device.owner = owner;
    if (v.index)
      with_device.vertices = {v.index, 3 * v.elements};
    const std::string how = merge ? "" : ", by vertices";
    require_same(with, scene, want, there(with, made, with_device), "made there" + how);
    require_same(with, scene, want, there(with, uploaded, with_device), "prepared" + how);
    require_same(with, scene, want, there(with, given, with_device), "given" + how);
  }
}
void compare(comparison &with, const std::string &scene, const mesh &m, const pose &at = {}) {
  compare(with, scene, m.view(), {}, at);
}

mesh twice(const mesh &m, bool by_other_vertices) {
  mesh out = m;
  if (by_other_vertices)
    out.xyz.insert(out.xyz.end(), m.xyz.begin(), m.xyz.end());
  for (const std::uint32_t v : m.index)
    out.index.push_back(v + (by_other_vertices ? static_cast<std::uint32_t>(m.xyz.size() / 3) : 0));
  return out;
}

void fixtures(comparison &with, bool small) {
  const mesh torus = small ? self_test::eight_torus(.1, 16, 8) : self_test::eight_torus(.2, 32, 16);
  compare(with, "self, torus", torus);
  if (!small)
    compare(with, "self, torus", self_test::eight_torus(.1, 400, 200));
  compare(with, "self, faces twice", twice(torus, false));
  compare(with, "self, faces twice", twice(torus, true));
  pose at;
  at.m[0] = at.m[5] = at.m[10] = 3, at.m[3] = 100;
  compare(with, "self, moved", torus, at);
  const std::vector<float> rows = torus.rows();
  compare(with, "self, rows", {.data = rows.data(), .elements = torus.faces()});
  std::vector<std::uint32_t> owner(torus.faces());
  for (std::size_t i = 0; i < owner.size(); ++i)
    owner[i] = static_cast<std::uint32_t>(i / 2);
  compare(with, "self, items", torus.view(), owner);
  const mesh thin{{0, 0, 0, 4, 0, 0, 0, 4, 0, 2, 0, 0, 6, 0, 0, 1, 1, 0}, {0, 1, 2, 0, 3, 1, 0, 1, 4, 5, 5, 5}};
  compare(with, "self, faces without area", thin);
  compare(with, "self, none", mesh{});
  compare(with, "self, one", mesh{{0, 0, 0, 1, 0, 0, 0, 1, 0}, {0, 1, 2}});
}

void lattices(comparison &with, bool small) {
  for (unsigned seed = 0; seed < (small ? 5U : 400U); ++seed) {
    const mesh m = self_test::lattice_mesh(seed, 5 + static_cast<int>(seed % 9), 8 + static_cast<int>(seed % 7),
                                           2 + static_cast<int>(seed % 4));
    compare(with, "self, lattices", m);
    pose at;
    for (const int k : {0, 5, 10})
      at.m[k] = seed % 3 == 0 ? 0x1p-120 : seed % 3 == 1 ? 0x1p90 : 1;
    compare(with, "self, lattices", m, at);
  }
  // Many faces in a small place, so that lists are short and walks are cut.
  const mesh crowd = self_test::lattice_mesh(5, 40, small ? 120 : 1500, 6);
  const prepared set = prepare(crowd.view(), *touch().a);
  device_set on_device(with.on(), set);
  device_self_options o;
  o.list_capacity = std::size_t{1} << 11;
  const device_self_result have = there(with, on_device, o);
  require_same(with, "self, short lists", self_pairs(set, crowd.view(), predicates()), have, "a crowd");
  with.require("self, short lists", small || have.parts > 1, "it was not cut");
  pairs_there left;
  o.leave_there = &left;
  with.require("self, short lists", there(with, on_device, o).pairs.empty() && left.size() == have.pairs.size(),
               "another list stays there");
}

void refusals(comparison &with) {
  const mesh m = self_test::eight_torus(.2, 8, 8);
  device_set set(with.on(), m.view(), *touch().a);
  const auto refused = [&](const char *what, const self_predicates &by, const device_self_options &o) {
    bool is = false;
    try {
      self_pairs(with.on(), set, by, neighbours::cuda::catalogue(), o);
    } catch (const std::invalid_argument &) {
      is = true;
    }
    with.require("self, refused", is, what);
  };
  const std::vector<std::uint32_t> few(5);
  device_self_options o;
  o.owner = few;
  refused("an owner map of another length", predicates(), o);
  o = {};
  o.merge = false, o.vertices = few;
  refused("vertices of fewer elements", predicates(), o);
  o = {};
  o.list_capacity = 100;
  refused("lists below 2^11", predicates(), o);
  const self_predicates balls{predicate_named("ball_ball"), predicates().one_common, predicates().two_common};
  refused("another kind", balls, {});
}

} // namespace

void same_self(comparison &with, const std::string &scene, const view &v) {
  compare(with, scene, v);
  device_set set(with.on(), v, *touch().a);
  there(with, set);
  const device_self_result r = there(with, set);
  std::printf("%s: %zu pairs, %llu candidates, %llu and %llu neighbours, %.3f ms on the device\n", scene.c_str(),
              r.pairs.size(), static_cast<unsigned long long>(r.candidates),
              static_cast<unsigned long long>(r.neighbours[0]), static_cast<unsigned long long>(r.neighbours[1]),
              r.device_seconds * 1000);
}

void self_scenes(comparison &with, const settings &s) {
  std::printf("meshes with themselves ...\n");
  fixtures(with, s.small);
  lattices(with, s.small);
  refusals(with);
}

} // namespace cuda_test
