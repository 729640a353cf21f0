// app/input/option_values.hpp: reads the values of options that several commands share.
#ifndef MEETC_APP_INPUT_OPTION_VALUES_HPP
#define MEETC_APP_INPUT_OPTION_VALUES_HPP

#include <array>
#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace meetc::app {

inline constexpr const char *files_help =
    "A mesh (.ply, .obj, .off, .stl), or a .csv whose first line names columns: "
    "x,y,z,r spheres; x0,y0,z0,x1,y1,z1 segments; x,y,z points; "
    "low_x,low_y,low_z,high_x,high_y,high_z boxes along the axes. "
    "- is standard input, for one file. A mesh without faces gives its lines as segments, or its points";

// The value of --threads, from 0 (all cores) to the maximum of the core. Throws failure.
int threads_named(const std::string &text);

// A number of devices, from 1 on. Throws failure.
int devices_named(const std::string &text);

// A number from 0 on. Throws failure that names the option.
double length_named(const char *option, const std::string &text);

// Reads numbers, separated by commas or blanks. Throws failure that names the option.
std::vector<double> number_list(const char *option, std::string text);
// Reads exactly to.size() of them.
void read_numbers(const char *option, const std::string &text, std::span<double> to);

template <std::size_t N> std::array<double, N> numbers(const char *option, const std::string &text) {
  std::array<double, N> out{};
  read_numbers(option, text, out);
  return out;
}

} // namespace meetc::app

#endif
