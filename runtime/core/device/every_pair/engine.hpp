// core/device/every_pair/engine.hpp: every pair of two sets, on a CUDA device, as a product of matrices.
//
// This is brute force: its cost is the product of the sets, and no hierarchy is walked. An element's enclosing ball becomes
// a few columns of numbers, the signs of a product of these matrices say which balls may touch
// (meetc/every_pair/matrix.hpp), and what is left is decided by the steps of any query. The answers are those of
// core/query/collide.hpp. To collide sets is what a query is for (core/device/collide.hpp), whose cost is their sum; this
// engine is to measure the meet as it was once computed, and to judge.
//
// The two filters on matrix units rest on an assumption about these, which the probe can refute; the float32 filter, their
// judge, and every other part rest on IEEE arithmetic alone.
#ifndef MEETC_CORE_DEVICE_EVERY_PAIR_ENGINE_HPP
#define MEETC_CORE_DEVICE_EVERY_PAIR_ENGINE_HPP

#include "meet/core/answers/answers.hpp"
#include "meet/core/device/set/device_set.hpp"
#include "meetc/every_pair/table.hpp"

#include <optional>

namespace meetc::every_pair {

struct options {
  answer_kind want = answer_kind::pairs;            // or count
  std::optional<filter> by = {};                    // empty: the fastest that the device offers
  std::optional<cover> balls = {};                  // empty: around boxes for the plain rungs, else around elements
  std::size_t list_capacity = std::size_t{1} << 25; // pairs in a list, at least 2^12
};

struct outcome : result { // candidates: the pairs that the filter passes and whose boxes touch
  filter by = filter::float32;
  std::uint64_t near = 0;  // pairs that the filter passed
  std::uint64_t parts = 0; // parts of the product that were run
  // From the first kernel to the last, with the allocations between them; without uploading sets, and without downloading
  // pairs.
  double device_seconds = 0;
};

// The engine of one device. It runs one query at a time, and none while collide() runs one there: threads wait for each
// other. The columns of the last two sets stay, and are not computed again unless these have moved.
class engine {
public:
  // The kernels are of the namespace of on.kernels().
  engine(const device &on, const catalogue &kernels) : on_(on), kernels_(kernels) {}

  // The probe of the matrix units, which runs when it is first asked for. Throws device_error, as all below.
  const probe_result &probe();
  bool offers(filter f);
  // The fastest filter whose model the probe did not refute.
  filter best_filter();

  // Elements are their own items. Throws usage_error also for `tolerant`, which presumes of the sets what nothing
  // here looks at, for other answers, and for a filter that the device does not offer.
  outcome collide(device_set &a, device_set &b, const predicate_info &predicate, rung precision,
                  const options &how = {});

  // The filter alone: enqueues, on the device's stream, to append the pairs of slots whose enclosing balls may touch. Once
  // the list is full it stops early.
  void list_near(filter by, cover balls, device_set &a, device_set &b, const cuda::pair_list &out);

private:
  struct made { // describes the contents of columns
    bool floats = false;
    cover of = cover::element;
    std::uint64_t frame = 0, own = 0; // versions
    bool operator==(const made &) const = default;
  };
  struct columns_of_set {
    device_memory<std::byte> memory;
    made have;
  };
  struct two_operands {
    operand x, y;
  };

  const set_launchers &launchers_of(const kind_info &kind) const;
  const extent *around(const device_rows &frame);
  two_operands operands(filter by, cover balls, const device_rows &a, const device_rows &b);
  operand columns(filter by, cover balls, bool first, const device_rows &of, const device_rows &frame);

  device on_;
  const catalogue &kernels_;
  probe_result probe_{}; // no cases: it has not run
  device_memory<extent> around_;
  std::uint64_t around_of_ = 0; // of this version
  columns_of_set columns_[2];   // of Y, of X
};

} // namespace meetc::every_pair

#endif
