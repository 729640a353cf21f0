// core/sets/posed_blocks.hpp: those blocks of a prepared set that may touch some boxes once it stands in a pose.
//
// The hierarchy stays that of the set's own frame: the box of a block is posed, which makes it larger, and is followed down
// only where it touches one of the boxes. The rows of the blocks that are left are moved as prepare() moves them, and have
// their own boxes.
#ifndef MEETC_CORE_SETS_POSED_BLOCKS_HPP
#define MEETC_CORE_SETS_POSED_BLOCKS_HPP

#include "meet/core/sets/element_set.hpp"

#include <span>
#include <vector>

namespace meetc {

// A finite box that holds the boxes of all elements in a pose, where without it they lie in `around`. Where a number might not
// be finite it is the widest box.
box posed_box(const pose &at, const box &around, float longest);

class posed_blocks {
public:
  // The pose is movable(). A block of which a number might not be finite is among them, wherever it lies.
  posed_blocks(const element_set &from, const pose &at, std::span<const box> near, std::stop_token stop = {});

  std::size_t elements() const { return elements_; }
  // Fills a set whose memory was taken for this number of elements. Returns the slot of the least element that is not finite
  // or breaks a rule of its kind, or elements(). `around` is the posed box of the whole set.
  std::size_t fill(element_set &set) const;

private:
  bool touches(const box &b) const;
  void mark(int at, std::size_t block);

  const element_set &from_;
  const pose &pose_;
  std::span<const box> near_;
  execution on_;                    // one thread
  std::vector<std::size_t> blocks_; // of level 0, ascending
  std::size_t elements_ = 0;
};

} // namespace meetc

#endif
