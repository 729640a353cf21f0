// Keys of 64 bits are put into order by the blocks of one kernel, between whose steps these meet. Included by nvcc only.
//
// Problem: a device carries out far fewer scattered additions and writes than it moves numbers side by side, so that to bring
// each key to its place by itself takes longer than all else. Method: the first bits of a key name its cell. A block counts
// its keys by cells, and learns by one addition for each cell how many of other blocks come before its own. It puts tiles of
// them into the order of the cells in its own memory, and brings neighbours to their cells together. Then a block takes a
// window of the order that it is asked for: it looks at the keys of the cells there, of which finer cells say which lie in
// the window, and puts these into order.
// It saves the kernels of a sort by digits, one for each digit, and the count of keys on the host that such a sort needs.
// Limits: keys differ from each other. There is no order where too many are alike in their first bits: those of a cell, those
// of a finer cell, or those of a window and of the finer cells that reach into it.
#ifndef MEETC_CUDA_DISTRIBUTE_HPP
#define MEETC_CUDA_DISTRIBUTE_HPP

#include <meetc/cuda/grid.hpp>
#include <meetc/cuda/table.hpp>

#include <cstdint>

namespace meetc::cuda {

// Keys of a tile, or of a window with its surroundings; those of a window alone; and cells.
inline constexpr unsigned most_of_tile = 8192, most_of_window = most_of_tile / 2, most_cells = counted_to_distribute;
// Keys of the cells of a window, and those that share a finer cell.
inline constexpr unsigned most_near_window = 1U << 18, most_alike = 2048;

// The shared memory of a block.
template <unsigned Threads> struct distribute_room {
  static constexpr unsigned window_cells = most_of_tile / 2; // finer ones
  static_assert(window_cells >= 2 * most_cells);
  std::uint64_t keys[most_of_tile];
  std::uint32_t counters[window_cells]; // right behind the keys; of cells, and where keys go; or of finer cells
  std::uint32_t starts[most_cells + 1]; // where each cell begins, and the end
  unsigned sums[Threads / 32];
  std::uint32_t first, last, begin, end; // of a window
};

// One block of so many, whose threads all call its functions. Where it is alone, it need not meet: in each function its threads
// meet between what they write and what the next function reads.
template <unsigned Threads> class distributing {
public:
  using room = distribute_room<Threads>;

  // Keys are below 2^key_bits, and some only are in use where `sparse`, which then has more cells.
  __device__ distributing(const distribution &d, int key_bits, bool sparse, unsigned block, unsigned blocks, room &r)
      : d_(d), room_(r), block_(block), blocks_(blocks) {
    tiles_ = (d.n - 1) / (blocks * most_of_tile) + 1;
    tile_ = ((d.n - 1) / (blocks * tiles_) + 32) / 32 * 32;
    const int wanted = 29 - __clz(tile_) + (sparse ? 2 : 0); // some keys of a tile to a cell
    const int bits = min(min(max(wanted, 1), 11), key_bits);
    static_assert(most_cells == 1U << 11);
    cells_ = 1U << bits, shift_ = key_bits - bits;
  }

  // Keys, and how many each cell has. `take(i, there, key)` makes the keys i[k] where there[k]; the lanes of a warp have
  // neighbours, and a warp calls it as a whole.
  template <unsigned Together, class Take> __device__ void count(Take &&take) {
    zero(cells_);
    __syncthreads();
    for (unsigned t = 0; t < tiles_; ++t) {
      const std::uint32_t end = end_of(t);
      for (std::uint32_t first = begin_of(t) + threadIdx.x; first - threadIdx.x % 32 < end;
           first += Together * Threads) {
        std::uint32_t i[Together];
        bool there[Together];
        std::uint64_t key[Together];
#pragma unroll
        for (unsigned k = 0; k < Together; ++k)
          i[k] = first + k * Threads, there[k] = i[k] < end;
        take(i, there, key);
#pragma unroll
        for (unsigned k = 0; k < Together; ++k)
          if (there[k]) {
            d_.keys[i[k]] = key[k];
            atomicAdd(room_.counters + cell(key[k]), 1U);
          }
      }
    }
    __syncthreads();
    for (unsigned c = threadIdx.x; c < cells_; c += Threads) {
      const std::uint32_t n = room_.counters[c];
      to()[c] = n > 0 ? atomicAdd(d_.counted + c, n) : 0;
    }
  }

  // Keys by their cells, once blocks have met after count().
  __device__ void distribute() {
    std::uint64_t keys[each];
    load(0, keys);
    for (unsigned c = threadIdx.x; c < cells_; c += Threads)
      room_.starts[c] = __ldcg(d_.counted + c);
    __syncthreads();
    scan(room_.starts, cells_);
    if (threadIdx.x == 0)
      room_.starts[cells_] = d_.n;
    for (unsigned c = threadIdx.x; c < cells_; c += Threads)
      to()[c] += room_.starts[c];
    for (unsigned t = 0; t < tiles_; ++t)
      distribute_tile(t, keys);
  }

  // Once blocks have met after distribute(), nobody counts any more.
  __device__ void clear() const {
    for (unsigned c = block_ * Threads + threadIdx.x; c < cells_; c += blocks_ * Threads)
      d_.counted[c] = 0;
  }

  // The keys from place `first` to before `last` of the order become the first of room.keys, at most a tile. Returns false
  // where they cannot be put into order; all threads get the same.
  __device__ bool window(std::uint32_t first, std::uint32_t last) {
    if (!take_near(first, last))
      return false;
    std::uint64_t mine[each];
    std::uint32_t place[each];
    bool alike = false;
#pragma unroll
    for (unsigned k = 0; k < each; ++k) {
      place[k] = ~std::uint32_t{0};
      if (k * Threads >= near_.n)
        continue;
      const std::uint32_t i = threadIdx.x + k * Threads;
      if (i >= near_.n)
        continue;
      mine[k] = room_.keys[i];
      alike |= !place_of(mine[k], first, place[k]);
    }
    if (__syncthreads_or(alike))
      return false;
#pragma unroll
    for (unsigned k = 0; k < each; ++k)
      if (k * Threads < near_.n && place[k] < last - first)
        room_.keys[place[k]] = mine[k];
    __syncthreads();
    return true;
  }

  // This block's share of all keys, in windows as large as the blocks have work: write(place, key). Where false is returned,
  // some cannot be put into order.
  template <class Write> __device__ bool each_in_order(Write &&write) {
    bool ordered = true;
    const std::uint32_t size = min(max((d_.n - 1) / blocks_ + 1, 256U), most_of_window);
    for (std::uint32_t w = block_; w <= (d_.n - 1) / size; w += blocks_) {
      const std::uint32_t first = w * size, length = min(d_.n - first, size);
      if (!window(first, first + length)) {
        ordered = false;
        continue;
      }
      for (std::uint32_t i = threadIdx.x; i < length; i += Threads)
        write(first + i, room_.keys[i]);
    }
    return ordered;
  }

private:
  static constexpr unsigned each = most_of_tile / Threads; // keys of a thread

  // The cells of a window, and the finer cells that reach into it.
  struct near_window {
    std::uint32_t begin;       // the place of the cells' first key
    int together;              // a finer cell is that of 2^together keys
    std::uint32_t from, n;     // the place of the finer cells' first key, and how many they have
    std::uint32_t first, last; // finer cells
  };

  // The keys of the finer cells that reach into a window become the first of room.keys, by these cells, whose counters say
  // where they end. Returns false where there are too many.
  __device__ bool take_near(std::uint32_t first, std::uint32_t last) {
    __syncthreads(); // of an earlier window nobody reads any more
    for (unsigned c = threadIdx.x; c < cells_; c += Threads) {
      const std::uint32_t begin = room_.starts[c], end = room_.starts[c + 1];
      if (begin <= first && first < end)
        room_.first = c;
      if (begin < last && last <= end)
        room_.last = c;
    }
    __syncthreads();
    const std::uint32_t low = room_.first, end = room_.starts[room_.last + 1];
    near_.begin = room_.starts[low];
    if (end - near_.begin > most_near_window)
      return false;
    // As many finer cells as keys, up to window_cells: each cell is cut into as many as it has keys.
    const unsigned keys = end - near_.begin;
    near_.together = 0;
    while ((keys - 1) >> near_.together >= room::window_cells)
      ++near_.together;
    const unsigned fine_cells = ((keys - 1) >> near_.together) + 1;
    zero(fine_cells);
    __syncthreads();
    each_near(near_.begin, end, [&](std::uint64_t key) { atomicAdd(room_.counters + fine(key), 1U); });
    __syncthreads();
    scan(room_.counters, fine_cells);
    // The finer cells that reach into the window, and the places from the first one's on.
    for (unsigned c = threadIdx.x; c < fine_cells; c += Threads) {
      const std::uint32_t from = room_.counters[c] + near_.begin,
                          to = c + 1 < fine_cells ? room_.counters[c + 1] + near_.begin : end;
      if (from <= first && first < to)
        room_.first = c, room_.begin = from;
      if (from < last && last <= to)
        room_.last = c, room_.end = to;
    }
    __syncthreads();
    near_.from = room_.begin, near_.n = room_.end - near_.from;
    near_.first = room_.first, near_.last = room_.last;
    if (near_.n > most_of_tile)
      return false;
    each_near(near_.begin, end, [&](std::uint64_t key) {
      if (const std::uint32_t c = fine(key); near_.first <= c && c <= near_.last)
        room_.keys[atomicAdd(room_.counters + c, 1U) + near_.begin - near_.from] =
            key; // after that the counter says where the cell ends
    });
    __syncthreads();
    return true;
  }
  __device__ std::uint32_t fine(std::uint64_t key) const {
    const std::uint32_t c = cell(key), from = room_.starts[c],
                        within = static_cast<std::uint32_t>(shift_ >= 32 ? key >> (shift_ - 32) : key << (32 - shift_));
    return (from - near_.begin + __umulhi(within, room_.starts[c + 1] - from)) >> near_.together;
  }
  // The place of a key, less `first`; of one before the window it is above all. Returns false where too many share its finer
  // cell; the place then means nothing.
  __device__ bool place_of(std::uint64_t key, std::uint32_t first, std::uint32_t &place) const {
    const std::uint32_t c = fine(key), begin = c > near_.first ? room_.counters[c - 1] + near_.begin - near_.from : 0,
                        end = room_.counters[c] + near_.begin - near_.from;
    place = ~std::uint32_t{0};
    if (end - begin > most_alike)
      return false;
    place = begin + near_.from - first;
    for (std::uint32_t other = begin; other < end; ++other)
      place += room_.keys[other] < key;
    return true;
  }

  __device__ std::uint32_t begin_of(unsigned t) const {
    const std::uint64_t begin = (t * std::uint64_t{blocks_} + block_) * tile_;
    return begin < d_.n ? static_cast<std::uint32_t>(begin) : d_.n;
  }
  __device__ std::uint32_t end_of(unsigned t) const {
    return min(d_.n - begin_of(t), tile_) + begin_of(t);
  }
  __device__ std::uint32_t cell(std::uint64_t key) const {
    return static_cast<std::uint32_t>(key >> shift_);
  }
  __device__ void zero(unsigned n) {
    for (unsigned c = threadIdx.x; c < n; c += Threads)
      room_.counters[c] = 0;
  }
  // n numbers that all threads see become the sums of those before each, which all threads see.
  __device__ void scan(std::uint32_t *numbers, unsigned n) {
    const unsigned of_thread = (n + Threads - 1) / Threads, from = min(threadIdx.x * of_thread, n),
                   to = min(from + of_thread, n);
    unsigned mine = 0, all = 0;
    for (unsigned i = from; i < to; ++i)
      mine += numbers[i];
    unsigned before = sum_before<Threads>(mine, room_.sums, all);
    for (unsigned i = from; i < to; ++i) {
      const unsigned x = numbers[i];
      numbers[i] = before;
      before += x;
    }
    __syncthreads();
  }

  // Where the keys of each cell go: behind the counters.
  __device__ std::uint32_t *to() const {
    return room_.counters + most_cells;
  }

  // The keys of a tile, of which each thread has some.
  __device__ void load(unsigned t, std::uint64_t (&keys)[each]) const {
    const std::uint32_t begin = begin_of(t), end = end_of(t);
#pragma unroll
    for (unsigned k = 0; k < each; ++k)
      if (const std::uint32_t i = begin + k * Threads + threadIdx.x; i < end)
        keys[k] = d_.keys[i];
  }
  // Its keys become those of the next tile, which are on their way while these are written.
  __device__ void distribute_tile(unsigned t, std::uint64_t (&keys)[each]) {
    const std::uint32_t begin = begin_of(t), end = end_of(t);
    const auto each_key = [&](auto &&take) {
#pragma unroll
      for (unsigned k = 0; k < each; ++k)
        if (begin + k * Threads + threadIdx.x < end)
          take(keys[k]);
    };
    if (tiles_ > 1) { // or the counters are those of count()
      zero(cells_);
      __syncthreads();
      each_key([&](std::uint64_t key) { atomicAdd(room_.counters + cell(key), 1U); });
      __syncthreads();
    }
    scan(room_.counters, cells_);
    // Less the place in the tile; behind that the next tile's go.
    for (unsigned c = threadIdx.x; c < cells_; c += Threads)
      to()[c] -= room_.counters[c];
    __syncthreads();
    each_key([&](std::uint64_t key) { room_.keys[atomicAdd(room_.counters + cell(key), 1U)] = key; });
    if (t + 1 < tiles_)
      load(t + 1, keys);
    __syncthreads();
    for (std::uint32_t i = threadIdx.x; i < end - begin; i += Threads) {
      const std::uint64_t key = room_.keys[i];
      d_.by_cell[to()[cell(key)] + i] = key;
    }
    __syncthreads();
    for (unsigned c = threadIdx.x; c < cells_; c += Threads)
      to()[c] += room_.counters[c]; // which says now where the cell ends in the tile
  }

  // Some keys that are by their cells, of which a thread has two on their way at once.
  template <class Take> __device__ void each_near(std::uint32_t begin, std::uint32_t end, Take &&take) const {
    constexpr unsigned together = 2;
    for (std::uint32_t i = begin + threadIdx.x; i < end; i += together * Threads) {
      std::uint64_t key[together];
#pragma unroll
      for (unsigned k = 0; k < together; ++k)
        if (i + k * Threads < end)
          key[k] = d_.by_cell[i + k * Threads];
#pragma unroll
      for (unsigned k = 0; k < together; ++k)
        if (i + k * Threads < end)
          take(key[k]);
    }
  }

  const distribution &d_;
  room &room_;
  const unsigned block_, blocks_;
  unsigned tiles_; // of this block
  std::uint32_t tile_, cells_;
  int shift_;
  near_window near_{}; // the same in all threads
};

} // namespace meetc::cuda

#endif
