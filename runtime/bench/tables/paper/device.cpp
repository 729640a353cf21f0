#include "bench/tables/paper/device.hpp"

#include "app/device_pairs.hpp"
#include "app/failure.hpp"
#include "app/sets.hpp"
#include "io/error.hpp"

#include <fmt/format.h>

#if MEETC_WITH_CUDA
#include "bench/harness/measure.hpp"
#include "cga/cga_cuda.hpp"
#include "cga/cga_every_pair.hpp"
#include "core/device/collide.hpp"
#include "core/device/every_pair/engine.hpp"

#include <chrono>
#endif

namespace meetc::bench {

#if MEETC_WITH_CUDA

namespace {

class cuda_bench_device final : public bench_device {
public:
  cuda_bench_device() : on_(cga::cuda::catalogue()), every_pair_(on_, cga::every_pair::catalogue()) {}
  std::string name() const override { return on_.facts().name; }

  device_time time(const device_job &job, int runs) override {
    try {
      const io::element_set &first = job.by.swapped ? job.b : job.a, &second = job.by.swapped ? job.a : job.b;
      const prepared a = app::prepare(first), b = app::prepare(second);
      device_set on_a(on_, a), on_b(on_, b);
      struct counted {
        std::uint64_t pairs;
        double device_seconds;
      };
      const auto count = [&](device_set &x, device_set &y) -> counted {
        if (job.brute_force) {
          const every_pair::outcome r =
              every_pair_.collide(x, y, *job.by.predicate, job.precision, {.want = answer_kind::count});
          return {r.count, r.device_seconds};
        }
        device_options o;
        o.want = answer_kind::count;
        const device_result r = meetc::collide(on_, x, y, *job.by.predicate, job.precision, o);
        return {r.count, r.device_seconds};
      };
      device_time out;
      std::vector<double> alone, whole;
      for (int i = 0; i <= runs; ++i) {
        const counted r = count(on_a, on_b);
        const auto start = std::chrono::steady_clock::now();
        device_set fresh_a(on_, a), fresh_b(on_, b);
        out.pairs = count(fresh_a, fresh_b).pairs;
        const std::chrono::duration<double> with = std::chrono::steady_clock::now() - start;
        if (i > 0)
          alone.push_back(r.device_seconds), whole.push_back(with.count());
      }
      out.seconds = median(alone);
      out.seconds_with_transfers = median(whole);
      return out;
    } catch (const device_error &e) {
      throw app::failure(e.what(), app::no_device);
    }
  }

private:
  device on_;
  every_pair::engine every_pair_;
};

} // namespace

std::unique_ptr<bench_device> open_bench_device() {
  try {
    return std::make_unique<cuda_bench_device>();
  } catch (const device_error &) {
    return nullptr;
  }
}

#else

std::unique_ptr<bench_device> open_bench_device() {
  return nullptr;
}

#endif

std::unique_ptr<bench_device> bench_device_named(const std::string &name) {
  if (app::processor_named(name) == app::processor::cuda) {
#if MEETC_WITH_CUDA
    try {
      return std::make_unique<cuda_bench_device>();
    } catch (const device_error &e) {
      throw app::failure(e.what(), app::no_device);
    }
#endif
  }
  return name == "auto" ? open_bench_device() : nullptr;
}

} // namespace meetc::bench
