#include "meet/report/contact_lines.hpp"

#include "meet/io/elements/words.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <span>

namespace meetc::report {

namespace {

using io::grouped;

std::string some(std::size_t n, const char *what) {
  return fmt::format("{} {}{}", grouped(n), what, n == 1 ? "" : "s");
}

} // namespace

template <class Real> contact_counts counts_of(const contact_set<Real> &c) {
  return {c.nodes(),
          c.pieces.size(),
          c.polylines.size(),
          static_cast<std::size_t>(std::count(c.closed.begin(), c.closed.end(), 1)),
          c.patches.size(),
          c.single_nodes.size(),
          c.witness_pairs.size(),
          c.embedded,
          c.seconds};
}
template contact_counts counts_of(const contact_set<float> &);
template contact_counts counts_of(const contact_set<double> &);

std::string in_words(const contact_counts &c) {
  if (c.witnesses > 0)
    return fmt::format("{} witness{}, one of each pair", grouped(c.witnesses), c.witnesses == 1 ? "" : "es");
  std::string out = fmt::format("{}, {}, {} ({} closed)", some(c.nodes, "node"), some(c.pieces, "piece"),
                                some(c.polylines, "polyline"), grouped(c.closed));
  if (c.patches > 0)
    out += fmt::format(", {}", some(c.patches, "flat polygon"));
  if (c.single_nodes > 0)
    out += fmt::format(", {}", some(c.single_nodes, "single point"));
  if (c.embedded == embedding::embedded)
    out += "; both meshes are embedded, so that nodes and points are one to one";
  else if (c.embedded == embedding::not_embedded)
    out += "; a mesh is not embedded (--self lists why), so that several nodes may be one point";
  return out;
}

contact_lines lines_of(const contact_set<double> &c) {
  contact_lines out;
  out.points = c.points;
  for (const auto &p : c.pieces)
    out.pieces.insert(out.pieces.end(), p.begin(), p.end());
  for (std::size_t i = 0; i < c.patches.size(); ++i) {
    const std::span<const std::uint32_t> corners = c.patches[i]; // convex
    for (std::size_t k = 2; k < corners.size(); ++k)
      out.triangles.insert(out.triangles.end(), {corners[0], corners[k - 1], corners[k]});
  }
  out.single = c.single_nodes;
  for (std::size_t i = 0; i < c.witness_pairs.size(); ++i)
    out.single.push_back(static_cast<std::uint32_t>(c.nodes() + i));
  out.points.insert(out.points.end(), c.witnesses.begin(), c.witnesses.end());
  return out;
}

} // namespace meetc::report
