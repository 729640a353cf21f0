#include "meet/core/sets/prepared.hpp"

#include "meet/core/sets/normalised.hpp"
#include "meet/core/threads/threads.hpp"

#include <algorithm>
#include <atomic>

namespace meetc {

prepared::prepared() = default;
prepared::prepared(prepared &&) noexcept = default;
prepared &prepared::operator=(prepared &&) noexcept = default;
prepared::~prepared() = default;
const kind_info &prepared::kind() const {
  return *set_->kind;
}
std::size_t prepared::elements() const {
  return elements_;
}

void prepared::bounds(float lo[3], float hi[3]) const {
  std::copy_n(set_->around.lo, 3, lo);
  std::copy_n(set_->around.hi, 3, hi);
}

stored_rows *prepared::stored(const stored_values &values, const kind_info &of) const {
  return stored_->of(values, of);
}
std::shared_ptr<const normalised_set> prepared::normalised(int power) const {
  return under_standard_word([&] { return normalised_->of(*set_, power); });
}

prepared prepared::of(const view &elements, const kind_info &kind, const pose &at, int threads,
                      const prepared *counterpart) {
  static std::atomic<std::uint64_t> prepared_sets{0};
  if (elements.elements > 0xffffffff)
    throw std::length_error(text(status::too_many_elements));
  bump_allocator set_need, scratch_need;
  take_set(set_need, kind, elements.elements);
  take_scratch(scratch_need, kind, elements.elements);

  prepared p;
  p.bytes_ = allocate(set_need.bytes());
  const owned_memory scratch_bytes = allocate(scratch_need.bytes());
  bump_allocator from({p.bytes_.get(), set_need.bytes()}), scratch_from({scratch_bytes.get(), scratch_need.bytes()});
  p.set_ = std::make_unique<element_set>(take_set(from, kind, elements.elements));
  const set_scratch scratch = take_scratch(scratch_from, kind, elements.elements);
  const status s =
      fill(*p.set_, elements, at, scratch, thread_count(threads), counterpart ? &counterpart->set() : nullptr);
  if (s == status::bad_view || s == status::bad_index || s == status::bad_value)
    throw input_error(check(elements, kind, at), kind);
  if (s != status::ok)
    throw std::invalid_argument(text(s));
  p.elements_ = elements.elements;
  p.number_ = ++prepared_sets;
  p.counterpart_ = counterpart ? counterpart->number_ : 0;
  p.stored_ = std::make_unique<stored_table>(kind);
  p.normalised_ = std::make_unique<normalisation>();
  return p;
}

prepared prepare(const view &elements, const kind_info &kind, const pose &at, int threads,
                 const prepared *counterpart) {
  return under_standard_word([&] { return prepared::of(elements, kind, at, threads, counterpart); });
}

} // namespace meetc
