#include "meet/core/device/tallies.hpp"

#include "meet/core/device/kernels.hpp"

namespace meetc {

void tallies::start(answer_kind want, std::uint32_t elements_a, std::uint32_t elements_b,
                    std::span<const std::uint64_t> of_instances, cudaStream_t stream) {
  want_ = want, elements_a_ = elements_a, elements_b_ = elements_b;
  of_instance_ = of_instances.empty() ? 0 : static_cast<std::uint32_t>(elements_b / of_instances.size());
  const auto zeroed = [stream](auto &numbers, std::size_t n) {
    numbers.reserve(n, "counts of elements");
    if (n > 0)
      check(cudaMemsetAsync(numbers.data(), 0, n * sizeof *numbers.data(), stream), "clearing counts");
  };
  if (!of_instances.empty())
    zeroed(counts_b_, of_instances.size());
  else if (want == answer_kind::counts)
    zeroed(counts_a_, elements_a), zeroed(counts_b_, elements_b);
  else
    zeroed(flags_a_, elements_a), zeroed(flags_b_, elements_b);
}

void tallies::add(const index_pair *hits, std::size_t n, const std::uint32_t *order_a, const std::uint32_t *order_b,
                  cudaStream_t stream) {
  check(tally({hits, n, order_a, order_b, counts_a_.data(), counts_b_.data(), flags_a_.data(), flags_b_.data(),
               of_instance_},
              stream),
        "starting a kernel");
}

void tallies::finish(result &r, std::span<std::uint64_t> of_instances, cudaStream_t stream) {
  const auto download = [stream](const auto &numbers, auto *to, std::size_t n) {
    static_assert(sizeof *to == sizeof *numbers.data());
    if (numbers.data())
      check(cudaMemcpyAsync(to, numbers.data(), n * sizeof *to, cudaMemcpyDeviceToHost, stream), "downloading counts");
  };
  if (!of_instances.empty()) {
    download(counts_b_, of_instances.data(), of_instances.size());
  } else if (want_ == answer_kind::counts) {
    r.counts.a.resize(elements_a_), r.counts.b.resize(elements_b_);
    download(counts_a_, r.counts.a.data(), elements_a_);
    download(counts_b_, r.counts.b.data(), elements_b_);
  } else {
    r.flags.a.resize(elements_a_), r.flags.b.resize(elements_b_);
    download(flags_a_, r.flags.a.data(), elements_a_);
    download(flags_b_, r.flags.b.data(), elements_b_);
  }
  check(cudaStreamSynchronize(stream), "downloading counts");
}

} // namespace meetc
