#include "tests/runtime/contacts/round_truth.hpp"

#include <meetc/contact/code.hpp>

namespace meetc::contacts_test {

round_truth::round_truth(const float *ball, const float *segment) {
  for (std::size_t k = 0; k < 3; ++k) {
    p_[k] = segment[k];
    d_[k] = mpq_class(segment[3 + k]) - p_[k];
    const mpq_class w = mpq_class(ball[k]) - p_[k];
    a_ += w * w, b_ += w * d_[k], c_ += d_[k] * d_[k];
  }
  a_ -= mpq_class(ball[3]) * ball[3];
  if (c_ != 0)
    least_at_ = b_ / c_;
}

int round_truth::root_side(int which, const mpq_class &t) const {
  if (which == double_root)
    return sgn(mpq_class(least_at_ - t));
  const int before = sgn(mpq_class(least_at_ - t)), outside = sgn(power(t));
  if (which == first_root)
    return before > 0 ? outside : before == 0 && power(least_at_) == 0 ? 0 : -1;
  return before < 0 ? -outside : before == 0 && power(least_at_) == 0 ? 0 : 1;
}

int round_truth::side(int which, int k, const mpq_class &x) const {
  const mpq_class &p = p_[static_cast<std::size_t>(k)], &d = d_[static_cast<std::size_t>(k)];
  if (d == 0)
    return sgn(mpq_class(p - x));
  return sgn(d) * root_side(which, (x - p) / d);
}

std::vector<round_truth::label> round_truth::labels(bool surface) const {
  std::vector<label> out;
  const auto end = [&](int which) {
    const int outside = sgn(power(which));
    if (outside == 0 || (outside < 0 && !surface))
      out.push_back({outside == 0 ? on_ball : in_ball, which});
  };
  end(0);
  if (c_ == 0)
    return out;
  const int least = sgn(power(least_at_));
  const auto root = [&](int which) {
    if (root_side(which, 0) > 0 && root_side(which, 1) < 0)
      out.push_back({which, first_edge});
  };
  if (least == 0)
    root(double_root);
  else if (least < 0)
    root(first_root), root(second_root);
  end(1);
  return out;
}

} // namespace meetc::contacts_test
