// app/report.hpp: the answer of `meet collide` in words and as JSON.
#ifndef MEETC_APP_REPORT_HPP
#define MEETC_APP_REPORT_HPP

#include "app/collide_sets.hpp"
#include "io/element_set.hpp"

#include <string>
#include <vector>

namespace meetc::app {

struct collide_report {
  std::string name_a, name_b; // of the files
  const io::element_set &a, &b;
  const how &asked;
  const answers &found;
  bool same_file = false, moved = false; // A and B are one file; B was transformed
  double read_seconds = 0;
  std::vector<std::string> written; // files
  std::vector<std::string> notes;
};

std::string summary(const collide_report &r);

// What to say of sets that leave the scene's box; empty where they lie in it.
std::string box_warning(const how &asked, const answers &found);

// One object and a newline.
std::string json(const collide_report &r);

// 345944 as "345,944".
std::string grouped(std::uint64_t n);
// "69,451 faces", "1 sphere"; polygons also as triangles.
std::string counted(const io::element_set &set);
std::string counted(const io::element_set &set, std::uint64_t n);
// "[0, 0, 0] to [1, 1, 1]"
std::string in_words(const box &b);

} // namespace meetc::app

#endif
