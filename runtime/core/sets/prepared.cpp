#include "meet/core/sets/prepared.hpp"

#include "meet/core/sets/normalised.hpp"
#include "meet/core/sets/posed_blocks.hpp"
#include "meet/core/sets/topology.hpp"
#include "meet/core/threads/threads.hpp"

#include <algorithm>
#include <atomic>
#include <utility>

namespace meetc {
namespace {

std::uint64_t next_number() {
  static std::atomic<std::uint64_t> prepared_sets{0};
  return ++prepared_sets;
}

} // namespace

void refuse(const view &one, std::size_t element, const kind_info &kind, const pose &at) {
  fault f = check(one, kind, at);
  f.element = element;
  throw input_error(f, kind);
}

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
std::shared_ptr<const normalised_set> prepared::normalised(int power, const std::stop_token &stop) const {
  return under_standard_word([&] { return normalised_->of(*set_, power, {1, stop}); });
}
const set_topology &prepared::topology(const std::stop_token &stop) const {
  return under_standard_word([&]() -> const set_topology & { return topology_->of(*set_, {1, stop}); });
}

prepared prepared::of(const view &elements, const kind_info &kind, const pose &at, const execution &on,
                      const prepared *counterpart) {
  if (elements.elements > 0xffffffff)
    throw std::length_error(text(status::too_many_elements));
  bump_allocator set_need, scratch_need;
  take_set(set_need, kind, elements.elements);
  take_scratch(scratch_need, kind, elements.elements);

  prepared p;
  p.bytes_ = allocate(set_need.bytes());
  p.room_ = set_need.bytes();
  const owned_memory scratch_bytes = allocate(scratch_need.bytes());
  bump_allocator from({p.bytes_.get(), set_need.bytes()}), scratch_from({scratch_bytes.get(), scratch_need.bytes()});
  p.set_ = std::make_unique<element_set>(take_set(from, kind, elements.elements));
  const set_scratch scratch = take_scratch(scratch_from, kind, elements.elements);
  const status s = fill(*p.set_, elements, at, scratch, on, counterpart ? &counterpart->set() : nullptr);
  if (s == status::bad_view || s == status::bad_index || s == status::bad_value)
    throw input_error(check(elements, kind, at), kind);
  if (s != status::ok)
    throw usage_error(text(s));
  p.finish(elements.elements, counterpart ? counterpart->number_ : 0);
  return p;
}

prepared prepared::of(const prepared &body, const pose &at, std::span<const box> near, prepared &spare,
                      const std::stop_token &stop) {
  const element_set &from = body.set();
  const kind_info &kind = body.kind();
  if (!body.whole())
    throw usage_error("a body must hold all of its elements");
  if (const status s = movable(kind, at); s != status::ok)
    throw usage_error(text(s));
  const posed_blocks blocks(from, at, near, stop);
  prepared p;
  p.take(spare, kind, blocks.elements());
  if (const std::size_t bad = blocks.fill(*p.set_); bad < blocks.elements()) {
    const std::uint32_t element = p.set_->order[bad];
    view one;
    const std::size_t slot =
        static_cast<std::size_t>(std::find(from.order, from.order + from.elements, element) - from.order);
    one.data = from.rows + slot * static_cast<std::size_t>(kind.fields);
    one.elements = 1;
    refuse(one, element, kind, at);
  }
  p.finish(body.elements_, several);
  return p;
}

void prepared::take(prepared &spare, const kind_info &kind, std::size_t elements) {
  bump_allocator need;
  take_set(need, kind, elements);
  bytes_ = std::move(spare.bytes_);
  room_ = std::exchange(spare.room_, 0);
  if (room_ < need.bytes()) {
    bytes_ = nullptr;
    bytes_ = allocate(need.bytes());
    room_ = need.bytes();
  }
  bump_allocator from({bytes_.get(), room_});
  set_ = std::make_unique<element_set>(take_set(from, kind, elements));
}

void prepared::finish(std::size_t elements, std::uint64_t counterpart) {
  elements_ = elements;
  number_ = next_number();
  counterpart_ = counterpart;
  stored_ = std::make_unique<stored_table>(kind());
  normalised_ = std::make_unique<normalisation>();
  topology_ = std::make_unique<kept_topology>();
}

prepared posed(const prepared &body, const pose &at, std::span<const box> near, prepared spare,
               const std::stop_token &stop) {
  return under_standard_word([&] { return prepared::of(body, at, near, spare, stop); });
}

prepared prepare(const view &elements, const kind_info &kind, const pose &at, int threads, const prepared *counterpart,
                 const std::stop_token &stop) {
  return under_standard_word(
      [&] { return prepared::of(elements, kind, at, execution_on(threads, stop), counterpart); });
}

} // namespace meetc
