#include "meet/core/query/corner_numbers.hpp"

#include "meet/core/answers/answers.hpp"
#include "meet/core/threads/threads.hpp"

#include <bit>
#include <cstring>
#include <stdexcept>

namespace meetc {
namespace {

constexpr std::uint32_t none = no_element;

// The coordinates of a point as bits, in which 0 and -0 are the same.
std::array<std::uint32_t, 3> bits_of(const float *point) {
  std::array<std::uint32_t, 3> out;
  for (std::size_t k = 0; k < 3; ++k) {
    const float x = point[k] == 0 ? 0.0F : point[k];
    std::memcpy(&out[k], &x, sizeof x);
  }
  return out;
}

std::uint64_t hash_of(const std::array<std::uint32_t, 3> &bits) {
  std::uint64_t h = 0;
  for (const std::uint32_t b : bits)
    h = (std::rotl(h, 25) ^ b) * 0x9e3779b97f4a7c15;
  return h ^ h >> 32;
}

// Numbers for vertices, in the order in which they are asked, so that neighbours in space have near numbers.
class numbering {
public:
  numbering(const element_set &set, std::size_t vertices, bool merge)
      : rows_(set.rows), merge_(merge), numbers_(vertices, none) {
    places_.reserve(std::min(vertices, 3 * set.elements));
    if (merge)
      table_.assign(std::bit_ceil(2 * places_.capacity() + 1), none);
  }

  // The number of a vertex, which is a corner at this place in the rows.
  std::uint32_t of(std::uint32_t vertex, std::uint32_t place) {
    std::uint32_t &number = numbers_[vertex];
    if (number == none)
      number = merge_ ? merged(place) : fresh(place);
    return number;
  }

private:
  std::uint32_t fresh(std::uint32_t place) {
    places_.push_back(place);
    return static_cast<std::uint32_t>(places_.size() - 1);
  }
  // By a hash table with open addresses.
  std::uint32_t merged(std::uint32_t place) {
    const std::array<std::uint32_t, 3> bits = bits_of(rows_ + std::size_t{3} * place);
    std::size_t at = hash_of(bits) & (table_.size() - 1);
    while (table_[at] != none && bits_of(rows_ + std::size_t{3} * places_[table_[at]]) != bits)
      at = (at + 1) & (table_.size() - 1);
    if (table_[at] == none)
      table_[at] = fresh(place);
    return table_[at];
  }

  const float *rows_;
  bool merge_;
  std::vector<std::uint32_t> numbers_; // by vertex
  std::vector<std::uint32_t> places_;  // by number: the place of one of its corners
  std::vector<std::uint32_t> table_;   // numbers
};

} // namespace

corner_numbers numbers_of_corners(const element_set &set, const view &elements, bool merge, int threads) {
  const std::size_t vertices = elements.index ? elements.vertices : 3 * set.elements;
  if (3 * set.elements > none)
    throw std::length_error("a mesh with itself has fewer than 2^32 corners");
  corner_numbers out(set.elements);
  for_chunks(threads, set.elements, 4096, [&](int, std::size_t begin, std::size_t end) {
    for (std::size_t slot = begin; slot < end; ++slot)
      for (std::size_t c = 0; c < 3; ++c) {
        const std::size_t corner = std::size_t{3} * set.order[slot] + c;
        out[slot][c] = elements.index ? elements.index[corner] : static_cast<std::uint32_t>(corner);
        if (out[slot][c] >= vertices)
          throw std::out_of_range("the index names a vertex that is not there");
      }
  });
  numbering number(set, vertices, merge);
  for (std::size_t slot = 0; slot < set.elements; ++slot)
    for (std::size_t c = 0; c < 3; ++c)
      out[slot][c] = number.of(out[slot][c], static_cast<std::uint32_t>(3 * slot + c));
  return out;
}

corner_stars::corner_stars(const corner_numbers &corners) {
  std::uint32_t most = 0;
  for (const auto &three : corners)
    most = std::max({most, three[0], three[1], three[2]});
  begin_.assign(corners.empty() ? 1 : most + std::size_t{2}, 0);
  for (const auto &three : corners)
    for (int i = 0; i < 3; ++i)
      begin_[three[static_cast<std::size_t>(i)] + std::size_t{1}] += is_first(three, i);
  for (std::size_t n = 1; n < begin_.size(); ++n)
    begin_[n] += begin_[n - 1];
  slots_.resize(begin_.back());
  std::vector<std::uint32_t> next = begin_;
  for (std::size_t slot = 0; slot < corners.size(); ++slot)
    for (int i = 0; i < 3; ++i)
      if (is_first(corners[slot], i))
        slots_[next[corners[slot][static_cast<std::size_t>(i)]]++] = static_cast<std::uint32_t>(slot);
}

} // namespace meetc
