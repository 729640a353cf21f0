// bench/device.hpp: what a benchmark asks of a device. Benchmarks know no more of it than this.
#ifndef MEETC_BENCH_DEVICE_HPP
#define MEETC_BENCH_DEVICE_HPP

#include "app/choose.hpp"
#include "io/element_set.hpp"

#include <cstdint>
#include <memory>
#include <string>

namespace meetc::bench {

// Counts the touching pairs of the sets' elements. Both are in the order of the user, `by` says which is the
// predicate's first. The same set twice gives every ordered pair, i = j included.
struct device_job {
  const io::element_set &a, &b;
  app::choice by;
  rung precision = rung::certified;
  bool brute_force = true; // every pair is decided or filtered, as the paper does it; no hierarchy is walked
};

struct device_time {
  double seconds = 0;                // the sets lie on the device, the count stays there
  double seconds_with_transfers = 0; // from the host's memory to the count in it
  std::uint64_t pairs = 0;
};

class bench_device {
public:
  virtual ~bench_device() = default;
  virtual std::string name() const = 0;
  // The median of so many runs, after one that is not counted. Throws failure with no_device where the device
  // fails.
  virtual device_time time(const device_job &job, int runs) = 0;
};

// Null where there is none that this build can use.
std::unique_ptr<bench_device> open_bench_device();

// For --device: "cpu" gives null, "cuda" a device or failure with app::no_device, "auto" what there is.
std::unique_ptr<bench_device> bench_device_named(const std::string &name);

} // namespace meetc::bench

#endif
