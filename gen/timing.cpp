#include "gen/timing.hpp"

#include <fmt/format.h>

namespace meetc {

std::string timing_program(const std::string &space) {
  return fmt::format("#include <{0}/{0}_runtime.hpp>\n"
                     "#include <meetc/decide/tolerant.hpp>\n"
                     "#include <algorithm>\n"
                     "#include <chrono>\n"
                     "#include <cstdio>\n"
                     "#include <vector>\n"
                     R"(static float place(std::uint64_t &state) {{ // in [-1, 1)
  state = state * 6364136223846793005U + 1442695040888963407U;
  return static_cast<float>(static_cast<std::int64_t>(state >> 40) - (1 << 23)) * 0x1p-23F;
}}
static std::vector<float> random_rows(const meetc::kind_info &k, std::size_t n, float box, double step, std::uint64_t state) {{
  std::vector<float> rows;
  for (std::size_t i = 0; i < n; ++i)
    for (int f = 0; f < k.fields; ++f) {{
      const float x = place(state) * box;
      const float v = k.roles[f] == meetc::role::length ? (x < 0 ? -x : x) / 2 : x;
      rows.push_back(step > 0 ? meetc::nearest_multiple(v, std::ilogb(step)) : v);
    }}
  return rows;
}}
int main() {{
  const meetc::catalogue &all = {0}::catalogue();
  constexpr std::size_t n = 4096;
  std::vector<meetc::index_pair> pairs;
  for (std::uint32_t i = 0; i < n; ++i)
    pairs.push_back({{i, i}});
  for (int p = 0; p < all.predicate_count; ++p) {{
    const meetc::predicate_info &of = all.predicates[p];
    meetc::decide_function decide = nullptr; // of certified its first rung, which decides nearly all pairs
    for (const meetc::decide_function one : {{of.decide[static_cast<int>(meetc::rung::fp32)], of.decide[static_cast<int>(meetc::rung::exact)],
                                              of.certify[0], of.decide[static_cast<int>(meetc::rung::tolerant)]}})
      decide = one ? one : decide;
    if (!decide)
      continue;
    const float box = all.box > 0 ? all.box : 1;
    const std::vector<float> a = random_rows(*of.a, n, box, of.tolerance.step, 1), b = random_rows(*of.b, n, box, of.tolerance.step, 2);
    std::vector<meetc::answer> out(n);
    double least = 1;
    for (int i = 0; i < 200; ++i) {{
      const auto start = std::chrono::steady_clock::now();
      decide(a.data(), b.data(), pairs.data(), n, out.data());
      least = std::min(least, std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
    }}
    std::printf("predicate %.4g %s\n", least * 1e9 / n, of.name);
  }}
  for (int f = 0; f < all.formula_count; ++f) {{
    const meetc::formula_info &of = all.formulas[f];
    std::vector<std::vector<float>> in(static_cast<std::size_t>(of.number_count), std::vector<float>(n)),
        values(static_cast<std::size_t>(of.result_count), std::vector<float>(n));
    std::vector<meetc::column> columns;
    std::vector<float *> out;
    std::uint64_t state = 3;
    for (std::vector<float> &column : in) {{
      for (float &x : column)
        x = place(state);
      columns.push_back({{column.data(), 1}});
    }}
    for (std::vector<float> &column : values)
      out.push_back(column.data());
    double least = 1;
    for (int i = 0; i < 200; ++i) {{
      const auto start = std::chrono::steady_clock::now();
      of.float32(columns.data(), nullptr, n, out.data());
      least = std::min(least, std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
    }}
    std::printf("formula %.4g %s\n", least * 1e9 / n, of.name);
  }}
}}
)",
                     space);
}

} // namespace meetc
