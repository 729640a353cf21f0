// Kinds that are given by grades alone: all blades of these grades, with a stored number for each.
#pragma once
#include "gen/lang/spec.hpp"
#include "gen/lang/toml_reader.hpp"

namespace meetc::lang {

// Reads `grades` of the kind's table t into k. `what` names the table, "kinds.even".
void read_grades(const toml_reader &in, const toml::table &t, const std::string &what, kind &k);

// Gives each kind with `grades` what it stores and its blade, once the vectors are known: the blades by grade, and those
// of one grade in the order of the vectors. The number of e1 ^ e2 is called c_e1_e2, that of the scalar c_1.
void complete_grades(algebra &a);

} // namespace meetc::lang
