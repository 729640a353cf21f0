#include "meet/core/device/memory/transfers.hpp"

#include "meet/core/device/memory/device.hpp"
#include "meet/core/threads/threads.hpp"

#include <algorithm>
#include <cstring>

namespace meetc {
namespace {

constexpr std::size_t block = std::size_t{1} << 21, least = 4 * block;
constexpr int most_workers = 4; // more do not fill the bus better

} // namespace

transfers::~transfers() {
  for (const buffer &b : buffers_) {
    cudaEventDestroy(b.free);
    cudaFreeHost(b.pinned);
  }
}

int transfers::take_buffers() {
  const int wanted = std::min(most_workers, thread_count(0));
  while (!refused_ && buffers_.size() < 2 * static_cast<std::size_t>(wanted)) {
    buffer b{};
    refused_ = cudaMallocHost(reinterpret_cast<void **>(&b.pinned), block) != cudaSuccess;
    if (!refused_ && cudaEventCreateWithFlags(&b.free, cudaEventDisableTiming) != cudaSuccess) {
      cudaFreeHost(b.pinned);
      refused_ = true;
    }
    if (!refused_)
      buffers_.push_back(b);
    else
      cudaGetLastError();
  }
  return static_cast<int>(buffers_.size() / 2);
}

void transfers::upload(void *there, const void *here, std::size_t bytes, cudaStream_t stream, const char *what) {
  const int workers = bytes >= least ? take_buffers() : 0;
  if (workers == 0) {
    check(cudaMemcpyAsync(there, here, bytes, cudaMemcpyHostToDevice, stream), what);
    return;
  }
  int device = 0;
  check(cudaGetDevice(&device), what);
  chunk_counter left(bytes, block);
  auto work = [&](int worker) {
    check(cudaSetDevice(device), what);
    const buffer *const mine = buffers_.data() + 2 * static_cast<std::size_t>(worker);
    int turn = 0;
    for (std::size_t begin, end; left.take(begin, end); turn ^= 1) {
      check(cudaEventSynchronize(mine[turn].free), what); // what it held before is there
      std::memcpy(mine[turn].pinned, static_cast<const std::byte *>(here) + begin, end - begin);
      check(cudaMemcpyAsync(static_cast<std::byte *>(there) + begin, mine[turn].pinned, end - begin,
                            cudaMemcpyHostToDevice, stream),
            what);
      check(cudaEventRecord(mine[turn].free, stream), what);
    }
  };
  run_workers(left.workers(workers), left, work);
}

void transfers::download(void *here, const void *there, std::size_t bytes, cudaStream_t stream, const char *what) {
  const int workers = bytes >= least ? take_buffers() : 0;
  if (workers == 0) {
    check(cudaMemcpyAsync(here, there, bytes, cudaMemcpyDeviceToHost, stream), what);
    check(cudaStreamSynchronize(stream), what);
    return;
  }
  int device = 0;
  check(cudaGetDevice(&device), what);
  chunk_counter left(bytes, block);
  auto work = [&](int worker) {
    check(cudaSetDevice(device), what);
    const buffer *const mine = buffers_.data() + 2 * static_cast<std::size_t>(worker);
    struct {
      std::size_t begin = 0, bytes = 0; // 0: nothing is on its way
    } coming[2];
    const auto take = [&](int turn) {
      if (coming[turn].bytes == 0)
        return;
      check(cudaEventSynchronize(mine[turn].free), what);
      std::memcpy(static_cast<std::byte *>(here) + coming[turn].begin, mine[turn].pinned, coming[turn].bytes);
      coming[turn].bytes = 0;
    };
    int turn = 0;
    for (std::size_t begin, end; left.take(begin, end); turn ^= 1) {
      take(turn);
      // An upload that used this buffer comes before on the same stream.
      check(cudaMemcpyAsync(mine[turn].pinned, static_cast<const std::byte *>(there) + begin, end - begin,
                            cudaMemcpyDeviceToHost, stream),
            what);
      check(cudaEventRecord(mine[turn].free, stream), what);
      coming[turn] = {begin, end - begin};
    }
    take(turn), take(turn ^ 1);
  };
  run_workers(left.workers(workers), left, work);
  check(cudaStreamSynchronize(stream), what);
}

} // namespace meetc
