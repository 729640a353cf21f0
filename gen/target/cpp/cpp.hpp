// The parts of emitted C++, one function a file or a part of one.
#pragma once
#include "gen/target/target.hpp"

namespace meetc::target {

std::string banner(const lang::scene &s, const std::string &what, const char *comment = "//");
std::string open_header(const lang::scene &s, const std::string &name, const std::vector<std::string> &includes = {},
                        const std::vector<std::string> &kernel_headers = {});
std::string close_header(const lang::scene &s);

// The header of a kernel that is made of signs, after its banner.
std::string kernel_header(const unit &u, std::size_t kernel);
// What the generated library compiles, for those who have headers alone.
std::string header_only(const unit &u);

std::vector<const lower::kernel *> predicates_of(const unit &u);
// The kinds that predicates take.
std::vector<const lang::kind *> element_kinds(const unit &u);
std::string shapes_header(const unit &u);

// The table of kinds and predicates through which a runtime knows this namespace.
std::string runtime_header(const unit &u);
std::string runtime_source(const unit &u);

// Launchers of the predicates on a CUDA device: their declarations, the source of the catalogue, and that of a predicate.
std::string cuda_header(const unit &u);
std::string cuda_catalogue(const unit &u);
std::string cuda_launchers(const unit &u, const lower::kernel &k);

// Touching balls as a matrix product, for scenes with a CUDA backend.
std::string ball_form_header(const unit &u);

// The kernel headers, as the generator was built with them.
std::vector<file> kernel_headers();

} // namespace meetc::target
