// Queries that a token ends: before they begin, and between two parts of a walk. The sets answer afterwards as before.
#include "engine.hpp"

#include "meet/core/device/self_pairs.hpp"
#include "meet/core/device/world.hpp"
#include "meet/core/threads/cancelled.hpp"
#include "tests/runtime/self/made_meshes.hpp"

#include <neighbours/neighbours_cuda.hpp>

#include <algorithm>
#include <chrono>
#include <thread>

namespace cuda_test {
namespace {

using namespace meetc;
using clock = std::chrono::steady_clock;

constexpr std::size_t least_lists = std::size_t{1} << 11;

class scenes {
public:
  explicit scenes(comparison &with) : with_(with) {}

  void require(bool holds, const std::string &what) { with_.require("stops", holds, what); }

  // ask(options) is a call with the `progress` and `stop` of its Options, of some parts.
  template <class Options, class Ask> void stops(const std::string &what, const Ask &ask, bool tells_of_parts = true) {
    Options before;
    std::stop_source requested;
    requested.request_stop();
    before.stop = requested.get_token();
    bool began = false;
    before.progress = [&began](double) { began = true; };
    require(cancelled_by(ask, before) && !began, what + ": a request before the call does not end it");
    if (!tells_of_parts)
      return;
    Options between;
    std::stop_source source;
    between.stop = source.get_token();
    int told = 0;
    between.progress = [&](double) { ++told, source.request_stop(); };
    require(cancelled_by(ask, between), what + ": a request during the call does not end it");
    require(told == 1, what + ": it went on for " + std::to_string(told) + " parts");
  }

  // Asks until it is stopped after a while. Returns how long it took to end.
  template <class Ask> double seconds_to_end(std::chrono::milliseconds after, const Ask &ask) {
    std::stop_source source;
    clock::time_point asked_to;
    device_options o;
    o.want = answer_kind::count;
    o.stop = source.get_token();
    std::jthread other([&] {
      std::this_thread::sleep_for(after);
      asked_to = clock::now();
      source.request_stop();
    });
    const bool ended = cancelled_by(ask, o);
    const clock::time_point end = clock::now();
    other.join();
    require(ended, "a long query was not ended");
    return std::chrono::duration<double>(end - asked_to).count();
  }

private:
  template <class Ask, class Options> static bool cancelled_by(const Ask &ask, const Options &options) {
    try {
      ask(options);
    } catch (const cancelled &) {
      return true;
    }
    return false;
  }

  comparison &with_;
};

} // namespace

void stop_scenes(comparison &with, const settings &s) {
  std::printf("queries that are ended ...\n");
  scenes all(with);
  engine random(s.seed + 70);
  const predicate_info &p = predicate_named("triangle_triangle");
  const std::size_t n = s.small ? 400 : 4000;
  const place crowded{1, 0.5, 1, 0};
  const rows_of x = random_rows(*p.a, n, crowded, random), y = random_rows(*p.b, n, crowded, random);
  const prepared host_a = prepare(view_of(x), *p.a), host_b = prepare(view_of(y), *p.b);
  device_set a(with.on(), host_a), b(with.on(), host_b), given_a = device_set::given(with.on(), view_of(x), *p.a),
                                                         given_b = device_set::given(with.on(), view_of(y), *p.b);
  const result want = collide(host_a, host_b, p, rung::certified);
  const auto asks = [&](device_set &of_a, device_set &of_b) {
    return [&](device_options o) {
      o.list_capacity = least_lists;
      collide(with.on(), of_a, of_b, p, rung::certified, o);
    };
  };
  const auto same_as_before = [&](device_set &of_a, device_set &of_b, const std::string &what) {
    all.require(same_list(collide(with.on(), of_a, of_b, p, rung::certified).pairs, want.pairs),
                what + ": another answer afterwards");
  };
  all.stops<device_options>("two sets", asks(a, b));
  same_as_before(a, b, "two sets");
  all.stops<device_options>("a set with itself", asks(a, a));
  all.stops<device_options>("given sets", asks(given_a, given_b));
  same_as_before(given_a, given_b, "given sets");

  const std::vector<pose> poses(5);
  all.stops<device_options>(
      "poses",
      [&](device_options o) { o.want = answer_kind::count, collide(with.on(), a, b, poses, p, rung::certified, o); },
      false);
  all.require(
      std::ranges::all_of(collide(with.on(), a, b, poses, p, rung::certified, {.want = answer_kind::count}).counts,
                          [&](std::uint64_t found) { return found == want.count; }),
      "poses: other counts afterwards");

  const self_test::mesh crowd = self_test::lattice_mesh(5, 40, s.small ? 120 : 1500, 6);
  device_set mesh(with.on(), crowd.view(), *p.a);
  const auto ask_self = [&](device_self_options o) {
    o.list_capacity = least_lists;
    return self_pairs(with.on(), mesh, self_test::predicates(), neighbours::cuda::catalogue(), o);
  };
  const std::vector<index_pair> crossing = ask_self({}).pairs;
  all.stops<device_self_options>("a mesh with itself", ask_self, !s.small);
  all.require(same_list(ask_self({}).pairs, crossing), "a mesh with itself: another answer afterwards");

  world bodies(cga::catalogue());
  bodies.add("a", std::make_shared<prepared>(prepare(view_of(x), *p.a)));
  bodies.add("b", std::make_shared<prepared>(prepare(view_of(y), *p.b)));
  device_world there(with.on(), bodies);
  const auto ask_world = [&](const world_options &o) { return there.touching(o); };
  all.stops<world_options>("bodies", ask_world);
  const world_answer found = there.touching({.want = answer_kind::pairs});
  all.require(found.touching.size() == 1 && same_list(found.touching[0].found.pairs, want.pairs),
              "bodies: another answer afterwards");

  const int numbers[] = {0, 0};
  const device_group group(with.on().kernels(), numbers);
  group_set cut(group, view_of(x), *p.a, spread::cut), whole(group, view_of(y), *p.b, spread::whole);
  all.stops<device_options>("a group", [&](device_options o) {
    o.list_capacity = least_lists;
    collide(group, cut, whole, p, rung::certified, o);
  });
  all.require(same_list(collide(group, cut, whole, p, rung::certified).pairs, want.pairs),
              "a group: another answer afterwards");
  if (s.small)
    return;
  // Nearly all pairs of half a million triangles touch.
  const rows_of many = random_rows(*p.a, 500000, {1, 1, 1, 0}, random);
  device_set large(with.on(), view_of(many), *p.a);
  double longest = 0;
  for (int i = 0; i < 20; ++i)
    longest = std::max(longest, all.seconds_to_end(std::chrono::milliseconds(50 + 7 * i), [&](const device_options &o) {
      collide(with.on(), large, large, p, rung::certified, o);
    }));
  std::printf("a query of 500,000 triangles ended %.1f ms after the request, at most\n", longest * 1000);
}

} // namespace cuda_test
