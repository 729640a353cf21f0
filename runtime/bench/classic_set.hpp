// bench/classic_set.hpp: a set in the forms that the classic tests read, and with what a predicate stores.
#ifndef MEETC_BENCH_CLASSIC_SET_HPP
#define MEETC_BENCH_CLASSIC_SET_HPP

#include "bench/classic_tests.hpp"
#include "core/memory.hpp"
#include "io/element_set.hpp"

#include <cstdint>
#include <vector>

namespace meetc::bench {

class classic_set {
public:
  // The elements of a set of triangles or balls, in this order; null: as they are given.
  explicit classic_set(const io::element_set &set, const std::uint32_t *order = nullptr);
  std::size_t count() const { return count_; }
  std::size_t fields() const { return fields_; }
  const float *rows() const { return rows_.data(); }
  baselines::classic_rows for_classic() const { return {rows_.data(), planes_.data(), columns(), stride_}; }

private:
  float *columns() const { return static_cast<float *>(columns_.get()); }

  std::size_t count_, fields_, stride_;
  std::vector<float> rows_, planes_;
  owned_memory columns_; // on a cache line, as what our own filter reads
};

// What a predicate stores for the rows; empty where it stores nothing.
std::vector<float> stored_for(const stored_values &values, const classic_set &set);

} // namespace meetc::bench

#endif
