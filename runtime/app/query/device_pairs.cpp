#include "meet/app/query/device_pairs.hpp"

#include "meet/app/input/failure.hpp"
#include "meet/app/input/sets.hpp"
#include "meet/core/threads/threads.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#if MEETC_WITH_CUDA
#include "cga/cga_cuda.hpp"
#include "meet/core/device/collide.hpp"

#include <chrono>
#include <numeric>
#include <optional>
#endif

namespace meetc::app {

processor processor_named(std::string_view name) {
  if (name == "cpu")
    return processor::cpu;
  if (name == "auto")
    return processor::best;
  if (name != "cuda")
    throw failure(fmt::format("--device {}: unknown; known: auto, cpu, cuda", io::quote(std::string(name))));
#if !MEETC_WITH_CUDA
  throw failure("--device cuda: this build has no CUDA kernels (" MEETC_NO_CUDA "); use --device cpu", no_device);
#endif
  return processor::cuda;
}

expected_seconds expected_on(std::size_t elements, int threads) {
  // On the CPU an element takes `one_thread` in `meet bench cpu --only balls`, less by the factor threads^gain from 1
  // to 16 threads (docs/cpu.md). On a device it takes `there` to be uploaded and ordered in `meet bench gpu --only
  // growth` (docs/gpu.md), and `start` is the time of a device's start on that machine as --json tells it.
  constexpr double one_thread = 200e-9, gain = 0.82, start = 0.3, there = 2e-9;
  constexpr int most_threads = 16;
  const auto n = static_cast<double>(elements);
  const int used = std::min(thread_count(threads), most_threads);
  return {one_thread * n / std::pow(used, gain), start + there * n};
}

bool device_expected([[maybe_unused]] std::size_t elements, [[maybe_unused]] int threads) {
#if MEETC_WITH_CUDA
  const expected_seconds expected = expected_on(elements, threads);
  return expected.cuda < expected.cpu;
#else
  return false;
#endif
}

#if MEETC_WITH_CUDA
namespace {

using seconds = std::chrono::duration<double>;

device_options options_there(const collide_options &options) {
  device_options o;
  o.want = options.want;
  o.first_met = options.first_met;
  o.owner_a = options.owner_a;
  o.owner_b = options.owner_b;
  o.progress = options.progress;
  return o;
}

device_account account_of(const device &on, std::size_t devices, const device_result &r, seconds started) {
  return {on.facts().name, static_cast<int>(devices), r.device_seconds, started.count()};
}

device_pairs pairs_on_one(const io::element_set &a, const io::element_set &b, const predicate_info &predicate,
                          rung precision, const pose &at, const collide_options &options) {
  const auto start = std::chrono::steady_clock::now();
  device on(cga::cuda::catalogue());
  const auto ready = std::chrono::steady_clock::now();
  device_set set_a(on, view_of(a), *a.kind, at, options.threads);
  std::optional<device_set> other; // unless A is collided with itself
  if (&a != &b)
    other.emplace(on, view_of(b), *b.kind, at, options.threads);
  device_set &set_b = other ? *other : set_a;
  device_pairs out;
  set_a.bounds(out.around_a.lo, out.around_a.hi);
  set_b.bounds(out.around_b.lo, out.around_b.hi);
  out.prepare_seconds = seconds(std::chrono::steady_clock::now() - ready).count();
  device_result r = meetc::collide(on, set_a, set_b, predicate, precision, options_there(options));
  out.account = account_of(on, 1, r, ready - start);
  out.found = std::move(r);
  return out;
}

device_pairs pairs_on_several(const io::element_set &a, const io::element_set &b, const predicate_info &predicate,
                              rung precision, const pose &at, int devices, const collide_options &options) {
  std::vector<int> numbers(static_cast<std::size_t>(devices));
  std::iota(numbers.begin(), numbers.end(), 0);
  const auto start = std::chrono::steady_clock::now();
  device_group on(cga::cuda::catalogue(), numbers);
  const auto ready = std::chrono::steady_clock::now();
  const auto [how_a, how_b] = spread_for(a.elements, b.elements, options.first_met);
  group_set set_a(on, view_of(a), *a.kind, how_a, at, options.threads),
      set_b(on, view_of(b), *b.kind, how_b, at, options.threads);
  device_pairs out;
  set_a.bounds(out.around_a.lo, out.around_a.hi);
  set_b.bounds(out.around_b.lo, out.around_b.hi);
  out.prepare_seconds = seconds(std::chrono::steady_clock::now() - ready).count();
  device_result r = meetc::collide(on, set_a, set_b, predicate, precision, options_there(options));
  out.account = account_of(on[0], on.size(), r, ready - start);
  out.found = std::move(r);
  return out;
}

} // namespace

device_pairs pairs_on_device(const io::element_set &a, const io::element_set &b, const predicate_info &predicate,
                             rung precision, double grid, int devices, const collide_options &options) {
  pose at;
  at.grid = grid;
  try {
    return devices > 1 && &a != &b ? pairs_on_several(a, b, predicate, precision, at, devices, options)
                                   : pairs_on_one(a, b, predicate, precision, at, options);
  } catch (const device_error &e) {
    throw failure(e.what(), no_device);
  }
}
#else
device_pairs pairs_on_device(const io::element_set &, const io::element_set &, const predicate_info &, rung, double,
                             int, const collide_options &) {
  throw failure("this build has no CUDA kernels", no_device);
}
#endif

} // namespace meetc::app
