// bench/tables/paper/device.hpp: the interface between benchmarks and a device.
#ifndef MEETC_BENCH_TABLES_PAPER_DEVICE_HPP
#define MEETC_BENCH_TABLES_PAPER_DEVICE_HPP

#include "app/choose.hpp"
#include "io/element_set.hpp"

#include <cstdint>
#include <memory>
#include <string>

namespace meetc::bench {

// Counts the touching pairs of the sets' elements. The sets are in the user's order; `by` says which is the predicate's
// first. The same set twice gives every ordered pair, i = j included.
struct device_job {
  const io::element_set &a, &b;
  app::choice by;
  rung precision = rung::certified;
  bool brute_force = true; // every pair is decided or filtered, as in the paper, without a hierarchy
};

struct device_time {
  double seconds = 0;                // with the sets on the device, where the count stays
  double seconds_with_transfers = 0; // from sets in the host's memory to the count in the host's memory
  std::uint64_t pairs = 0;
};

class bench_device {
public:
  virtual ~bench_device() = default;
  virtual std::string name() const = 0;
  // The median of `runs` runs, after one that does not count. Throws failure with no_device where the device fails.
  virtual device_time time(const device_job &job, int runs) = 0;
};

// Null where there is none that this build can use.
std::unique_ptr<bench_device> open_bench_device();

// The device for --device: null for "cpu", a device or failure with app::no_device for "cuda", a device or null for
// "auto".
std::unique_ptr<bench_device> bench_device_named(const std::string &name);

} // namespace meetc::bench

#endif
