// Queries that are cut between the devices of a group: against the CPU's answers, on as many devices as there are and on one
// that stands in the group several times.
#include "engine.hpp"

#include "meet/core/device/collide.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <numeric>

namespace cuda_test {
namespace {

using namespace meetc;

bool same_pairs(const std::vector<index_pair> &x, const std::vector<index_pair> &y) {
  return std::equal(x.begin(), x.end(), y.begin(), y.end(),
                    [](const index_pair &p, const index_pair &q) { return p.a == q.a && p.b == q.b; });
}
bool same_answer(const result &x, const result &y) {
  return same_pairs(x.pairs, y.pairs) && x.count == y.count && x.flags.a == y.flags.a && x.flags.b == y.flags.b &&
         x.counts.a == y.counts.a && x.counts.b == y.counts.b && x.first_met == y.first_met;
}

std::vector<std::vector<int>> groups() {
  std::vector<std::vector<int>> out{{0}, {0, 0}, {0, 0, 0}};
  int count = 0;
  if (cudaGetDeviceCount(&count) == cudaSuccess && count > 1) {
    out.emplace_back(static_cast<std::size_t>(count));
    std::iota(out.back().begin(), out.back().end(), 0);
  }
  return out;
}

struct owners {
  const char *name;
  std::vector<std::uint32_t> a, b;
};

class scenes {
public:
  scenes(comparison &with, device_group &on, std::string name) : with_(with), on_(on), name_(std::move(name)) {}

  // Every kind of answer; x and y may be the same elements.
  void same(const std::string &what, const predicate_info &p, const view &x, const view &y, const pose &at,
            const owners &o) {
    const prepared a = prepare(x, *p.a, at), b = prepare(y, *p.b, at);
    for (const bool cut_a : {true, false}) {
      group_set ga(on_, x, *p.a, cut_a ? spread::cut : spread::whole, at),
          gb(on_, y, *p.b, cut_a ? spread::whole : spread::cut, at);
      same(what + (cut_a ? ", A is cut" : ", B is cut"), p, a, ga, b, gb, o);
    }
  }
  void same(const std::string &what, const predicate_info &p, const prepared &a, group_set &ga, const prepared &b,
            group_set &gb, const owners &o) {
    for (const answer_kind want : {answer_kind::pairs, answer_kind::count, answer_kind::counts, answer_kind::flags,
                                   answer_kind::any, answer_kind::none}) {
      collide_options here;
      device_options there;
      here.want = there.want = want;
      here.owner_a = there.owner_a = o.a;
      here.owner_b = there.owner_b = o.b;
      here.first_met = there.first_met =
          p.first_met && o.a.empty() && want != answer_kind::any && ga.how() == spread::cut;
      if (want == answer_kind::none && !here.first_met)
        continue;
      there.first_alone = true;
      const result expected = collide(a, b, p, rung::certified, here);
      const device_result have = collide(on_, ga, gb, p, rung::certified, there);
      require(same_answer(have, expected), std::string(p.name) + ", " + what + ", " + o.name +
                                               ": another answer, of kind " + std::to_string(static_cast<int>(want)));
      with_.add(name_, p, have);
    }
    float lo[3], hi[3], want_lo[3], want_hi[3];
    for (const auto &[set, of] : {std::pair(&a, &ga), std::pair(&b, &gb)}) {
      set->bounds(want_lo, want_hi), of->bounds(lo, hi);
      require(set->elements() == 0
                  ? lo[0] > hi[0]
                  : std::memcmp(lo, want_lo, sizeof lo) == 0 && std::memcmp(hi, want_hi, sizeof hi) == 0,
              std::string(p.name) + ", " + what + ": another box around all elements");
    }
  }
  void require(bool holds, const std::string &what) { with_.require(name_, holds, what); }

  // A fault in the last element of A, in whichever slice that is, and in B.
  void faults(const predicate_info &p, rows_of x, rows_of y) {
    const auto element_of = [](const auto &make) {
      try {
        make();
      } catch (const input_error &e) {
        return e.where.element;
      }
      return std::numeric_limits<std::size_t>::max();
    };
    x.rows.back() = std::numeric_limits<float>::quiet_NaN();
    require(element_of([&] { group_set(on_, view_of(x), *p.a, spread::cut); }) == x.size() - 1,
            "a fault of the last slice names another element");
    y.rows[5 * static_cast<std::size_t>(p.b->fields)] = std::numeric_limits<float>::infinity();
    require(element_of([&] { group_set(on_, view_of(y), *p.b, spread::whole); }) == 5,
            "a fault of a whole set names another element");
    x.rows.back() = std::numeric_limits<float>::max() / 2;
    pose far;
    far.m[0] = far.m[5] = far.m[10] = far.length_scale = 4;
    group_set ready(on_, view_of(x), *p.a, spread::cut);
    require(element_of([&] { ready.move(far); }) == x.size() - 1, "a move beyond float32 names another element");
  }
  void refusals(const predicate_info &p, const rows_of &x, const rows_of &y) {
    group_set a(on_, view_of(x), *p.a, spread::cut), b(on_, view_of(y), *p.b, spread::whole);
    const auto refused = [](const auto &query) {
      try {
        query();
      } catch (const std::invalid_argument &) {
        return true;
      }
      return false;
    };
    require(refused([&] { collide(on_, a, a, p, rung::certified); }), "two sets that are cut are not refused");
    require(refused([&] { collide(on_, b, b, p, rung::certified); }), "two whole sets are not refused");
    pairs_there pairs;
    device_options leaves;
    leaves.leave_there = &pairs;
    require(refused([&] { collide(on_, a, b, p, rung::certified, leaves); }),
            "a list that is left there is not refused");
    const predicate_info &q = predicate_named("segment_triangle");
    const rows_of segments = same_rows(*q.a, 5);
    group_set whole(on_, view_of(segments), *q.a, spread::whole);
    device_options first;
    first.first_met = true;
    require(refused([&] { collide(on_, whole, a, q, rung::certified, first); }),
            "a whole set is asked what it meets first");
    require(spread_for(3, 2, false).first == spread::cut && spread_for(2, 3, false).first == spread::whole &&
                spread_for(2, 3, true).first == spread::cut,
            "another set than the larger is cut");
    const std::vector<std::uint32_t> few(x.size() - 1);
    device_options o;
    o.owner_a = few;
    require(refused([&] { collide(on_, a, b, p, rung::certified, o); }), "owners of other elements are not refused");
    require(refused([&] { device_group(on_[0].kernels(), {}); }), "a group of no device is not refused");
    const int missing[] = {0, 4711};
    bool named = false;
    try {
      device_group(on_[0].kernels(), missing);
    } catch (const missing_device &e) {
      named = std::string(e.what()).find("there is no CUDA device number 4711 here") == 0;
    }
    require(named, "a device that is not there is not named");
  }

private:
  comparison &with_;
  device_group &on_;
  std::string name_;
};

void run(comparison &with, const settings &s, device_group &on, const std::string &name) {
  engine random(s.seed + 50);
  scenes all(with, on, name);
  const std::size_t n = s.small ? 80 : 2500, m = s.small ? 50 : 900;
  const place at{1, 0.5, 1, 0};
  each_predicate([&](const predicate_info &p) {
    const rows_of x = random_rows(*p.a, n, at, random), y = random_rows(*p.b, m, at, random);
    owners few{"owners", {}, {}}, second{"owners of B", {}, {}};
    for (std::size_t i = 0; i < n; ++i) // elements of one item lie in several slices
      few.a.push_back(static_cast<std::uint32_t>(random() % (n / 4)));
    for (std::size_t i = 0; i < m; ++i)
      few.b.push_back(static_cast<std::uint32_t>(random() % (m / 2)));
    second.b = few.b;
    for (const owners &o : {owners{"no owners", {}, {}}, second, few})
      all.same("random", p, view_of(x), view_of(y), pose_for(*p.a, {}), o);
    const owners none{"no owners", {}, {}};
    const rows_of hostile = family_rows(*p.a, n, -1, random), other = family_rows(*p.b, m, -1, random);
    all.same("families", p, view_of(hostile), view_of(other), {}, none);
    const rows_of one = random_rows(*p.a, 1, at, random), nothing{p.a, {}}, also_nothing{p.b, {}};
    all.same("one element", p, view_of(one), view_of(y), {}, none);
    all.same("nothing in A", p, view_of(nothing), view_of(y), {}, none);
    all.same("nothing in B", p, view_of(x), view_of(also_nothing), {}, none);
    if (p.a == p.b)
      all.same("with itself", p, view_of(x), view_of(x), {}, none);
    pose moved;
    moved.m[3] = 0.0625, moved.m[7] = -0.125;
    group_set a(on, view_of(x), *p.a, spread::cut), b(on, view_of(y), *p.b, spread::whole);
    a.move(moved), b.move(moved);
    all.same("moved", p, prepare(view_of(x), *p.a, moved), a, prepare(view_of(y), *p.b, moved), b, none);
  });
  const predicate_info &p = predicate_named("triangle_triangle");
  const rows_of x = random_rows(*p.a, n, at, random), y = random_rows(*p.b, m, at, random);
  all.faults(p, x, y);
  all.refusals(p, x, y);
  // A mesh: a slice of its faces has all of its points.
  const std::size_t points = n;
  std::vector<float> coordinates(3 * points);
  std::vector<std::uint32_t> index(3 * n);
  for (float &c : coordinates)
    c = std::ldexp(static_cast<float>(random() % 64), -6);
  for (std::size_t i = 0; i < index.size(); ++i)
    index[i] = static_cast<std::uint32_t>((i / 3 + (i % 3) * (1 + random() % 3)) % points);
  const view mesh{coordinates.data(), points, 3 * sizeof(float), index.data(), n};
  all.same("a mesh", p, mesh, view_of(y), {}, {"no owners", {}, {}});
}

} // namespace

void group_scenes(comparison &with, const settings &s) {
  for (const std::vector<int> &numbers : groups()) {
    device_group on(with.on().kernels(), numbers);
    const bool several = numbers.size() > 1 && numbers[1] != numbers[0];
    run(with, s, on, "cut into " + std::to_string(numbers.size()) + (several ? ", a device each" : ""));
  }
}

} // namespace cuda_test
