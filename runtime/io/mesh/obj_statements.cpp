#include "io/mesh/obj_statements.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace meetc::io {

namespace {

constexpr std::string_view passed_over[] = {"vt",       "vn",       "vp",     "g",          "o",        "s",
                                            "mg",       "usemtl",   "mtllib", "usemap",     "maplib",   "bevel",
                                            "c_interp", "d_interp", "lod",    "shadow_obj", "trace_obj"};

constexpr std::string_view curves[] = {"cstype", "deg",   "bmat", "step", "curv", "curv2", "surf",
                                       "parm",   "trim",  "hole", "scrv", "sp",   "end",   "con",
                                       "ctech",  "stech", "bzp",  "bsp",  "cdc",  "cdp",   "res"};

constexpr std::size_t most_keywords = 64, most_named = 8;

} // namespace

bool skipped_statements::add(std::string_view key, const char *at) {
  if (std::ranges::find(passed_over, key) != std::end(passed_over))
    return true;
  for (const char c : key)
    if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f)
      return false;
  add({std::string(key), at, 1, std::ranges::find(curves, key) != std::end(curves)});
  return true;
}

void skipped_statements::add(statement s) {
  const auto found = std::ranges::find(seen_, s.key, &statement::key);
  if (found != seen_.end())
    found->times += s.times;
  else if (seen_.size() < most_keywords)
    seen_.push_back(std::move(s));
  else
    others_ += s.times;
}

void skipped_statements::add(const skipped_statements &later) {
  for (const statement &s : later.seen_)
    add(s);
  others_ += later.others_;
}

std::vector<std::string> skipped_statements::notes(const text_file &text) const {
  std::vector<std::string> out;
  for (const bool free_form : {true, false}) {
    std::string list;
    std::size_t named = 0, others = free_form ? 0 : others_;
    for (const statement &s : seen_) {
      if (s.free_form != free_form)
        continue;
      if (++named > most_named)
        others += s.times;
      else
        list += fmt::format("{}{} (line {}, {})", list.empty() ? "" : ", ", quote(s.key), text.line_of(s.first),
                            s.times == 1 ? "once" : fmt::format("{} times", s.times));
    }
    if (list.empty())
      continue;
    if (others > 0)
      list += fmt::format(" and {} others", others);
    out.push_back(free_form ? "free-form curves and surfaces are left out: " + list
                            : "statements that are no geometry are skipped: " + list);
  }
  return out;
}

} // namespace meetc::io
