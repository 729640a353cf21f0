#include "meet/core/device/repeated.hpp"

#include "meet/core/device/device.hpp"

#include <algorithm>
#include <utility>

namespace meetc {
namespace {

constexpr std::size_t most_sequences = 8; // and notes

// Null where the driver cannot capture this.
cudaGraphExec_t captured(cudaStream_t stream, const std::function<void()> &enqueue) {
  if (cudaStreamBeginCapture(stream, cudaStreamCaptureModeThreadLocal) != cudaSuccess) {
    cudaGetLastError();
    return nullptr;
  }
  cudaGraph_t graph = nullptr;
  cudaGraphExec_t out = nullptr;
  bool complete = true;
  try {
    enqueue();
  } catch (const device_error &) {
    complete = false; // it is enqueued again without a capture, and then tells of an error that is not the capture's
  } catch (...) {
    cudaStreamEndCapture(stream, &graph);
    if (graph)
      cudaGraphDestroy(graph);
    cudaGetLastError();
    throw;
  }
  complete = cudaStreamEndCapture(stream, &graph) == cudaSuccess && complete;
  if (complete && cudaGraphInstantiate(&out, graph, 0) != cudaSuccess)
    out = nullptr;
  if (graph)
    cudaGraphDestroy(graph);
  cudaGetLastError();
  return out;
}

} // namespace

repeated_launches::~repeated_launches() {
  for (const sequence &s : last_)
    if (s.graph)
      cudaGraphExecDestroy(s.graph);
}

std::uint64_t &repeated_launches::note(const launch_key &key) {
  const auto known = std::find_if(notes_.begin(), notes_.end(), [&key](const auto &n) { return n.first == key; });
  if (known != notes_.end()) {
    std::rotate(known, known + 1, notes_.end());
  } else {
    if (notes_.size() == most_sequences)
      notes_.erase(notes_.begin());
    notes_.emplace_back(key, 0);
  }
  return notes_.back().second;
}

void repeated_launches::run(cudaStream_t stream, launch_key key, const std::function<void()> &enqueue) {
  const auto known = std::find_if(last_.begin(), last_.end(), [&key](const sequence &s) { return s.key == key; });
  if (known == last_.end()) {
    if (last_.size() == most_sequences) {
      if (last_.front().graph)
        cudaGraphExecDestroy(last_.front().graph);
      last_.erase(last_.begin());
    }
    last_.push_back({std::move(key), false, nullptr});
    enqueue();
    return;
  }
  std::rotate(known, known + 1, last_.end());
  sequence &s = last_.back();
  if (!std::exchange(s.seen_twice, true))
    s.graph = captured(stream, enqueue);
  if (s.graph)
    check(cudaGraphLaunch(s.graph, stream), "launching a graph");
  else
    enqueue();
}

} // namespace meetc
