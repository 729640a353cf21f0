// app/query/device_pairs.hpp: the choice of a processor, and the pairs of two sets on the CUDA device, which orders them too.
#ifndef MEETC_APP_QUERY_DEVICE_PAIRS_HPP
#define MEETC_APP_QUERY_DEVICE_PAIRS_HPP

#include "meet/core/hierarchy/box.hpp"
#include "meet/core/query/collide.hpp"
#include "meet/io/elements/element_set.hpp"

#include <string>
#include <string_view>

namespace meetc::app {

enum class processor : std::uint8_t { cpu, cuda, best };

// "auto" is the best. Throws failure for an unknown name, and for "cuda" if this build has no CUDA kernels.
processor processor_named(std::string_view name);

// The expected seconds of a query on so many elements as they were read. A device's include its start and the
// transfers.
struct expected_seconds {
  double cpu, cuda;
};
expected_seconds expected_on(std::size_t elements, int threads);
// Whether this build has a device's kernels and they are expected to be the faster ones.
bool device_expected(std::size_t elements, int threads);

// The device's own report on its answer.
struct device_account {
  std::string device;        // "NVIDIA H200"
  int devices = 1;           // between which the query was cut; the members below are of the first, or of the slowest
  double device_seconds = 0; // for the kernels alone
  double start_seconds = 0;  // until the device was ready
};
struct device_pairs {
  result found;
  device_account account;
  box around_a{}, around_b{}; // all elements of a set; lo > hi where there are none
  double prepare_seconds = 0; // to upload the sets, and to check and order them there
};

// Both sets are rounded to `grid` (pose::grid). The query is cut between the first `devices` of CUDA, but for a set with
// itself, which one device answers sooner. Throws failure, with exit code no_device, where there are not as many, where one
// fails, or where it lacks the memory, and input_error where a rounded number leaves float32.
device_pairs pairs_on_device(const io::element_set &a, const io::element_set &b, const predicate_info &predicate,
                             rung precision, double grid, int devices, const collide_options &options);

} // namespace meetc::app

#endif
