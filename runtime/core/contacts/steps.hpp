// core/contacts/steps.hpp: the steps of contacts() that look at each pair, or each node, alone. The processor takes them,
// or a device; names and joining, which stand between and behind them, are the same code for both.
#ifndef MEETC_CORE_CONTACTS_STEPS_HPP
#define MEETC_CORE_CONTACTS_STEPS_HPP

#include "meet/core/contacts/contacts.hpp"
#include "meet/core/threads/threads.hpp"

namespace meetc {

template <class Real> class contact_steps {
public:
  virtual ~contact_steps() = default;
  // codes[i] becomes the contact code of pair i, which names rows. Called once, first.
  virtual void find_codes(const touched_rows &a, const touched_rows &b, std::span<const index_pair> pairs,
                          std::uint64_t *codes) = 0;
  // The coordinates of each node, of the same rows.
  virtual void place_nodes(std::span<const node_source> nodes, Real *points) = 0;
  // The witness of each pair, which has this code.
  virtual void place_witnesses(std::span<const index_pair> pairs, const std::uint64_t *codes, Real *points) = 0;
};

template <class Real> class steps_on_cpu final : public contact_steps<Real> {
public:
  steps_on_cpu(const predicate_info &by, execution on);
  void find_codes(const touched_rows &a, const touched_rows &b, std::span<const index_pair> pairs,
                  std::uint64_t *codes) override;
  void place_nodes(std::span<const node_source> nodes, Real *points) override;
  void place_witnesses(std::span<const index_pair> pairs, const std::uint64_t *codes, Real *points) override;

private:
  const predicate_info &by_;
  execution on_;
  const touched_rows *a_ = nullptr, *b_ = nullptr;
};

// contacts() by these steps. Throws what it throws, and what the steps throw.
template <class Real>
contact_set<Real> contacts_by(contact_steps<Real> &steps, const view &a, const view &b, const predicate_info &predicate,
                              std::span<const index_pair> pairs, const contact_options &options);

} // namespace meetc

#endif
