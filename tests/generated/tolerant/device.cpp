// The rung tolerant on a device: whole queries equal those of the CPU, after an upload and after a move, and sets that it
// does not fit are refused.
#include "tests/generated/tolerant/campaign.hpp"
#include "tests/runtime/device/kernels/cuda_test.hpp"

#include "meet/core/device/collide.hpp"
#include "meet/core/query/find.hpp"

#include <probe/probe_cuda.hpp>
#include <probe/probe_runtime.hpp>

#include <cstdio>
#include <cstring>
#include <functional>

using namespace meetc;
using namespace meetc::tolerant_test;

namespace {

int failures = 0;

void require(bool holds, const char *what) {
  if (holds)
    return;
  std::printf("FAILED: %s\n", what);
  ++failures;
}

prepared prepare_rows(const kind_info &kind, const std::vector<float> &rows, const pose &at) {
  view v;
  v.data = rows.data();
  v.stride_bytes = static_cast<std::size_t>(kind.fields) * sizeof(float);
  v.elements = rows.size() / static_cast<std::size_t>(kind.fields);
  return prepare(v, kind, at);
}

bool same(const std::vector<index_pair> &x, const std::vector<index_pair> &y) {
  return x.size() == y.size() &&
         std::equal(x.begin(), x.end(), y.begin(),
                    [](const index_pair &p, const index_pair &q) { return p.a == q.a && p.b == q.b; });
}

std::string thrown(const std::function<void()> &f) {
  try {
    f();
  } catch (const std::exception &e) {
    return e.what();
  }
  return {};
}

} // namespace

int main() {
  if (cuda_test::no_device())
    return cuda_test::skipped;
  const predicate_info &p = find_predicate(probe::catalogue(), "segment_triangle");
  device on(probe::cuda::catalogue());
  pose still, moved;
  still.grid = moved.grid = p.tolerance.step;
  moved.m[0] = moved.m[5] = 0.8, moved.m[1] = -0.6, moved.m[4] = 0.6, moved.m[11] = 0.0123;
  std::uint64_t pairs = 0;
  for (const family f : families) {
    const rows r = make(p, f, 3000, 31, p.tolerance.reach / 2);
    const prepared a = prepare_rows(*p.a, r.a, still), b = prepare_rows(*p.b, r.b, still);
    device_set on_a(on, a), on_b(on, b);
    const result here = collide(a, b, p, rung::tolerant);
    require(same(here.pairs, collide(on, on_a, on_b, p, rung::tolerant).pairs), name_of(f));
    pairs += here.count;
    // The device moves what was uploaded, which has been rounded once already.
    std::vector<float> rounded = r.b;
    for (std::size_t i = 0; i < r.count; ++i)
      move_rows(*p.b, still, rounded.data() + i * static_cast<std::size_t>(p.b->fields), 1);
    on_b.move(moved);
    const result there = collide(on, on_a, on_b, p, rung::tolerant);
    require(same(collide(a, prepare_rows(*p.b, rounded, moved), p, rung::tolerant).pairs, there.pairs), name_of(f));
    pairs += there.count;
  }
  require(pairs > 1000, "too few pairs to tell");
  const rows r = make(p, family::near, 200, 32, p.tolerance.reach);
  device_set on_a(on, prepare_rows(*p.a, r.a, still)), on_b(on, prepare_rows(*p.b, r.b, still)),
      off_grid(on, prepare_rows(*p.b, r.b, {}));
  const auto refused = [&](device_set &x, device_set &y) {
    return thrown([&] { collide(on, x, y, p, rung::tolerant); });
  };
  require(refused(on_a, on_b).empty(), "sets that fit");
  require(refused(on_a, off_grid).find("poses have its grid") != std::string::npos, "a set that is not on the grid");
  pose away = still;
  away.m[3] = 1;
  on_b.move(away);
  require(refused(on_a, on_b).find("leaves the box") != std::string::npos, "a set that is moved out of the box");
  away.grid = 0;
  on_b.move(away);
  require(refused(on_a, on_b).find("poses have its grid") != std::string::npos, "a set that is moved off the grid");
  away.grid = 0.3;
  require(thrown([&] { on_b.move(away); }).find("power of two") != std::string::npos, "a grid that is none");
  on_b.move({});
  require(refused(on_a, on_b).empty(), "a set that is moved back");
  std::printf("%s: %llu pairs of segments and triangles, %d failures\n", on.facts().name.c_str(),
              static_cast<unsigned long long>(pairs), failures);
  return failures > 0;
}
