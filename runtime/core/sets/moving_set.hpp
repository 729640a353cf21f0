// core/sets/moving_set.hpp: a set whose elements move, and which is refitted where they move.
//
// Rows and boxes are made anew in the order in which the elements were last put, so that moving costs a part of preparing. All
// answers are those of a set that is prepared from the moved elements; only the time of a query depends on the order. It grows
// as elements leave their neighbours, which looseness() tells.
#ifndef MEETC_CORE_SETS_MOVING_SET_HPP
#define MEETC_CORE_SETS_MOVING_SET_HPP

#include "meet/core/sets/prepared.hpp"

#include <vector>

namespace meetc {

struct magnitudes;

// It holds two sets: update() fills the one that is not in use, and a call that throws leaves the other as it was. One thread
// at a time may change it, while none uses what now() has returned; else several may use that.
class moving_set {
public:
  // Prepares the elements, and throws as prepare() does. The index is copied.
  moving_set(const view &elements, const kind_info &kind, const pose &at = {}, int threads = 0,
             const std::stop_token &stop = {});

  // The same elements in other places: as many elements and vertices as at first. An index is not read again: elements keep
  // their vertices. Throws as prepare() does, and usage_error for another number of elements or vertices, or for
  // an index where there was none.
  void update(const view &moved, const pose &at = {}, int threads = 0, const std::stop_token &stop = {});
  // The same, and puts them in order again, as prepare() does and in its time.
  void reorder(const view &moved, const pose &at = {}, int threads = 0, const std::stop_token &stop = {});

  // The set as it lies now; the next change ends it.
  const prepared &now() const { return now_; }
  operator const prepared &() const { return now_; } // NOLINT: a moving set goes where a prepared one does

  // How much larger the boxes around sixteen neighbours are, beside those of elements, than when they were put in order: 1
  // then, and about 1 while neighbours stay neighbours. Where each sixteen were one point, it is infinite once they part.
  double looseness() const;

private:
  void require_alike(const view &moved) const;
  void put_in_order(const view &elements, const kind_info &kind, const pose &at, int threads,
                    const std::stop_token &stop);
  prepared refitted(const view &moved, const pose &at, const execution &on);
  bool pose_points(const view &moved, const pose &at, magnitudes &most, const execution &on);
  std::vector<std::uint32_t> index_by_slot() const;
  [[noreturn]] void refuse_least(const view &moved, const pose &at) const;

  // With an index: the vertices that elements have, in the order of slots, where they lie, and the index of these by slot.
  std::size_t vertices_ = 0;
  std::vector<std::uint32_t> used_, index_;
  std::vector<float> points_;
  prepared now_, spare_;
  double spread_ = 0; // when the elements were put in order
};

} // namespace meetc

#endif
