#include "meet/app/input/input_options.hpp"

#include "meet/app/input/failure.hpp"
#include "meet/app/input/matrix.hpp"
#include "meet/app/input/motor.hpp"
#include "meet/app/input/option_values.hpp"
#include "meet/io/files/file_bytes.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <utility>

namespace meetc::app {

namespace {

std::string option(const char *what, char side) {
  return fmt::format("--{}-{}", what, side);
}

char letter(char side) {
  return side == 'a' ? 'A' : 'B';
}

// A motor of any length; see motor.hpp.
std::array<double, 12> motor_named(const std::string &option, const std::string &text) {
  const std::vector<double> v = number_list(option.c_str(), text);
  std::array<double, 8> motor{};
  if (v.size() != motor.size())
    throw failure(fmt::format("{}: 8 numbers expected, with commas between them, {} given", option, v.size()));
  if (std::all_of(v.begin(), v.begin() + 4, [](double x) { return x == 0; }))
    throw failure(fmt::format("{}: the scalar and the rotation are 0, so this is no motion", option));
  std::copy_n(v.begin(), motor.size(), motor.begin());
  return matrix_of_motor(motor);
}

} // namespace

void add_reading(CLI::App &c, char side, input_arguments &to) {
  c.add_option(option("format", side), to.format, fmt::format("The format of {}, whatever its name says", letter(side)))
      ->type_name("ply|obj|off|stl|csv");
  c.add_option(option("kind", side), to.kind,
               fmt::format("The kind of element to take from {}, if it holds several", letter(side)))
      ->type_name("KIND");
}

void add_moving(CLI::App &c, char side, input_arguments &to) {
  c.add_option(option("scale", side), to.scale,
               fmt::format("Multiply {} by s first: coordinates and radii", letter(side)))
      ->type_name("s");
  CLI::Option *const matrix = c.add_option(
      option("matrix", side), to.matrix,
      fmt::format("Then move {} by m00,m01,..,m23: 12 numbers, row-major 3x4, or 16, 4x4; for spheres a similarity",
                  letter(side)));
  matrix->type_name("NUMBERS");
  c.add_option(
       option("motor", side), to.motor,
       fmt::format("Or move {} by a motor on 1,e23,e31,e12,e01,e02,e03,e0123, where planes are vectors; of any length",
                   letter(side)))
      ->type_name("NUMBERS")
      ->excludes(matrix);
  c.add_option(option("translate", side), to.translate, fmt::format("Then move {} by x,y,z", letter(side)))
      ->type_name("x,y,z");
}

io::read_options input_named(char side, const input_arguments &given) {
  io::read_options out;
  out.move.side = side;
  if (given.format)
    out.format = io::format_named(option("format", side), *given.format);
  if (given.kind)
    out.kind = *given.kind;
  if (given.scale)
    out.move.scale = numbers<1>(option("scale", side).c_str(), *given.scale)[0];
  if (given.matrix) {
    const std::string name = option("matrix", side);
    out.move.matrix = matrix_of(number_list(name.c_str(), *given.matrix), name);
  }
  if (given.motor)
    out.move.matrix = motor_named(option("motor", side), *given.motor);
  if (given.translate)
    out.move.translate = numbers<3>(option("translate", side).c_str(), *given.translate);
  out.move.check();
  return out;
}

void check_inputs(const std::filesystem::path &a, const std::filesystem::path &b) {
  std::error_code code;
  if (io::is_standard_input(a) && io::is_standard_input(b))
    throw failure("only one of A and B can be standard input");
  if (std::filesystem::equivalent(a, b, code) && std::filesystem::is_fifo(a, code))
    throw failure(fmt::format("{}: A and B are one pipe, which can be read once", a.string()));
}

} // namespace meetc::app
