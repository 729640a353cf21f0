// bench/tables/paper/brute_force.hpp: every pair of two sets decided on one core, as in the paper.
//
// Method: each test is called for blocks of pairs of one row of a with many rows of b. If there are more pairs than the
// budget allows, rows are left out evenly on both sides: the work of brute force is proportional to the number of pairs.
#ifndef MEETC_BENCH_TABLES_PAPER_BRUTE_FORCE_HPP
#define MEETC_BENCH_TABLES_PAPER_BRUTE_FORCE_HPP

#include "meet/bench/harness/method.hpp"
#include "meet/io/elements/element_set.hpp"
#include "meetc/support.hpp"

#include <cstdint>
#include <vector>

namespace meetc::bench {

// A test of pairs. Those that read stored values read the ones of the plain rung, or of the bounded rungs.
struct pair_test {
  pair_decider decide;
  bool plain = false;
};

class brute_force {
public:
  // a and b are the predicate's first and second set; their stored values are computed here.
  brute_force(const predicate_info &predicate, const io::element_set &a, const io::element_set &b,
              std::uint64_t budget);

  std::uint64_t pairs() const { return a_.count() * b_.count(); } // in the sample
  bool is_sample() const { return share_ < 1; }
  double share() const { return share_; } // of all pairs

  void run(const pair_test &test) const; // on all pairs of the sample
  // How the answers of a test differ from those of another one.
  difference compared(const pair_test &test, const pair_test &truth) const;

private:
  // Rows with what a predicate wants stored beside them: for its plain rung, and for the others.
  struct side {
    std::vector<float> rows, plain, bounded;
    std::size_t fields, floats;

    side(const io::element_set &set, std::size_t stride, const stored_values &of_plain,
         const stored_values &of_bounded);
    std::size_t count() const { return rows.size() / fields; }
    row_array from(std::size_t row, bool for_plain) const;
  };
  void decide(const pair_test &test, std::size_t i, std::size_t j, std::size_t n, answer *out) const;
  template <class Take> void each_block(const Take &take) const;

  side a_, b_;
  double share_;
  std::vector<index_pair> one_with_many_; // (0, j)
};

// The classic tests as functions of rows.
namespace classic {
extern const decide_function balls, moller, moller_0, guigue_devillers, moller_trumbore;
}

} // namespace meetc::bench

#endif
