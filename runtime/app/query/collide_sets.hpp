// app/query/collide_sets.hpp: collides two sets with one predicate, and gathers the data of a report and of a picture.
#ifndef MEETC_APP_QUERY_COLLIDE_SETS_HPP
#define MEETC_APP_QUERY_COLLIDE_SETS_HPP

#include "meet/app/query/choose.hpp"
#include "meet/app/query/device_pairs.hpp"
#include "meet/core/hierarchy/box.hpp"
#include "meet/core/query/collide.hpp"
#include "meet/core/query/self_pairs.hpp"
#include "meet/io/elements/element_set.hpp"

#include <functional>

namespace meetc::app {

struct side_answer {
  box bounds{};                  // around all elements; lo > hi where there are none
  std::vector<std::uint8_t> hit; // 1 for each of the file's items that is in a pair
  std::uint64_t touched = 0;     // the number of these; with `any` 0 or 1
};

struct answers {
  std::vector<index_pair> list;          // of items, sorted by a, then b; empty unless `keep`
  std::vector<index_pair> element_pairs; // with query::elements: in the predicate's order, sorted likewise
  // With query::first: for each item of the predicate's first set that touches something, the pair that it meets first;
  // sorted likewise.
  std::vector<index_pair> first;
  std::uint64_t pairs = 0;      // with `any` 0 or 1
  std::uint64_t candidates = 0; // pairs of elements that the predicate decided
  rung_report rungs;            // of `certified`
  side_answer a, b;
  double prepare_seconds = 0, collide_seconds = 0;
  processor on = processor::cpu;  // which of the two answered
  device_account by_device;       // on processor::cuda
  std::vector<std::string> notes; // on the choice of processor, if collide_sets() made it
};

struct query {
  choice by;
  rung precision = rung::certified;
  // An answer may be wrong only where moving one element by at most `tolerance` changes it; 0: never. For the sake of
  // the tolerance, numbers are rounded to multiples of `grid`.
  double tolerance = 0, grid = 0;
  float box = 0;     // of the scene; 0: none
  bool any = false;  // stop at the first pair
  bool keep = false; // keep the list of pairs; without it, and without polygons, memory does not grow with the pairs
  bool elements = false; // keep the list of pairs of elements as well, such as the triangles of polygons
  bool first = false;    // of each segment, the pair with the triangle that it meets first
  const self_predicates *embedded_by = nullptr; // with contacts: also tell whether both meshes are embedded
  int threads = 0;                              // 0: all cores
  processor on = processor::cpu;                // best: the one that is expected to be the faster
  int devices = 1;                              // the number of devices that share the query
  std::function<void(double fraction)> progress = {};
};

// Sets q.tolerance and q.grid. Throws failure if the predicate keeps no such tolerance.
void set_tolerance(query &q, double tolerance);

// Throws failure if the predicate was not generated for the precision or for `first`, and std::bad_alloc.
answers collide_sets(const io::element_set &a, const io::element_set &b, const query &q);

} // namespace meetc::app

#endif
