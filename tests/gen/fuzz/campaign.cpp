#include "tests/gen/fuzz/campaign.hpp"

#include "gen/verify/verify.hpp"
#include "tests/gen/fuzz/judge.hpp"

#include <algorithm>
#include <ctime>
#include <fmt/format.h>

namespace meetc::fuzz {

std::string current;

namespace {

// A message without what is quoted, so that refusals of one sort are counted together.
std::string sort_of(const std::string &message) {
  std::string out;
  bool quoted = false;
  for (const char c : message) {
    if (c == '\'')
      quoted = !quoted;
    if (!quoted || c == '\'')
      out += c >= '0' && c <= '9' ? '#' : c;
  }
  if (const std::size_t at = out.find(" is not defined here"); at != std::string::npos)
    return "a call is not defined" + out.substr(at + 15, 5);
  if (out.find("needs the number") != std::string::npos)
    return "a constant is beyond 2^53";
  return out;
}

class campaign {
public:
  explicit campaign(const plan &p) : plan_(p) {}

  std::string fault_of(const formula &f) { return alone(f); }

  tally run() {
    std::map<std::string, std::vector<compiled>> waiting;
    for (long i = plan_.first; i < plan_.first + plan_.count; ++i) {
      const formula f = draw(plan_.seed, i);
      std::optional<compiled> c = one(f, &out_);
      if (c && plan_.machine_code) {
        std::vector<compiled> &batch = waiting[f.in->name()];
        batch.push_back(std::move(*c));
        if (batch.size() == 50)
          flush(batch);
      }
      if (plan_.talk && (i + 1 - plan_.first) % 500 == 0)
        fmt::print(stderr, "{} formulas, {} findings\n", i + 1 - plan_.first, out_.findings.size());
    }
    for (auto &[name, batch] : waiting)
      flush(batch);
    return std::move(out_);
  }

private:
  plan plan_;
  tally out_;

  // A long run may be ended before its end.
  void keep(finding f) {
    if (plan_.talk)
      fmt::print(stderr, "{}", text_of(f));
    out_.findings.push_back(std::move(f));
  }
  std::map<std::string, std::unique_ptr<compiler>> compilers_;

  compiler &compiler_of(const space &s) {
    std::unique_ptr<compiler> &c = compilers_[s.name()];
    if (!c)
      c = std::make_unique<compiler>(s);
    return *c;
  }

  void begin(const std::string &what) const {
    current = what;
    if (plan_.before_each)
      plan_.before_each();
  }

  // Compiles and judges the programs of one formula. Nothing where it is refused or wrong. Without a tally, only `fault_`
  // says what was wrong.
  std::string fault_;
  std::optional<compiled> one(const formula &f, tally *t) {
    compiler &with = compiler_of(*f.in);
    begin(f.text());
    fault_.clear();
    std::optional<compiled> c;
    const std::clock_t start = std::clock();
    try {
      c = with.compile(f);
    } catch (const spec_error &e) {
      if (e.message().empty() || !e.where())
        fault_ = "an error without a message or a place: " + e.render();
      else if (e.message().find("needs the number") == std::string::npos && with.expands(f))
        fault_ = "refused, though it expands: " + e.message();
      if (t)
        ++t->refused, ++t->refusals[sort_of(e.message())];
    } catch (const std::exception &e) {
      fault_ = fmt::format("internal: {}", e.what());
    }
    const double seconds = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
    if (fault_.empty() && seconds > most_seconds)
      fault_ = fmt::format("meetc took {:.1f} seconds", seconds);
    if (t) {
      ++t->formulas;
      t->seconds += seconds;
      if (seconds > t->slowest)
        t->slowest = seconds, t->slowest_text = current;
    }
    if (c && fault_.empty())
      judge_programs(with, *c, t);
    if (!fault_.empty()) {
      if (t)
        keep(smaller(f, [this](const formula &g) {
          one(g, nullptr);
          return fault_;
        }));
      return std::nullopt;
    }
    if (c && t)
      ++t->compiled, ++t->by_space[f.in->name()], ++t->chosen[with.way_of(*c)], t->too_long += !c->was_expanded;
    return c;
  }

  void judge_programs(compiler &with, compiled &c, tally *t) {
    if (plan_.change)
      plan_.change(c.kernel);
    try {
      const verify::report r =
          verify::verify_formula(with.model(), c.kernel, 2, static_cast<unsigned>(c.from.number) + 1);
      if (t)
        t->cases += r.cases;
      if (r.wrong > 0 || r.cases == 0) {
        fault_ = fmt::format("verify: {}", r.first_wrong);
        return;
      }
      std::optional<lower::declared_formula> declared;
      std::size_t terms = 0;
      for (const poly::poly &p : c.kernel.value.polynomials)
        terms += p.length();
      if (c.was_expanded && terms < 200 && !plan_.change)
        try {
          declared = with.in_declared_basis(c);
        } catch (const spec_error &) {
          // It is long there, as where a factor is zero and the other one long.
        }
      fault_ = judge(with.model(), c)
                   .programs(plan_.seed + static_cast<std::uint64_t>(c.from.number), declared ? &*declared : nullptr);
    } catch (const std::exception &e) {
      fault_ = fmt::format("while judging: {}", e.what());
    }
  }

  std::string machine_fault(compiler &with, const std::vector<const compiled *> &all, batch_result &r) const {
    try {
      r = run_batch(with, all, plan_.seed);
      return "";
    } catch (const std::exception &e) {
      return fmt::format("while emitting: {}", e.what());
    }
  }

  void flush(std::vector<compiled> &batch) {
    if (batch.empty())
      return;
    compiler &with = compiler_of(*batch.front().from.in);
    begin(fmt::format("a batch in {} from {} on", batch.front().from.in->name(), batch.front().from.text()));
    std::vector<const compiled *> all;
    for (const compiled &c : batch)
      all.push_back(&c);
    batch_result r;
    const std::string fault = machine_fault(with, all, r);
    out_.exact += r.exact, out_.within_bound += r.within_bound, out_.never_exact += r.never_exact;
    std::vector<const compiled *> wrong;
    for (const batch_result::fault &f : r.faults)
      if (wrong.empty() || wrong.back() != f.of)
        wrong.push_back(f.of);
    if (!fault.empty() || std::find(wrong.begin(), wrong.end(), nullptr) != wrong.end())
      wrong = all; // one of the batch, which is not known: each is tried alone
    const std::size_t before = out_.findings.size();
    std::sort(wrong.begin(), wrong.end()); // as they were drawn
    wrong.erase(std::unique(wrong.begin(), wrong.end()), wrong.end());
    for (const compiled *c : wrong)
      if (!alone(c->from).empty())
        keep(smaller(c->from, [this](const formula &g) { return alone(g); }));
    if (!wrong.empty() && out_.findings.size() == before) // only together
      keep({batch.front().from, batch.front().from,
            "only in a batch: " + (fault.empty() ? r.faults.front().what : fault)});
    batch.clear();
  }

  // The fault of a formula in a batch of its own, or "".
  std::string alone(const formula &f) {
    const std::optional<compiled> c = one(f, nullptr);
    if (!c)
      return fault_;
    batch_result r;
    const std::string fault = machine_fault(compiler_of(*f.in), {&*c}, r);
    return !fault.empty() ? fault : r.faults.empty() ? "" : r.faults.front().what;
  }

  // Takes parts away while something is wrong.
  template <class Fault> finding smaller(const formula &f, Fault fault) {
    finding out{f, f, fault(f)};
    int left = 100; // tries, of which some take seconds
    const auto better = [&](const formula &g) {
      if (left-- <= 0)
        return false;
      if (const std::string what = fault(g); !what.empty()) {
        out.smallest = g, out.what = what;
        return true;
      }
      return false;
    };
    for (bool again = true; again && left > 0;) {
      const formula now = out.smallest;
      again = for_each_smaller(now, better);
    }
    return out;
  }
};

const char *name_of(way w) {
  return w == way::expanded    ? "expanded"
         : w == way::arguments ? "from values of arguments"
                               : "from values of all parts";
}

} // namespace

tally run(const plan &p) {
  return campaign(p).run();
}

std::string fault_of(const formula &f) {
  return campaign({}).fault_of(f);
}

std::string text_of(const finding &f) {
  return fmt::format("FINDING: {}\n  drawn:    {}\n  smallest: {}\n", f.what, f.of.text(), f.smallest.text());
}

std::string text_of(const tally &t) {
  std::string out = fmt::format("{} formulas: {} compiled, {} refused, {} findings\n", t.formulas, t.compiled,
                                t.refused, t.findings.size());
  for (const auto &[space, n] : t.by_space)
    out += fmt::format("  {}: {}\n", space, n);
  for (const auto &[way, n] : t.chosen)
    out += fmt::format("  {}: {}\n", name_of(way), n);
  out += fmt::format("  too long to expand: {}\n", t.too_long);
  out += fmt::format(
      "{} cases of verify; machine code: {} values exact, {} within their bounds; {} functions without operands that "
      "doubles hold exactly\n",
      t.cases, t.exact, t.within_bound, t.never_exact);
  out += fmt::format("meetc took {:.1f} s; {:.2f} s for the slowest one, {}\n", t.seconds, t.slowest, t.slowest_text);
  for (const auto &[message, n] : t.refusals)
    out += fmt::format("  refused {} times: {}\n", n, message);
  for (const finding &f : t.findings)
    out += text_of(f);
  return out;
}

} // namespace meetc::fuzz
