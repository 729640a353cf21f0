#include "app/device_pairs.hpp"

#include "app/failure.hpp"
#include "app/sets.hpp"
#include "core/threads.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#if MEETC_WITH_CUDA
#include "cga/cga_cuda.hpp"
#include "core/device/collide.hpp"

#include <chrono>
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
  throw failure("--device cuda: this build has no CUDA kernels (no nvcc was found); use --device cpu", no_device);
#endif
  return processor::cuda;
}

expected_seconds expected_on(std::size_t elements, int threads) {
  // What an element takes in `meet bench cpu --only balls`, from 1 to 16 threads (docs/cpu.md), and where it is uploaded and
  // ordered in `meet bench gpu --only growth` (docs/gpu.md); `start` is what --json says of a device's start on that machine.
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
device_pairs pairs_on_device(const io::element_set &a, const io::element_set &b, const predicate_info &predicate,
                             rung precision, double grid, const collide_options &options) {
  try {
    const auto start = std::chrono::steady_clock::now();
    device on(cga::cuda::catalogue());
    const auto ready = std::chrono::steady_clock::now();
    pose at;
    at.grid = grid;
    device_set set_a(on, view_of(a), *a.kind, at, options.threads);
    std::optional<device_set> other; // unless A is collided with itself
    if (&a != &b)
      other.emplace(on, view_of(b), *b.kind, at, options.threads);
    device_set &set_b = other ? *other : set_a;
    device_pairs out;
    set_a.bounds(out.around_a.lo, out.around_a.hi);
    set_b.bounds(out.around_b.lo, out.around_b.hi);
    const std::chrono::duration<double> started = ready - start, made = std::chrono::steady_clock::now() - ready;
    out.prepare_seconds = made.count();
    device_options o;
    o.want = options.want;
    o.first_met = options.first_met;
    o.owner_a = options.owner_a;
    o.owner_b = options.owner_b;
    o.progress = options.progress;
    device_result r = meetc::collide(on, set_a, set_b, predicate, precision, o);
    out.account = {on.facts().name,
                   r.by == search::tree ? "none" : model_of(r.filter), // a hierarchy compares numbers alone
                   name_of(r.by),
                   {},
                   r.device_seconds,
                   started.count()};
    for (int i = 0; i < searches; ++i)
      out.account.expected.emplace_back(name_of(static_cast<search>(i)), r.expected.of[i]);
    out.found = std::move(r);
    return out;
  } catch (const device_error &e) {
    throw failure(e.what(), no_device);
  }
}
#else
device_pairs pairs_on_device(const io::element_set &, const io::element_set &, const predicate_info &, rung, double,
                             const collide_options &) {
  throw failure("this build has no CUDA kernels", no_device);
}
#endif

} // namespace meetc::app
