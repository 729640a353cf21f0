// The fuzzer itself: a short run, and the faults that it must find.
#include "tests/catch.hpp"
#include "tests/gen/fuzz/campaign.hpp"

#include <set>

using namespace meetc;
using namespace meetc::fuzz;

namespace {

// The first formulas that compile and whose value has several coefficients.
std::vector<compiled> some(compiler &with, const space &in, std::size_t count) {
  std::vector<compiled> out;
  for (long number = 0; out.size() < count; ++number) {
    const formula f = draw(11, number);
    if (f.in != &in)
      continue;
    try {
      out.push_back(with.compile(f));
    } catch (const spec_error &) {
      continue;
    }
    if (out.back().kernel.value.result.size() < 2)
      out.pop_back();
  }
  return out;
}

// Changes the statements of the emitted C++ function on blades.
void change_body(std::vector<target::file> &files, const compiled &c,
                 const std::function<bool(std::string &)> &change) {
  for (target::file &f : files)
    if (f.path.ends_with('/' + c.kernel.asked.name() + ".hpp")) {
      const std::size_t from = f.text.find(" B;\n"), to = f.text.find("  return B;", from);
      std::string body = f.text.substr(from, to - from);
      if (!change(body))
        return;
      f.text.replace(from, to - from, body);
      return;
    }
}

bool replace_first(std::string &text, const std::string &from, const std::string &to) {
  const std::size_t at = text.find(from);
  if (at != std::string::npos)
    text.replace(at, from.size(), to);
  return at != std::string::npos;
}

bool finds(compiler &with, const compiled &c, const std::function<bool(std::string &)> &change, bool &changed) {
  changed = false;
  const batch_result r = run_batch(with, {&c}, 5, [&](std::vector<target::file> &files) {
    change_body(files, c, [&](std::string &body) { return changed = change(body); });
  });
  return !r.faults.empty();
}

} // namespace

TEST_CASE("a short run of the fuzzer finds nothing, and meets every way to compute a formula") {
  const tally t = run({.seed = 30, .count = 30});
  INFO(text_of(t));
  CHECK(t.findings.empty());
  CHECK(t.compiled >= 20);
  CHECK(t.chosen.size() == 3);
  CHECK(t.too_long > 0);
  CHECK(t.exact > 1000);
  CHECK(t.within_bound > 1000);
}

TEST_CASE(
    "a coefficient that a compiled formula lacks is found in every formula, with a smaller formula that shows it") {
  std::set<std::string> changed, found;
  const tally t = run({.seed = 3, .count = 25, .machine_code = false, .change = [&](lower::kernel &k) {
                         lower::formula &f = k.value;
                         if (f.result.size() < 2)
                           return;
                         f.result.pop_back(), f.result_names.pop_back(), f.from_blades.results.pop_back();
                         if (f.is_expanded())
                           f.polynomials.pop_back();
                         changed.insert(k.asked.function.substr(0, k.asked.function.find('_')));
                       }});
  INFO(text_of(t));
  long smaller = 0;
  for (const finding &f : t.findings) {
    found.insert(f.of.function());
    smaller += size(*f.smallest.body) < size(*f.of.body);
    CHECK(size(*f.smallest.body) <= size(*f.of.body));
  }
  CHECK(changed == found);
  CHECK(found.size() >= 8);
  CHECK(smaller >= 5);
}

TEST_CASE("a formula without results, and one with a sign changed, are found in every formula") {
  const auto count = [](const std::function<void(lower::kernel &)> &change) {
    const tally t = run({.seed = 4, .count = 12, .machine_code = false, .change = change});
    INFO(text_of(t));
    CHECK(t.compiled == 0);
    CHECK(t.findings.size() >= 8);
  };
  count([](lower::kernel &k) { k.value.from_blades.results.clear(); });
  count([](lower::kernel &k) { // of the whole value, so that the polynomials say the same
    lower::formula &f = k.value;
    ir::node_id &first = f.from_blades.results.front();
    if (f.is_expanded() && f.polynomials.front().is_zero()) { // then it becomes a number that is not zero
      first = f.from_blades.nodes.constant(1);
      f.polynomials.front() = poly::poly(*f.numbers, 1);
      return;
    }
    first = f.from_blades.nodes.negate(first);
    if (f.is_expanded())
      f.polynomials.front() = f.polynomials.front().scaled(-1);
  });
}

TEST_CASE("a line lost from emitted code, and a changed operator in it, are found by the compiled comparison") {
  int lost = 0, signs = 0, products = 0;
  for (const space &in : spaces()) {
    compiler with(in);
    for (const compiled &c : some(with, in, 2)) {
      INFO(c.from.text());
      bool changed = false;
      CHECK((finds(
          with, c,
          [](std::string &body) { // an assignment, which is then of no value
            const std::size_t at = body.rfind("  B."), end = body.find('\n', at);
            body.erase(at, end + 1 - at);
            return true;
          },
          changed)));
      lost += changed;
      const bool found_sign = finds(
          with, c,
          [](std::string &body) {
            return replace_first(body, " - ", " + ") || replace_first(body, " + ", " - ") ||
                   replace_first(body, "multiply_add<T>(", "multiply_add<T>(-");
          },
          changed);
      CHECK(found_sign == changed);
      signs += changed;
      const bool found_product = finds(
          with, c, [](std::string &body) { return replace_first(body, " * ", " + "); }, changed);
      CHECK(found_product == changed);
      products += changed;
    }
  }
  CHECK(lost == 8);
  CHECK(signs >= 6);
  CHECK(products >= 3);
}
