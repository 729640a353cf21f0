// picture/palette.hpp: the colours of all pictures, charts, coloured meshes and pages.
//
// Colours that stand beside each other differ for readers with any of the three dichromacies as well: the tests simulate
// these (Machado, Oliveira, Fernandes: A physiologically-based model for simulation of color vision deficiency, 2009).
#ifndef MEETC_PICTURE_PALETTE_HPP
#define MEETC_PICTURE_PALETTE_HPP

#include <array>
#include <cstdint>
#include <string>

namespace meetc::picture {

struct colour {
  std::uint8_t r, g, b;
  friend bool operator==(const colour &, const colour &) = default;
};

namespace palette {

inline constexpr std::array<colour, 3> calm{{{196, 184, 160}, {126, 152, 188}, {150, 130, 126}}}; // of sets and bodies
inline constexpr colour yellow{255, 214, 0};   // hit elements of the first set, and bodies that touch
inline constexpr colour vermilion{222, 60, 0}; // hit elements of the second
inline constexpr colour contact{0, 60, 220};   // where elements meet
inline constexpr colour ink{44, 48, 54};       // words
inline constexpr colour paper{252, 252, 251};  // behind charts
inline constexpr colour line{222, 225, 228};   // grids of charts
inline constexpr colour thin_line{240, 241, 242};

// Curves and marks of charts.
inline constexpr std::array<colour, 4> series{{{20, 70, 200}, {200, 60, 0}, {0, 155, 120}, {175, 80, 185}}};

// Shares from 0 to 1, ever darker.
struct stop {
  double at;
  colour ink;
};
inline constexpr std::array<stop, 6> shares{{{0, {242, 245, 247}},
                                             {0.001, {254, 232, 160}},
                                             {0.05, {254, 196, 79}},
                                             {0.25, {240, 140, 40}},
                                             {0.6, {200, 76, 2}},
                                             {1, {90, 30, 4}}}};

} // namespace palette

// As #rrggbb.
std::string hexadecimal(colour c);

} // namespace meetc::picture

#endif
