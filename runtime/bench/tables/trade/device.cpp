#include "meet/bench/tables/device.hpp"

#include "meet/app/input/failure.hpp"
#include "meet/app/query/device_pairs.hpp"

#if MEETC_WITH_CUDA
#include "cga/cga_cuda.hpp"
#include "cga/cga_every_pair.hpp"
#include "meet/app/input/sets.hpp"
#include "meet/bench/harness/device_clock.hpp"
#include "meet/bench/tables/trade/cells.hpp"
#include "meet/core/device/collide.hpp"
#include "meet/core/device/every_pair/engine.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <string_view>
#endif

namespace meetc::bench {

#if MEETC_WITH_CUDA

namespace {

constexpr std::size_t long_list = std::size_t{1} << 22; // pairs that fill a device many times
constexpr std::size_t filtered = 4096;                  // elements of each set whose pairs the filter looks at

prepared prepare_rows(const kind_info &kind, const float *rows, std::size_t n) {
  view v;
  v.data = rows;
  v.stride_bytes = static_cast<std::size_t>(kind.fields) * sizeof(float);
  v.elements = n;
  return prepare(v, kind);
}

template <class T> void upload(device_memory<T> &to, const std::vector<T> &from, cudaStream_t stream) {
  to.reserve(from.size(), "pairs");
  check(cudaMemcpyAsync(to.data(), from.data(), from.size() * sizeof(T), cudaMemcpyHostToDevice, stream),
        "uploading pairs");
  check(cudaStreamSynchronize(stream), "uploading pairs");
}
template <class T> std::vector<T> download(const device_memory<T> &from, std::size_t n, cudaStream_t stream) {
  std::vector<T> out(n);
  check(cudaMemcpyAsync(out.data(), from.data(), n * sizeof(T), cudaMemcpyDeviceToHost, stream), "downloading pairs");
  check(cudaStreamSynchronize(stream), "downloading pairs");
  return out;
}

class cuda_bench_device final : public bench_device {
public:
  cuda_bench_device() : on_(cga::cuda::catalogue()), every_pair_(on_, cga::every_pair::catalogue()) {}
  std::string name() const override { return on_.facts().name; }

  device_time time_every_pair(const device_job &job, int runs) override {
    return reported([&] {
      const io::element_set &first = job.by.swapped ? job.b : job.a, &second = job.by.swapped ? job.a : job.b;
      const prepared a = app::prepare(first), b = app::prepare(second);
      device_set on_a(on_, a), on_b(on_, b);
      const auto count = [&](device_set &x, device_set &y) {
        return every_pair_.collide(x, y, *job.by.predicate, rung::certified, {.want = answer_kind::count});
      };
      host_clock clock(0);
      device_time out;
      const auto [alone, whole] = medians_of<2>(runs, [&] {
        const double seconds = count(on_a, on_b).device_seconds;
        clock.start();
        device_set fresh_a(on_, a), fresh_b(on_, b);
        out.pairs = count(fresh_a, fresh_b).count;
        return std::array{seconds, clock.stop()};
      });
      out.seconds = alone;
      out.seconds_with_transfers = whole;
      return out;
    });
  }

  std::vector<trade_point> measure(const element_pairs &pairs, int repetitions) override {
    return reported([&] {
      std::vector<trade_point> out;
      if (pairs.count == 0)
        return out;
      const std::vector<answer> exact = decide_all(pairs, pairs.by->decide[static_cast<int>(rung::exact)]);
      for (const rung r : {rung::fp32, rung::certified})
        if (decider_of(*pairs.by, r))
          out.push_back(by_rung(pairs, exact, r, repetitions));
      if (std::string_view(pairs.by->name) == "ball_ball" && every_pair_.best_filter() != every_pair::filter::float32)
        out.push_back(by_filter(pairs, exact, repetitions));
      for (trade_point &p : out)
        p.on_device = true;
      return out;
    });
  }

  result query(const prepared &a, const prepared &b, const predicate_info &p, rung precision,
               int repetitions) override {
    return reported([&] {
      device_set on_a(on_, a), on_b(on_, b);
      device_result r;
      r.seconds = medians_of<1>(repetitions, [&] {
        r = meetc::collide(on_, on_a, on_b, p, precision);
        return std::array{r.device_seconds};
      })[0];
      return static_cast<result &&>(std::move(r));
    });
  }

private:
  template <class F> static auto reported(F &&f) -> decltype(f()) {
    try {
      return f();
    } catch (const device_error &e) {
      throw app::failure(e.what(), app::no_device);
    }
  }

  const cuda::predicate_launchers &launchers_of(const predicate_info &p) const {
    const cuda::predicate_launchers *const first = on_.kernels().predicates;
    return *std::find_if(first, first + on_.kernels().predicate_count,
                         [&p](const auto &l) { return std::strcmp(l.name, p.name) == 0; });
  }

  trade_point by_rung(const element_pairs &pairs, const std::vector<answer> &exact, rung precision, int repetitions) {
    const cuda::predicate_launchers &run = launchers_of(*pairs.by);
    const cudaStream_t stream = on_.stream();
    device_set a(on_, prepare_rows(*pairs.by->a, pairs.a.data(), pairs.count)),
        b(on_, prepare_rows(*pairs.by->b, pairs.b.data(), pairs.count));
    const auto n = static_cast<std::uint32_t>(pairs.count);
    // Slot i of a set holds element order[i].
    std::vector<std::uint32_t> slot_b(n);
    const std::vector<std::uint32_t> order_a = orders(a), order_b = orders(b);
    for (std::uint32_t s = 0; s < n; ++s)
      slot_b[order_b[s]] = s;
    const std::size_t copies = std::max<std::size_t>(1, long_list / n);
    std::vector<index_pair> list;
    for (std::size_t c = 0; c < copies; ++c)
      for (std::uint32_t s = 0; s < n; ++s)
        list.push_back({s, slot_b[order_a[s]]});
    device_memory<index_pair> pairs_there, hits, left;
    device_memory<unsigned long long> counts;
    upload(pairs_there, list, stream);
    hits.reserve(list.size(), "hits"), left.reserve(list.size(), "pairs");
    counts.reserve(4, "counters");
    const cuda::cascade_steps steps = cuda::steps_of(precision);
    const auto decide = [&](std::size_t length) {
      check(cudaMemsetAsync(counts.data(), 0, 4 * sizeof(unsigned long long), stream), "clearing counters");
      cuda::pair_list in{pairs_there.data(), nullptr, length};
      for (int s = 0; s < steps.count; ++s) {
        const cuda::pair_list unsure{left.data(), counts.data() + 1 + s, list.size()}; // the last step writes none
        check(run.pairs.run(steps.of[s], a.rows().data(), b.rows().data(), in,
                            {hits.data(), counts.data(), list.size()}, unsure, stream),
              "starting a decision step");
        in = unsure;
      }
    };
    const double seconds = clock_.seconds([&] { decide(list.size()); }, repetitions);
    decide(n);
    const std::vector<unsigned long long> seen = download(counts, 4, stream);
    std::vector<answer> given(n, answer::no);
    for (const index_pair &h : download(hits, seen[0], stream))
      given[order_a[h.a]] = answer::yes;
    trade_point point{{std::string(app::name_of(precision)) + ", device", nullptr, precision},
                      seconds / static_cast<double>(list.size())};
    point.wrong = wrongness_of(pairs, point.method, given, exact);
    if (point.method.promises_truth())
      require_truth(fmt::format("trade: {}", pairs.by->name), point.method.name, point.wrong.differs);
    if (precision == rung::certified)
      point.unsure = seen[1];
    return point;
  }

  // The filter sees every pair of the elements, and the answers are those of row with row.
  trade_point by_filter(const element_pairs &pairs, const std::vector<answer> &exact, int repetitions) {
    const cudaStream_t stream = on_.stream();
    const std::size_t n = std::min(pairs.count, filtered);
    device_set a(on_, prepare_rows(*pairs.by->a, pairs.a.data(), n)),
        b(on_, prepare_rows(*pairs.by->b, pairs.b.data(), n));
    device_memory<index_pair> kept;
    device_memory<unsigned long long> count;
    kept.reserve(n * n, "a list of candidates"), count.reserve(1, "a counter");
    const auto filter = [&] {
      check(cudaMemsetAsync(count.data(), 0, sizeof(unsigned long long), stream), "clearing counters");
      every_pair_.list_near(every_pair_.best_filter(), cover::element, a, b, {kept.data(), count.data(), n * n});
    };
    const double seconds = clock_.seconds(filter, repetitions);
    const std::vector<std::uint32_t> order_a = orders(a), order_b = orders(b);
    std::vector<answer> given(n, answer::no);
    for (const index_pair &p : download(kept, download(count, 1, stream)[0], stream))
      if (order_a[p.a] == order_b[p.b])
        given[order_a[p.a]] = answer::yes;
    trade_point point{{"fp16 filter, device", nullptr, {}}, seconds / static_cast<double>(n * n)};
    element_pairs some = pairs;
    some.count = n;
    point.wrong = wrongness_of(some, point.method, given, exact);
    point.pairs = n;
    return point;
  }

  std::vector<std::uint32_t> orders(const device_set &of) const {
    std::vector<std::uint32_t> out(of.elements());
    check(cudaMemcpy(out.data(), of.rows().order(), out.size() * sizeof(std::uint32_t), cudaMemcpyDeviceToHost),
          "downloading an order");
    return out;
  }

  device on_;
  every_pair::engine every_pair_;
  device_clock clock_{on_};
};

std::unique_ptr<bench_device> open_device() {
  try {
    return std::make_unique<cuda_bench_device>();
  } catch (const device_error &e) {
    throw app::failure(e.what(), app::no_device);
  }
}

} // namespace

#endif

std::unique_ptr<bench_device> bench_device_named(const std::string &name) {
  [[maybe_unused]] const bool asked = app::processor_named(name) == app::processor::cuda;
#if MEETC_WITH_CUDA
  if (asked)
    return open_device();
  if (name == "auto")
    try {
      return open_device();
    } catch (const app::failure &) { // there is none: the processor alone is measured
    }
#endif
  return nullptr;
}

} // namespace meetc::bench
