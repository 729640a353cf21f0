#include "meet/core/contacts/contacts.hpp"

#include "meet/core/contacts/joining.hpp"
#include "meet/core/contacts/names.hpp"
#include "meet/core/contacts/steps.hpp"
#include "meet/core/views/check.hpp"
#include "meet/core/views/numbered.hpp"
#include "meet/core/views/rows.hpp"
#include "meet/core/views/usage_error.hpp"

#include <algorithm>
#include <chrono>
#include <iterator>
#include <stdexcept>

namespace meetc {
namespace {

void require(bool holds, const std::string &what) {
  if (!holds)
    throw usage_error("contacts: " + what);
}
void require_set(const view &elements, const kind_info &kind, const pose &at) {
  const char *const wrong = wrong_with(elements, kind);
  require(wrong == nullptr, wrong ? wrong : "");
  const status s = movable(kind, at);
  require(s == status::ok, text(s));
}

template <class Real> class finding {
public:
  finding(const predicate_info &predicate, std::span<const index_pair> pairs, const execution &on)
      : predicate_(predicate), on_(on) {
    out_.pairs.reserve(pairs.size());
    for_strips(on_, pairs.size(), [&](std::size_t begin, std::size_t end) {
      const std::span<const index_pair> strip = pairs.subspan(begin, end - begin);
      out_.pairs.insert(out_.pairs.end(), strip.begin(), strip.end());
    });
  }

  contact_set<Real> run(contact_steps<Real> &steps, const view &a, const view &b, const contact_options &options) {
    gather(a, b, options);
    out_.codes.resize(rows_.size());
    steps.find_codes(out_.rows_a, out_.rows_b, rows_, out_.codes.data());
    name_nodes();
    out_.points.resize(3 * out_.sources.size());
    steps.place_nodes(out_.sources, out_.points.data());
    place_witnesses(steps);
    joined_contacts j = join_contacts(out_.codes, out_.corners, out_.nodes(), on_);
    out_.pieces = std::move(j.pieces);
    out_.polylines = std::move(j.polylines);
    out_.closed = std::move(j.closed);
    out_.patches = std::move(j.patches);
    out_.patch_pairs = std::move(j.patch_pairs);
    out_.single_nodes = std::move(j.single_nodes);
    return std::move(out_);
  }

private:
  const predicate_info &predicate_;
  const execution &on_; // of what one thread does
  contact_set<Real> out_;
  std::vector<index_pair> rows_; // by pair

  void gather(const view &a, const view &b, const contact_options &options) {
    std::vector<std::uint32_t> in_a, in_b;
    out_.rows_a = touched_by(a, *predicate_.a, options.at_a, out_.pairs, false, in_a, on_);
    out_.rows_b = touched_by(b, *predicate_.b, options.at_b, out_.pairs, true, in_b, on_);
    rows_.reserve(in_a.size());
    for_strips(on_, in_a.size(), [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i)
        rows_.push_back({in_a[i], in_b[i]});
    });
  }

  // Room for all corners, so that no list is moved as a whole while it grows.
  void reserve_nodes() {
    std::size_t corners = 0;
    for_strips(on_, out_.codes.size(), [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i)
        corners += static_cast<std::size_t>(contact_code(out_.codes[i]).labels());
    });
    out_.corners.nodes.reserve(corners);
    out_.corners.offsets.reserve(out_.codes.size() + 1);
    out_.sources.reserve(corners), out_.on_a.reserve(corners), out_.on_b.reserve(corners);
  }
  void name_nodes() {
    reserve_nodes();
    const part_names names_a(out_.rows_a, on_), names_b(out_.rows_b, on_);
    numbered<std::uint64_t, 2> nodes(2 * out_.pairs.size(), on_);
    for (std::size_t i = 0; i < out_.pairs.size(); ++i) {
      if ((i & 0x3ff) == 0)
        on_.go_on();
      const contact_code code(out_.codes[i]);
      for (int l = 0; l < code.labels(); ++l) {
        const unsigned label = code.label(l);
        const int on_a = part_of_a(label, names_b, rows_[i].b);
        const std::uint32_t node =
            nodes.number({names_a.name(rows_[i].a, on_a), names_b.name(rows_[i].b, label_b(label))});
        out_.corners.nodes.push_back(node);
        if (node == out_.sources.size())
          add_node(i, label);
      }
      out_.corners.end_list();
    }
  }
  // The carrier of a, with the roots in the order of the segment's name, so that both directions have the same two.
  int part_of_a(unsigned label, const part_names &names_b, std::uint32_t row_b) const {
    const int on = label_a(label);
    if (out_.rows_a.corners != 0 || (on != first_root && on != second_root) ||
        !names_b.runs_back(row_b, label_b(label)))
      return on;
    return on == first_root ? second_root : first_root;
  }
  void add_node(std::size_t pair, unsigned label) {
    out_.sources.push_back({rows_[pair].a, rows_[pair].b, label});
    const auto part = [](std::uint32_t element, int carrier, int corners) {
      return element_part{element, static_cast<std::uint8_t>(carrier_dimension(carrier, corners)),
                          static_cast<std::uint8_t>(carrier)};
    };
    out_.on_a.push_back(part(out_.pairs[pair].a, label_a(label), out_.rows_a.corners));
    out_.on_b.push_back(part(out_.pairs[pair].b, label_b(label), out_.rows_b.corners));
  }
  void place_witnesses(contact_steps<Real> &steps) {
    std::vector<index_pair> rows;
    std::vector<std::uint64_t> codes;
    for (std::size_t i = 0; i < out_.codes.size(); ++i)
      if (contact_code(out_.codes[i]).has_witness()) {
        out_.witness_pairs.push_back(static_cast<std::uint32_t>(i));
        rows.push_back(rows_[i]), codes.push_back(out_.codes[i]);
      }
    out_.witnesses.resize(3 * rows.size());
    steps.place_witnesses(rows, codes.data(), out_.witnesses.data());
  }
};

bool same_mesh(const view &a, const view &b) {
  return a.data == b.data && a.vertices == b.vertices && a.stride_bytes == b.stride_bytes && a.index == b.index &&
         a.elements == b.elements;
}
bool is_embedded(const view &mesh, const kind_info &kind, const pose &at, const contact_options &options) {
  const prepared set = prepare(mesh, kind, at, options.threads, nullptr, options.stop);
  self_options quietly;
  quietly.threads = options.threads;
  quietly.stop = options.stop;
  const self_result crossing = self_pairs(set, mesh, *options.embedded_by, quietly);
  return crossing.pairs.empty() && crossing.degenerate.empty();
}
bool same_pose(const pose &x, const pose &y) {
  return std::equal(std::begin(x.m), std::end(x.m), std::begin(y.m)) && x.length_scale == y.length_scale &&
         x.grid == y.grid;
}
embedding find_embedding(const view &a, const view &b, const contact_options &options) {
  const kind_info &kind = *options.embedded_by->apart.a;
  const bool one = same_mesh(a, b) && same_pose(options.at_a, options.at_b);
  const bool both = is_embedded(a, kind, options.at_a, options) && (one || is_embedded(b, kind, options.at_b, options));
  return both ? embedding::embedded : embedding::not_embedded;
}

} // namespace

template <class Real>
contact_set<Real> contacts_by(contact_steps<Real> &steps, const view &a, const view &b, const predicate_info &predicate,
                              std::span<const index_pair> pairs, const contact_options &options) {
  return under_standard_word([&] {
    const auto start = std::chrono::steady_clock::now();
    require(predicate.contacts != nullptr,
            std::string(predicate.name) + " has none: its scene asks for no sign that its `contacts` names");
    require_set(a, *predicate.a, options.at_a);
    require_set(b, *predicate.b, options.at_b);
    if (options.embedded_by)
      require(predicate.a == options.embedded_by->apart.a && predicate.b == predicate.a,
              "embedded_by goes with two sets of triangles");
    contact_set<Real> out = finding<Real>(predicate, pairs, {1, options.stop}).run(steps, a, b, options);
    if (options.embedded_by)
      out.embedded = find_embedding(a, b, options);
    out.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    return out;
  });
}

template <class Real>
contact_set<Real> contacts(const view &a, const view &b, const predicate_info &predicate,
                           std::span<const index_pair> pairs, const contact_options &options) {
  steps_on_cpu<Real> steps(predicate, execution_on(options.threads, options.stop));
  return contacts_by(steps, a, b, predicate, pairs, options);
}

template contact_set<float> contacts_by(contact_steps<float> &, const view &, const view &, const predicate_info &,
                                        std::span<const index_pair>, const contact_options &);
template contact_set<double> contacts_by(contact_steps<double> &, const view &, const view &, const predicate_info &,
                                         std::span<const index_pair>, const contact_options &);
template contact_set<float> contacts(const view &, const view &, const predicate_info &, std::span<const index_pair>,
                                     const contact_options &);
template contact_set<double> contacts(const view &, const view &, const predicate_info &, std::span<const index_pair>,
                                      const contact_options &);

} // namespace meetc
