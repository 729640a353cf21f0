// bench/peers/each.hpp: the functions that each library's source defines. For peers.cpp alone.
#ifndef MEETC_BENCH_PEERS_EACH_HPP
#define MEETC_BENCH_PEERS_EACH_HPP

#include "meet/bench/peers/peers.hpp"

namespace meetc::bench::peers {

library embree();
library cgal();
library fcl();
library trueform();

} // namespace meetc::bench::peers

// C names, which the list of a shared library's symbols can hold.
extern "C" {
const meetc::bench::peers::exact_pairs *meetc_cgal_pairs_baseline();
const meetc::bench::peers::exact_pairs *meetc_cgal_pairs_avx2();
const meetc::bench::peers::exact_pairs *meetc_cgal_pairs_avx512();
}

#endif
