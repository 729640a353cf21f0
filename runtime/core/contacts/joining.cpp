#include "meet/core/contacts/joining.hpp"

#include "meet/core/views/numbered.hpp"

#include <algorithm>

namespace meetc {
namespace {

using piece = std::array<std::uint32_t, 2>;

// How pairs report the segment between two nodes.
enum : std::uint8_t { crossing = 1, in_plane = 2, patch_side = 4 };

class joining {
public:
  joining(const node_lists &corners, std::size_t nodes, const execution &on)
      : corners_(corners), nodes_(nodes), on_(on), keys_(corners.size(), on) {}

  joined_contacts run(std::span<const std::uint64_t> codes) {
    reserve(); // so that no list is moved as a whole while it grows
    std::vector<std::uint8_t> used(nodes_, 0);
    for_strips(on_, codes.size(), [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i)
        take(contact_code(codes[i]), corners_[i], static_cast<std::uint32_t>(i), used);
    });
    for_strips(on_, reports_.size(), [&](std::size_t begin, std::size_t end) {
      for (std::size_t k = begin; k < end; ++k)
        if ((reports_[k] & crossing) != 0 || reports_[k] == in_plane) {
          out_.pieces.push_back(directed_[k]);
          for (const std::uint32_t node : directed_[k])
            used[node] = 1;
        }
    });
    for_strips(on_, nodes_, [&](std::size_t begin, std::size_t end) {
      for (auto n = static_cast<std::uint32_t>(begin); n < end; ++n)
        if (!used[n])
          out_.single_nodes.push_back(n);
    });
    chain();
    return std::move(out_);
  }

private:
  const node_lists &corners_;
  std::size_t nodes_;
  const execution &on_;
  numbered<std::uint32_t, 2> keys_;
  std::vector<std::uint8_t> reports_; // by key
  std::vector<piece> directed_;       // by key: as it was first reported by a pair that meets in it
  joined_contacts out_;
  std::vector<std::uint32_t> begin_, at_; // the pieces at each node
  std::vector<std::uint8_t> done_;        // by piece

  void reserve() {
    const std::size_t most = corners_.nodes.size();
    reports_.reserve(most), directed_.reserve(most), out_.pieces.reserve(most), out_.single_nodes.reserve(nodes_);
    out_.patches.nodes.reserve(most), out_.patches.offsets.reserve(corners_.size() + 1);
    out_.patch_pairs.reserve(corners_.size());
  }
  void report(std::uint32_t from, std::uint32_t to, std::uint8_t how) {
    const std::uint32_t k = keys_.number({std::min(from, to), std::max(from, to)});
    if (k == reports_.size()) {
      reports_.push_back(0);
      directed_.push_back({from, to});
    }
    if ((how & crossing) != 0 && (reports_[k] & crossing) == 0)
      directed_[k] = {from, to};
    reports_[k] |= how;
  }
  void take(contact_code code, std::span<const std::uint32_t> at, std::uint32_t pair, std::vector<std::uint8_t> &used) {
    if (at.size() == 2 && code.dimension() == 1)
      report(at[0], at[1], code.in_one_plane() ? in_plane : crossing);
    if (at.size() < 3)
      return;
    for (std::size_t i = 0; i < at.size(); ++i) {
      report(at[i], at[(i + 1) % at.size()], patch_side);
      used[at[i]] = 1;
      out_.patches.nodes.push_back(at[i]);
    }
    out_.patches.end_list();
    out_.patch_pairs.push_back(pair);
  }

  std::uint32_t degree(std::uint32_t node) const { return begin_[node + 1] - begin_[node]; }

  void chain() {
    begin_.assign(nodes_ + 1, 0);
    for_strips(on_, out_.pieces.size(), [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i)
        for (const std::uint32_t node : out_.pieces[i])
          ++begin_[node + 1];
    });
    for_strips(on_, nodes_, [&](std::size_t begin, std::size_t end) {
      for (std::size_t n = begin; n < end; ++n)
        begin_[n + 1] += begin_[n];
    });
    at_.resize(2 * out_.pieces.size());
    std::vector<std::uint32_t> next(begin_.begin(), begin_.end() - 1);
    for_strips(on_, out_.pieces.size(), [&](std::size_t begin, std::size_t end) {
      for (auto i = static_cast<std::uint32_t>(begin); i < end; ++i)
        for (const std::uint32_t node : out_.pieces[i])
          at_[next[node]++] = i;
    });
    done_.assign(out_.pieces.size(), 0);
    for (const bool loops : {false, true}) // chains from their ends and branch points first
      for_strips(on_, nodes_, [&](std::size_t begin, std::size_t end) {
        for (auto n = static_cast<std::uint32_t>(begin); n < end; ++n)
          if (loops || degree(n) != 2)
            for (std::uint32_t i = begin_[n]; i < begin_[n + 1]; ++i)
              if (!done_[at_[i]])
                follow(n, at_[i]);
      });
  }

  // The polyline from the node along the piece, to the next end or branch point or back to the node.
  void follow(std::uint32_t start, std::uint32_t along) {
    std::vector<std::uint32_t> &nodes = out_.polylines.nodes;
    const std::size_t first = nodes.size();
    std::uint32_t node = start;
    std::ptrdiff_t forward = 0;
    for (bool more = true; more;) {
      nodes.push_back(node);
      done_[along] = 1;
      const piece &p = out_.pieces[along];
      forward += p[0] == node ? 1 : -1;
      node = p[0] == node ? p[1] : p[0];
      more = node != start && degree(node) == 2;
      if (more)
        along = at_[begin_[node]] == along ? at_[begin_[node] + 1] : at_[begin_[node]];
    }
    const bool closed = node == start;
    if (!closed)
      nodes.push_back(node);
    if (forward < 0) // a closed one keeps its first node
      std::reverse(nodes.begin() + static_cast<std::ptrdiff_t>(first) + (closed ? 1 : 0), nodes.end());
    out_.polylines.end_list();
    out_.closed.push_back(closed ? 1 : 0);
  }
};

} // namespace

joined_contacts join_contacts(std::span<const std::uint64_t> codes, const node_lists &corners, std::size_t nodes,
                              const execution &on) {
  return joining(corners, nodes, on).run(codes);
}

} // namespace meetc
