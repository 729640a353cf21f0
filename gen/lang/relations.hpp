// Reads what a kind states of its blade, relations and samples that satisfy them, and what a predicate states of its elements.
#pragma once
#include "gen/lang/spec.hpp"
#include "gen/lang/toml_reader.hpp"

namespace meetc::lang {

std::vector<field> read_fields(const toml_reader &in, const toml::node &node, const std::string &what);

// Reads `relations` and `samples` of the kind's table t into k. `what` names the table, "kinds.motor".
void read_relations(const toml_reader &in, const toml::table &t, const std::string &what, kind &k);

// Reads `means` and `common` of the predicate's table t into p. `what` names the table, "predicates.ball_ball".
void read_meaning(const toml_reader &in, const toml::table &t, const std::string &what, predicate &p);
// Throws where the kinds of its operands are no bodies, or have fewer points than are common.
void check_meaning(const algebra &a, const predicate &p);

} // namespace meetc::lang
