// core/sets/prepared.hpp: a set that is ready to collide and owns its memory.
#ifndef MEETC_CORE_SETS_PREPARED_HPP
#define MEETC_CORE_SETS_PREPARED_HPP

#include "meet/core/threads/cancelled.hpp"
#include "meet/core/views/check.hpp"
#include "meet/core/views/memory.hpp"
#include "meet/core/views/pose.hpp"
#include "meet/core/views/usage_error.hpp"
#include "meet/core/views/view.hpp"

#include <cstddef>
#include <memory>
#include <span>
#include <stdexcept>
#include <stop_token>

namespace meetc {

// The exception for a bad element.
class input_error : public std::invalid_argument {
public:
  // `before` is put in front of the text.
  input_error(const fault &f, const kind_info &kind, const std::string &before = {})
      : std::invalid_argument(before + describe(f, kind)), where(f) {}
  input_error(const fault &f, const std::string &text) : std::invalid_argument(text), where(f) {}
  fault where;
};

struct box;
struct element_set;
struct execution;
struct normalised_set;
struct set_topology;
class kept_topology;
class normalisation;
class stored_rows;
class stored_table;

// Packed rows of kind().fields floats in spatial order, boxes and hierarchy. It is immutable, and several calls may use
// it at once. A prepared() that was moved from, or made from nothing, holds no set; it may only be assigned to or destroyed.
class prepared {
public:
  prepared(prepared &&) noexcept;
  prepared &operator=(prepared &&) noexcept;
  ~prepared();

  const kind_info &kind() const;
  std::size_t elements() const;
  // The closed box around all elements: finite, in the units of their coordinates; lo > hi for the empty set.
  void bounds(float lo[3], float hi[3]) const;
  const element_set &set() const { return *set_; }
  // Whether it was prepared for collisions with `other` (and, if it is whole, with any set).
  bool fits(const prepared &other) const {
    return counterpart_ == 0 || counterpart_ == other.number_ || counterpart_ == several;
  }
  // Whether it holds all elements.
  bool whole() const { return counterpart_ == 0; }
  // Where the values that a predicate reads beside the rows are kept. Null if it reads none, or if `of`, the kind for
  // which they are computed, is not kind() itself: two catalogues may number such values differently.
  stored_rows *stored(const stored_values &values, const kind_info &of) const;
  // The set times 2^power; null where it is not to be had (core/sets/normalised.hpp).
  std::shared_ptr<const normalised_set> normalised(int power, const std::stop_token &stop = {}) const;
  // The set is whole. Found when first asked for (core/sets/topology.hpp).
  const set_topology &topology(const std::stop_token &stop = {}) const;

  prepared(); // holds nothing

private:
  friend class moving_set;
  friend prepared prepare(const view &, const kind_info &, const pose &, int, const prepared *,
                          const std::stop_token &);
  friend prepared posed(const prepared &, const pose &, std::span<const box>, prepared, const std::stop_token &);
  static constexpr std::uint64_t several = ~std::uint64_t{0}; // for sets that the caller knows
  static prepared of(const prepared &body, const pose &, std::span<const box> near, prepared &spare,
                     const std::stop_token &stop);
  static prepared of(const view &, const kind_info &, const pose &, const execution &on, const prepared *counterpart);
  // Takes the memory of `spare` where that suffices, and a set from it.
  void take(prepared &spare, const kind_info &kind, std::size_t elements);
  // The set is filled, and is of so many elements of the caller.
  void finish(std::size_t elements, std::uint64_t counterpart);
  std::size_t elements_ = 0, room_ = 0;        // the bytes that are held
  std::uint64_t number_ = 0, counterpart_ = 0; // of this set, and of the one that it was prepared for; 0: for any
  owned_memory bytes_;
  std::unique_ptr<element_set> set_;
  std::unique_ptr<stored_table> stored_;
  std::unique_ptr<normalisation> normalised_;
  std::unique_ptr<kept_topology> topology_;
};

// Throws input_error for a view of one bad element, which is `element` of the caller.
[[noreturn]] void refuse(const view &one, std::size_t element, const kind_info &kind, const pose &at);

// Copies the elements in the pose, on this number of threads (0: all cores). A set without elements is allowed. With
// `counterpart`, the result is for collisions with that set alone: elements whose boxes do not touch its boxes are checked, but
// neither copied nor ordered, and answers are still about all elements. This pays where one set is far larger or reaches
// farther than the other. Throws input_error (an index beyond the vertices, a value that is not finite, a broken rule of the
// kind, a view with null data or too short a stride), usage_error (a kind that cannot be moved), std::length_error
// (2^32 elements or more), std::bad_alloc, or `cancelled` soon after `stop` was asked to.
prepared prepare(const view &elements, const kind_info &kind, const pose &at = {}, int threads = 0,
                 const prepared *counterpart = nullptr, const std::stop_token &stop = {});

// The same elements in a pose, in the order of `body` and without ordering them again, for collisions with sets whose bounds
// lie in one of the boxes `near`: it holds the blocks of sixteen elements that may touch these. Rows are those that prepare()
// computes from the rows of `body` in the pose, bit for bit; answers are about all elements. bounds() is a box that may be
// larger than the elements. `body` is whole. The memory of `spare`, which nobody uses any more, serves again where it suffices.
// Throws as prepare() does; the fault names the element.
prepared posed(const prepared &body, const pose &at, std::span<const box> near, prepared spare = {},
               const std::stop_token &stop = {});

} // namespace meetc

#endif
