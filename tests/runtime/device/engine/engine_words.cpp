// The device's entries under control words that another library may have set: the answers are those of the CPU under the
// standard word, nothing traps, and the word is as it was.
#include "engine.hpp"

#include "meet/core/device/collide.hpp"
#include "meet/core/device/contacts.hpp"
#include "meet/core/device/self_pairs.hpp"
#include "tests/downstream/flags/words.hpp"
#include "tests/runtime/self/made_meshes.hpp"

#include <cstring>
#include <neighbours/neighbours_cuda.hpp>

namespace cuda_test {
namespace {

using namespace meetc;

// Calls f under each word, and notes whether the word is kept.
template <class F> void under_each(comparison &with, const std::string &scene, const F &f) {
  for (const auto word : strange_words) {
    bool kept = false;
    std::string thrown;
    {
      const other_word changed(word);
      if (!changed.kept)
        continue;
      try {
        call_apart(f);
      } catch (const std::exception &e) {
        set_control_word(plain_word);
        thrown = e.what();
        set_control_word(word);
      }
      kept = ::settings(control_word()) == ::settings(word);
    }
    with.require(scene, kept && thrown.empty(), "the word is another one afterwards, or " + thrown);
  }
}

// A pose whose arithmetic rounds, and meets subnormal numbers.
pose rounding_pose() {
  pose at;
  at.m[0] = 1 / 3.0, at.m[5] = 0.3, at.m[10] = 0.75, at.m[3] = 0x1.8p-148;
  at.length_scale = 1 / 3.0;
  return at;
}

void of_predicate(comparison &with, const predicate_info &p, double scale, engine &random) {
  const std::string scene = "under words";
  const rows_of a = random_rows(*p.a, 80, {1, 0.3, scale, 0}, random),
                b = random_rows(*p.b, 90, {1, 0.3, scale, 0}, random);
  const pose at = rounding_pose();
  const prepared set_a = prepare(view_of(a), *p.a), set_b = prepare(view_of(b), *p.b),
                 moved = prepare(view_of(b), *p.b, at);
  const result want = collide(set_a, set_b, p, rung::certified), want_moved = collide(set_a, moved, p, rung::certified);
  float lo[3], hi[3];
  set_a.bounds(lo, hi);
  under_each(with, scene, [&] {
    device_set x(with.on(), view_of(a), *p.a), y(with.on(), view_of(b), *p.b), of_prepared(with.on(), set_a);
    float low[3], high[3];
    x.bounds(low, high);
    const device_result as_it_is = collide(with.on(), x, y, p, rung::certified),
                        again = collide(with.on(), of_prepared, y, p, rung::certified);
    device_set given_a = device_set::given(with.on(), view_of(a), *p.a),
               given_b = device_set::given(with.on(), view_of(b), *p.b);
    given_b.move(at);
    const device_result given = collide(with.on(), given_a, given_b, p, rung::certified);
    device_options count;
    count.want = answer_kind::count;
    const pose poses[] = {pose(), at};
    const poses_result several = collide(with.on(), x, y, poses, p, rung::certified, count);
    y.move(at);
    const device_result posed = collide(with.on(), x, y, p, rung::certified);
    const bool same = same_list(as_it_is.pairs, want.pairs) && same_list(again.pairs, want.pairs) &&
                      same_list(given.pairs, want_moved.pairs) && same_list(posed.pairs, want_moved.pairs) &&
                      several.counts == std::vector<std::uint64_t>{want.count, want_moved.count} &&
                      std::memcmp(low, lo, sizeof lo) == 0 && std::memcmp(high, hi, sizeof hi) == 0;
    if (!same)
      throw std::logic_error(std::string(p.name) + " answers otherwise");
  });
}

void of_contacts(comparison &with, const predicate_info &p, double scale, engine &random) {
  const rows_of a = random_rows(*p.a, 60, {1, 0.5, scale, 0}, random),
                b = random_rows(*p.b, 60, {1, 0.5, scale, 0}, random);
  const std::vector<index_pair> pairs =
      collide(prepare(view_of(a), *p.a), prepare(view_of(b), *p.b), p, rung::certified).pairs;
  const contact_set<double> want = contacts<double>(view_of(a), view_of(b), p, pairs);
  under_each(with, "contacts under words", [&] {
    const contact_set<double> have = contacts<double>(with.on(), view_of(a), view_of(b), p, pairs);
    if (have.codes != want.codes || have.points.size() != want.points.size() ||
        (!want.points.empty() &&
         std::memcmp(have.points.data(), want.points.data(), want.points.size() * sizeof(double)) != 0))
      throw std::logic_error(std::string(p.name) + " has other contacts");
  });
}

void of_mesh(comparison &with, unsigned seed) {
  const self_test::mesh m = self_test::lattice_mesh(seed, 12, 20, 4);
  const predicate_info &touch = predicate_named("triangle_triangle");
  const pose at = rounding_pose();
  const self_result want = self_pairs(prepare(m.view(), *touch.a, at), m.view(), self_test::predicates());
  under_each(with, "self under words", [&] {
    device_set set(with.on(), m.view(), *touch.a, at);
    const device_self_result have = self_pairs(with.on(), set, self_test::predicates(), neighbours::cuda::catalogue());
    if (!same_list(have.pairs, want.pairs) || have.degenerate != want.degenerate)
      throw std::logic_error("a mesh crosses itself otherwise");
  });
}

} // namespace

void word_scenes(comparison &with, const settings &s) {
  engine random(s.seed + 900);
  each_predicate([&](const predicate_info &p) {
    for (const double scale : {1.0, 0x1p-140})
      of_predicate(with, p, scale, random);
    if (p.contacts)
      for (const double scale : {1.0, 0x1p-140})
        of_contacts(with, p, scale, random);
  });
  for (unsigned seed = 0; seed < 4; ++seed)
    of_mesh(with, seed);
}

} // namespace cuda_test
