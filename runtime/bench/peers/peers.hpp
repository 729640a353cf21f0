// bench/peers/peers.hpp: other libraries that find pairs or decide them, behind one interface.
//
// Each library has one source in this folder, which is compiled where CMake is asked for it (MEETC_BENCH_PEERS) and finds
// the library. Nothing else includes their headers.
#ifndef MEETC_BENCH_PEERS_PEERS_HPP
#define MEETC_BENCH_PEERS_PEERS_HPP

#include "meetc/table/table.hpp"

#include <cstddef>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace meetc::bench::peers {

// Packed rows of 9 floats (triangles) or 6 (segments).
struct packed_rows {
  const float *data;
  std::size_t count;
};

// One way in which a library finds pairs of two sets. The sets outlive it.
class pair_finder {
public:
  virtual ~pair_finder() = default;
  virtual void build() = 0;                               // whatever a query needs; called again, it starts anew
  virtual void query(std::vector<index_pair> &found) = 0; // replaces what is there; in any order
};

struct finder_settings {
  int threads;
  instruction_set set;
};

enum class finds : unsigned char { touching, candidates };
struct offered_finder {
  std::string name;
  finds what;
  // A set against itself: both are the same rows.
  std::function<std::unique_ptr<pair_finder>(packed_rows a, packed_rows b, const finder_settings &)> make;
};

// A library, and how its code was compiled: "its package's baseline build" or as this program is.
struct library {
  std::string name;
  bool built_in = false; // false: nothing else is known
  std::string version = {}, compiled = {};
  std::vector<offered_finder> triangles_triangles = {}, segments_triangles = {};
};

// Embree, CGAL, FCL and trueform, in this order, whether built in or not.
std::vector<library> libraries();

// An exact kernel's decisions on n pairs of triangles, row i with row i, for one instruction set. The functions are plain
// because each set's code lies in a library of its own.
struct exact_pairs {
  void *(*make)(const float *a, const float *b, std::size_t n); // in the kernel's own numbers
  void (*decide)(const void *made, answer *out);
  void (*drop)(void *made);
};

// CGAL's exact predicates compiled for this set, or null.
const exact_pairs *cgal_pairs_for(instruction_set set);

} // namespace meetc::bench::peers

#endif
