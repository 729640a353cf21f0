#include "tests/gen/fuzz/batch.hpp"

#include "gen/support/process.hpp"
#include "gen/target/cpp/names.hpp"
#include "tests/gen/fuzz/harness.hpp"
#include "tests/gen/fuzz/judge.hpp"
#include "tests/gen/fuzz/rounding.hpp"
#include "tests/gen/oracle/random.hpp"

#include <cmath>
#include <dlfcn.h>
#include <fmt/format.h>

namespace meetc::fuzz {
namespace {

using oracle_test::random_numbers;

class library {
public:
  explicit library(const fs::path &path) : handle_(::dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL)) {
    if (!handle_)
      throw std::runtime_error(::dlerror());
  }
  ~library() { ::dlclose(handle_); }
  library(const library &) = delete;
  library &operator=(const library &) = delete;

  template <class T> std::vector<double> call(const entry &e, const std::vector<double> &in) const {
    const std::string symbol = e.symbol + (sizeof(T) == 8 ? 'd' : 'f');
    const auto function = reinterpret_cast<void (*)(const T *, T *)>(::dlsym(handle_, symbol.c_str()));
    if (!function)
      throw std::runtime_error("no " + symbol);
    const std::vector<T> from(in.begin(), in.end());
    std::vector<T> out(e.outputs.size(), std::numeric_limits<T>::quiet_NaN());
    function(from.data(), out.data());
    return {out.begin(), out.end()};
  }

private:
  void *handle_;
};

// The values by which the kernel's programs compute an entry, in exact numbers or in bounds: first the blades of stored
// operands, where the entry computes these.
struct steps {
  std::vector<ir::program> makers; // by operand; empty where the entry reads what its program reads
  const ir::program *last;
};
steps steps_of(const lower::model &m, const entry &e) {
  const lower::formula &f = e.of->kernel.value;
  if (e.reads == entry::from::blades)
    return {{}, &f.from_blades};
  if (e.reads == entry::from::pairs)
    return {{}, &f.for_pairs};
  if (f.is_number())
    return {{}, &f.from_stored};
  steps out{{}, &f.from_blades};
  for (const lang::kind *k : e.of->kernel.asked.kinds)
    out.makers.push_back(lower::makers(m, *k).front().code);
  return out;
}

template <class Number, class Evaluate>
std::vector<Number> made(const steps &s, const std::vector<Number> &in, Evaluate evaluate) {
  if (s.makers.empty())
    return in;
  std::vector<Number> out;
  auto at = in.begin();
  for (const ir::program &p : s.makers) {
    const auto end = at + static_cast<std::ptrdiff_t>(p.nodes.inputs().size());
    const std::vector<Number> blade = evaluate(p, std::vector<Number>(at, end));
    out.insert(out.end(), blade.begin(), blade.end());
    at = end;
  }
  return out;
}

bool all_exact(const steps &s, const std::vector<rational> &in) {
  bool exact = true;
  const std::vector<rational> last = made(s, in, [&](const ir::program &p, const std::vector<rational> &x) {
    exact = exact && is_exact(p, x);
    return ir::evaluate(p, x);
  });
  return exact && is_exact(*s.last, last);
}

std::vector<double> bounds_of(const steps &s, const std::vector<rational> &in, const precision &of) {
  std::vector<bounded> from;
  for (const rational &q : in)
    from.push_back({std::fabs(q.get_d()), 0});
  const auto last =
      made(s, from, [&](const ir::program &p, const std::vector<bounded> &x) { return error_bounds(p, x, of); });
  std::vector<double> out;
  for (const bounded &b : error_bounds(*s.last, last, of))
    out.push_back(b.error);
  return out;
}

class comparison {
public:
  comparison(const lower::model &m, const std::vector<std::unique_ptr<library>> &built, std::uint64_t seed,
             batch_result &out)
      : model_(m), built_(built), random_(seed), out_(out) {}

  void compare(const entry &e) {
    const steps s = steps_of(model_, e);
    const judge right(model_, *e.of);
    const std::size_t n = e.reads == entry::from::blades ? right.blade_numbers() : right.stored_numbers();
    const auto want = [&](const std::vector<rational> &in) {
      return e.reads == entry::from::blades ? right.on_blades(in) : right.on_stored(in);
    };
    bool found = false;
    // Small integers and halves; smaller ones where something does not fit into a double.
    for (const auto &[range, halves] : {std::pair(6, 2), std::pair(3, 1), std::pair(1, 1), std::pair(1, 0)})
      if (std::vector<rational> in = small(n, range, halves); all_exact(s, in)) {
        found = true;
        check<double>(e, in, want(in), std::vector<double>(e.outputs.size(), 0), "exactly");
        out_.exact += static_cast<long>(built_.size() * e.outputs.size());
        break;
      }
    out_.never_exact += !found;
    const std::vector<rational> wide = floats(n, 53), narrow = floats(n, 24);
    check<double>(e, wide, want(wide), spread(e, bounds_of(s, wide, double_precision)), "within its bound in double");
    check<float>(e, narrow, want(narrow), spread(e, bounds_of(s, narrow, float_precision)),
                 "within its bound in float");
    out_.within_bound += static_cast<long>(2 * built_.size() * e.outputs.size());
  }

private:
  const lower::model &model_;
  const std::vector<std::unique_ptr<library>> &built_;
  random_numbers random_;
  batch_result &out_;

  std::vector<rational> small(std::size_t n, int range, int halves) {
    std::vector<rational> out;
    for (std::size_t i = 0; i < n; ++i) {
      out.emplace_back(halves == 0 && random_.integer(0, 3) > 0 ? 0 : random_.integer(-range, range),
                       halves == 2 ? 2 : 1);
      out.back().canonicalize();
    }
    return out;
  }
  // In magnitude from 1/4 to 4, with so many bits.
  std::vector<rational> floats(std::size_t n, int bits) {
    std::vector<rational> out;
    for (std::size_t i = 0; i < n; ++i) {
      double x = 1;
      for (int b = 1; b < bits; ++b)
        x = 2 * x + random_.integer(0, 1);
      out.emplace_back(std::ldexp(random_.integer(0, 1) ? x : -x, random_.integer(-2, 1) - bits + 1));
    }
    return out;
  }

  // Bounds of the results, at the places of the outputs; other outputs are 0 without an error.
  static std::vector<double> spread(const entry &e, const std::vector<double> &of_results) {
    const std::vector<lower::blade> &results = e.of->kernel.value.result;
    std::vector<double> out(e.outputs.size(), 0);
    for (std::size_t i = 0; i < out.size(); ++i)
      for (std::size_t k = 0; k < results.size(); ++k)
        if (results[k] == e.outputs[i])
          out[i] = of_results[k];
    return out;
  }

  template <class T>
  void check(const entry &e, const std::vector<rational> &in, const multivector &want,
             const std::vector<double> &bounds, const char *how) {
    std::vector<double> numbers;
    for (const rational &q : in)
      numbers.push_back(q.get_d());
    for (std::size_t b = 0; b < built_.size(); ++b) {
      const std::vector<double> have = built_[b]->call<T>(e, numbers);
      multivector rest = want;
      for (std::size_t i = 0; i < have.size(); ++i) {
        rest[e.outputs[i]] = 0;
        const bool near = std::isfinite(have[i]) && abs(rational(have[i]) - want[e.outputs[i]]) <= rational(bounds[i]);
        if (near)
          continue;
        out_.faults.push_back({e.of, fmt::format("{}, {}: {} is {} and should be {} {} (bound {})", e.symbol,
                                                 builds()[b].name, model_.working().name(e.outputs[i]), have[i],
                                                 want[e.outputs[i]].get_str(), how, bounds[i])});
        return;
      }
      if (!oracle::is_zero(rest)) {
        out_.faults.push_back({e.of, fmt::format("{}: a coefficient is no output", e.symbol)});
        return;
      }
    }
  }
};

// Compiles both units into one library. Returns what the compilers said where they failed.
std::string compile(const fs::path &folder, const build &b, const fs::path &to) {
  const std::string include = "-I" + folder.string(), object = (folder / "batch_c.o").string();
  std::vector<std::string> c{MEETC_FUZZ_CXX, "-x",         "c",       "-std=c99", "-Wall",
                             "-Wextra",      "-Wpedantic", "-Werror", "-fPIC"};
  std::vector<std::string> cpp{MEETC_FUZZ_CXX, "-std=c++20", "-Wall", "-Wextra",
                               "-Wpedantic",   "-Werror",    "-fPIC", "-shared"};
  c.insert(c.end(), b.flags.begin(), b.flags.end());
  cpp.insert(cpp.end(), b.flags.begin(), b.flags.end());
  c.insert(c.end(), {include, "-c", (folder / "batch.c").string(), "-o", object});
  cpp.insert(cpp.end(), {include, (folder / "batch.cpp").string(), object, "-o", to.string()});
  for (const auto &command : {c, cpp})
    if (const finished_process p = run_process(command); p.code != 0)
      return p.said.substr(0, 1000);
  return "";
}

} // namespace

const std::vector<build> &builds() {
  static const std::vector<build> all = [] {
    std::vector<build> out{{"without FMA", {"-O0"}}};
#if defined(__x86_64__)
    if (__builtin_cpu_supports("fma"))
      out.push_back({"with FMA", {"-O1", "-mfma"}});
#endif
    return out;
  }();
  return all;
}

batch_result run_batch(compiler &with, const std::vector<const compiled *> &all, std::uint64_t seed,
                       const text_change &change) {
  batch_result out;
  if (all.empty())
    return out;
  const fs::path folder = test_files::folder() / "batch";
  fs::remove_all(folder);
  std::vector<target::file> files = with.emit(all);
  if (change)
    change(files);
  const auto put = [](const std::string &name, const std::string &text) {
    fs::create_directories((test_files::folder() / "batch" / name).parent_path());
    test_files::put("batch/" + name, text);
  };
  for (const target::file &f : files)
    put(f.path, f.text);
  for (const compiled *c : all)
    if (const std::string what = check_text(with, *c, files); !what.empty())
      out.faults.push_back({c, what});
  const harness h = harness_for(with.model(), all.front()->from.in->name(), all);
  put("batch.cpp", h.cpp);
  put("batch.c", h.c);
  std::vector<std::unique_ptr<library>> built;
  for (const build &b : builds()) {
    if (change && !built.empty())
      break;
    const fs::path to = folder / fmt::format("{}.so", built.size());
    if (const std::string said = compile(folder, b, to); !said.empty()) {
      out.faults.push_back({all.size() == 1 ? all.front() : nullptr, fmt::format("{}: {}", b.name, said)});
      return out;
    }
    built.push_back(std::make_unique<library>(to));
  }
  comparison compare(with.model(), built, seed, out);
  for (const entry &e : h.entries)
    compare.compare(e);
  return out;
}

std::string check_text(const compiler &with, const compiled &c, const std::vector<target::file> &files) {
  const std::string space = target::identifier(c.from.in->name()), name = c.kernel.asked.name();
  const std::vector<lower::basis_blade> fields =
      lower::named(with.model().working(), returned(with.model(), c.kernel.value));
  const auto body_of = [&](const std::string &path, const std::string &function) -> std::string {
    for (const target::file &f : files)
      if (f.path == path)
        for (std::size_t at = f.text.find(' ' + function + '('); at != std::string::npos;
             at = f.text.find(' ' + function + '(', at + 1))
          if (const std::size_t line = f.text.rfind('\n', at) + 1; f.text.compare(line, 2, "//") != 0)
            return f.text.substr(at, f.text.find("\n}\n", at) - at);
    return "";
  };
  for (const auto &[path, function] :
       {std::pair(fmt::format("{}/{}.hpp", space, name), target::kernel_function(c.kernel.asked)),
        std::pair(fmt::format("{0}/{0}.h", space), fmt::format("{}_{}", space, target::identifier(name + "_blades"))),
        std::pair(fmt::format("{0}/{0}.h", space),
                  fmt::format("{}_{}f", space, target::identifier(name + "_blades")))}) {
    const std::string body = body_of(path, function);
    const auto times = [&](const std::string &what) {
      std::size_t n = 0;
      for (std::size_t at = body.find(what); at != std::string::npos; at = body.find(what, at + 1))
        ++n;
      return n;
    };
    if (c.kernel.value.is_number()) {
      if (times("return ") != 1)
        return fmt::format("{} in {} does not return once", function, path);
      continue;
    }
    for (const lower::basis_blade &b : fields)
      if (times(fmt::format("  B.{} = ", target::blade_field(b))) != 1)
        return fmt::format("{} in {} does not assign {} once", function, path, b.text());
  }
  return "";
}

} // namespace meetc::fuzz
