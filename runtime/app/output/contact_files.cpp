#include "meet/app/output/contact_files.hpp"

#include "meet/app/input/failure.hpp"
#include "meet/app/input/sets.hpp"
#include "meet/app/query/device_self.hpp"
#include "meet/app/text/json.hpp"
#include "meet/app/text/words.hpp"
#include "meet/core/contacts/contacts.hpp"
#include "meet/io/files/atomic_file.hpp"
#include "meet/io/files/endian.hpp"
#include "meet/io/text/text.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <iterator>

namespace meetc::app {

namespace fs = std::filesystem;

namespace {

// The contacts with the sets as the user named them: the predicate may take them in the other order.
template <class Real> struct named_contacts {
  const contact_set<Real> &of;
  const io::element_set &a, &b;
  bool swapped;

  std::uint32_t element(std::size_t pair, bool side_b) const {
    return side_b != swapped ? of.pairs[pair].b : of.pairs[pair].a;
  }
  const element_part &on(std::size_t node, bool side_b) const {
    return side_b != swapped ? of.on_b[node] : of.on_a[node];
  }
  const io::element_set &set(bool side_b) const { return side_b ? b : a; }
};

// The dimension of a part and the file's numbers of its vertices, or of its face.
struct part_numbers {
  const char *what;
  std::size_t numbers[2];
  int count;
};
part_numbers numbers_of(const element_part &part, const io::element_set &set) {
  const auto points = static_cast<std::size_t>(set.kind->points);
  const auto vertex = [&](int corner) -> std::size_t {
    const std::size_t at = points * part.element + static_cast<std::size_t>(corner) % points;
    return set.index.empty() ? at : set.index[at];
  };
  if (points == 0)
    return {part.dimension == 3 ? "inside" : "surface", {part.element, 0}, 1};
  if (part.dimension == 2)
    return {"face", {set.owner_of(part.element), 0}, 1};
  if (part.dimension == 0)
    return {"vertex", {vertex(part.carrier), 0}, 1};
  const int first = part.carrier - first_edge;
  return {"edge", {vertex(first), vertex(first + 1)}, 2};
}
void append_part(std::string &out, const part_numbers &p) {
  fmt::format_to(std::back_inserter(out), ",{}", p.what);
  for (int i = 0; i < p.count; ++i)
    fmt::format_to(std::back_inserter(out), " {}", p.numbers[i]);
}

template <class Real> std::string as_csv(const named_contacts<Real> &c) {
  const bool cut_a = !c.a.owner.empty(), cut_b = !c.b.owner.empty();
  std::string out =
      fmt::format("a,b{}{},node,x,y,z,on_a,on_b\n", cut_a ? ",triangle_a" : "", cut_b ? ",triangle_b" : "");
  const auto begin_row = [&](std::size_t pair) {
    const std::uint32_t a = c.element(pair, false), b = c.element(pair, true);
    fmt::format_to(std::back_inserter(out), "{},{}", c.a.owner_of(a), c.b.owner_of(b));
    if (cut_a)
      fmt::format_to(std::back_inserter(out), ",{}", a);
    if (cut_b)
      fmt::format_to(std::back_inserter(out), ",{}", b);
  };
  for (std::size_t i = 0; i < c.of.pairs.size(); ++i)
    for (const std::uint32_t node : c.of.corners[i]) {
      begin_row(i);
      const Real *const x = c.of.points.data() + std::size_t{3} * node;
      fmt::format_to(std::back_inserter(out), ",{},{},{},{}", node, x[0], x[1], x[2]);
      append_part(out, numbers_of(c.on(node, false), c.a));
      append_part(out, numbers_of(c.on(node, true), c.b));
      out += '\n';
    }
  for (std::size_t i = 0; i < c.of.witness_pairs.size(); ++i) {
    begin_row(c.of.witness_pairs[i]);
    const Real *const x = c.of.witnesses.data() + 3 * i;
    fmt::format_to(std::back_inserter(out), ",,{},{},{},witness,witness\n", x[0], x[1], x[2]);
  }
  return out;
}

// Nodes are counted from 1.
void append_list(std::string &out, char what, std::span<const std::uint32_t> nodes) {
  out += what;
  for (const std::uint32_t node : nodes)
    fmt::format_to(std::back_inserter(out), " {}", std::size_t{node} + 1);
}
template <class Real> void append_vertices(std::string &out, const std::vector<Real> &points) {
  for (std::size_t i = 0; i < points.size(); i += 3)
    fmt::format_to(std::back_inserter(out), "v {} {} {}\n", points[i], points[i + 1], points[i + 2]);
}
constexpr const char *witness_comment = "each point is a witness, one of its pair";

template <class Real> std::string as_obj(const contact_set<Real> &c) {
  std::string out;
  if (!c.witness_pairs.empty())
    out = fmt::format("# {}\n", witness_comment);
  append_vertices(out, c.points);
  append_vertices(out, c.witnesses);
  for (std::size_t i = 0; i < c.polylines.size(); ++i) {
    append_list(out, 'l', c.polylines[i]);
    if (c.closed[i])
      fmt::format_to(std::back_inserter(out), " {}", std::size_t{c.polylines[i][0]} + 1);
    out += '\n';
  }
  for (std::size_t i = 0; i < c.patches.size(); ++i) {
    append_list(out, 'f', c.patches[i]);
    out += '\n';
  }
  for (const std::uint32_t node : c.single_nodes)
    fmt::format_to(std::back_inserter(out), "p {}\n", std::size_t{node} + 1);
  for (std::size_t i = 0; i < c.witness_pairs.size(); ++i)
    fmt::format_to(std::back_inserter(out), "p {}\n", c.nodes() + i + 1);
  return out;
}

template <class T> void append_binary(std::string &out, T value) {
  const auto bytes = io::store(value, std::endian::little);
  out.append(bytes.data(), bytes.size());
}
template <class Real> std::string as_ply(const contact_set<Real> &c) {
  const char *const type = sizeof(Real) == 4 ? "float" : "double";
  std::string edges;
  std::size_t edge_count = 0;
  const auto edge = [&](std::uint32_t from, std::uint32_t to) {
    append_binary(edges, from), append_binary(edges, to);
    ++edge_count;
  };
  for (std::size_t i = 0; i < c.polylines.size(); ++i) {
    const std::span<const std::uint32_t> nodes = c.polylines[i];
    for (std::size_t k = 1; k < nodes.size(); ++k)
      edge(nodes[k - 1], nodes[k]);
    if (c.closed[i])
      edge(nodes.back(), nodes.front());
  }
  std::string out =
      fmt::format("ply\nformat binary_little_endian 1.0\n{}element vertex {}\nproperty {} x\nproperty {} y\n"
                  "property {} z\nelement edge {}\nproperty int vertex1\nproperty int vertex2\n"
                  "element face {}\nproperty list uchar int vertex_indices\nend_header\n",
                  c.witness_pairs.empty() ? "" : fmt::format("comment {}\n", witness_comment),
                  c.nodes() + c.witness_pairs.size(), type, type, type, edge_count, c.patches.size());
  for (const std::vector<Real> *const points : {&c.points, &c.witnesses})
    for (const Real x : *points)
      append_binary(out, x);
  out += edges;
  for (std::size_t i = 0; i < c.patches.size(); ++i) {
    append_binary(out, static_cast<std::uint8_t>(c.patches[i].size()));
    for (const std::uint32_t node : c.patches[i])
      append_binary(out, node);
  }
  return out;
}

json as_json(const part_numbers &p) {
  json out = {p.what};
  for (int i = 0; i < p.count; ++i)
    out.push_back(p.numbers[i]);
  return out;
}
json list(std::span<const std::uint32_t> nodes) {
  json out = json::array();
  for (const std::uint32_t node : nodes)
    out.push_back(node);
  return out;
}
// The shortest decimals that are read back as the number in its type.
json shortest(float x) {
  return number(fmt::format("{}", x));
}
json shortest(double x) {
  return x;
}
template <class Real> std::string as_json(const named_contacts<Real> &c) {
  json nodes = json::array(), pairs = json::array(), pieces = json::array(), polylines = json::array(),
       patches = json::array(), witnesses = json::array();
  const auto at = [](const Real *x) { return json{shortest(x[0]), shortest(x[1]), shortest(x[2])}; };
  for (std::size_t n = 0; n < c.of.nodes(); ++n) {
    nodes.push_back({{"at", at(c.of.points.data() + 3 * n)},
                     {"on_a", as_json(numbers_of(c.on(n, false), c.a))},
                     {"on_b", as_json(numbers_of(c.on(n, true), c.b))}});
  }
  for (std::size_t i = 0; i < c.of.pairs.size(); ++i) {
    const std::uint32_t a = c.element(i, false), b = c.element(i, true);
    json pair = {{"a", c.a.owner_of(a)}, {"b", c.b.owner_of(b)}};
    if (!c.a.owner.empty())
      pair["triangle_a"] = a;
    if (!c.b.owner.empty())
      pair["triangle_b"] = b;
    const contact_code code(c.of.codes[i]);
    pair["in_one_plane"] = code.in_one_plane();
    pair["corners"] = list(c.of.corners[i]);
    pairs.push_back(std::move(pair));
  }
  for (const auto &p : c.of.pieces)
    pieces.push_back(list(p));
  for (std::size_t i = 0; i < c.of.polylines.size(); ++i)
    polylines.push_back({{"closed", c.of.closed[i] != 0}, {"nodes", list(c.of.polylines[i])}});
  for (std::size_t i = 0; i < c.of.patches.size(); ++i)
    patches.push_back({{"pair", c.of.patch_pairs[i]}, {"nodes", list(c.of.patches[i])}});
  for (std::size_t i = 0; i < c.of.witness_pairs.size(); ++i)
    witnesses.push_back({{"pair", c.of.witness_pairs[i]}, {"at", at(c.of.witnesses.data() + 3 * i)}});
  return in_one_line({{"embedded", name_of(c.of.embedded)},
                      {"coordinates", sizeof(Real) == 4 ? "float32" : "float64"},
                      {"nodes", std::move(nodes)},
                      {"pairs", std::move(pairs)},
                      {"pieces", std::move(pieces)},
                      {"polylines", std::move(polylines)},
                      {"patches", std::move(patches)},
                      {"single_nodes", list(c.of.single_nodes)},
                      {"witnesses", std::move(witnesses)}}) +
         '\n';
}

std::string extension_of(const fs::path &to) {
  return io::lower_case(to.extension().string());
}

template <class Real>
contact_counts write_in(const fs::path &to, const io::element_set &a, const io::element_set &b, const query &asked,
                        const answers &found, output_files &outputs) {
  const contact_set<Real> c = find_contacts<Real>(a, b, asked, found);
  for (std::size_t i = 0; i < c.witnesses.size(); ++i)
    if (!std::isfinite(c.witnesses[i])) {
      const index_pair &p = c.pairs[c.witness_pairs[i / 3]];
      throw failure(fmt::format("--contacts {}: {} {} and {} {} meet beyond the range of float32; write "
                                "--contacts-float64 as well",
                                to.string(), asked.by.predicate->a->name, p.a, asked.by.predicate->b->name, p.b));
    }
  const std::string extension = extension_of(to);
  const named_contacts<Real> named{c, a, b, asked.by.swapped};
  outputs.write(to, [&](const fs::path &file) {
    io::write_file(file, extension == ".csv"   ? as_csv(named)
                         : extension == ".obj" ? as_obj(c)
                         : extension == ".ply" ? as_ply(c)
                                               : as_json(named));
  });
  return counts_of(c);
}

} // namespace

// By the processor that has found the pairs. Where that was a choice of ours and it fails, the CPU takes its place.
template <class Real>
contact_set<Real> find_contacts(const io::element_set &a, const io::element_set &b, const query &asked,
                                const answers &found) {
  const io::element_set &first = asked.by.swapped ? b : a, &second = asked.by.swapped ? a : b;
  contact_options options;
  options.threads = asked.threads;
  options.embedded_by = asked.embedded_by;
  if (found.on == processor::cuda)
    try {
      return contacts_on_device<Real>(first, second, *asked.by.predicate, found.element_pairs, options);
    } catch (const failure &e) {
      if (asked.on == processor::cuda || e.code() != no_device)
        throw;
    }
  return contacts<Real>(view_of(first), view_of(second), *asked.by.predicate, found.element_pairs, options);
}
template contact_set<float> find_contacts(const io::element_set &, const io::element_set &, const query &,
                                          const answers &);
template contact_set<double> find_contacts(const io::element_set &, const io::element_set &, const query &,
                                           const answers &);

void check_contact_file(const fs::path &to) {
  const std::string extension = extension_of(to);
  if (extension != ".csv" && extension != ".obj" && extension != ".ply" && extension != ".json")
    throw failure(fmt::format("--contacts {}: contacts are written as .csv, .obj, .ply or .json; name it {}",
                              to.string(), fs::path(to).replace_extension(".obj").string()));
}

const char *name_of(embedding e) {
  return e == embedding::unchecked ? "unchecked" : e == embedding::embedded ? "yes" : "no";
}

void require_contacts(const predicate_info &predicate) {
  if (!predicate.contacts)
    throw failure(
        fmt::format("--contacts goes with two meshes, segments and a mesh, and spheres with spheres, segments or "
                    "a mesh; {} has no contacts",
                    predicate.name));
}

contact_counts write_contacts(const fs::path &to, bool float64, const io::element_set &a, const io::element_set &b,
                              const query &asked, const answers &found, output_files &outputs) {
  return float64 ? write_in<double>(to, a, b, asked, found, outputs) : write_in<float>(to, a, b, asked, found, outputs);
}

} // namespace meetc::app
