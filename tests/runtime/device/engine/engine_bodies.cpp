// Many bodies that move: the device's world against the CPU's.
#include "engine.hpp"

#include "meet/core/device/world.hpp"

#include "tests/runtime/device/kernels/cuda_test.hpp"

#include <cmath>
#include <functional>
#include <string>

namespace cuda_test {
namespace {

using namespace meetc;

// A body turned by a rational turn about one axis, with a place within `range`.
pose drawn(engine &random, double range) {
  const auto uniform = [&random](double lo, double hi) {
    return lo + (hi - lo) * (static_cast<double>(random() >> 11) * 0x1p-53);
  };
  const double t = uniform(-1, 1), c = (1 - t * t) / (1 + t * t), s = 2 * t / (1 + t * t);
  pose p;
  const double m[12] = {c,  0, s, uniform(-range, range), 0, 1, 0, uniform(-range, range),
                        -s, 0, c, uniform(-range, range)};
  std::copy_n(m, 12, p.m);
  return p;
}

bool same_result(const result &x, const result &y) {
  return x.count == y.count && same_list(x.pairs, y.pairs) && x.flags.a == y.flags.a && x.flags.b == y.flags.b &&
         x.counts.a == y.counts.a && x.counts.b == y.counts.b;
}
bool same_answer(const world_answer &x, const world_answer &y) {
  return x.near == y.near && std::ranges::equal(x.touching, y.touching, [](const auto &a, const auto &b) {
           return a.a == b.a && a.b == b.b && same_result(a.found, b.found);
         });
}

// No predicate decides some pairs, which are not to be asked about.
void ignore_undecided(world &bodies) {
  for (std::uint32_t a = 0; a < bodies.size(); ++a)
    for (std::uint32_t b = a + 1; b < bodies.size(); ++b)
      if (!first_for(fitting(cga::catalogue(), bodies.shape(a).kind(), bodies.shape(b).kind()), "solid"))
        bodies.ignore(a, b);
}

// The text of an input_error; empty: there was none.
std::string thrown(const std::function<void()> &ask) {
  try {
    ask();
  } catch (const input_error &e) {
    return e.what();
  }
  return "";
}

} // namespace

// Bodies of all kinds, of which some share a shape and some have items.
void body_scenes(comparison &with, const settings &s) {
  engine random(s.seed + 60);
  const std::string scene = "bodies";
  const std::size_t n = s.small ? 40 : 400;
  std::vector<std::shared_ptr<const prepared>> shapes;
  const catalogue &all = cga::catalogue();
  std::vector<rows_of> rows;
  for (int k = 0; k < all.kind_count; ++k)
    rows.push_back(random_rows(all.kinds[k], n + static_cast<std::size_t>(k), {1, 0.2, 1, 0}, random));
  for (const rows_of &r : rows)
    shapes.push_back(std::make_shared<prepared>(prepare(view_of(r), *r.kind)));
  world bodies(all);
  const std::size_t count = s.small ? 12 : 40;
  for (std::size_t i = 0; i < count; ++i) {
    const auto &shape = shapes[i % shapes.size()];
    std::vector<std::uint32_t> owners;
    for (std::size_t e = 0; i % 3 == 0 && e < shape->elements(); ++e)
      owners.push_back(static_cast<std::uint32_t>(e / 4));
    bodies.add("body " + std::to_string(i), shape, {}, std::move(owners));
  }
  ignore_undecided(bodies);
  device_world there(with.on(), bodies);
  std::size_t touching = 0;
  for (int frame = 0; frame < (s.small ? 2 : 6); ++frame) {
    // In the last frame some stay, and some stand as they are.
    for (std::uint32_t b = 0; b < count; ++b)
      if (frame == 0 || b % 3 != 0)
        bodies.move(b, b % 5 == 4 ? pose() : pose_for(bodies.shape(b).kind(), drawn(random, 1.5)));
    for (const answer_kind want : {answer_kind::pairs, answer_kind::counts, answer_kind::flags, answer_kind::any}) {
      world_options o;
      o.want = want;
      o.precision = frame % 2 == 0 ? rung::certified : rung::exact;
      const world_answer have = there.touching(o);
      touching += have.touching.size();
      with.require(scene, same_answer(bodies.touching(o), have), "another answer than the CPU's");
      o.first = true;
      with.require(scene, same_answer(bodies.touching(o), there.touching(o)), "another first pair than the CPU's");
      const std::uint32_t some[] = {1, 2};
      o.first = false, o.of = some;
      with.require(scene, same_answer(bodies.touching(o), there.touching(o)), "another answer about some bodies");
    }
  }
  with.require(scene, touching > count, "the test's own bodies hardly touch");
  // Bodies that are added later, and one that leaves float32.
  const std::uint32_t added = bodies.add("added", shapes[0], {});
  ignore_undecided(bodies);
  with.require(scene, same_answer(bodies.touching(), there.touching()), "another answer with one more body");
  pose far;
  far.m[3] = 1e39;
  bodies.move(added, far);
  const std::string want = thrown([&] { static_cast<void>(bodies.touching()); }),
                    have = thrown([&] { static_cast<void>(there.touching()); });
  with.require(scene, !want.empty() && want == have, "\"" + have + "\", and the CPU: \"" + want + "\"");
  bodies.move(added, {});
  with.require(scene, same_answer(bodies.touching(), there.touching()), "another answer after an error");
}

} // namespace cuda_test
