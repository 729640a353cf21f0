#include "meet/core/device/every_pair/engine.hpp"

#include "meet/core/device/answers/element_pairs.hpp"
#include "meet/core/device/query/lists.hpp"
#include "meet/core/device/query/parts.hpp"
#include "meet/core/device/query/query.hpp"
#include "meet/core/views/usage_error.hpp"
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

constexpr std::size_t least_list = std::size_t{part_step} * part_step; // the pairs of a part that is cut no further

void require(bool holds, const char *what) {
  if (!holds)
    throw usage_error(what);
}

// The parts of a product, from the filter to the list of hits.
class product_query {
public:
  product_query(const device &on, const catalogue &kernels, const device_rows &a, const device_rows &b,
                const cuda::predicate_launchers &predicate, const options &how, const part_steps &steps)
      : on_(on), kernels_(kernels), buffers_(on.buffers()), a_(a), b_(b), predicate_(predicate), steps_(steps),
        lists_(buffers_, 0, how.list_capacity, how.want == answer_kind::pairs) {}

  // `pairs` has started; null: they are only counted.
  void run(on_device::query_answer *pairs, outcome &r) {
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
      if (!lists_.hold(1)) { // no later list is longer than that of the filter
        left.push_back(p);
        if (!lists_.take_more_room())
          most = area(p) / 4;
        continue;
      }
      take_part(pairs, r);
    }
  }

private:
  // Between whole blocks of the filter's kernels where a side has several.
  static std::pair<cuda::part, cuda::part> cut(const cuda::part &p) {
    const std::uint32_t a = p.end_a - p.first_a, b = p.end_b - p.first_b;
    return halves(p, a > b, std::max(a, b) > matrix_block ? matrix_block : part_step);
  }

  void try_part(const cuda::part &p) {
    const cuda::pair_list near = lists_.candidates(), second = lists_.kept();
    steps_.near = near;
    steps_.touching = {second.pairs, buffers_.count_of(counter::touching), second.capacity};
    steps_.kept = second.count, steps_.unsure = buffers_.count_of(counter::unsure_fp32);
    buffers_.clear_counts();
    check(decide_part(kernels_, predicate_, steps_, p, lists_.hits(), on_.stream()), "starting a part of a product");
    buffers_.mark_clock();
    buffers_.read_notes("deciding every pair");
  }
  void take_part(on_device::query_answer *pairs, outcome &r) {
    const auto seen = [this](counter c) { return buffers_.seen_of(c); };
    r.near += seen(counter::candidates);
    r.candidates += seen(counter::touching);
    r.count += seen(counter::hits);
    r.rungs.unsure[0] += seen(counter::unsure_fp32);
    r.rungs.unsure[1] += seen(counter::unsure_fp64);
    r.rungs.unsure[2] += seen(counter::unsure_fp64x2);
    if (pairs)
      pairs->take({buffers_.hits.data(), static_cast<std::size_t>(seen(counter::hits)), false});
  }

  const device &on_;
  const catalogue &kernels_;
  device_buffers &buffers_;
  const device_rows &a_, &b_;
  const cuda::predicate_launchers &predicate_;
  part_steps steps_;
  query_lists lists_;
};

} // namespace

const probe_result &engine::probe() {
  const control_word_guard guard;
  const auto lock = on_.use();
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

const extent *engine::around(const device_rows &frame) {
  around_.reserve(1, "a set's extent");
  if (around_of_ != frame.version()) {
    around_of_ = 0;
    check(launchers_of(frame.kind()).enclose(frame.data(), frame.elements(), around_.data(), on_.stream()),
          "starting a kernel");
    around_of_ = frame.version();
  }
  return around_.data();
}

operand engine::columns(filter by, cover balls, bool first, const device_rows &of, const device_rows &frame) {
  const made want{by == filter::float32, balls, frame.version(), of.version()};
  columns_of_set &c = columns_[first];
  if (want != c.have) {
    c.have = {};
    c.memory.reserve(column_bytes(by, of.elements()), "the filter's columns");
    check(launchers_of(of.kind()).columns(by, balls, first, of.data(), of.elements(), around(frame), c.memory.data(),
                                          on_.stream()),
          "starting a kernel");
    c.have = want;
  }
  return {of.elements(), c.memory.data()};
}

engine::two_operands engine::operands(filter by, cover balls, const device_rows &a, const device_rows &b) {
  const device_rows &frame = b.elements() < a.elements() ? a : b;
  return {columns(by, balls, true, a, frame), columns(by, balls, false, b, frame)};
}

void engine::list_near(filter by, cover balls, device_set &a, device_set &b, const cuda::pair_list &out) {
  const auto lock = on_.use();
  const two_operands of = operands(by, balls, a.rows(), b.rows());
  check(kernels_.candidates(by, of.x, of.y, {0, a.elements(), 0, b.elements()}, out, on_.stream()),
        "starting the filter");
}

outcome engine::collide(device_set &a, device_set &b, const predicate_info &predicate, rung precision,
                        const options &how) {
  const control_word_guard guard;
  const auto lock = on_.use();
  const auto start = std::chrono::steady_clock::now();
  require_query(on_, a, b, predicate, precision, {});
  require(how.want == answer_kind::pairs || how.want == answer_kind::count,
          "every pair is answered by pairs, or by their number");
  require(precision != rung::tolerant, "every pair is not decided within a tolerance");
  require(how.list_capacity >= least_list, "a list holds at least 2^12 pairs");
  require(!how.by || offers(*how.by), "this device does not offer the filter that was asked for");
  require(!a.as_given() && !b.as_given(), "every pair is asked of sets that are in order");
  outcome r;
  r.by = how.by ? *how.by : best_filter();
  if (a.elements() > 0 && b.elements() > 0) {
    device_buffers &buffers = on_.buffers();
    const cudaStream_t stream = on_.stream();
    buffers.start_clock();
    const two_operands of = operands(r.by, how.balls.value_or(balls_for(precision)), a.rows(), b.rows());
    part_steps steps{};
    steps.by = r.by, steps.precision = precision;
    steps.x = of.x, steps.y = of.y, steps.rows_a = a.rows().data(), steps.rows_b = b.rows().data();
    steps.boxes = {a.rows().tree(stream).nodes, b.rows().tree(stream).nodes};
    product_query product(on_, kernels_, a.rows(), b.rows(), meetc::launchers_of(on_.kernels(), predicate), how, steps);
    device_result listed;
    on_device::element_pairs pairs;
    const bool lists = how.want == answer_kind::pairs;
    if (lists)
      pairs.start({on_, a.rows(), b.rows()});
    product.run(lists ? &pairs : nullptr, r);
    if (lists) {
      pairs.finish();
      pairs.download(listed);
      r.pairs = std::move(listed.pairs);
    }
    r.device_seconds = buffers.clocked();
  }
  r.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return r;
}

} // namespace meetc::every_pair
