// A device itself: threads that share it, sets that outlive the last name of it, and frees that fail.
#include "engine.hpp"

#include "meet/core/device/memory/memory.hpp"

#include <cga/cga_cuda.hpp>

#include <atomic>
#include <thread>

namespace cuda_test {
namespace {

using namespace meetc;

// Queries of several threads at once, each on sets of its own and on one that all share.
void shared(comparison &with, const settings &s) {
  engine random(s.seed + 80);
  const predicate_info &p = predicate_named("triangle_triangle");
  const std::size_t n = s.small ? 150 : 3000;
  const rows_of all = random_rows(*p.b, n, {1, 0.2, 1, 0}, random);
  device_set of_all(with.on(), view_of(all), *p.b);
  constexpr int threads = 4;
  std::atomic<int> right{0};
  const int times = s.small ? 3 : 20;
  {
    std::vector<std::jthread> some;
    for (int t = 0; t < threads; ++t) {
      const rows_of mine = random_rows(*p.a, n / 2 + static_cast<std::size_t>(t), {1, 0.2, 1, 0}, random);
      some.emplace_back([&, mine] {
        const result want = collide(prepare(view_of(mine), *p.a, {}, 1), prepare(view_of(all), *p.b, {}, 1), p,
                                    rung::certified, {.threads = 1});
        for (int i = 0; i < times; ++i) {
          device_set there =
              i % 2 ? device_set::given(with.on(), view_of(mine), *p.a) : device_set(with.on(), view_of(mine), *p.a);
          right += want.count > 0 && same_list(collide(with.on(), there, of_all, p, rung::certified).pairs, want.pairs);
        }
      });
    }
  }
  with.require("threads share a device", right == threads * times, "another list");
}

void outlived(comparison &with, const settings &s) {
  engine random(s.seed + 81);
  const predicate_info &p = predicate_named("ball_ball");
  const rows_of x = random_rows(*p.a, 200, {1, 0.2, 1, 0}, random);
  std::optional<device> first(cga::cuda::catalogue());
  device_set a(*first, view_of(x), *p.a), b = device_set::given(*first, view_of(x), *p.b);
  first.reset();
  with.require("a set keeps its device",
               same_list(collide(a.on(), a, b, p, rung::certified).pairs,
                         collide(prepare(view_of(x), *p.a), prepare(view_of(x), *p.b), p, rung::certified).pairs),
               "another list");
}

// Nobody can be told where memory is freed. The next call tells.
void frees(comparison &with) {
  int on_the_host = 0;
  free_on_device(&on_the_host);
  std::string said;
  try {
    check(cudaSuccess, "a test");
  } catch (const device_error &e) {
    said = e.what();
  }
  with.require("frees", said.find("CUDA: freeing memory: ") == 0, "a free that failed is not told: " + said);
  check(cudaSuccess, "a test"); // once
}

} // namespace

void device_scenes(comparison &with, const settings &s) {
  shared(with, s);
  outlived(with, s);
  frees(with);
}

} // namespace cuda_test
