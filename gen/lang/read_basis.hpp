// The table [algebra]: vectors, metric, null vectors and the order of blades.
#pragma once
#include "gen/lang/spec.hpp"
#include "gen/lang/toml_reader.hpp"

namespace meetc::lang {

void read_basis(const toml_reader &in, const toml::table &t, algebra &out);
// The key `order`, where the vectors are known. Replaces the order of an algebra that this one extends. Throws spec_error.
void read_order(const toml_reader &in, const toml::node &list, algebra &out);

} // namespace meetc::lang
