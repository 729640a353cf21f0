#include "meet/core/hierarchy/spatial_order.hpp"

#include "meet/core/threads/radix_sort.hpp"
#include "meetc/volume/hilbert.hpp"

#include <array>

namespace meetc {
namespace {

constexpr int cells = 1024; // along each axis: ten bits of thirty
constexpr int place_bits = 30;

// Hilbert's curve as a machine that reads the three bits of an octant of each cube in turn: its state says how the curve
// within that cube is turned. Two octants are read at once.
constexpr int two_octants = 64;
struct curve {
  static constexpr int states = 24; // the turns of a cube; the curve needs half of them
  using octants = std::array<std::uint8_t, 8>;
  std::array<std::array<std::uint16_t, two_octants>, states>
      steps{}; // six bits of the place, and above them the next state

  constexpr curve() {
    // The place of each octant, and how the curve within it is turned: the curve of the next finer cells tells.
    octants place{}, at{}, turn[8]{};
    for (std::uint32_t o = 0; o < 8; ++o)
      at[place[o] = place_of(o, 0, 1)] = static_cast<std::uint8_t>(o);
    for (std::uint32_t o = 0; o < 8; ++o)
      for (std::uint32_t within = 0; within < 8; ++within)
        turn[o][within] = at[place_of(o, within, 2) & 7];
    // A state is a turn: where each octant is on the curve that is not turned.
    octants turns[states]{{0, 1, 2, 3, 4, 5, 6, 7}};
    std::uint8_t next[states][8]{};
    int found = 1;
    for (int s = 0; s < found; ++s)
      for (std::uint32_t o = 0; o < 8; ++o) {
        octants t{};
        for (std::uint32_t within = 0; within < 8; ++within)
          t[within] = turn[turns[s][o]][turns[s][within]];
        int same = 0;
        while (same < found && turns[same] != t)
          ++same;
        turns[same] = t;
        found += same == found;
        next[s][o] = static_cast<std::uint8_t>(same);
      }
    for (int s = 0; s < found; ++s)
      for (std::uint32_t o = 0; o < two_octants; ++o) {
        const int between = next[s][o >> 3];
        const std::uint32_t first = place[turns[s][o >> 3]], second = place[turns[between][o & 7]];
        steps[s][o] = static_cast<std::uint16_t>(next[between][o & 7] << 6 | first << 3 | second);
      }
  }

  // The bits of the axes are taken in turn from `code`, the last axis first.
  std::uint32_t place(std::uint32_t code) const {
    std::uint32_t out = 0, state = 0;
    for (int shift = place_bits - 6; shift >= 0; shift -= 6) {
      const std::uint32_t step = steps[state][code >> shift & 63];
      out = out << 6 | (step & 63);
      state = step >> 6;
    }
    return out;
  }

private:
  static constexpr std::uint8_t place_of(std::uint32_t octant, std::uint32_t within, int bits) {
    std::uint32_t cell[3] = {};
    for (int k = 0; k < 3; ++k)
      cell[k] = bits == 1 ? octant >> k & 1 : (octant >> k & 1) << 1 | (within >> k & 1);
    return static_cast<std::uint8_t>(hilbert_place(cell[0], cell[1], cell[2], bits));
  }
};
constexpr curve hilbert;

// Ten bits, each moved to every third position.
std::uint32_t spread(std::uint32_t v) {
  v = (v | v << 16) & 0x030000ff;
  v = (v | v << 8) & 0x0300f00f;
  v = (v | v << 4) & 0x030c30c3;
  return (v | v << 2) & 0x09249249;
}

std::uint64_t key_of(const centre &c, std::uint32_t element, const centre_extent &e, double scale) {
  std::uint32_t code = 0;
  for (int k = 0; k < 3; ++k) {
    const double cell = (static_cast<double>(c.at[k]) - static_cast<double>(e.lo[k])) * scale;
    code |= spread(static_cast<std::uint32_t>(static_cast<std::int32_t>(std::min(cell, cells - 1.0)))) << k;
  }
  return std::uint64_t{hilbert.place(code)} << 32 | element;
}

constexpr auto place_of = [](std::uint64_t key) { return key >> 32; };

// Gives runs that share a cell and do not fit into a block a grid of their own. The extent shrinks by about 1024 each
// time, from at most 2^129 to at least 2^-150, so at most some thirty grids are nested.
void refine(const centre *centres, std::uint64_t *keys, std::uint64_t *scratch, std::size_t n, const execution &on) {
  for (std::size_t begin = 0, end; begin < n; begin = end) {
    if ((begin & 0xfff) == 0)
      on.go_on();
    for (end = begin + 1; end < n && keys[end] >> 32 == keys[begin] >> 32;)
      ++end;
    if (end - begin <= lanes)
      continue;
    centre_extent e;
    for_strips(on, end - begin, [&](std::size_t from, std::size_t to) {
      for (std::size_t i = from; i < to; ++i)
        e.add(centres[static_cast<std::uint32_t>(keys[begin + i])]);
    });
    if (!(e.size() > 0))
      continue;
    for_strips(on, end - begin, [&](std::size_t from, std::size_t to) {
      for (std::size_t i = begin + from; i < begin + to; ++i) {
        const auto element = static_cast<std::uint32_t>(keys[i]);
        keys[i] = key_of(centres[element], element, e, cells / e.size());
      }
    });
    radix_sort(keys + begin, scratch, end - begin, place_bits, place_of, on);
    refine(centres, keys + begin, scratch, end - begin, on);
  }
}

} // namespace

void spatial_order(const centre *centres, const std::uint32_t *list, const centre_extent &all, std::size_t n,
                   std::uint64_t *keys, std::uint64_t *scratch, const execution &on) {
  const double scale = all.size() > 0 ? cells / all.size() : 0;
  constexpr std::size_t least_part = 4096;
  const std::size_t part = std::max(least_part, (n + most_sort_parts - 1) / most_sort_parts);
  for_chunks(on, n, least_part, [&](int, std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const std::uint32_t element = list ? list[i] : static_cast<std::uint32_t>(i);
      scratch[i] = key_of(centres[element], element, all, scale);
    }
  });
  radix_sort_parts(
      (n + part - 1) / part,
      [&](std::size_t p, const auto &visit) { visit(scratch + p * part, std::min(part, n - p * part)); }, keys,
      place_bits, on, place_of, [&](int, std::size_t begin, std::size_t) { return scratch + begin; },
      [&](std::size_t begin, std::size_t some, std::uint64_t *room) { refine(centres, keys + begin, room, some, on); });
}

} // namespace meetc
