// The shared memory of a block that distributes keys (cuda/distribute.hpp).
#ifndef MEETC_CUDA_DISTRIBUTE_ROOM_HPP
#define MEETC_CUDA_DISTRIBUTE_ROOM_HPP

#include <meetc/cuda/table.hpp>

#include <cstdint>

namespace meetc::cuda {

// Keys of a tile or of a window with its surroundings, where nothing else is said, and cells.
inline constexpr unsigned most_of_tile = 8192, most_cells = 2048;
// Keys of the cells of a window, and those that share a finer cell.
inline constexpr unsigned most_near_window = 1U << 18, most_alike = 2048;

static_assert(counted_to_distribute == most_cells);

// The shared memory of a block.
template <unsigned Threads, unsigned Tile = most_of_tile> struct distribute_room {
  static constexpr unsigned window_cells = Tile / 2; // finer cells of a window
  static_assert(window_cells >= 2 * most_cells);
  std::uint64_t keys[Tile];
  std::uint32_t counters[window_cells]; // right behind the keys; of cells, and where keys go; or of finer cells
  std::uint32_t starts[most_cells + 1]; // where each cell begins, and the end
  unsigned sums[Threads / 32];
  std::uint32_t first, last, begin, end; // of a window
};

} // namespace meetc::cuda

#endif
