#include "meet/bench/peers/peers.hpp"

#include "meet/bench/peers/each.hpp"

namespace meetc::bench::peers {

std::vector<library> libraries() {
  std::vector<library> all;
#if MEETC_WITH_EMBREE
  all.push_back(embree());
#else
  all.push_back({"Embree"});
#endif
#if MEETC_WITH_CGAL
  all.push_back(cgal());
#else
  all.push_back({"CGAL"});
#endif
#if MEETC_WITH_FCL
  all.push_back(fcl());
#else
  all.push_back({"FCL"});
#endif
#if MEETC_WITH_TRUEFORM
  all.push_back(trueform());
#else
  all.push_back({"trueform"});
#endif
  return all;
}

const exact_pairs *cgal_pairs_for([[maybe_unused]] instruction_set set) {
#if MEETC_WITH_CGAL
  if (!runs_here(set))
    return nullptr;
  switch (set) {
  case instruction_set::baseline:
    return meetc_cgal_pairs_baseline();
#if MEETC_WITH_CGAL_avx2
  case instruction_set::avx2:
    return meetc_cgal_pairs_avx2();
#endif
#if MEETC_WITH_CGAL_avx512
  case instruction_set::avx512:
    return meetc_cgal_pairs_avx512();
#endif
  default:
    break;
  }
#endif
  return nullptr;
}

} // namespace meetc::bench::peers
