#include "meet/app/query/choose.hpp"

#include "meet/app/input/failure.hpp"
#include "meet/core/query/find.hpp"

#include <fmt/format.h>

namespace meetc::app {

namespace {

constexpr const char *rung_names[rung_count] = {"fp32", "fp64", "fp64x2", "exact", "certified", "tolerant"};

std::string join(const std::vector<std::string> &words) {
  std::string out;
  for (const std::string &w : words)
    out += (out.empty() ? "" : ", ") + w;
  return out;
}

std::string names_of(const std::vector<choice> &choices) {
  std::vector<std::string> names;
  for (const choice &c : choices)
    names.emplace_back(c.predicate->name);
  return join(names);
}

// Lists each pair of kinds once.
std::string supported_pairs(const catalogue &all) {
  std::vector<std::string> pairs;
  for (int i = 0; i < all.predicate_count; ++i) {
    const predicate_info &p = all.predicates[i];
    std::string pair = fmt::format("{} with {}", p.a->name, p.b->name);
    bool known = false;
    for (const std::string &other : pairs)
      known = known || other == pair;
    if (!known)
      pairs.push_back(std::move(pair));
  }
  return join(pairs);
}

choice choose_by_name(const catalogue &all, const std::vector<choice> &fit, const std::string &name,
                      const std::string &kinds) {
  for (const choice &c : fit)
    if (c.predicate->name == name)
      return c;
  for (int i = 0; i < all.predicate_count; ++i) {
    const predicate_info &p = all.predicates[i];
    if (p.name == name)
      throw failure(fmt::format("--predicate {}: it is for {} with {}, but the files hold {}; for these: {}", name,
                                p.a->name, p.b->name, kinds, names_of(fit)));
  }
  throw failure(fmt::format("--predicate {}: unknown; for {} there is: {}", io::quote(name), kinds, names_of(fit)));
}

} // namespace

std::string mode_named(const std::optional<std::string> &mode) {
  if (mode && *mode != "solid" && *mode != "surface")
    throw failure(fmt::format("--mode {}: unknown; known: solid, surface", io::quote(*mode)));
  return mode.value_or("solid");
}

choice choose(const catalogue &all, const kind_info &a, const kind_info &b, const std::optional<std::string> &name,
              const std::optional<std::string> &mode) {
  const std::string wanted = mode_named(mode);
  const std::string kinds = fmt::format("{} with {}", a.name, b.name);
  const std::vector<choice> fit = fitting(all, a, b);
  if (fit.empty())
    throw failure(fmt::format("no predicate for {}; supported: {}", kinds, supported_pairs(all)));
  if (name) {
    const choice c = choose_by_name(all, fit, *name, kinds);
    const std::string_view own = c.predicate->mode;
    if (mode && !own.empty() && own != *mode)
      throw failure(fmt::format("--predicate {} answers for --mode {}, not {}", *name, own, *mode));
    return c;
  }
  if (const std::optional<choice> c = first_for(fit, wanted))
    return *c;
  throw failure(fmt::format("no predicate for {} in --mode {}; there is: {}", kinds, wanted, names_of(fit)));
}

self_predicates of_one_mesh(const catalogue &all, const catalogue &neighbours) {
  return {find_predicate(all, "triangle_triangle"), find_predicate(neighbours, "beyond_corner"),
          find_predicate(neighbours, "beyond_edge")};
}

const char *name_of(rung precision) {
  return rung_names[static_cast<int>(precision)];
}

rung precision_named(std::string_view name) {
  constexpr int known = static_cast<int>(rung::tolerant); // which --tolerance asks for
  for (int i = 0; i < known; ++i)
    if (name == rung_names[i])
      return static_cast<rung>(i);
  throw failure(fmt::format("--precision {}: there is none of this name; known: {}", io::quote(name),
                            join({rung_names, rung_names + known})));
}

const catalogue &kernels_named(const kernel_library &all, std::string_view name) {
  if (name == "auto")
    return all.best();
  std::vector<std::string> known{"auto"};
  for (int i = 0; i < instruction_set_count; ++i)
    if (const catalogue *kernels = all.of(static_cast<instruction_set>(i))) {
      known.emplace_back(name_of(kernels->compiled_for));
      if (name == known.back())
        return *kernels;
    }
  throw failure(fmt::format("--instruction-set {}: not in this build or not for this processor; known: {}",
                            io::quote(name), join(known)));
}

} // namespace meetc::app
