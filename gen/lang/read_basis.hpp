// The table [algebra]: vectors, metric and null vectors.
#pragma once
#include "gen/lang/spec.hpp"
#include "gen/lang/toml_reader.hpp"

namespace meetc::lang {

void read_basis(const toml_reader &in, const toml::table &t, algebra &out);

} // namespace meetc::lang
