#include "meet/core/query/corner_numbers.hpp"

#include "meet/core/answers/answers.hpp"
#include "meet/core/query/common_corners.hpp"
#include "meet/core/views/numbered.hpp"

#include <algorithm>
#include <stdexcept>

namespace meetc {
namespace {

// Numbers for vertices, in the order in which they are asked, so that neighbours in space have near numbers.
class numbering {
public:
  numbering(const element_set &set, std::size_t vertices, bool merge, const execution &on)
      : rows_(set.rows), merge_(merge), numbers_(vertices, no_element),
        points_(merge ? std::min(vertices, 3 * set.elements) : 0, on) {}

  // The number of a vertex, which is a corner at this place in the rows.
  std::uint32_t of(std::uint32_t vertex, std::uint32_t place) {
    std::uint32_t &number = numbers_[vertex];
    if (number == no_element)
      number = merge_ ? points_.number(key_of_point(rows_ + std::size_t{3} * place)) : next_++;
    return number;
  }

private:
  const float *rows_;
  bool merge_;
  std::vector<std::uint32_t> numbers_; // by vertex
  numbered<std::uint32_t, 3> points_;
  std::uint32_t next_ = 0;
};

} // namespace

corner_numbers numbers_of_corners(const element_set &set, const view &elements, bool merge, const execution &on) {
  const std::size_t vertices = elements.index ? elements.vertices : 3 * set.elements;
  if (3 * set.elements > no_element)
    throw std::length_error("a mesh with itself has fewer than 2^32 corners");
  corner_numbers out(set.elements);
  for_chunks(on, set.elements, 4096, [&](int, std::size_t begin, std::size_t end) {
    for (std::size_t slot = begin; slot < end; ++slot)
      for (std::size_t c = 0; c < 3; ++c) {
        const std::size_t corner = std::size_t{3} * set.order[slot] + c;
        out[slot][c] = elements.index ? elements.index[corner] : static_cast<std::uint32_t>(corner);
        if (out[slot][c] >= vertices)
          throw std::out_of_range("the index names a vertex that is not there");
      }
  });
  numbering number(set, vertices, merge, on);
  for_strips(on, set.elements, [&](std::size_t begin, std::size_t end) {
    for (std::size_t slot = begin; slot < end; ++slot)
      for (std::size_t c = 0; c < 3; ++c)
        out[slot][c] = number.of(out[slot][c], static_cast<std::uint32_t>(3 * slot + c));
  });
  return out;
}

corner_stars::corner_stars(const corner_numbers &corners, const execution &on) {
  std::uint32_t most = 0;
  for (const auto &three : corners)
    most = std::max({most, three[0], three[1], three[2]});
  begin_.assign(corners.empty() ? 1 : most + std::size_t{2}, 0);
  for_strips(on, corners.size(), [&](std::size_t first, std::size_t end) {
    for (std::size_t slot = first; slot < end; ++slot)
      for (int i = 0; i < 3; ++i)
        begin_[corners[slot][static_cast<std::size_t>(i)] + std::size_t{1}] += is_first(corners[slot].data(), i);
  });
  for (std::size_t n = 1; n < begin_.size(); ++n)
    begin_[n] += begin_[n - 1];
  slots_.resize(begin_.back());
  std::vector<std::uint32_t> next = begin_;
  for_strips(on, corners.size(), [&](std::size_t first, std::size_t end) {
    for (std::size_t slot = first; slot < end; ++slot)
      for (int i = 0; i < 3; ++i)
        if (is_first(corners[slot].data(), i))
          slots_[next[corners[slot][static_cast<std::size_t>(i)]]++] = static_cast<std::uint32_t>(slot);
  });
}

} // namespace meetc
