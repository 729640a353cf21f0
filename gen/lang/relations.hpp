// Reads what a kind states of its blade: relations, and samples that satisfy them.
#pragma once
#include "gen/lang/spec.hpp"
#include "gen/lang/toml_reader.hpp"

namespace meetc::lang {

std::vector<field> read_fields(const toml_reader &in, const toml::node &node, const std::string &what);

// Reads `relations` and `samples` of the kind's table t into k. `what` names the table, "kinds.motor".
void read_relations(const toml_reader &in, const toml::table &t, const std::string &what, kind &k);

} // namespace meetc::lang
