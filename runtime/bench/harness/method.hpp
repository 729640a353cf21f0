// bench/harness/method.hpp: methods that answer the same question about a scene, timed by turns and checked.
//
// A method is a name, steps that are timed apart, and the difference of its answer from the truth of the scene.
// A method that promises the truth, and whose answer is another, ends the benchmark: its times would mean nothing.
#ifndef MEETC_BENCH_HARNESS_METHOD_HPP
#define MEETC_BENCH_HARNESS_METHOD_HPP

#include "meet/bench/harness/turns.hpp"
#include "meetc/table/table.hpp"

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

namespace meetc::bench {

// How an answer differs from the true one: hits that are not true, and true ones that it lacks.
struct difference {
  std::uint64_t found = 0, extra = 0, missed = 0;
  std::uint64_t wrong() const { return extra + missed; }
};

// `truth` is sorted by a, then b, and holds no pair twice. A pair that the list holds twice counts as an extra one.
difference difference_of(std::vector<index_pair> found, const std::vector<index_pair> &truth);
// One answer for each pair of a list.
difference difference_of(std::span<const answer> given, std::span<const answer> truth);
// Where only numbers of hits are known.
difference difference_of(std::uint64_t found, std::uint64_t truth);

// Decides a list of pairs, as a decide_function does.
using pair_decider = std::function<void(row_array a, row_array b, const index_pair *pairs, std::size_t n, answer *out)>;
// By the filter cascade of a rung; empty: the predicate was not generated for it.
pair_decider decider_of(const predicate_info &p, rung precision);

struct method {
  std::string name;
  bool promises_truth = true;
  works steps;                        // in this order
  std::function<difference()> answer; // after the last step; empty: nothing is to be compared, and nothing promised
};

struct measured {
  std::vector<double> seconds; // of each step
  difference found;
};
struct measured_methods {
  std::vector<measured> of; // each method
  int repetitions = 0;
};

// Times the steps of all methods by turns, then asks for their answers. Throws app::failure with app::check_failed, which
// names the scene, where a method that promises the truth gives another answer.
measured_methods measure(const std::string &scene, clock &by, const std::vector<method> &all, const turns &how);

// The same check of one answer.
void require_truth(const std::string &scene, const std::string &method, const difference &found);

} // namespace meetc::bench

#endif
