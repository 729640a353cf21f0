// core/device/memory/buffers.hpp: what queries on one device share, so that only the first allocates memory.
#ifndef MEETC_CORE_DEVICE_MEMORY_BUFFERS_HPP
#define MEETC_CORE_DEVICE_MEMORY_BUFFERS_HPP

#include "meet/core/device/memory/memory.hpp"
#include "meet/core/device/memory/transfers.hpp"

#include <cstdint>
#include <span>

namespace meetc {

// The counters of a query: its lists, the items of a walk that warps have taken, and whether its hits are in no order. Then
// those of a mesh with itself: pairs with no common corner, one, two and three, and what the steps for one and two count.
enum class counter : std::uint8_t {
  candidates,
  kept,
  touching,
  hits,
  unsure_fp32,
  unsure_fp64,
  unsure_fp64x2, // right after unsure_fp64, as certify_rest needs it
  taken,
  unordered,
  apart,
  one_common,
  one_kept,
  one_unsure_fp32,
  one_unsure_fp64,
  one_unsure_fp64x2,
  two_common,
  two_kept,
  two_unsure_fp32,
  two_unsure_fp64,
  two_unsure_fp64x2,
  three_common
};
inline constexpr int counters = 21;

// The notes of a query on the device: one piece, which the host reads at once.
struct query_notes {
  cuda::order_findings found[2]; // of the sets that it has ordered
  unsigned long long counts[counters];
};
// The notes of culling in device memory, all 0 at first. Set 0 is the one that marks first.
struct cull_findings {
  cuda::joined_box around[2];
  unsigned kept[3]; // of set 0, of set 1, and of set 0 by the marks of set 1
  unsigned arrived; // blocks of the last kernel
  unsigned long long bad[2];
};

// The notes that it reads, in host memory that the device can write to.
struct host_notes {
  query_notes of_query;
  cull_findings culled;
  std::uint32_t culled_there; // whether they are
};

struct device_buffers {
  device_memory<index_pair> first, second, hits; // first and second alternate for candidates and unsure pairs
  device_memory<query_notes> notes;              // one
  device_memory<std::uint32_t> to_order;         // as hit_order counts
  device_memory<std::uint64_t> keys, more_keys;  // hits as sortable numbers
  device_memory<std::byte> sort_space;
  device_memory<std::uint32_t> first_slots, first_numbers; // what is met first
  transfers moving;
  cudaStream_t stream = nullptr; // of all queries
  cudaStream_t beside = nullptr; // for work on one set while the query's stream works on the other
  cudaEvent_t forked = nullptr, joined = nullptr;
  cudaEvent_t clock[2] = {nullptr, nullptr};
  host_notes *seen = nullptr;
  device_memory<std::byte> cull_space;

  // In device memory.
  cuda::order_findings *found() const { return notes.data()->found; }
  unsigned long long *count_of(counter c) const { return notes.data()->counts + static_cast<int>(c); }
  std::span<unsigned long long> counts() const { return notes.data()->counts; }
  // On the host, since read_notes().
  unsigned long long seen_of(counter c) const { return seen->of_query.counts[static_cast<int>(c)]; }

  // These enqueue, and throw device_error.
  void clear_counts() const {
    check(cudaMemsetAsync(counts().data(), 0, counts().size_bytes(), stream), "clearing counters");
  }
  void start_clock() const { check(cudaEventRecord(clock[0], stream), "starting a clock"); }
  void mark_clock() const { check(cudaEventRecord(clock[1], stream), "stopping a clock"); } // the last mark counts
  // Work on `beside` between the two is that of one set, while the stream works on the other.
  void fork() const { follow(stream, forked, beside); }
  void join() const { follow(beside, joined, stream); }
  // Waits for the stream.
  void read_notes(const char *what) const {
    check(cudaMemcpyAsync(&seen->of_query, notes.data(), sizeof(query_notes), cudaMemcpyDeviceToHost, stream), what);
    check(cudaStreamSynchronize(stream), what);
  }
  // Seconds on the clock, once its mark is reached.
  double clocked() const {
    float ms = 0;
    check(cudaEventSynchronize(clock[1]), "waiting for the device");
    check(cudaEventElapsedTime(&ms, clock[0], clock[1]), "reading a clock");
    return static_cast<double>(ms) / 1000;
  }

  // Apart from the constructor, so that what was created is destroyed where the next cannot be. Throws device_error.
  void create() {
    check(cudaStreamCreateWithFlags(&stream, cudaStreamNonBlocking), "making a stream");
    for (cudaEvent_t &e : clock)
      check(cudaEventCreate(&e), "making an event");
    for (cudaEvent_t *const e : {&forked, &joined})
      check(cudaEventCreateWithFlags(e, cudaEventDisableTiming), "making an event");
    check(cudaStreamCreateWithFlags(&beside, cudaStreamNonBlocking), "making a stream");
    check(cudaMallocHost(reinterpret_cast<void **>(&seen), sizeof *seen), "allocating host memory");
    notes.reserve(1, "counters"), to_order.reserve(cuda::counted_to_distribute, "counters");
    check(cudaMemsetAsync(notes.data(), 0, sizeof(query_notes), stream), "clearing counters"); // all are read, always
    check(cudaMemsetAsync(to_order.data(), 0, cuda::counted_to_distribute * sizeof(std::uint32_t), stream),
          "clearing counters");
  }

private:
  static void follow(cudaStream_t from, cudaEvent_t mark, cudaStream_t to) {
    check(cudaEventRecord(mark, from), "joining streams");
    check(cudaStreamWaitEvent(to, mark, 0), "joining streams");
  }

public:
  ~device_buffers() {
    for (const cudaEvent_t e : {clock[0], clock[1], forked, joined})
      if (e)
        cudaEventDestroy(e);
    for (const cudaStream_t s : {stream, beside})
      if (s)
        cudaStreamDestroy(s);
    cudaFreeHost(seen);
  }
};

} // namespace meetc

#endif
