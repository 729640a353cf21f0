// core/device/answers/element_numbers.hpp: flags and counts of elements, which are marked on the device, and counts of
// instances.
#ifndef MEETC_CORE_DEVICE_ANSWERS_ELEMENT_NUMBERS_HPP
#define MEETC_CORE_DEVICE_ANSWERS_ELEMENT_NUMBERS_HPP

#include "meet/core/device/answers/query_answer.hpp"
#include "meet/core/device/memory/memory.hpp"

#include <span>

namespace meetc::on_device {

// Numbers that are 0 at first, in device memory.
template <class T> class tallied_numbers {
public:
  void start(std::size_t n, cudaStream_t stream);
  T *data() const { return there_.data(); }
  // Enqueues; `to` has as many elements.
  template <class To> void download(To *to, cudaStream_t stream) const;

private:
  device_memory<T> there_;
  std::size_t n_ = 0;
};

// A number for each element of both sets.
template <class T> class element_numbers : public query_answer {
public:
  void start(const queried_sets &sets) override;

protected:
  template <class To> per_element<To> numbers() const; // waits
  const queried_sets &sets() const { return *sets_; }
  tallied_numbers<T> a_, b_;

private:
  std::optional<queried_sets> sets_;
};

// 1 for each element that is in a pair.
class element_flags final : public element_numbers<std::uint8_t> {
public:
  void take(const part_hits &hits) override;
  void download(device_result &r) override;
};

// The number of pairs that each element is in.
class element_counts final : public element_numbers<unsigned long long> {
public:
  void take(const part_hits &hits) override;
  void download(device_result &r) override;
};

// The number of pairs of each instance, where B is instances of equally many elements, one after another.
class instance_counts final : public query_answer {
public:
  explicit instance_counts(std::span<std::uint64_t> counts) : counts_(counts) {} // a number for each instance
  void start(const queried_sets &sets) override;
  void take(const part_hits &hits) override;
  void download(device_result &r) override;

private:
  std::span<std::uint64_t> counts_;
  cudaStream_t stream_ = nullptr;
  std::uint32_t slots_ = 0; // of an instance
  tallied_numbers<unsigned long long> there_;
};

} // namespace meetc::on_device

#endif
