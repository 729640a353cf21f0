// bench/tables/gpu/sets.hpp: the sets of a scene, in the host's memory and on a device.
#ifndef MEETC_BENCH_TABLES_GPU_SETS_HPP
#define MEETC_BENCH_TABLES_GPU_SETS_HPP

#include "meet/app/input/sets.hpp"
#include "meet/bench/scenes/scenes.hpp"
#include "meet/core/device/set/device_set.hpp"
#include "meet/core/query/find.hpp"

#include <optional>
#include <utility>

namespace meetc::bench {

struct sets_here {
  const scene &of;
  const predicate_info &predicate;
  const std::pair<io::element_set, io::element_set> made;

  sets_here(const scene &one, const catalogue &all)
      : of(one), predicate(find_predicate(all, one.predicate)), made(one.make()) {}
  const io::element_set &a() const { return made.first; }
  const io::element_set &b() const { return of.itself ? made.first : made.second; }
};

// As they were read: moved, checked and ordered there.
class sets_there {
public:
  sets_there(const device &on, const sets_here &from) : a_(on, io::view_of(from.a()), *from.a().kind) {
    if (!from.of.itself)
      own_b_.emplace(on, io::view_of(from.b()), *from.b().kind);
  }
  device_set &a() { return a_; }
  device_set &b() { return own_b_ ? *own_b_ : a_; }
  double ordered_seconds() { return a_.ordered_seconds() + (own_b_ ? own_b_->ordered_seconds() : 0); }

private:
  device_set a_;
  std::optional<device_set> own_b_; // empty: the scene's second set is the first
};

} // namespace meetc::bench

#endif
