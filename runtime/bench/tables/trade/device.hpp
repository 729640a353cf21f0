// bench/tables/trade/device.hpp: the pairs of `meet trade` on a device: what its rungs cost there, and its filter alone.
#ifndef MEETC_BENCH_TABLES_TRADE_DEVICE_HPP
#define MEETC_BENCH_TABLES_TRADE_DEVICE_HPP

#include "bench/tables/trade/measure.hpp"
#include "core/collide.hpp"

#include <memory>
#include <string>
#include <vector>

namespace meetc::bench {

class trade_device {
public:
  virtual ~trade_device() = default;
  virtual std::string name() const = 0;
  // Plain fp32 and certified on a list of the pairs that is long enough to fill the device; and, for two balls, the fp16
  // filter alone, which looks at all pairs of some of the elements and calls a hit what it does not rule out. Times are
  // medians by events. Throws failure with app::no_device where the device fails.
  virtual std::vector<trade_point> measure(const element_pairs &pairs, int repetitions) = 0;
  // A whole query with the list of pairs, on sets that are on the device; seconds are a median by events.
  virtual result query(const prepared &a, const prepared &b, const predicate_info &p, rung precision,
                       int repetitions) = 0;
};

// The device for --device: null for "cpu", a device or failure with app::no_device for "cuda", a device or null for
// "auto".
std::unique_ptr<trade_device> trade_device_named(const std::string &name);

} // namespace meetc::bench

#endif
