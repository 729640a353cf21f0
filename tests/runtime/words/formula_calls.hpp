// The public functions that evaluate formulas, as entries of core_entries.cpp.
#ifndef MEETC_TESTS_RUNTIME_WORDS_FORMULA_CALLS_HPP
#define MEETC_TESTS_RUNTIME_WORDS_FORMULA_CALLS_HPP

#include "entries.hpp"

namespace words_test {

void call_evaluate(caller &under);
void call_columns_of(caller &under);
void call_common_objects(caller &under);
void call_require_rows(caller &under);
void call_formula_named(caller &under);
void call_find_formula(caller &under);
void call_column(caller &under);

} // namespace words_test

#endif
