#include "meet/core/device/answers/element_numbers.hpp"

#include "meet/core/device/answers/kernels.hpp"

namespace meetc::on_device {

template <class T> void tallied_numbers<T>::start(std::size_t n, cudaStream_t stream) {
  n_ = n;
  there_.reserve(n, "counts of elements");
  if (n > 0)
    check(cudaMemsetAsync(there_.data(), 0, n * sizeof(T), stream), "clearing counts");
}

template <class T> template <class To> void tallied_numbers<T>::download(To *to, cudaStream_t stream) const {
  static_assert(sizeof(To) == sizeof(T));
  if (n_ > 0)
    check(cudaMemcpyAsync(to, there_.data(), n_ * sizeof(T), cudaMemcpyDeviceToHost, stream), "downloading counts");
}

template <class T> void element_numbers<T>::start(const queried_sets &sets) {
  sets_.emplace(sets);
  a_.start(sets.a.numbers(), sets.on.stream());
  b_.start(sets.b.numbers(), sets.on.stream());
}

template <class T> template <class To> per_element<To> element_numbers<T>::numbers() const {
  const cudaStream_t stream = sets_->on.stream();
  per_element<To> out{std::vector<To>(sets_->a.numbers()), std::vector<To>(sets_->b.numbers())};
  a_.download(out.a.data(), stream);
  b_.download(out.b.data(), stream);
  check(cudaStreamSynchronize(stream), "downloading counts");
  return out;
}

void element_flags::take(const part_hits &hits) {
  check(tally({.hits = hits.pairs,
               .n = hits.n,
               .order_a = sets().a.order(),
               .order_b = sets().b.order(),
               .flags_a = a_.data(),
               .flags_b = b_.data()},
              sets().on.stream()),
        "starting a kernel");
}
void element_flags::download(device_result &r) {
  r.flags = numbers<std::uint8_t>();
}

void element_counts::take(const part_hits &hits) {
  check(tally({.hits = hits.pairs,
               .n = hits.n,
               .order_a = sets().a.order(),
               .order_b = sets().b.order(),
               .counts_a = a_.data(),
               .counts_b = b_.data()},
              sets().on.stream()),
        "starting a kernel");
}
void element_counts::download(device_result &r) {
  r.counts = numbers<std::uint64_t>();
}

void instance_counts::start(const queried_sets &sets) {
  stream_ = sets.on.stream();
  slots_ = counts_.empty() ? 1 : static_cast<std::uint32_t>(sets.b.elements() / counts_.size());
  there_.start(counts_.size(), stream_);
}
void instance_counts::take(const part_hits &hits) {
  check(tally({.hits = hits.pairs, .n = hits.n, .counts_b = there_.data(), .of_instance = slots_}, stream_),
        "starting a kernel");
}
void instance_counts::download(device_result &) {
  there_.download(counts_.data(), stream_);
  check(cudaStreamSynchronize(stream_), "downloading counts");
}

} // namespace meetc::on_device
