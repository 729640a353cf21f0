#include "core/prepared.hpp"

#include "core/stored.hpp"
#include "core/threads.hpp"

#include <algorithm>

namespace meetc {

prepared::prepared() = default;
prepared::prepared(prepared &&) noexcept = default;
prepared &prepared::operator=(prepared &&) noexcept = default;
prepared::~prepared() = default;
const kind_info &prepared::kind() const {
  return *set_->kind;
}
std::size_t prepared::elements() const {
  return set_->elements;
}

void prepared::bounds(float lo[3], float hi[3]) const {
  box b{{1, 1, 1}, {-1, -1, -1}};
  if (set_->boxes.depth > 0)
    b = set_->boxes.top().blocks[0].around();
  std::copy_n(b.lo, 3, lo);
  std::copy_n(b.hi, 3, hi);
}

stored_rows *prepared::stored(const stored_values &values, const kind_info &of) const {
  const bool any = &of == &kind() && values.number >= 0 && values.number < kind().stored;
  return any ? &stored_[static_cast<std::size_t>(values.number)] : nullptr;
}

prepared prepare(const view &elements, const kind_info &kind, const pose &at, int threads) {
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
  const status s = fill(*p.set_, elements, at, scratch, thread_count(threads));
  if (s == status::bad_index || s == status::bad_value)
    throw input_error(check(elements, kind, at), kind);
  if (s != status::ok)
    throw std::invalid_argument(text(s));
  p.stored_ = std::make_unique<stored_rows[]>(static_cast<std::size_t>(kind.stored));
  return p;
}

} // namespace meetc
