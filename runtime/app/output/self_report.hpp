// app/output/self_report.hpp: the answer of `meet collide --self` as text, as JSON and as a table.
#ifndef MEETC_APP_OUTPUT_SELF_REPORT_HPP
#define MEETC_APP_OUTPUT_SELF_REPORT_HPP

#include "meet/app/query/device_pairs.hpp"
#include "meet/core/hierarchy/box.hpp"
#include "meet/core/query/self_pairs.hpp"
#include "meet/io/elements/element_set.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace meetc::app {

struct self_report {
  std::string name; // of the file
  const io::element_set &a;
  self_result found = {};
  box bounds = {};
  bool moved = false, merged = true;
  double read_seconds = 0, prepare_seconds = 0;
  const char *instruction_set = "";
  processor on = processor::cpu;       // which of the two answered
  device_account by_device = {};       // on processor::cuda
  std::vector<std::string> notes = {}; // on the choice of processor
  std::vector<std::string> written = {};

  // About faces, which polygons are as a whole; filled by name_faces().
  std::uint64_t pairs = 0, touched = 0;
  std::vector<std::uint8_t> hit = {};           // 1 for each face that is in a pair
  std::vector<std::uint32_t> without_area = {}; // faces all of whose triangles have none, sorted
};

void name_faces(self_report &r);

// The pairs of faces, sorted, each once.
std::vector<index_pair> pairs_of_faces(const self_report &r);

// A line `a,b`, then a row for each pair of faces; where polygons were cut, for each pair of triangles, whose numbers follow
// as triangle_a and triangle_b.
void write_self_pairs(const std::filesystem::path &to, const self_report &r);

std::string summary(const self_report &r);

// One JSON object and a newline.
std::string as_json(const self_report &r);

} // namespace meetc::app

#endif
