#include "app/device_pairs.hpp"

#include "app/failure.hpp"

#include <fmt/format.h>

#if MEETC_WITH_CUDA
#include "cga/cga_cuda.hpp"
#include "core/device/collide.hpp"

#include <chrono>
#endif

namespace meetc::app {

processor processor_named(std::string_view name) {
  if (name == "cpu" || name == "auto")
    return processor::cpu;
  if (name != "cuda")
    throw failure(fmt::format("--device {}: unknown; known: auto, cpu, cuda", io::quote(std::string(name))));
#if !MEETC_WITH_CUDA
  throw failure("--device cuda: this build has no CUDA kernels (no nvcc was found); use --device cpu", no_device);
#endif
  return processor::cuda;
}

#if MEETC_WITH_CUDA
device_pairs pairs_on_device(const prepared &a, const prepared &b, const predicate_info &predicate, rung precision,
                             const collide_options &options) {
  try {
    const auto start = std::chrono::steady_clock::now();
    device on(cga::cuda::catalogue());
    device_set set_a(on, a), set_b(on, b);
    const std::chrono::duration<double> started = std::chrono::steady_clock::now() - start;
    device_options o;
    o.want = options.want;
    o.owner_a = options.owner_a;
    o.owner_b = options.owner_b;
    o.progress = options.progress;
    device_result r = meetc::collide(on, set_a, set_b, predicate, precision, o);
    device_account by{on.facts().name,
                      r.by == search::tree ? "none" : model_of(r.filter), // a hierarchy compares numbers alone
                      name_of(r.by),
                      {},
                      r.device_seconds,
                      started.count()};
    for (int i = 0; i < searches; ++i)
      by.expected.emplace_back(name_of(static_cast<search>(i)), r.expected.of[i]);
    return {std::move(r), std::move(by)};
  } catch (const device_error &e) {
    throw failure(e.what(), no_device);
  }
}
#else
device_pairs pairs_on_device(const prepared &, const prepared &, const predicate_info &, rung,
                             const collide_options &) {
  throw failure("this build has no CUDA kernels", no_device);
}
#endif

} // namespace meetc::app
