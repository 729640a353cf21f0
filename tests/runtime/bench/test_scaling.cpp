// The fitted exponent and its tolerance.
#include "tests/catch.hpp"

#include "meet/bench/harness/scaling.hpp"

#include <cmath>
#include <random>

using meetc::bench::fit_power;
using meetc::bench::power_fit;

namespace {

const std::vector<double> sizes{5e3, 20e3, 100e3, 345e3, 1.4e6, 5.5e6};

std::vector<double> powers(double exponent) {
  std::vector<double> counts;
  for (const double n : sizes)
    counts.push_back(7 * std::pow(n, exponent));
  return counts;
}

} // namespace

TEST_CASE("a power is found, and distinguished from others") {
  const power_fit root = fit_power(sizes, powers(0.5), 0.5, 0.1);
  CHECK(root.exponent == Approx(0.5));
  CHECK(root.holds);
  CHECK(std::abs(root.worst) < 1e-9);
  CHECK(root.tolerance < 0.05);
  for (const double other : {0.0, 0.4, 0.6, 2.0 / 3, 1.0}) {
    const power_fit fit = fit_power(sizes, powers(other), 0.5, 0.1);
    CHECK(fit.exponent == Approx(other).margin(1e-9));
    CHECK_FALSE(fit.holds);
  }
}

TEST_CASE("counts within the scatter never leave the tolerance, and some reach it") {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> share(-1, 1);
  for (int i = 0; i < 1000; ++i) {
    std::vector<double> counts = powers(0.5);
    for (double &c : counts)
      c *= std::pow(1.1, share(random));
    CHECK(fit_power(sizes, counts, 0.5, 0.1).holds);
  }
  std::vector<double> tilted = powers(0.5);
  double mean = 0;
  for (const double n : sizes)
    mean += std::log(n) / static_cast<double>(sizes.size());
  for (std::size_t i = 0; i < sizes.size(); ++i)
    tilted[i] *= std::log(sizes[i]) > mean ? 1.1 : 1 / 1.1;
  const power_fit fit = fit_power(sizes, tilted, 0.5, 0.1);
  CHECK(fit.exponent - 0.5 == Approx(fit.tolerance));
  CHECK_FALSE(fit_power(sizes, tilted, 0.5, 0.05).holds);
}

TEST_CASE("the farthest row is named, and rows of size or count 0 are left out") {
  std::vector<double> counts = powers(0.5);
  counts[4] *= 0.8;
  const power_fit fit = fit_power(sizes, counts, 0.5, 0.1);
  CHECK(fit.worst == Approx(-0.2));
  CHECK(fit.worst_size == Approx(1.4e6));
  CHECK(in_words(fit).find("farthest from it is the row of 1,400,000, 20 % below") != std::string::npos);
  CHECK(in_words(fit_power(sizes, powers(0), 0, 0.1)).find("exponent 0.000, expected 0 ") == 0);
  CHECK(in_words(fit_power(sizes, powers(0), 0, 0.1)).find("no row is off it by 1 %") != std::string::npos);
  counts[2] = 0;
  CHECK(fit_power(sizes, counts, 0.5, 0.1).holds);
  CHECK(std::isnan(fit_power({1, 2}, {0, 5}, 0.5, 0.1).exponent));
  CHECK(std::isnan(fit_power({3, 3}, {4, 5}, 0.5, 0.1).exponent));
  CHECK_FALSE(fit_power({}, {}, 0.5, 0.1).holds);
  CHECK(in_words(fit_power({}, {}, 0.5, 0.1)) == "too few rows with hits to fit an exponent");
  CHECK(as_json(fit_power({}, {}, 0.5, 0.1)).dump() == R"({"law":0.5,"exponent":null,"holds":false})");
}
