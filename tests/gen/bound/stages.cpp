#include "tests/gen/bound/stages.hpp"

#include <cga/cga.hpp>
#include <cga/for_each.hpp>
#include <cga/header_only.hpp>
#include <map>
#include <stdexcept>

namespace meetc::bounds_test {
namespace {

template <class P, class Stage, bool Fused> struct runner {
  static void in_tiny(const sample &s, double floor, tiny *v, tiny *m) {
    tiny a[P::inputs_a], b[P::inputs_b];
    for (int i = 0; i < P::inputs_a + P::inputs_b; ++i)
      (i < P::inputs_a ? a[i] : b[i - P::inputs_a]) =
          tiny::of(std::ldexp(static_cast<double>(s.numbers[static_cast<std::size_t>(i)]), s.scale));
    tiny::fusing = Fused;
    tiny::contracting = tiny::format.contract_values;
    meetc::stage_values<Stage>(a, b, v);
    tiny::contracting = tiny::format.contract_magnitudes;
    meetc::stage_magnitudes<Stage>(a, b, meetc::leaf_magnitude<tiny>{tiny::of(floor)}, m);
    tiny::contracting = false;
    tiny::fusing = true;
  }
  template <class I> static void rows(const sample &s, I *a, I *b) {
    for (int i = 0; i < P::inputs_a + P::inputs_b; ++i)
      (i < P::inputs_a ? a[i] : b[i - P::inputs_a]) = static_cast<I>(s.numbers[static_cast<std::size_t>(i)]);
  }
  static void in_integers(const sample &s, double floor, int128 *v, int128 *m) {
    int128 a[P::inputs_a], b[P::inputs_b];
    rows(s, a, b);
    meetc::stage_values<Stage>(a, b, v);
    const auto leaf = [&](int128 d) {
      const tiny computed = tiny::rounded({std::ldexp(static_cast<double>(d), s.scale), 0});
      const double t = meetc::leaf_magnitude<tiny>{tiny::of(floor)}(computed).value();
      return static_cast<int128>(std::ldexp(t, -s.scale));
    };
    meetc::stage_magnitudes<Stage>(a, b, leaf, m);
  }
  static void in_fp64(const sample &s, double *words) {
    double a[P::inputs_a], b[P::inputs_b];
    rows(s, a, b);
    if constexpr (Stage::mixed) {
      meetc::double_double v[Stage::atoms];
      meetc::stage_values<Stage>(a, b, v);
      for (int i = 0; i < Stage::atoms; ++i)
        words[2 * i] = v[i].hi, words[2 * i + 1] = v[i].lo;
    } else {
      double v[Stage::atoms];
      meetc::stage_values<Stage>(a, b, v);
      for (int i = 0; i < Stage::atoms; ++i)
        words[2 * i] = v[i], words[2 * i + 1] = 0;
    }
  }
  static void count(counted *v, counted *m) {
    counted::fuses = counted::fuses && Fused;
    counted a[P::inputs_a], b[P::inputs_b];
    std::fill(a, a + P::inputs_a, counted::input());
    std::fill(b, b + P::inputs_b, counted::input());
    meetc::stage_values<Stage>(a, b, v);
    meetc::stage_magnitudes<Stage>(
        a, b, [](const counted &) { return counted(); }, m);
  }
};

struct analysed_kernel {
  const lower::kernel *kernel;
  bound::kernel_bounds bounds;
};

const analysed_kernel &kernel_named(const std::string &name) {
  static std::map<std::string, analysed_kernel> known;
  const auto at = known.find(name);
  if (at != known.end())
    return at->second;
  for (const lower::kernel &k : shipped_scene().kernels)
    if (k.asked.name() == name)
      return known[name] = {&k, bound::analyse(lower::subject_of(k.decision)).value()};
  throw std::logic_error("the shipped scene has no " + name);
}

template <class P, class Stage, bool Fused>
void add(std::vector<stage_case> &out, const std::string &name, const analysed_kernel &k, const ir::program &code,
         const bound::stage_bounds &bounds) {
  if constexpr (Stage::atoms > 0) {
    using run = runner<P, Stage, Fused>;
    out.push_back({name,
                   P::inputs_a,
                   P::inputs_b,
                   Stage::atoms,
                   Stage::degree,
                   Stage::growth,
                   Stage::window,
                   Stage::floor_fp32,
                   Stage::floor_fp64,
                   Stage::box_lowest,
                   Stage::box_highest,
                   Stage::mixed,
                   Fused,
                   k.kernel,
                   &code,
                   &k.bounds,
                   &bounds,
                   Fused ? &Stage::factor : &Stage::factor_unfused,
                   Fused ? &Stage::box : &Stage::box_unfused,
                   &Stage::degree_of,
                   &Stage::zero_if,
                   &P::coincident,
                   &run::in_tiny,
                   &run::in_integers,
                   &run::in_fp64,
                   &run::count});
  }
}

template <class P, class Stage>
void add_both(std::vector<stage_case> &out, const std::string &name, const analysed_kernel &k, const lower::stage &from,
              const bound::stage_bounds &bounds) {
  if (from.atoms.empty())
    return;
  add<P, Stage, true>(out, name, k, from.code, bounds);
  add<P, Stage, false>(out, name + ", unfused", k, bounds.unfused->code, bounds.unfused->bounds);
}
template <class P> void add_all(std::vector<stage_case> &out, const std::string &name) {
  const analysed_kernel &k = kernel_named(name);
  const lower::predicate &d = k.kernel->decision;
  add_both<P, typename P::reject_stage>(out, name + ", reject", k, d.reject, k.bounds.reject);
  add_both<P, typename P::common_stage>(out, name + ", common", k, d.common, k.bounds.common);
  add_both<P, typename P::rare_stage>(out, name + ", rare", k, d.rare, k.bounds.rare);
}

// A sign kernel has only the common stage.
template <class P> void add_sign(std::vector<stage_case> &out, const std::string &name) {
  const analysed_kernel &k = kernel_named(name);
  add_both<P, typename P::common_stage>(out, name + ", sign", k, k.kernel->decision.common, k.bounds.common);
}

} // namespace

const compilation &shipped_scene() {
  static const compilation compiled = [] {
    compilation c = load(MEETC_SCENE);
    compile_all(c);
    return c;
  }();
  return compiled;
}

const std::vector<stage_case> &both_schedules() {
  static const std::vector<stage_case> stages = [] {
    std::vector<stage_case> out;
    cga::for_each_sign([&out](auto p) { add_sign<typename decltype(p)::type>(out, p.name); });
    cga::for_each_predicate([&out](auto p) {
      if (std::string_view(p.name) != "box_box") // which compares numbers, and rounds none
        add_all<typename decltype(p)::type>(out, p.name);
    });
    return out;
  }();
  return stages;
}

const std::vector<stage_case> &all_stages() {
  static const std::vector<stage_case> fused = [] {
    std::vector<stage_case> out = both_schedules();
    std::erase_if(out, [](const stage_case &c) { return !c.fused; });
    return out;
  }();
  return fused;
}

} // namespace meetc::bounds_test
