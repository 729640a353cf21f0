// The command that checks every kernel of a scene.
#include "gen/driver.hpp"
#include "gen/support/output.hpp"
#include "gen/verify/verify.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace meetc {
namespace {

class verification {
public:
  verification(const compilation &c, const verify_options &o) : c_(c), o_(o) {}

  void check(std::size_t kernel) {
    const lower::kernel &k = c_.kernels[kernel];
    tell(k.asked.text, fmt::format("{:<36} ", k.asked.text), k.is_predicate && !k.is_sign, [&] {
      return k.is_sign        ? verify::verify_sign(*c_.model, k, std::max(1L, o_.cases / 10), o_.seed)
             : k.is_predicate ? verify::verify_predicate(*c_.model, k, o_.cases, o_.seed)
                              : verify::verify_formula(*c_.model, k, std::max(1L, o_.cases / 50), o_.seed);
    });
    if (c_.bounds[kernel] && !c_.bounds[kernel]->settled_by.empty())
      tell(k.asked.text + ", settled by equal points", "  settled by equal points: ", false, [&] {
        return verify::verify_settled(*c_.model, k, *c_.bounds[kernel], std::max(1L, o_.cases / 10), o_.seed);
      });
  }

  // exp, gives and the like are no polynomials: there is no exact value to compare with.
  void pass_over(const lower::analytic_kernel &k) {
    unchecked_.push_back(k.text);
    say(fmt::format("{:<36} not checked: its values are no rational numbers; the header states their error\n", k.text));
  }

  // The summary, and the exit code.
  int end() const {
    say(fmt::format("{}: {} wrong of {} cases in {} kernels\n", c_.scene->name, wrong_, cases_, c_.kernels.size()));
    if (!by_text_.empty())
      say(fmt::format(
          "judged by the dense products of their own text, which tell a wrong program and no wrong question, "
          "since a kind has no hull: {}\n",
          join(by_text_, ", ")));
    if (!unchecked_.empty())
      say(fmt::format("not checked: {}{}\n", join(unchecked_, ", "),
                      o_.allow_unchecked ? "" : " (--allow-unchecked accepts this)"));
    return wrong_ > 0 || (!unchecked_.empty() && !o_.allow_unchecked) ? 1 : 0;
  }

private:
  const compilation &c_;
  const verify_options &o_;
  long wrong_ = 0, cases_ = 0;
  std::vector<std::string> unchecked_, by_text_;

  // Runs one check and says what it found. A check that fails or compares nothing leaves the others as they are.
  template <class Check> void tell(const std::string &what, const std::string &lead, bool geometry, Check check) {
    verify::report r;
    try {
      r = check();
    } catch (const spec_error &e) {
      r = {};
      r.note = fmt::format("not checked: {}", e.what());
    }
    if (r.cases == 0 && r.note.empty())
      r.note = "not checked: none of the cases was a valid one";
    cases_ += r.cases;
    wrong_ += r.wrong;
    if (r.cases == 0) {
      unchecked_.push_back(what);
      say(fmt::format("{}{}\n", lead, r.note));
      return;
    }
    say(fmt::format("{}{} wrong of {}", lead, r.wrong, r.cases));
    say(geometry ? fmt::format(" ({} hits, {} degenerate){}\n", r.hits, r.degenerate, r.by_text ? ", by its text" : "")
                 : "\n");
    if (r.by_text)
      by_text_.push_back(what);
    if (r.wrong)
      say(fmt::format("  first: {}\n", r.first_wrong));
  }
};

} // namespace

int verify_scene(const verify_options &o) {
  compilation c = load(o.scene, o.algebra_path);
  compile_all(c);
  verification all(c, o);
  for (std::size_t i = 0; i < c.kernels.size(); ++i)
    all.check(i);
  for (const lower::analytic_kernel &k : c.analytic)
    all.pass_over(k);
  return all.end();
}

} // namespace meetc
