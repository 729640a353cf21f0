// bench/tables/device.hpp: the questions of the paper's tables and of `meet trade` to a device.
#ifndef MEETC_BENCH_TABLES_DEVICE_HPP
#define MEETC_BENCH_TABLES_DEVICE_HPP

#include "meet/app/query/choose.hpp"
#include "meet/bench/tables/trade_point.hpp"
#include "meet/bench/truth/near_pairs.hpp"
#include "meet/core/query/collide.hpp"
#include "meet/io/elements/element_set.hpp"

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace meetc::bench {

// Two sets in the user's order; `by` says which is the predicate's first. The same set twice gives every ordered pair, i = j
// included.
struct device_job {
  const io::element_set &a, &b;
  choice by;
};

struct device_time {
  double seconds = 0;                // with the sets on the device, where the count stays
  double seconds_with_transfers = 0; // from sets in the host's memory to the count in the host's memory
  std::uint64_t pairs = 0;
};

// Times are medians, after a run that does not count, and on the device by its events. All throw failure with app::no_device
// where the device fails.
class bench_device {
public:
  virtual ~bench_device() = default;
  virtual std::string name() const = 0;
  // Counts the touching pairs of the sets' elements, certified, by looking at every pair, as in the paper.
  virtual device_time time_every_pair(const device_job &job, int runs) = 0;
  // Plain fp32 and certified on a list of the pairs that is long enough to fill the device; and, for two balls, the fp16
  // filter alone, which looks at all pairs of some of the elements and calls a hit what it does not rule out.
  virtual std::vector<trade_point> measure(const element_pairs &pairs, int repetitions) = 0;
  // A whole query with the list of pairs, on sets that are on the device; seconds are its.
  virtual result query(const prepared &a, const prepared &b, const predicate_info &p, rung precision,
                       int repetitions) = 0;
};

// The device for --device: null for "cpu", a device or failure with app::no_device for "cuda", a device or null for
// "auto".
std::unique_ptr<bench_device> bench_device_named(const std::string &name);

} // namespace meetc::bench

#endif
