// Poses: rows bit for bit, pairs, and errors.
#include "engine.hpp"

#include "meet/core/sets/element_set.hpp"

#include "tests/runtime/device/kernels/cuda_test.hpp"

#include <cmath>
#include <cstring>
#include <functional>

namespace cuda_test {
namespace {

using namespace meetc;

constexpr rung certified[] = {rung::certified};

pose turned(double scale, double x, double y, double z) {
  static constexpr double turn[3][3] = {{0.36, 0.48, -0.8}, {-0.8, 0.6, 0}, {0.48, 0.64, 0.6}};
  pose p;
  const double t[3] = {x, y, z};
  for (int i = 0; i < 3; ++i) {
    for (int k = 0; k < 3; ++k)
      p.m[4 * i + k] = scale * turn[i][k];
    p.m[4 * i + 3] = t[i];
  }
  p.length_scale = scale;
  return p;
}

// The rows on the device equal those of the CPU, bit for bit. The set keeps the slots with which it was uploaded.
bool same_rows_there(const device_set &there, const prepared &uploaded, const prepared &moved) {
  const auto fields = static_cast<std::size_t>(there.kind().fields);
  std::vector<float> rows(there.elements() * fields);
  cuda_test::check(cudaMemcpy(rows.data(), there.rows().data(), rows.size() * sizeof(float), cudaMemcpyDeviceToHost),
                   "copy rows");
  std::vector<std::uint32_t> slot(moved.elements());
  for (std::uint32_t s = 0; s < slot.size(); ++s)
    slot[moved.set().order[s]] = s;
  bool same = true;
  for (std::size_t s = 0; s < there.elements(); ++s)
    same = same && std::memcmp(rows.data() + s * fields, moved.set().rows + slot[uploaded.set().order[s]] * fields,
                               fields * sizeof(float)) == 0;
  return same;
}

void moves(comparison &with, const settings &s) {
  engine random(s.seed + 20);
  const std::size_t n = s.small ? 60 : 600;
  pose mirrored;
  mirrored.m[0] = -1;
  pose sheared = turned(0.7, 0.1, -0.2, 0.3);
  sheared.m[1] += 0.5, sheared.m[4] *= 3;
  pose flat = turned(1, 0, 0, 0);
  flat.m[8] = flat.m[9] = flat.m[10] = 0;
  pose coarse = turned(1, 0.1, 0.2, -0.3), rounded; // one moves and rounds, one rounds alone
  coarse.grid = 0x1p-9, rounded.grid = 0x1p-4;
  const pose poses[] = {coarse,
                        {},
                        turned(1, 0.1, 0.2, -0.3),
                        rounded,
                        turned(1e-6, 0, 0, 0),
                        turned(3e5, 1e7, -1e7, 5),
                        mirrored,
                        turned(1e-44, 0, 0, 0),
                        turned(0, 0.5, 0.5, 0.5),
                        sheared,
                        flat,
                        {},
                        turned(1e30, 1e31, 0, 0)};
  for (int i = 0; i < cga::catalogue().predicate_count; ++i) {
    const predicate_info &p = cga::catalogue().predicates[i];
    const rows_of x = random_rows(*p.a, n, {1, 0.2, 1, 0}, random),
                  y = random_rows(*p.b, n / 3 + 1, {1, 0.2, 1, 0}, random);
    const prepared a = prepare(view_of(x), *p.a), b = prepare(view_of(y), *p.b);
    device_set da(with.on(), a), db(with.on(), b);
    for (const pose &at : std::span(poses).first(s.small ? 4 : std::size(poses))) {
      const pose at_a = pose_for(*p.a, at), at_b = pose_for(*p.b, at);
      da.move(at_a);
      const prepared a_there = prepare(view_of(x), *p.a, at_a);
      with.require("poses", same_rows_there(da, a, a_there), std::string(p.name) + ": other rows under a pose");
      with.same("poses of a", p, a_there, da, b, db, certified); // the frame stays b's
      db.move(at_b);
      const prepared b_there = prepare(view_of(y), *p.b, at_b);
      with.require("poses", same_rows_there(db, b, b_there), std::string(p.name) + ": other rows under a pose");
      options o;
      o.expectations = true;
      with.same("poses of both", p, a_there, da, b_there, db, certified, o);
      db.move({});
    }
  }
}

// The fault that a call throws.
fault thrown(const std::function<void()> &f) {
  try {
    f();
  } catch (const input_error &e) {
    return e.where;
  }
  return {};
}

void overflows(comparison &with, const settings &s) {
  engine random(s.seed + 21);
  const std::string scene = "poses refused";
  for (int k = 0; k < cga::catalogue().kind_count; ++k) {
    const kind_info &kind = cga::catalogue().kinds[k];
    const auto fields = static_cast<std::size_t>(kind.fields);
    for (const std::size_t n : {1, 20, 700}) {
      rows_of rows = random_rows(kind, n, {1, 0.2, 1, 0}, random);
      // Some that go beyond float32 under a scale of 1e20, in one field each; the caller's first is not the first slot.
      for (std::size_t i = n / 2; i < n; i += 1 + n / 7)
        rows.rows[i * fields + random() % fields] = 1e19F;
      put_in_order(rows);
      const pose at = pose_for(kind, turned(1e20, 0, 0, 0));
      const prepared p = prepare(view_of(rows), kind);
      device_set there(with.on(), p);
      const pose before = pose_for(kind, turned(2, 1, 1, 1));
      there.move(before);
      const fault want = check(view_of(rows), kind, at), have = thrown([&] { there.move(at); });
      const bool same_value = std::memcmp(&want.value, &have.value, sizeof want.value) == 0 ||
                              (std::isnan(want.value) && std::isnan(have.value));
      with.require(scene, want.kind == fault_kind::moved, "the test's own pose does not overflow");
      with.require(scene,
                   want.kind == have.kind && want.element == have.element && want.field == have.field && same_value,
                   std::string(kind.name) + ": " + (have ? describe(have, kind) : "nothing") +
                       ", and the CPU: " + describe(want, kind));
      with.require(scene, same_rows_there(there, p, prepare(view_of(rows), kind, before)),
                   std::string(kind.name) + ": the set is not as it was before");
      for (const double length : {-1.0, std::nan("")}) {
        pose bad = before;
        bad.length_scale = length;
        bool refused = false;
        try {
          there.move(bad);
        } catch (const std::invalid_argument &) {
          refused = true;
        }
        with.require(scene, refused, "a length scale that is none");
      }
    }
  }
  // A box is neither turned nor mirrored.
  const kind_info &box = *predicate_named("box_box").a;
  const rows_of boxes = random_rows(box, 10, {}, random);
  device_set stays(with.on(), prepare(view_of(boxes), box));
  pose mirrored;
  mirrored.m[5] = -1;
  for (const pose &at : {turned(1, 0, 0, 0), mirrored}) {
    bool refused = false;
    try {
      stays.move(at);
    } catch (const std::invalid_argument &) {
      refused = true;
    }
    with.require(scene, refused, "a box that would be turned or mirrored");
  }
  // A kind that no pose can move: a point's kernels with roles that have no meaning.
  static constexpr role roles[] = {role::other, role::x, role::y};
  kind_info odd = cga::catalogue().kinds[0];
  odd.roles = roles;
  const rows_of rows = random_rows(odd, 10, {}, random);
  const prepared p = prepare({rows.rows.data(), 0, 3 * sizeof(float), nullptr, 10}, odd);
  device_set there(with.on(), p);
  bool refused = false;
  try {
    there.move(turned(2, 0, 0, 0));
  } catch (const std::invalid_argument &) {
    refused = true;
  }
  with.require(scene, refused && !can_move(odd), "a kind that cannot be moved");
  there.move({}); // the identity passes
  // There is nothing to move.
  const kind_info &point = cga::catalogue().kinds[0];
  const rows_of none{&point, {}};
  device_set empty(with.on(), prepare(view_of(none), point));
  empty.move(turned(1e30, 0, 0, 0));
  with.require(scene, empty.elements() == 0, "an empty set");
}

} // namespace

void pose_scenes(comparison &with, const settings &s) {
  moves(with, s);
  overflows(with, s);
}

} // namespace cuda_test
