#include "meet/core/device/every_pair/engine.hpp"

#include "meet/core/device/buffers.hpp"
#include "meet/core/device/hits.hpp"
#include "meet/core/device/parts.hpp"
#include "meet/core/device/query.hpp"
#include "meetc/every_pair/query.hpp"

#include <algorithm>
#include <chrono>
#include <cstring>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace meetc::every_pair {
namespace {

constexpr std::size_t first_capacity = std::size_t{1} << 22;
constexpr std::size_t least_list = std::size_t{part_step} * part_step; // the pairs of a part that is cut no further

void require(bool holds, const char *what) {
  if (!holds)
    throw std::invalid_argument(what);
}

// The parts of a product, from the filter to the list of hits.
class product_query {
public:
  product_query(device &on, const catalogue &kernels, device_set &a, device_set &b,
                const cuda::predicate_launchers &predicate, const options &how, const part_steps &steps)
      : on_(on), kernels_(kernels), buffers_(on.buffers()), a_(a), b_(b), predicate_(predicate), how_(how),
        steps_(steps), hits_(on, a, b, {}, {}) {}

  void run(outcome &r) {
    buffers_.take_notes(0);
    const std::size_t least = std::min(how_.list_capacity, first_capacity);
    buffers_.first.reserve(least, "a list of candidates");
    buffers_.second.reserve(least, "a list of candidates");
    if (lists_hits())
      buffers_.hits.reserve(least, "a list of hits");
    capacity_ = std::min(buffers_.first.capacity(), how_.list_capacity);
    if (!enlarge_lists(capacity_))
      capacity_ = least;
    std::vector<cuda::part> left{{0, a_.elements(), 0, b_.elements()}};
    for (std::uint64_t most = ~std::uint64_t{0}; !left.empty();) { // the largest part that is worth trying
      const cuda::part p = left.back();
      left.pop_back();
      if (area(p) > most && area(p) > least_list) {
        const auto [x, y] = cut(p);
        left.push_back(y), left.push_back(x);
        continue;
      }
      try_part(p);
      ++r.parts;
      if (overflowed()) {
        left.push_back(p);
        if (capacity_ == how_.list_capacity || !enlarge_lists(how_.list_capacity))
          most = area(p) / 4;
        continue;
      }
      take_part(r);
    }
    const auto stop_clock = [this] { check(cudaEventRecord(buffers_.events[1], on_.stream()), "stopping a clock"); };
    if (lists_hits())
      hits_.finish(how_.want, r, stop_clock, nullptr);
    else
      stop_clock();
  }

private:
  bool lists_hits() const { return how_.want == answer_kind::pairs; }
  unsigned long long seen(counter c) const { return buffers_.seen->of_query.counts[static_cast<int>(c)]; }
  unsigned long long *count(counter c) { return buffers_.counts() + static_cast<int>(c); }

  // Returns false where there is too little memory.
  bool enlarge_lists(std::size_t capacity) {
    const cudaStream_t stream = on_.stream();
    if (!buffers_.first.grow(capacity, 0, stream) || !buffers_.second.grow(capacity, 0, stream) ||
        (lists_hits() && !buffers_.hits.grow(capacity, 0, stream)))
      return false;
    capacity_ = capacity;
    return true;
  }

  // Between whole blocks of the filter's kernels where a side has several.
  static std::pair<cuda::part, cuda::part> cut(const cuda::part &p) {
    const std::uint32_t a = p.end_a - p.first_a, b = p.end_b - p.first_b;
    return halves(p, a > b, std::max(a, b) > matrix_block ? matrix_block : part_step);
  }

  void try_part(const cuda::part &p) {
    const cudaStream_t stream = on_.stream();
    steps_.near = {buffers_.first.data(), count(counter::candidates), capacity_};
    steps_.touching = {buffers_.second.data(), count(counter::touching), capacity_};
    steps_.kept = count(counter::kept), steps_.unsure = count(counter::unsure_fp32);
    const cuda::pair_list hits{lists_hits() ? buffers_.hits.data() : nullptr, count(counter::hits),
                               lists_hits() ? capacity_ : 0};
    check(cudaMemsetAsync(buffers_.counts(), 0, counters * sizeof(unsigned long long), stream), "clearing counters");
    check(decide_part(kernels_, predicate_, steps_, p, hits, stream), "starting a part of a product");
    check(cudaMemcpyAsync(&buffers_.seen->of_query, buffers_.notes.data(), sizeof(query_notes), cudaMemcpyDeviceToHost,
                          stream),
          "reading counters");
    check(cudaStreamSynchronize(stream), "deciding every pair");
  }
  bool overflowed() const { return seen(counter::candidates) > capacity_; } // no later list is longer
  void take_part(outcome &r) {
    r.near += seen(counter::candidates);
    r.candidates += seen(counter::touching);
    r.count += seen(counter::hits);
    r.rungs.unsure[0] += seen(counter::unsure_fp32);
    r.rungs.unsure[1] += seen(counter::unsure_fp64);
    r.rungs.unsure[2] += seen(counter::unsure_fp64x2);
    if (lists_hits() && seen(counter::hits) > 0)
      hits_.add(buffers_.hits.data(), seen(counter::hits));
  }

  device &on_;
  const catalogue &kernels_;
  device_buffers &buffers_;
  device_set &a_, &b_;
  const cuda::predicate_launchers &predicate_;
  const options &how_;
  part_steps steps_;
  hit_pairs hits_;
  std::size_t capacity_ = 0;
};

} // namespace

const probe_result &engine::probe() {
  const control_word_guard guard;
  if (probe_.cases == 0) {
    device_memory<probe_result> found;
    found.reserve(1, "the probe");
    check(kernels_.probe(found.data(), on_.stream()), "starting the probe");
    check(cudaMemcpyAsync(&probe_, found.data(), sizeof probe_, cudaMemcpyDeviceToHost, on_.stream()), "the probe");
    check(cudaStreamSynchronize(on_.stream()), "the probe");
  }
  return probe_;
}

bool engine::offers(filter f) {
  if (f == filter::float32)
    return true;
  const probe_result &found = probe();
  const bool mma = found.cases > 0 && found.mma_faults == 0;
  // wgmma computes hits again by mma.sync.
  return f == filter::mma ? mma : mma && found.has_wgmma && found.wgmma_faults == 0;
}

filter engine::best_filter() {
  for (const filter f : {filter::wgmma, filter::mma})
    if (offers(f))
      return f;
  return filter::float32;
}

const set_launchers &engine::launchers_of(const kind_info &kind) const {
  for (int k = 0; k < kernels_.kind_count; ++k)
    if (std::strcmp(kernels_.kinds[k].name, kind.name) == 0)
      return kernels_.kinds[k];
  throw device_error(std::string("no kernels for every pair were generated for the kind ") + kind.name);
}

const extent *engine::around(device_set &frame) {
  around_.reserve(1, "a set's extent");
  if (around_of_ != frame.version()) {
    around_of_ = 0;
    check(launchers_of(frame.kind()).enclose(frame.rows(), frame.elements(), around_.data(), on_.stream()),
          "starting a kernel");
    around_of_ = frame.version();
  }
  return around_.data();
}

operand engine::columns(filter by, cover balls, bool first, device_set &of, device_set &frame) {
  const made want{by == filter::float32, balls, frame.version(), of.version()};
  columns_of_set &c = columns_[first];
  if (want != c.have) {
    c.have = {};
    c.memory.reserve(column_bytes(by, of.elements()), "the filter's columns");
    check(launchers_of(of.kind()).columns(by, balls, first, of.rows(), of.elements(), around(frame), c.memory.data(),
                                          on_.stream()),
          "starting a kernel");
    c.have = want;
  }
  return {of.elements(), c.memory.data()};
}

engine::two_operands engine::operands(filter by, cover balls, device_set &a, device_set &b) {
  device_set &frame = b.elements() < a.elements() ? a : b;
  return {columns(by, balls, true, a, frame), columns(by, balls, false, b, frame)};
}

void engine::list_near(filter by, cover balls, device_set &a, device_set &b, const cuda::pair_list &out) {
  const two_operands of = operands(by, balls, a, b);
  check(kernels_.candidates(by, of.x, of.y, {0, a.elements(), 0, b.elements()}, out, on_.stream()),
        "starting the filter");
}

outcome engine::collide(device_set &a, device_set &b, const predicate_info &predicate, rung precision,
                        const options &how) {
  const control_word_guard guard;
  const auto start = std::chrono::steady_clock::now();
  require_query(on_, a, b, predicate, precision, {});
  require(how.want == answer_kind::pairs || how.want == answer_kind::count,
          "every pair is answered by pairs, or by their number");
  require(precision != rung::tolerant, "every pair is not decided within a tolerance");
  require(how.list_capacity >= least_list, "a list holds at least 2^12 pairs");
  require(!how.by || offers(*how.by), "this device does not offer the filter that was asked for");
  for (const device_set *const s : {&a, &b})
    require(s->elements() == 0 || s->order(), "a set in several poses is for collide_poses() alone");
  outcome r;
  r.by = how.by ? *how.by : best_filter();
  if (a.elements() > 0 && b.elements() > 0) {
    device_buffers &buffers = on_.buffers();
    const cudaStream_t stream = on_.stream();
    check(cudaEventRecord(buffers.events[0], stream), "starting a clock");
    const two_operands of = operands(r.by, how.balls.value_or(balls_for(precision)), a, b);
    part_steps steps{};
    steps.by = r.by, steps.precision = precision;
    steps.x = of.x, steps.y = of.y, steps.rows_a = a.rows(), steps.rows_b = b.rows();
    steps.boxes = {a.tree(stream).nodes, b.tree(stream).nodes};
    product_query(on_, kernels_, a, b, meetc::launchers_of(on_.kernels(), predicate), how, steps).run(r);
    r.device_seconds = buffers.between();
  }
  r.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return r;
}

} // namespace meetc::every_pair
