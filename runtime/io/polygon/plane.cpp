#include "meet/io/polygon/plane.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace meetc::io {

namespace {
constexpr double u = 0x1p-53;
}

int turn(const projected &a, const projected &b, const projected &c, exact_sum &room) {
  const double left = (b.x - a.x) * (c.y - a.y), right = (b.y - a.y) * (c.x - a.x);
  const double difference = left - right;
  // Each product has three roundings, and the difference one.
  if (std::abs(difference) > 8 * u * (std::abs(left) + std::abs(right)))
    return difference > 0 ? 1 : -1;
  if (left == 0 && right == 0) // a difference is 0 only if its numbers are equal
    return 0;
  room.clear();
  for (const auto &[p, q] : {std::pair(a, b), std::pair(b, c), std::pair(c, a)}) {
    room.add(p.x * q.y); // exact: 24 by 24 bits
    room.add(-(p.y * q.x));
  }
  return room.sign();
}

polygon_plane::polygon_plane(std::span<const float> corners) : corners_(corners) {
  for (int k = 0; k < 3; ++k) {
    const int l = (k + 1) % 3, m = (k + 2) % 3;
    double sum = 0, size = 0;
    for (std::size_t i = 1; i + 1 < this->size(); ++i) {
      const double x = from_first(i, l) * from_first(i + 1, m), y = from_first(i, m) * from_first(i + 1, l);
      sum += x - y;
      size += std::abs(x) + std::abs(y);
    }
    normal_[k] = sum;
    // Three roundings for a product, one for a difference, and one for each sum.
    error_[k] = (static_cast<double>(this->size()) + 8) * u * size;
  }
  find_axis();
}

exact_sum polygon_plane::component(int k) const {
  const int l = (k + 1) % 3, m = (k + 2) % 3;
  exact_sum sum;
  for (std::size_t i = 0; i < size(); ++i) {
    sum.add(at(i, l) * at(i + 1, m)); // exact: 24 by 24 bits
    sum.add(-(at(i, m) * at(i + 1, l)));
  }
  return sum;
}

void polygon_plane::find_axis() {
  int best = 0;
  for (int k = 1; k < 3; ++k)
    if (std::abs(normal_[k]) > std::abs(normal_[best]))
      best = k;
  bool certain = std::abs(normal_[best]) > error_[best];
  for (int k = 0; k < 3; ++k)
    certain = certain && (k == best || std::abs(normal_[best]) - error_[best] > std::abs(normal_[k]) + error_[k]);
  if (certain) {
    axis_ = best;
    side_ = normal_[best] > 0 ? 1 : -1;
    return;
  }
  const exact_sum exact[3] = {component(0), component(1), component(2)};
  best = 0;
  for (int k = 1; k < 3; ++k) {
    exact_sum more;
    more.add_magnitude(exact[k], false);
    more.add_magnitude(exact[best], true);
    if (more.sign() > 0)
      best = k;
  }
  side_ = exact[best].sign();
  axis_ = side_ == 0 ? -1 : best;
}

double polygon_plane::distance() const {
  if (axis_ < 0)
    return 0;
  double length = std::hypot(normal_[0], normal_[1], normal_[2]);
  if (!(length > 4 * (error_[0] + error_[1] + error_[2]))) // the sums may have cancelled
    length = std::hypot(component(0).value(), component(1).value(), component(2).value());
  double most = 0;
  for (std::size_t i = 1; i < size(); ++i) {
    double height = 0, error = 0;
    for (int k = 0; k < 3; ++k) {
      const double d = from_first(i, k);
      height += normal_[k] * d;
      error += (error_[k] + 8 * u * std::abs(normal_[k])) * std::abs(d);
    }
    if (std::abs(height) <= error) {
      if (error == 0)
        continue;
      exact_sum exact;
      for (int k = 0; k < 3; ++k) {
        const int l = (k + 1) % 3, m = (k + 2) % 3;
        for (std::size_t j = 0; j < size(); ++j)
          for (const std::size_t of : {i, std::size_t{0}}) {
            const double c = of == i ? at(i, k) : -at(0, k);
            exact.add_product(at(j, l) * at(j + 1, m), c);
            exact.add_product(-(at(j, m) * at(j + 1, l)), c);
          }
      }
      height = exact.value();
    }
    most = std::max(most, std::abs(height));
  }
  return most == 0 ? 0 : most / length;
}

} // namespace meetc::io
