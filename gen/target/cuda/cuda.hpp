// Launchers of predicates and formulas on a CUDA device, over the headers of the target cpp.
#pragma once
#include "gen/target/target.hpp"

namespace meetc::target {

std::vector<file> cuda_files(const unit &u);
// The launchers. Throws spec_error where the kernel is one sign.
std::string cuda_text(const unit &u, std::size_t kernel);

// The declarations of the launchers, and the sources of the catalogue, of a predicate and of all formulas.
std::string cuda_header(const unit &u);
std::string cuda_catalogue(const unit &u);
std::string cuda_launchers(const unit &u, const lower::kernel &k);
std::string cuda_formulas(const unit &u);

} // namespace meetc::target
