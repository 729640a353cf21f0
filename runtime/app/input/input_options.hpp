// app/input/input_options.hpp: the options for reading and moving a file, one set for each of A and B.
#ifndef MEETC_APP_INPUT_INPUT_OPTIONS_HPP
#define MEETC_APP_INPUT_INPUT_OPTIONS_HPP

#include "meet/io/read.hpp"

#include <filesystem>
#include <optional>
#include <string>

namespace CLI {
class App;
}

namespace meetc::app {

// The options' values as they are on the command line.
struct input_arguments {
  std::optional<std::string> format, kind, scale, matrix, motor, translate;
};

// --format-a and --kind-a for the side 'a'; likewise for 'b'.
void add_reading(CLI::App &c, char side, input_arguments &to);
// --scale-a, --matrix-a or --motor-a, and --translate-a.
void add_moving(CLI::App &c, char side, input_arguments &to);

// Throws io::error that names the option.
io::read_options input_named(char side, const input_arguments &given);

// Throws failure if both files are standard input or one pipe, which can be read once.
void check_inputs(const std::filesystem::path &a, const std::filesystem::path &b);

} // namespace meetc::app

#endif
