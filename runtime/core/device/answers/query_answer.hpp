// core/device/answers/query_answer.hpp: the interface between a query on a device and what it answers.
//
// It is that of the CPU (core/answers/query_answer.hpp) in a device's memory: a query yields lists of hits, and each answer
// takes from them what it needs. The query knows none of the answers, and an answer does not know how hits are found.
#ifndef MEETC_CORE_DEVICE_ANSWERS_QUERY_ANSWER_HPP
#define MEETC_CORE_DEVICE_ANSWERS_QUERY_ANSWER_HPP

#include "meet/core/device/answers/device_result.hpp"
#include "meet/core/device/set/rows.hpp"

namespace meetc::on_device {

// The sets whose rows the query reads.
struct queried_sets {
  const device &on;
  const device_rows &a, &b;
};

// The hits of a part of the query, in device memory: pairs of slots in any order.
struct part_hits {
  const index_pair *pairs;
  std::size_t n;
  bool whole; // the part is the whole query, and take_early() has had its hits
};

// All members enqueue their work on the device's stream and throw device_error.
class query_answer {
public:
  virtual ~query_answer() = default;

  // Called once, before the first part.
  virtual void start(const queried_sets &sets) = 0;
  // Called behind the kernels of a part that is the whole query, before the host knows how many hits there are. If they do not
  // fit into the list, none of them is taken, and parts follow.
  virtual void take_early(const cuda::pair_list &) {}
  // If needs_pairs() is false, only n means something.
  virtual void take(const part_hits &hits) = 0;
  // Called once, after the last part: enqueues the rest of its work there.
  virtual void finish() {}
  // Called once, at the end: waits, and fills its part of the result.
  virtual void download(device_result &r) = 0;

  // Whether it needs the hits, or only their number, which each query counts.
  virtual bool needs_pairs() const { return true; }
  // Whether it may be done before the last hit. A query whose answers all are done stops.
  virtual bool stops_early() const { return false; }
  virtual bool done() const { return false; }
};

} // namespace meetc::on_device

#endif
