// Where pairs meet, found on a device, against the CPU's contacts, bit for bit.
#include "engine.hpp"

#include "meet/core/device/contacts.hpp"
#include "tests/runtime/contacts/families.hpp"
#include "tests/runtime/self/made_meshes.hpp"

#include <cstring>
#include <stdexcept>

namespace cuda_test {
namespace {

using namespace meetc;

template <class T> bool same_bytes(const std::vector<T> &x, const std::vector<T> &y) {
  return x.size() == y.size() && (x.empty() || std::memcmp(x.data(), y.data(), x.size() * sizeof(T)) == 0);
}
bool same_lists(const node_lists &x, const node_lists &y) {
  return x.offsets == y.offsets && x.nodes == y.nodes;
}
bool same_parts(const std::vector<element_part> &x, const std::vector<element_part> &y) {
  bool same = x.size() == y.size();
  for (std::size_t i = 0; same && i < x.size(); ++i)
    same = x[i].element == y[i].element && x[i].dimension == y[i].dimension && x[i].carrier == y[i].carrier;
  return same;
}
template <class Real> bool same_sets(const contact_set<Real> &x, const contact_set<Real> &y) {
  return same_list(x.pairs, y.pairs) && x.codes == y.codes && same_lists(x.corners, y.corners) &&
         same_bytes(x.points, y.points) && same_parts(x.on_a, y.on_a) && same_parts(x.on_b, y.on_b) &&
         x.pieces == y.pieces && same_lists(x.polylines, y.polylines) && x.closed == y.closed &&
         same_lists(x.patches, y.patches) && x.patch_pairs == y.patch_pairs && x.single_nodes == y.single_nodes;
}

struct found_on_device {
  std::size_t pairs = 0, nodes = 0, pairs_left = 0, nodes_left = 0;
};
template <class Real>
void compare(comparison &with, const std::string &scene, const view &a, const view &b, const predicate_info &p,
             std::span<const index_pair> pairs, const contact_options &options, found_on_device &total) {
  device_contact_work work;
  const contact_set<Real> want = contacts<Real>(a, b, p, pairs, options),
                          have = contacts<Real>(with.on(), a, b, p, pairs, options, &work);
  with.require(scene, same_sets(want, have),
               std::string(p.name) + (sizeof(Real) == 4 ? " in float32" : " in float64") + ", " +
                   std::to_string(pairs.size()) + " pairs: other contacts");
  total.pairs += pairs.size(), total.nodes += want.nodes();
  total.pairs_left += work.pairs_left, total.nodes_left += work.nodes_left;
}
found_on_device compare(comparison &with, const std::string &scene, const view &a, const view &b,
                        const predicate_info &p, std::span<const index_pair> pairs,
                        const contact_options &options = {}) {
  found_on_device total;
  compare<float>(with, scene, a, b, p, pairs, options, total);
  compare<double>(with, scene, a, b, p, pairs, options, total);
  return total;
}

// Pairs in special positions, whether they touch or not.
void families_of(comparison &with, const predicate_info &p, std::size_t n, unsigned seed) {
  std::mt19937 random(seed);
  for (const contacts_test::family &f : contacts_test::families(p.a->points)) {
    rows_of a{p.a, {}}, b{p.b, {}};
    std::vector<index_pair> pairs;
    for (std::uint32_t i = 0; i < n; ++i) {
      const contacts_test::pair_rows two = f.pair(random);
      a.rows.insert(a.rows.end(), two.a.begin(), two.a.end());
      b.rows.insert(b.rows.end(), two.b.begin(), two.b.end());
      pairs.push_back({i, i});
    }
    const std::string scene = std::string("contacts, ") + f.name;
    const found_on_device found = compare(with, scene, view_of(a), view_of(b), p, pairs);
    // On a lattice and in general position a device tells all signs and nearly all coordinates.
    const std::string name = f.name;
    if (name == "lattice of 8" || name == "general position" || name == "in one plane" || name == "far from the origin")
      with.require(scene, found.pairs_left == 0 && found.nodes > 0 && found.nodes_left * 2 < found.nodes,
                   std::string(p.name) + ": a device left " + std::to_string(found.pairs_left) + " pairs and " +
                       std::to_string(found.nodes_left) + " of " + std::to_string(found.nodes) + " nodes");
  }
}

// Meshes that cross along curves and lie on each other, moved or not: nodes of several pairs.
void meshes(comparison &with, bool small) {
  const predicate_info &p = predicate_named("triangle_triangle");
  const self_test::mesh torus = small ? self_test::eight_torus(.2, 16, 8) : self_test::eight_torus(.2, 96, 48);
  contact_options moved, twice;
  moved.at_b.m[3] = 0.25, moved.at_b.m[7] = 0.125;
  twice.at_b.m[11] = 0; // where it was
  for (const contact_options &o : {moved, twice}) {
    const prepared a = prepare(torus.view(), *p.a, o.at_a), b = prepare(torus.view(), *p.b, o.at_b);
    const std::vector<index_pair> pairs = collide(a, b, p, rung::certified).pairs;
    const found_on_device found = compare(with, "contacts, meshes", torus.view(), torus.view(), p, pairs, o);
    with.require("contacts, meshes", found.pairs > 0 && found.nodes > 0, "no contacts");
  }
  const self_test::mesh flat = self_test::lattice_mesh(3, 14, small ? 12 : 60, 4);
  const prepared f = prepare(flat.view(), *p.a);
  compare(with, "contacts, meshes", flat.view(), flat.view(), p, collide(f, f, p, rung::certified).pairs);
  compare(with, "contacts, no pairs", torus.view(), torus.view(), p, {});
}

template <class Error, class Call> bool throws(const Call &call) {
  try {
    call();
  } catch (const Error &) {
    return true;
  }
  return false;
}

void refusals(comparison &with) {
  const predicate_info &p = predicate_named("triangle_triangle"), &boxes = predicate_named("box_box");
  const std::vector<float> row = {0, 0, 0, 1, 0, 0, 0, 1, 0};
  const view one{.data = row.data(), .elements = 1};
  const index_pair pair{0, 0}, beyond{0, 1};
  const auto ask = [&](const predicate_info &by, const view &b, const index_pair &of) {
    contacts(with.on(), one, b, by, {&of, 1});
  };
  const auto require = [&](bool holds, const char *what) { with.require("contacts, refused", holds, what); };
  require(throws<std::invalid_argument>([&] { ask(boxes, one, pair); }), "a predicate without contacts");
  require(throws<std::out_of_range>([&] { ask(p, one, beyond); }), "an element that is not there");
  predicate_info stranger = p;
  stranger.name = "stranger";
  require(throws<device_error>([&] { ask(stranger, one, pair); }), "a predicate without kernels");
  std::vector<float> bad = row;
  bad[4] = INFINITY;
  const view broken{.data = bad.data(), .elements = 1};
  require(throws<input_error>([&] { ask(p, broken, pair); }), "a number that is not finite");
  ask(p, one, pair);
}

} // namespace

void same_contacts(comparison &with, const std::string &scene, const view &a, const view &b, const predicate_info &p,
                   std::span<const index_pair> pairs) {
  const found_on_device found = compare(with, scene, a, b, p, pairs);
  std::printf("%s: contacts of %zu pairs in two types, %zu nodes; left to the host: %zu pairs, %zu nodes\n",
              scene.c_str(), found.pairs, found.nodes, found.pairs_left, found.nodes_left);
}

void contact_scenes(comparison &with, const settings &s) {
  std::printf("contacts ...\n");
  for (const char *const name : {"triangle_triangle", "segment_triangle"})
    families_of(with, predicate_named(name), s.small ? 150 : 20'000, static_cast<unsigned>(s.seed));
  meshes(with, s.small);
  refusals(with);
}

} // namespace cuda_test
