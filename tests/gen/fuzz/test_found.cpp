// The faults that the fuzzer has found, each in a small form.
#include "tests/catch.hpp"
#include "tests/gen/fuzz/campaign.hpp"

using namespace meetc;
using namespace meetc::fuzz;

namespace {

const space &named(const std::string &name) {
  for (const space &s : spaces())
    if (s.name() == name)
      return s;
  throw std::out_of_range(name);
}

// f(kinds...) = body.
formula with_kinds(const char *in, const expression_ptr &body, const std::vector<std::string> &kinds) {
  formula out{&named(in), 0, body, {}, kinds};
  for (std::size_t i = 0; i < kinds.size(); ++i)
    out.arguments.push_back(parameter(static_cast<int>(i)));
  return out;
}

bool compiles(const formula &f) {
  compiler with(*f.in);
  with.compile(f);
  return true;
}

} // namespace

TEST_CASE("an argument of one grade may be computed from parts that have more, and still be in a function's domain") {
  const expression_ptr moved = call("sandwich", {parameter(0), parameter(1)});
  // A motor moves a plane to a plane. That cannot be seen from motor*plane alone, which is odd.
  CHECK(compiles(with_kinds("pga3", call("meet", {moved, parameter(1)}), {"motor", "plane"})));
  CHECK(fault_of(with_kinds("pga3", call("meet", {moved, parameter(1)}), {"motor", "plane"})).empty());
  const expression_ptr twice = call("sandwich", {call("gp", {parameter(0), parameter(0)}), moved});
  CHECK(compiles(with_kinds("pga3", call("meet", {twice, moved}), {"motor", "plane"})));
  CHECK(fault_of(with_kinds("pga3", call("meet", {twice, moved}), {"motor", "plane"})).empty());
}

TEST_CASE("the parts of a fraction may be integers of different sizes") {
  const auto number = [](const char *decimals) {
    return std::make_shared<expression>(expression{.is = form::number, .text = decimals});
  };
  const auto over = [](expression_ptr a, expression_ptr b) {
    return std::make_shared<expression>(expression{.is = form::divide, .parts = {std::move(a), std::move(b)}});
  };
  const expression_ptr small = over(over(parameter(0), number("1000003")), number("1000003"));
  CHECK(fault_of(with_kinds("pga3", small, {"motor"})).empty());
}
