#include "bench/trade_families.hpp"

#include "app/sets.hpp"
#include "core/candidates.hpp"
#include "core/element_set.hpp"

#include <algorithm>

namespace meetc::bench {

namespace {

// Keeps all pairs of slots.
class collector final : public pair_sink {
public:
  collector() : room_(2 * longest_run) {
    pairs_ = room_.data();
    full_ = longest_run;
  }
  bool flush() override {
    all.insert(all.end(), room_.begin(), room_.begin() + static_cast<std::ptrdiff_t>(size_));
    size_ = 0;
    return true;
  }
  std::vector<index_pair> all;

private:
  std::vector<index_pair> room_;
};

} // namespace

element_pairs candidates_of(const predicate_info &p, const io::element_set &a, const io::element_set &b,
                            std::size_t most) {
  const prepared first = app::prepare(a), second = app::prepare(b);
  const tree_pairs source(first.set(), second.set(), ruled_out_by::boxes);
  collector found;
  for (std::size_t u = 0; u < source.units(); ++u)
    source.yield(u, found);
  found.flush();
  const std::size_t n = std::min(most, found.all.size());
  element_pairs out{&p, {}, {}, n};
  const auto add = [](std::vector<float> &to, const element_set &from, std::uint32_t slot) {
    const auto fields = static_cast<std::size_t>(from.kind->fields);
    const float *const row = from.rows + slot * fields;
    to.insert(to.end(), row, row + fields);
  };
  for (std::size_t i = 0; i < n; ++i) {
    const index_pair &pair = found.all[i * found.all.size() / n];
    add(out.a, first.set(), pair.a);
    add(out.b, second.set(), pair.b);
  }
  return out;
}

} // namespace meetc::bench
