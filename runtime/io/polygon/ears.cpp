#include "meet/io/polygon/ears.hpp"

#include <algorithm>

namespace meetc::io {

namespace {

bool same(const projected &a, const projected &b) {
  return a.x == b.x && a.y == b.y;
}

// Whether p, on the line through a and c, lies strictly between them.
bool between(const projected &a, const projected &p, const projected &c) {
  const auto in = [](double lo, double x, double hi) { return lo < hi ? lo < x && x < hi : hi < x && x < lo; };
  return a.x != c.x ? in(a.x, p.x, c.x) : in(a.y, p.y, c.y);
}

} // namespace

void ear_cutter::emit(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
  *out_++ = a;
  *out_++ = b;
  *out_++ = c;
}

bool ear_cutter::fan() {
  const auto n = static_cast<std::uint32_t>(p_.size());
  for (std::uint32_t i = 2; i < n; ++i)
    if (turn(p_[0], p_[i - 1], p_[i], room_) < 0)
      return false;
  for (std::uint32_t i = 2; i < n; ++i)
    emit(0, i - 1, i);
  return true;
}

// A corner at which the boundary goes back on itself.
bool ear_cutter::is_spike(std::uint32_t b) {
  const projected &a = p_[prev_[b]], &c = p_[next_[b]], &p = p_[b];
  return turn_at(b) == 0 && !between(a, p, c);
}

// Whether the edge from this corner meets the inside of the triangle at b. A separating line of a segment and a triangle, if
// there is one, runs along a side of either. `strict`: an edge that starts inside the triangle's third side blocks too,
// since taking the triangle would leave one without area there.
bool ear_cutter::blocks(std::uint32_t edge, std::uint32_t b, bool strict) {
  if (edge == prev_[b] || edge == b)
    return false;
  const projected &v0 = p_[edge], &v1 = p_[next_[edge]], t[3] = {p_[prev_[b]], p_[b], p_[next_[b]]};
  const auto [x0, x1] = std::minmax({t[0].x, t[1].x, t[2].x});
  const auto [y0, y1] = std::minmax({t[0].y, t[1].y, t[2].y});
  if (std::max(v0.x, v1.x) < x0 || std::min(v0.x, v1.x) > x1 || std::max(v0.y, v1.y) < y0 || std::min(v0.y, v1.y) > y1)
    return false;
  if (strict && edge != next_[b] && between(t[0], v0, t[2]) && turn(t[0], v0, t[2], room_) == 0)
    return true;
  for (int k = 0; k < 3; ++k)
    if (turn(t[k], t[(k + 1) % 3], v0, room_) <= 0 && turn(t[k], t[(k + 1) % 3], v1, room_) <= 0)
      return false;
  if (same(v0, v1)) // then each of the turns above is positive
    return true;
  bool left = false, right = false;
  for (const projected &corner : t) {
    const int s = turn(v0, v1, corner, room_);
    left = left || s > 0;
    right = right || s < 0;
  }
  return left && right;
}

bool ear_cutter::is_ear(std::uint32_t b, bool strict) {
  if (turn_at(b) <= 0)
    return false;
  // The edge that blocked this corner last time often still does.
  if (alive_[blocker_[b]] && blocks(blocker_[b], b, strict))
    return false;
  for (std::uint32_t e = next_[b]; e != prev_[b]; e = next_[e])
    if (blocks(e, b, strict)) {
      blocker_[b] = e;
      return false;
    }
  return true;
}

// Finds the next corner to cut off, from b on: a spike, else an ear, else a corner that lies between its neighbours.
bool ear_cutter::find(std::uint32_t &b) {
  while (!spikes_.empty()) {
    const std::uint32_t s = spikes_.back();
    spikes_.pop_back();
    if (alive_[s] && is_spike(s)) {
      b = s;
      return true;
    }
  }
  for (const bool strict : {true, false})
    for (std::size_t i = 0; i < left_; ++i, b = next_[b])
      if (is_ear(b, strict))
        return true;
  for (std::size_t i = 0; i < left_; ++i, b = next_[b])
    if (turn_at(b) == 0)
      return true;
  return false;
}

void ear_cutter::clip(std::uint32_t b) {
  const std::uint32_t a = prev_[b], c = next_[b];
  emit(a, b, c);
  next_[a] = c;
  prev_[c] = a;
  alive_[b] = 0;
  --left_;
  spikes_.push_back(a);
  spikes_.push_back(c);
}

bool ear_cutter::cut(std::span<const projected> corners, std::uint32_t *triangles) {
  p_ = corners;
  out_ = triangles;
  if (fan())
    return true;
  const auto n = static_cast<std::uint32_t>(corners.size());
  prev_.resize(n);
  next_.resize(n);
  blocker_.resize(n);
  alive_.assign(n, 1);
  spikes_.clear();
  for (std::uint32_t i = 0; i < n; ++i) {
    prev_[i] = (i + n - 1) % n;
    next_[i] = (i + 1) % n;
    blocker_[i] = i;
    spikes_.push_back(n - 1 - i);
  }
  left_ = n;
  std::uint32_t b = 1;
  while (left_ > 3 && find(b)) {
    const std::uint32_t after = next_[b];
    clip(b);
    b = next_[after];
  }
  const bool whole = left_ == 3 && turn_at(b) >= 0;
  std::uint32_t first = static_cast<std::uint32_t>(std::find(alive_.begin(), alive_.end(), 1) - alive_.begin());
  for (std::uint32_t v = next_[first]; next_[v] != first; v = next_[v])
    emit(first, v, next_[v]);
  return whole;
}

} // namespace meetc::io
