// core/device/buffers.hpp: what queries on one device share, so that only the first allocates memory.
#ifndef MEETC_CORE_DEVICE_BUFFERS_HPP
#define MEETC_CORE_DEVICE_BUFFERS_HPP

#include "meet/core/device/cull.hpp"
#include "meet/core/device/hit_history.hpp"
#include "meet/core/device/memory.hpp"
#include "meet/core/device/transfers.hpp"

#include <cstdint>

namespace meetc {

// What a query counts: its lists, the items of a walk that warps have taken, and whether its hits are in no order.
enum class counter : std::uint8_t {
  candidates,
  kept,
  touching,
  hits,
  unsure_fp32,
  unsure_fp64,
  unsure_fp64x2, // right after unsure_fp64, as certify_rest needs it
  taken,
  unordered
};
inline constexpr int counters = 9;

// What a query notes on the device: one piece, which the host reads at once.
struct query_notes {
  cuda::order_findings found[2]; // of the sets that it has ordered
  unsigned long long counts[counters];
};

// What it reads of the device, in host memory that the device can write to.
struct host_notes {
  query_notes of_query;
  cull_findings culled;
  std::uint32_t culled_there; // whether they are
};

struct device_buffers {
  device_memory<index_pair> first, second, hits; // first and second alternate for candidates and unsure pairs
  device_memory<unsigned long long> notes;       // query_notes, and behind them what it takes to order hits
  device_memory<std::uint64_t> keys, more_keys;  // hits as sortable numbers
  device_memory<std::byte> sort_space;
  device_memory<std::uint32_t> first_slots, first_numbers; // what is met first
  hit_history hits_before;
  transfers moving;
  cudaStream_t stream = nullptr; // of all queries
  cudaStream_t beside = nullptr; // for work on one set while the query's stream works on the other
  cudaEvent_t forked = nullptr, joined = nullptr;
  cudaEvent_t events[2] = {nullptr, nullptr};
  host_notes *seen = nullptr;
  device_memory<std::byte> cull_space;

  cuda::order_findings *found() const { return reinterpret_cast<query_notes *>(notes.data())->found; }
  unsigned long long *counts() const { return reinterpret_cast<query_notes *>(notes.data())->counts; }
  unsigned long long *to_order() const { return counts() + counters; }
  // Room for the notes and so many numbers at to_order(). Throws device_error.
  void take_notes(std::size_t numbers) {
    const std::size_t all = sizeof(query_notes) / sizeof(unsigned long long) + numbers;
    if (all <= notes.capacity())
      return;
    notes.reserve(all, "counters");
    check(cudaMemsetAsync(notes.data(), 0, sizeof(query_notes), stream), "clearing counters"); // all are read, always
  }

  // Apart from the constructor, so that what was created is destroyed where the next cannot be. Throws device_error.
  void create() {
    check(cudaStreamCreateWithFlags(&stream, cudaStreamNonBlocking), "making a stream");
    for (cudaEvent_t &e : events)
      check(cudaEventCreate(&e), "making an event");
    for (cudaEvent_t *const e : {&forked, &joined})
      check(cudaEventCreateWithFlags(e, cudaEventDisableTiming), "making an event");
    check(cudaStreamCreateWithFlags(&beside, cudaStreamNonBlocking), "making a stream");
    check(cudaMallocHost(reinterpret_cast<void **>(&seen), sizeof *seen), "allocating host memory");
  }
  // Seconds between the two events, once the second is reached.
  double between() const {
    float ms = 0;
    check(cudaEventSynchronize(events[1]), "waiting for the device");
    check(cudaEventElapsedTime(&ms, events[0], events[1]), "reading a clock");
    return static_cast<double>(ms) / 1000;
  }

  ~device_buffers() {
    for (const cudaEvent_t e : {events[0], events[1], forked, joined})
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
