// Reads and checks what a predicate says of its two elements.
#pragma once
#include "gen/lang/spec.hpp"
#include "gen/lang/toml_reader.hpp"

namespace meetc::lang {

// Reads `means` and `common` of the predicate's table t into p. `what` names the table, "predicates.ball_ball".
void read_meaning(const toml_reader &in, const toml::table &t, const std::string &what, predicate &p);

// Throws where the kinds of its operands are no bodies, or have fewer points than are common.
void check_meaning(const algebra &a, const predicate &p);

} // namespace meetc::lang
