// The parts of emitted C++: each function writes a file or a part of one.
#pragma once
#include "gen/target/target.hpp"

namespace meetc::target {

std::string banner(const lang::scene &s, const std::string &what, const char *comment = "//");
// `first`: the kernel header that comes first. One of formulas needs few of them, and so takes little time to compile.
inline constexpr const char *formula_support = "number/formula.hpp";
std::string open_header(const lang::scene &s, const std::string &name, const std::vector<std::string> &includes = {},
                        const std::vector<std::string> &kernel_headers = {}, const char *first = "support.hpp");
std::string close_header(const lang::scene &s);
// Breaks long lines of code after commas.
std::string broken_lines(const std::string &text);

// The structs of all kinds.
std::string kinds_header(const unit &u);
// The contents of a formula's namespace in its header.
std::string formula_header(const unit &u, const lower::kernel &k);
// The header of a function that is no polynomial.
std::string analytic_text(const unit &u, std::size_t kernel);
// The header of a kernel that consists of signs, after its banner.
std::string kernel_header(const unit &u, std::size_t kernel);
// The code of the generated library, for header-only users.
std::string header_only(const unit &u);

// The predicates of which a runtime can decide pairs of sets.
std::vector<const lower::kernel *> predicates_of(const unit &u);
// The sign by which a runtime orders the hits of this predicate; null: the scene does not ask for it, or not for certified
// answers.
const lower::kernel *order_of(const unit &u, const lower::kernel &predicate);
// The sign by which a runtime finds where the operands of this predicate meet; null as above.
const lower::kernel *contacts_of(const unit &u, const lower::kernel &predicate);
// The kinds that predicates take, in the spec's order.
std::vector<const lower::lowered_kind *> element_kinds(const unit &u);
// The index of a kernel's operand among them.
std::size_t element_place(const std::vector<const lower::lowered_kind *> &elements, const lower::kernel &k,
                          std::size_t operand);
std::string shapes_header(const unit &u);
std::string operators_header(const unit &u);
// The names of a kind's numbers in a CSV file.
std::string csv_names(const lower::lowered_kind &k);

// The formulas that a runtime evaluates on columns: those of one operand or more that take stored numbers.
std::vector<const lower::kernel *> formulas_on_columns(const unit &u);
std::string columns_header(const unit &u);
std::string formulas_source(const unit &u);
std::string for_each_header(const unit &u);

// The table of kinds and predicates by which a runtime knows this namespace.
std::string runtime_header(const unit &u);
std::string runtime_source(const unit &u);

// The header of one kernel.
std::string cpp_text(const unit &u, std::size_t kernel);
// Headers and the runtime table.
std::vector<file> cpp_files(const unit &u);

// The kernel headers that were packed into the generator.
std::vector<file> kernel_headers();

} // namespace meetc::target
