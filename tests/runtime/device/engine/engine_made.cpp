// Sets that are made on the device, and one set in many poses.
#include "engine.hpp"

#include "meet/core/device/collide.hpp"
#include "meet/core/device/memory/transfers.hpp"
#include "meet/core/sets/element_set.hpp"

#include <algorithm>
#include <cstring>
#include <functional>
#include <limits>

namespace cuda_test {
namespace {

using namespace meetc;

constexpr rung certified[] = {rung::certified};

// A turn about an axis, scaled, and then a move.
pose placed(double scale, double x, double y, double z) {
  pose p;
  const double turn[9] = {0.6, -0.8, 0, 0.8, 0.6, 0, 0, 0, 1}, t[3] = {x, y, z};
  for (int i = 0; i < 3; ++i) {
    for (int k = 0; k < 3; ++k)
      p.m[4 * i + k] = scale * turn[3 * i + k];
    p.m[4 * i + 3] = t[i];
  }
  p.length_scale = scale;
  return p;
}

bool same_box(device_set &there, const prepared &set) {
  float have[2][3], want[2][3];
  there.bounds(have[0], have[1]);
  set.bounds(want[0], want[1]);
  return set.elements() == 0 ? have[0][0] > have[1][0] : std::memcmp(have, want, sizeof want) == 0;
}

void made(comparison &with, const settings &s) {
  engine random(s.seed + 40);
  const std::size_t n = s.small ? 90 : 3000;
  pose rounded = placed(1, 0.1, 0.2, 0.3);
  rounded.grid = 0x1p-9;
  const pose poses[] = {{}, placed(1.5, 0.1, -0.2, 0.3), rounded};
  each_predicate([&](const predicate_info &p) {
    const auto check = [&](const std::string &scene, const view &x, const view &y, const pose &at) {
      const pose at_a = pose_for(*p.a, at), at_b = pose_for(*p.b, at);
      const prepared a = prepare(x, *p.a, at_a), b = prepare(y, *p.b, at_b);
      device_set da(with.on(), x, *p.a, at_a), db(with.on(), y, *p.b, at_b);
      const std::string what = std::string(p.name) + ": ";
      with.require(scene, same_box(da, a) && same_box(db, b), what + "another box around all elements");
      with.require(scene, da.rows().reaches() == std::pair(a.set().reach, a.set().longest), what + "another reach");
      with.require(scene, da.rows().grid() == at.grid, what + "another grid");
      for (const auto &[there, set] : {std::pair(&da, &a), std::pair(&db, &b)})
        with.require(scene, there->ordered_seconds() == 0 || is_in_order(*there, *set), what + "another order");
      options o;
      o.all_modes = true, o.all_filters = false;
      with.same(scene, p, a, da, b, db, certified, o);
      device_set uploaded(with.on(), a);
      const pose next = pose_for(*p.a, placed(1, 0.01, 0, 0.02));
      da.move(next), uploaded.move(next);
      const device_result have = collide(with.on(), da, db, p, rung::certified),
                          want = collide(with.on(), uploaded, db, p, rung::certified);
      with.require(scene, have.pairs.size() == want.pairs.size() && have.count == want.count,
                   what + "another answer after a move");
    };
    for (const pose &at : poses) {
      rows_of x = random_rows(*p.a, n, {1, 0.1, 1, 0}, random), y = random_rows(*p.b, n / 3, {1, 0.1, 1, 0}, random);
      check("made there", view_of(x), view_of(y), at);
      // All but one share a cell of the device's grid.
      const auto fields = static_cast<std::size_t>(p.a->fields);
      for (std::size_t f = 0; f < fields; ++f)
        x.rows[f] = p.a->roles[f] == role::length ? 1.0F : 1e15F;
      check("made there, one far away", view_of(x), view_of(y), at);
    }
    // Too many too close to each other, and few of them in one place: the places are sorted instead.
    rows_of close = random_rows(*p.a, 5200, {1, 0.05, 1, 0}, random);
    for (std::size_t i = 0; i < 5000 * static_cast<std::size_t>(p.a->fields); ++i)
      close.rows[i] /= 64;
    check("made there, many close together", view_of(close), view_of(random_rows(*p.b, 300, {1, 0.05, 1, 0}, random)),
          {});
    const rows_of x = same_rows(*p.a, 200), y = same_rows(*p.b, 50), none{p.b, {}};
    // Too far apart in memory to be uploaded as they stand.
    const std::size_t stride = std::size_t{1} << 15, rows = 60;
    const rows_of sparse = random_rows(*p.a, rows, {1, 0.1, 1, 0}, random);
    std::vector<unsigned char> bytes(stride * rows);
    const std::size_t row_bytes = static_cast<std::size_t>(p.a->fields) * sizeof(float);
    for (std::size_t i = 0; i < rows; ++i)
      std::memcpy(bytes.data() + i * stride, sparse.rows.data() + i * static_cast<std::size_t>(p.a->fields), row_bytes);
    check("made there, far apart", {reinterpret_cast<const float *>(bytes.data()), 0, stride, nullptr, rows},
          view_of(y), {});
    check("made there, all alike", view_of(x), view_of(y), {});
    check("made there, nothing", view_of(x), view_of(none), {});
  });
}

// A mesh of triangles, with points that lie apart in memory.
void indexed(comparison &with, const settings &s) {
  engine random(s.seed + 41);
  const predicate_info &p = predicate_named("triangle_triangle");
  const std::string scene = "made there, of indices";
  constexpr std::size_t stride = 17;
  const std::uint32_t points = s.small ? 40 : 900;
  std::vector<unsigned char> bytes(points * stride);
  std::uniform_real_distribution<float> unit(0, 1);
  for (std::size_t i = 0; i < points; ++i) {
    const float xyz[3] = {unit(random), unit(random), unit(random)};
    std::memcpy(bytes.data() + i * stride, xyz, sizeof xyz);
  }
  std::vector<std::uint32_t> index;
  for (std::uint32_t i = 0; i < 3 * points; ++i)
    index.push_back(i % 3 == 0 ? i / 3 : static_cast<std::uint32_t>(random() % points));
  view mesh{reinterpret_cast<const float *>(bytes.data()), points, stride, index.data(), points};
  const prepared a = prepare(mesh, *p.a);
  device_set there(with.on(), mesh, *p.a);
  with.same(scene, p, a, there, a, there, certified);

  const auto refused = [&](const char *what) {
    const fault want = check(mesh, *p.a);
    fault have;
    try {
      device_set bad(with.on(), mesh, *p.a);
    } catch (const input_error &e) {
      have = e.where;
    }
    with.require(scene, want && describe(have, *p.a) == describe(want, *p.a), what);
  };
  const std::uint32_t before = index[33];
  index[33] = points;
  refused("an index beyond the points");
  index[33] = before;
  const float bad = std::numeric_limits<float>::quiet_NaN();
  std::memcpy(bytes.data() + 7 * stride + sizeof(float), &bad, sizeof bad);
  refused("a number that is none");
}

// Memory of every size goes there and comes back, also twice through the same buffers.
void travels(comparison &with, const settings &s) {
  engine random(s.seed + 43);
  transfers moving;
  cudaStream_t stream = with.on().stream();
  for (const std::size_t bytes : {std::size_t{0}, std::size_t{5}, (std::size_t{8} << 20) - 1, (std::size_t{8} << 20),
                                  (std::size_t{50} << 20) + 13}) {
    std::vector<unsigned char> here(bytes), back(bytes);
    device_memory<unsigned char> there;
    there.reserve(bytes + 1, "a test");
    for (int round = 0; round < 2; ++round) {
      for (std::size_t i = 0; i < bytes; i += 509)
        here[i] = static_cast<unsigned char>(random());
      const std::vector<unsigned char> want = here;
      moving.upload(there.data(), here.data(), bytes, stream, "a test");
      std::fill(here.begin(), here.end(), static_cast<unsigned char>(0)); // it has been taken
      moving.download(back.data(), there.data(), bytes, stream, "a test");
      with.require("travels", back == want, std::to_string(bytes) + " bytes come back otherwise");
    }
  }
}

void many_poses(comparison &with, const settings &s) {
  engine random(s.seed + 42);
  const std::string scene = "many poses";
  std::vector<pose> poses;
  for (int i = 0; i < (s.small ? 7 : 40); ++i)
    poses.push_back(i % 4 == 1 ? placed(1, 100, -5.0 * i, 3) : // far away
                        i % 5 == 0 ? pose{}
                                   : placed(i % 7 == 3 ? 1e3 : 1, 0.05 * i, i % 3 == 0 ? 0.2 : -0.03 * i, 0.1));
  std::uint64_t all = 0;
  device_options counted;
  counted.want = answer_kind::count;
  each_predicate([&](const predicate_info &p) {
    const rows_of x = random_rows(*p.a, s.small ? 60 : 400, {1, 0.3, 1, 0}, random),
                  y = random_rows(*p.b, s.small ? 33 : 300, {1, 0.3, 1, 0}, random);
    const prepared a = prepare(view_of(x), *p.a), b = prepare(view_of(y), *p.b);
    device_set da(with.on(), a), db(with.on(), b);
    db.move(pose_for(*p.b, placed(2, 1, 1, 1))); // which the poses replace
    std::vector<pose> fit;
    for (const pose &at : poses)
      fit.push_back(pose_for(*p.b, at));
    std::vector<std::uint64_t> want;
    collide_options counting;
    counting.want = answer_kind::count;
    for (const pose &at : fit)
      want.push_back(collide(a, prepare(view_of(y), *p.b, at), p, rung::certified, counting).count), all += want.back();
    for (const std::size_t capacity : {std::size_t{1} << 18, std::size_t{1} << 25}) {
      device_options o = counted;
      o.list_capacity = capacity;
      const poses_result have = collide(with.on(), da, db, fit, p, rung::certified, o);
      with.require(scene, have.counts == want, std::string(p.name) + ": other counts of pairs");
      o.want = answer_kind::any;
      const poses_result any = collide(with.on(), da, db, fit, p, rung::certified, o);
      bool same = any.counts.size() == want.size();
      for (std::size_t i = 0; same && i < want.size(); ++i)
        same = any.counts[i] == (want[i] > 0);
      with.require(scene, same, std::string(p.name) + ": other poses touch");
    }
    // Two bodies on each side, where those of B take poses that follow each other.
    std::vector<pose> turns;
    for (std::size_t i = 0; i < fit.size(); ++i)
      turns.push_back(fit[i]), turns.push_back(fit[(i + 1) % fit.size()]);
    device_set other_a(with.on(), b.elements() > 0 && p.a == p.b ? b : a), other_b(with.on(), b);
    device_set *const bodies_a[] = {&da, &other_a};
    const device_set *const bodies_b[] = {&db, &other_b};
    const poses_result bodies = collide(with.on(), bodies_a, bodies_b, turns, p, rung::certified, counted);
    bool right = bodies.counts.size() == 2 * turns.size();
    const poses_result of_other = collide(with.on(), other_a, db, fit, p, rung::certified, counted);
    for (std::size_t i = 0; right && i < fit.size(); ++i)
      for (std::size_t j = 0; j < 2; ++j) {
        const std::size_t at = (i + j) % fit.size();
        right = right && bodies.counts[2 * i + j] == want[at] &&
                bodies.counts[turns.size() + 2 * i + j] == of_other.counts[at];
      }
    with.require(scene, right, std::string(p.name) + ": other counts of bodies");
    const poses_result none = collide(with.on(), da, db, {}, p, rung::certified, counted);
    with.require(scene, none.counts.empty(), "no poses");
    std::vector<pose> far = fit;
    far[4] = pose_for(*p.b, placed(1e30, 0, 0, 0));
    far[4].m[3] = 1e300;
    std::string said;
    try {
      collide(with.on(), da, db, far, p, rung::certified, counted);
    } catch (const input_error &e) {
      said = e.what();
    }
    // The first of several in the caller's order.
    fault want_first = check(view_of(y), *p.b, far[4]);
    with.require(scene, said == "pose 4: " + describe(want_first, *p.b),
                 std::string(p.name) + ": a pose beyond float32: " + said);
  });
  with.require(scene, all > 100, "the poses touch too little");
}

} // namespace

void made_scenes(comparison &with, const settings &s) {
  made(with, s);
  indexed(with, s);
  travels(with, s);
  many_poses(with, s);
}

} // namespace cuda_test
