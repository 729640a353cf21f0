// bench/tables/paper/report.hpp: the result of `meet bench paper` as text, as a page and as JSON.
#ifndef MEETC_BENCH_TABLES_PAPER_REPORT_HPP
#define MEETC_BENCH_TABLES_PAPER_REPORT_HPP

#include "bench/tables/paper/parts.hpp"

#include <string>

namespace meetc::bench {

struct paper_report {
  const paper_result &found;
  const paper_bodies &bodies;
  const bench_device *device; // null: none
  bool from_files, quick;
  int threads;
  bool drawn; // whether the figures were drawn
};

std::string as_text(const paper_report &r);
std::string as_markdown(const paper_report &r, const std::string &command);
std::string as_json(const paper_report &r); // one object and a newline

} // namespace meetc::bench

#endif
