#include "gen/poly/local_origin.hpp"

#include <algorithm>
#include <map>

namespace meetc::poly {

local_origin::local_origin(const ring &base, std::vector<stored_number> numbers)
    : base_(base), numbers_(std::move(numbers)) {
  std::vector<std::string> names = base.names();
  std::map<std::pair<int, int>, int> group_vector; // maps (operand, group) to a vector
  std::map<std::pair<int, int>, int> group_point;
  for (int v = 0; v < base.size(); ++v) {
    const stored_number &s = numbers_[static_cast<std::size_t>(v)];
    const residency where = s.operand == 0 ? residency::a : residency::b;
    int id = -1;
    if (s.group >= 0) {
      const auto [it, fresh] = group_vector.try_emplace({s.operand, s.group}, static_cast<int>(vectors_.size()));
      if (fresh)
        vectors_.emplace_back();
      id = it->second;
      vectors_[static_cast<std::size_t>(id)].push_back(v);
      if (s.position) {
        const auto [p, new_point] = group_point.try_emplace({s.operand, s.group}, static_cast<int>(points_.size()));
        if (new_point)
          points_.push_back({s.operand, {}});
        points_[static_cast<std::size_t>(p->second)].variables.push_back(v);
      }
    }
    info_.push_back({where, id, s.axis, v, -1});
  }
  difference_.assign(points_.size(), std::vector<int>(points_.size(), -1));
  for (std::size_t i = 0; i < points_.size(); ++i)
    for (std::size_t j = i + 1; j < points_.size(); ++j) {
      const point &from = points_[i], &to = points_[j];
      const residency where = from.operand != to.operand ? residency::pair
                              : from.operand == 0        ? residency::a
                                                         : residency::b;
      difference_[i][j] = static_cast<int>(vectors_.size());
      vectors_.emplace_back();
      for (std::size_t axis = 0; axis < from.variables.size(); ++axis) {
        vectors_.back().push_back(static_cast<int>(names.size()));
        names.push_back('(' + base.name(to.variables[axis]) + " - " + base.name(from.variables[axis]) + ')');
        info_.push_back({where, difference_[i][j], static_cast<int>(axis), to.variables[axis], from.variables[axis]});
      }
    }
  local_ = std::make_unique<ring>(std::move(names));
  for (int v = 0; v < base.size(); ++v)
    unchanged_.push_back(poly::variable(*local_, v));
}

std::vector<int> local_origin::points_of(const poly &p) const {
  const std::vector<int> used = p.variables();
  std::vector<int> out;
  for (std::size_t i = 0; i < points_.size(); ++i)
    if (std::any_of(points_[i].variables.begin(), points_[i].variables.end(),
                    [&](int v) { return std::binary_search(used.begin(), used.end(), v); }))
      out.push_back(static_cast<int>(i));
  return out;
}

bool local_origin::is_invariant(const poly &absolute) const {
  if (points_.empty())
    return false;
  for (std::size_t axis = 0; axis < points_[0].variables.size(); ++axis) {
    poly sum(base_);
    for (const point &p : points_)
      sum = sum + absolute.derivative(p.variables[axis]);
    if (!sum.is_zero())
      return false;
  }
  return true;
}

poly local_origin::lower(const poly &absolute) const {
  std::vector<poly> images = unchanged_;
  const std::vector<int> used = points_of(absolute);
  if (!used.empty() && is_invariant(absolute)) {
    const int origin = used.front();
    int second = -1; // the other operand's origin
    for (const int i : used)
      if (second < 0 &&
          points_[static_cast<std::size_t>(i)].operand != points_[static_cast<std::size_t>(origin)].operand)
        second = i;
    const auto component = [&](int i, int j, std::size_t axis) {
      const auto id = static_cast<std::size_t>(difference_[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)]);
      return poly::variable(*local_, vectors_[id][axis]);
    };
    for (const int i : used) {
      const point &p = points_[static_cast<std::size_t>(i)];
      for (std::size_t axis = 0; axis < p.variables.size(); ++axis) {
        poly image(*local_);
        if (i == origin) {
        } else if (p.operand == points_[static_cast<std::size_t>(origin)].operand) {
          image = component(origin, i, axis);
        } else {
          image = component(origin, second, axis);
          if (i != second)
            image = image + component(second, i, axis);
        }
        images[static_cast<std::size_t>(p.variables[axis])] = std::move(image);
      }
    }
  }
  return absolute.substitute(images, *local_);
}

poly local_origin::raise(const poly &local) const {
  std::vector<poly> images;
  for (const local_variable &v : info_) {
    poly image = poly::variable(base_, v.minuend);
    if (v.subtrahend >= 0)
      image = image - poly::variable(base_, v.subtrahend);
    images.push_back(std::move(image));
  }
  return local.substitute(images, base_);
}

} // namespace meetc::poly
