#include "meet/core/device/set/cull.hpp"

#include "meet/core/device/memory/buffers.hpp"
#include "meet/core/device/set/cull_kernels.hpp"
#include "meet/core/device/set/given.hpp"
#include "meet/core/hierarchy/two_points.hpp"
#include "meetc/cuda/cull_grid.hpp"
#include "meetc/cuda/cutter.hpp"

#include <algorithm>
#include <atomic>
#include <bit>

namespace meetc {
namespace {

// A cell is a few times as wide as an element of a mesh that fills the box.
int bits_for(std::uint32_t elements) {
  return std::clamp(static_cast<int>(std::bit_width(elements)) / 2 - 2, cuda::least_cull_bits, cuda::most_cull_bits);
}

// Waits until a report has come, or all has ended. Returns whether it has come.
bool has_come(std::uint32_t &there, cudaStream_t stream) {
  const std::atomic_ref<std::uint32_t> come(there);
  for (unsigned looks = 1; come.load(std::memory_order_acquire) == 0; ++looks)
    if (looks % 64 == 0)
      if (const cudaError_t e = cudaStreamQuery(stream); e != cudaErrorNotReady) {
        check(e, "culling");
        return come.load(std::memory_order_acquire) != 0;
      }
  return true;
}

} // namespace

bool cull_pays(const given_elements &a, const given_elements &b) {
  constexpr std::uint64_t fewest = std::uint64_t{1} << 17; // fewer are in order sooner
  const bool mesh = a.there().index || b.there().index;    // its elements leave most cells empty
  return &a != &b && mesh && std::uint64_t{a.there().elements} + b.there().elements >= fewest;
}

bool cull(const device &on, const given_elements &a, const given_elements &b, bool by_lines, culled &out) {
  const bool lines_a = by_lines && has_two_points(a.kind()), lines_b = by_lines && has_two_points(b.kind());
  const bool b_first = lines_a == lines_b ? b.there().elements < a.there().elements : lines_b;
  const given_elements *const sets[2] = {b_first ? &b : &a, b_first ? &a : &b};
  const bool again = !lines_a && !lines_b;
  device_buffers &buffers = on.buffers();
  const cudaStream_t stream = on.stream();
  cuda::sift_job job{};
  job.bits = bits_for(std::max(a.there().elements, b.there().elements));
  job.by_lines = by_lines;
  const std::size_t words = cuda::cull_marks::words_for(job.bits);
  cull_findings *found = nullptr;
  std::uint32_t *marks[2] = {nullptr, nullptr}, *kept[3] = {nullptr, nullptr, nullptr},
                *vertices[2] = {nullptr, nullptr};
  std::size_t zeroed = 0;
  for (const bool planned : {true, false}) {
    cuda::cutter from(buffers.cull_space.data(), buffers.cull_space.capacity());
    found = from.take<cull_findings>(1);
    marks[0] = from.take<std::uint32_t>(words), marks[1] = from.take<std::uint32_t>(again ? words : 0);
    zeroed = from.used();
    kept[0] = from.take<std::uint32_t>(sets[0]->there().elements),
    kept[1] = from.take<std::uint32_t>(sets[1]->there().elements);
    kept[2] = from.take<std::uint32_t>(again ? sets[0]->there().elements : 0);
    for (int s = 0; s < 2; ++s)
      vertices[s] = from.take<std::uint32_t>(sets[s]->there().index ? sets[s]->there().vertices : 0);
    if (planned && !buffers.cull_space.grow(from.used(), 0, stream))
      return false;
  }
  buffers.start_clock();
  check(cudaMemsetAsync(buffers.cull_space.data(), 0, zeroed, stream), "clearing marks");
  vertices_of_two corners{};
  for (int s = 0; s < 2; ++s) {
    corners.at[s] = cuda_pose(sets[s]->at);
    if (sets[s]->there().index)
      corners.of[s] = sets[s]->there();
    else
      check(launchers_of(on.kernels(), sets[s]->kind())
                .pose(sets[s]->there(), corners.at[s], nullptr, nullptr, nullptr, found->around + s, stream),
            "starting a kernel");
  }
  check(surround_vertices(corners, found->around, stream), "starting a kernel");
  check(find_cells(corners, found->around, job.bits, {{vertices[0], vertices[1]}}, stream), "starting a kernel");
  job.around = found->around;
  const int last = again ? 2 : 1;
  host_notes &seen = *buffers.seen;
  seen.culled_there = 0;
  const auto sift = [&](int set, int pass) {
    job.from = sets[set]->there(), job.at = corners.at[set];
    job.vertices = vertices[set], job.kept = kept[pass], job.count = found->kept + pass, job.bad = found->bad + set;
    if (pass == last)
      job.at_end = {reinterpret_cast<const std::uint32_t *>(found), reinterpret_cast<std::uint32_t *>(&seen.culled),
                    sizeof seen.culled / sizeof(std::uint32_t), &seen.culled_there, &found->arrived};
    check(launchers_of(on.kernels(), sets[set]->kind()).sift(job, stream), "starting a kernel");
  };
  job.marks = marks[0];
  sift(0, 0);
  job.marked = marks[0], job.marks = again ? marks[1] : nullptr;
  sift(1, 1);
  if (again) {
    job.marked = marks[1], job.marks = nullptr, job.among = kept[0], job.among_count = found->kept;
    sift(0, 2);
  }
  if (!has_come(seen.culled_there, stream)) { // no block of the last pass has run
    check(cudaMemcpyAsync(&seen.culled, found, sizeof seen.culled, cudaMemcpyDeviceToHost, stream), "culling");
    check(cudaStreamSynchronize(stream), "culling");
  }
  for (const bool of_b : {false, true}) // of A before B
    if (seen.culled.bad[of_b != b_first] != 0)
      (of_b ? b : a).refuse();
  const int of_first = again ? 2 : 0;
  out = {kept[of_first], kept[1], seen.culled.kept[of_first], seen.culled.kept[1]};
  if (b_first)
    out = {out.b, out.a, out.elements_b, out.elements_a};
  if (std::uint64_t{out.elements_a} + out.elements_b < (std::uint64_t{a.there().elements} + b.there().elements) / 2)
    out.common = found->around;
  return true;
}

} // namespace meetc
