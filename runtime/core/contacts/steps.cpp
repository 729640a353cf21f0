#include "meet/core/contacts/steps.hpp"

#include "meet/core/threads/threads.hpp"
#include "meetc/contact/place.hpp"

namespace meetc {
namespace {

constexpr std::size_t pairs_at_once = 256, nodes_at_once = 512;

contact_element element(const touched_rows &of, std::uint32_t row) {
  return {of.rows.data() + std::size_t{3} * static_cast<std::size_t>(of.corners) * row, of.corners};
}

} // namespace

template <class Real>
steps_on_cpu<Real>::steps_on_cpu(const predicate_info &by, int threads) : by_(by), threads_(thread_count(threads)) {}

template <class Real>
void steps_on_cpu<Real>::find_codes(const touched_rows &a, const touched_rows &b, std::span<const index_pair> pairs,
                                    std::uint64_t *codes) {
  a_ = &a, b_ = &b;
  for_chunks(threads_, pairs.size(), pairs_at_once, [&](int, std::size_t begin, std::size_t end) {
    by_.contacts(a.rows.data(), b.rows.data(), pairs.data() + begin, end - begin, codes + begin);
  });
}

template <class Real> void steps_on_cpu<Real>::place_nodes(std::span<const node_source> nodes, Real *points) {
  for_chunks(threads_, nodes.size(), nodes_at_once, [&](int, std::size_t begin, std::size_t end) {
    for (std::size_t n = begin; n < end; ++n)
      place_label<Real>(element(*a_, nodes[n].a), element(*b_, nodes[n].b), nodes[n].label, points + 3 * n);
  });
}

template class steps_on_cpu<float>;
template class steps_on_cpu<double>;

} // namespace meetc
