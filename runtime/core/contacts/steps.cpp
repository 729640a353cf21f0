#include "meet/core/contacts/steps.hpp"

#include "meetc/contact/place.hpp"
#include "meetc/contact/root_place.hpp"
#include "meetc/contact/witness.hpp"

namespace meetc {
namespace {

constexpr std::size_t pairs_at_once = 256, nodes_at_once = 512;

contact_element element(const touched_rows &of, std::uint32_t row) {
  return {of.rows.data() + static_cast<std::size_t>(of.fields) * row, of.corners};
}

} // namespace

template <class Real>
steps_on_cpu<Real>::steps_on_cpu(const predicate_info &by, execution on) : by_(by), on_(std::move(on)) {}

template <class Real>
void steps_on_cpu<Real>::find_codes(const touched_rows &a, const touched_rows &b, std::span<const index_pair> pairs,
                                    std::uint64_t *codes) {
  a_ = &a, b_ = &b;
  for_chunks(on_, pairs.size(), pairs_at_once, [&](int, std::size_t begin, std::size_t end) {
    by_.contacts(a.rows.data(), b.rows.data(), pairs.data() + begin, end - begin, codes + begin);
  });
}

template <class Real> void steps_on_cpu<Real>::place_nodes(std::span<const node_source> nodes, Real *points) {
  for_chunks(on_, nodes.size(), nodes_at_once, [&](int, std::size_t begin, std::size_t end) {
    for (std::size_t n = begin; n < end; ++n) {
      const contact_element a = element(*a_, nodes[n].a), b = element(*b_, nodes[n].b);
      if (a.corners == 0) // a ball
        place_round_label(a.row, b.row, nodes[n].label, points + 3 * n);
      else
        place_label(a, b, nodes[n].label, points + 3 * n);
    }
  });
}

template <class Real>
void steps_on_cpu<Real>::place_witnesses(std::span<const index_pair> pairs, const std::uint64_t *codes, Real *points) {
  for_chunks(on_, pairs.size(), nodes_at_once, [&](int, std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      place_witness(element(*a_, pairs[i].a), element(*b_, pairs[i].b), contact_code(codes[i]), points + 3 * i);
  });
}

template class steps_on_cpu<float>;
template class steps_on_cpu<double>;

} // namespace meetc
