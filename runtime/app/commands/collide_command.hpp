// app/commands/collide_command.hpp: `meet collide` finds the elements of two files that touch.
#ifndef MEETC_APP_COMMANDS_COLLIDE_COMMAND_HPP
#define MEETC_APP_COMMANDS_COLLIDE_COMMAND_HPP

#include "meet/app/commands/command.hpp"
#include "meet/app/input/picture_options.hpp"
#include "meet/app/query/choose.hpp"
#include "meet/app/query/device_pairs.hpp"
#include "meet/io/read.hpp"
#include "meetc/support.hpp"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace meetc::app {

struct collide_request {
  std::filesystem::path a, b;
  std::optional<std::string> predicate, mode;
  rung precision = rung::certified;
  double tolerance = 0; // 0: no answer may be wrong
  io::read_options read_a, read_b;
  bool any = false, json = false, fail_on_touch = false;
  bool self = false, merge = true; // A with itself; its corners with equal coordinates are one
  std::optional<std::filesystem::path> pairs, first, contacts, colour, image, page;
  bool contacts_float64 = false, contacts_embedded = false;
  picture_view view;                 // of the image
  std::vector<std::string> evaluate; // a formula and the file for its values, or none
  int threads = 0;
  int devices = 1;
  processor on = processor::cpu;
};

// Writes the requested files and returns the text for standard output; with fail_on_touch the exit code is check_failed where
// something touches. If a set leaves the scene's box, a line on standard error warns of it. Throws io::error.
printed collide(const catalogue &all, const catalogue &neighbours, const collide_request &request);

// The command and its options. `neighbours` has the predicates of `--self`.
command add_collide(CLI::App &program, const kernel_library &all, const kernel_library &neighbours);

} // namespace meetc::app

#endif
