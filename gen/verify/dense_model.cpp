#include "gen/verify/dense_model.hpp"

namespace meetc::verify {
namespace {

oracle::matrix working_metric(const lower::model &m) {
  const auto n = static_cast<std::size_t>(m.working().vectors());
  oracle::matrix out(n, std::vector<oracle::rational>(n));
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < n; ++j)
      out[i][j] = m.working().product(static_cast<int>(i), static_cast<int>(j));
  return out;
}

oracle::matrix identity(const lower::model &m) {
  const auto n = static_cast<std::size_t>(m.working().vectors());
  oracle::matrix out(n, std::vector<oracle::rational>(n));
  for (std::size_t i = 0; i < n; ++i)
    out[i][i] = 1;
  return out;
}

} // namespace

dense_evaluator dense_evaluator_of(const lower::model &m) {
  return {m.spec(), working_metric(m), m.to_working(), identity(m)};
}

} // namespace meetc::verify
