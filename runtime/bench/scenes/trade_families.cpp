#include "meet/bench/scenes/trade_families.hpp"

#include "meet/app/input/sets.hpp"
#include "meet/core/sets/element_set.hpp"
#include "meet/core/traversal/candidates.hpp"

#include <algorithm>

namespace meetc::bench {

namespace {

// Counts all pairs of slots, and keeps those whose numbers are i * count / wanted, if `wanted` of `count` are to be kept.
class sampler final : public pair_sink {
public:
  explicit sampler(std::size_t count = 0, std::size_t wanted = 0)
      : room_(2 * longest_run), count_(count), wanted_(wanted) {
    pairs_ = room_.data();
    full_ = longest_run;
  }
  bool flush() override {
    for (std::size_t i = 0; i < size_; ++i, ++seen)
      if (kept.size() < wanted_ && seen == kept.size() * count_ / wanted_)
        kept.push_back(room_[i]);
    size_ = 0;
    return true;
  }
  std::size_t seen = 0;
  std::vector<index_pair> kept;

private:
  std::vector<index_pair> room_;
  std::size_t count_, wanted_;
};

void walk(const tree_pairs &source, sampler &to) {
  for (std::size_t u = 0; u < source.units(); ++u)
    source.yield(u, to);
  to.flush();
}

} // namespace

element_pairs candidates_of(const predicate_info &p, const io::element_set &a, const io::element_set &b,
                            std::size_t most) {
  const prepared first = app::prepare(a), second = app::prepare(b);
  const tree_pairs source(first.set(), second.set(), ruled_out_by::boxes);
  sampler all;
  walk(source, all);
  const std::size_t n = std::min(most, all.seen);
  sampler some(all.seen, n);
  walk(source, some);
  element_pairs out{&p, {}, {}, n};
  const auto add = [](std::vector<float> &to, const element_set &from, std::uint32_t slot) {
    const auto fields = static_cast<std::size_t>(from.kind->fields);
    const float *const row = from.rows + slot * fields;
    to.insert(to.end(), row, row + fields);
  };
  for (const index_pair &pair : some.kept) {
    add(out.a, first.set(), pair.a);
    add(out.b, second.set(), pair.b);
  }
  return out;
}

} // namespace meetc::bench
