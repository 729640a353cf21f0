// app/output/report.hpp: the answer of `meet collide` as text and as JSON.
#ifndef MEETC_APP_OUTPUT_REPORT_HPP
#define MEETC_APP_OUTPUT_REPORT_HPP

#include "meet/app/output/contact_files.hpp"
#include "meet/app/query/collide_sets.hpp"
#include "meet/io/elements/element_set.hpp"

#include <optional>
#include <string>
#include <vector>

namespace meetc::app {

struct collide_report {
  std::string name_a, name_b; // of the files
  const io::element_set &a, &b;
  const query &asked;
  const answers &found;
  bool same_file = false, moved_a = false, moved_b = false; // A and B are one file
  double read_seconds = 0;
  const char *instruction_set = ""; // of the code that decides on the CPU
  std::vector<std::string> written; // files
  std::vector<std::string> notes;
  std::optional<contact_counts> contacts = {}; // if they were asked for
};

// The notes on the files, on the choice of a processor, and on the files written.
std::vector<std::string> all_notes(const collide_report &r);

std::string summary(const collide_report &r);

// The answer in words, and a newline.
std::string answer_line(const collide_report &r);

// "on NVIDIA H200: 0.300 s to start, 0.001000 s of kernels" and a newline.
std::string device_line(const device_account &d);

// The warning for sets that leave the scene's box; empty if both lie in it.
std::string box_warning(const query &asked, const answers &found);

// One JSON object and a newline.
std::string as_json(const collide_report &r);

} // namespace meetc::app

#endif
