// app/output/pair_values.hpp: the values of a formula for the pairs that a query has found, as a table.
#ifndef MEETC_APP_OUTPUT_PAIR_VALUES_HPP
#define MEETC_APP_OUTPUT_PAIR_VALUES_HPP

#include "meet/io/elements/element_set.hpp"
#include "meetc/table/table.hpp"

#include <filesystem>
#include <span>
#include <string>

namespace meetc::app {

struct formula_choice {
  const formula_info *formula = nullptr;
  bool swapped = false; // the formula's first operand is an element of the user's b
  bool float32 = false; // computed in float32; else in float64
};

// The formula of this text for the kinds of two sets in either order. Throws failure, which names those that take both, also
// where pairs are of polygons or polylines that have several elements.
formula_choice choose_formula(const catalogue &all, const io::element_set &a, const io::element_set &b,
                              const std::string &text, bool float32);

// Writes a line "a,b,VALUE..." for each pair, in their order. Numbers are the shortest decimals that give the same float.
// Values are of the elements' numbers, rounded and moved as `meet collide` reads them. Throws io::error.
void write_pair_values(const std::filesystem::path &to, const formula_choice &by, const io::element_set &a,
                       const io::element_set &b, std::span<const index_pair> pairs, int threads);

} // namespace meetc::app

#endif
