#include "meet/io/mesh/obj_statements.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace meetc::io {

namespace {

constexpr std::string_view passed_over[] = {"vt",       "vn",       "vp",     "g",          "o",        "s",
                                            "mg",       "usemtl",   "mtllib", "usemap",     "maplib",   "bevel",
                                            "c_interp", "d_interp", "lod",    "shadow_obj", "trace_obj"};

constexpr std::string_view curves[] = {"cstype", "deg",   "bmat", "step", "curv", "curv2", "surf",
                                       "parm",   "trim",  "hole", "scrv", "sp",   "end",   "con",
                                       "ctech",  "stech", "bzp",  "bsp",  "cdc",  "cdp",   "res"};

constexpr std::size_t most_named = 8;

} // namespace

bool skipped_statements::add(std::string_view key, const char *at) {
  if (std::ranges::find(passed_over, key) != std::end(passed_over))
    return true;
  for (const char c : key)
    if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f)
      return false;
  const auto found = seen_.find(key);
  if (found != seen_.end())
    ++found->second.times;
  else
    seen_.emplace(key, statement{at, 1, std::ranges::find(curves, key) != std::end(curves), seen_.size()});
  return true;
}

std::vector<const skipped_statements::entry *> skipped_statements::in_order() const {
  std::vector<const entry *> out(seen_.size());
  for (const entry &e : seen_)
    out[e.second.order] = &e;
  return out;
}

void skipped_statements::add(const skipped_statements &later) {
  for (const entry *e : later.in_order()) {
    const auto [known, fresh] = seen_.try_emplace(e->first, e->second);
    if (fresh)
      known->second.order = seen_.size() - 1;
    else
      known->second.times += e->second.times;
  }
}

std::vector<std::string> skipped_statements::notes(const text_file &text) const {
  std::vector<std::string> out;
  for (const bool free_form : {true, false}) {
    std::string list;
    std::size_t named = 0, others = 0;
    for (const entry *e : in_order()) {
      const auto &[key, s] = *e;
      if (s.free_form != free_form)
        continue;
      if (++named > most_named)
        others += s.times;
      else
        list += fmt::format("{}{} (line {}, {})", list.empty() ? "" : ", ", quote(key), text.line_of(s.first),
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
