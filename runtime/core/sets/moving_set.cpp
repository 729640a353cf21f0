#include "meet/core/sets/moving_set.hpp"

#include "meet/core/sets/element_set.hpp"
#include "meet/core/threads/threads.hpp"
#include "meet/core/views/rows.hpp"

#include <cmath>
#include <mutex>
#include <numeric>

namespace meetc {
namespace {

// A vertex of the elements, as a row.
constexpr role xyz[3] = {role::x, role::y, role::z};
constexpr kind_info point{"point", "x,y,z", 3, xyz, 1, nullptr, nullptr};

constexpr std::uint32_t no_place = ~std::uint32_t{0}; // of a vertex that no element has

double mean_width(const level &l) {
  return std::accumulate(std::begin(l.widths), std::end(l.widths), 0.0) / static_cast<double>(l.boxes);
}

// The mean width of the boxes around sixteen elements, in that of elements, or, if these are points, in the set's own.
double spread_of(const hierarchy &h) {
  if (h.depth == 0)
    return 1;
  double unit = mean_width(h.levels[0]);
  if (unit == 0) {
    const box around = h.top().blocks[0].around();
    for (int k = 0; k < 3; ++k)
      unit += static_cast<double>(around.hi[k]) - static_cast<double>(around.lo[k]);
  }
  return unit > 0 ? mean_width(h.levels[1]) / unit : 0; // 0: all are one point
}

} // namespace

moving_set::moving_set(const view &elements, const kind_info &kind, const pose &at, int threads,
                       const std::stop_token &stop)
    : vertices_(elements.index ? elements.vertices : 0) {
  put_in_order(elements, kind, at, threads, stop);
}

void moving_set::put_in_order(const view &elements, const kind_info &kind, const pose &at, int threads,
                              const std::stop_token &stop) {
  under_standard_word([&] {
    prepared next = prepare(elements, kind, at, threads, nullptr, stop);
    std::vector<std::uint32_t> used, index;
    if (elements.index) {
      const auto points = static_cast<std::size_t>(kind.points);
      std::vector<std::uint32_t> place(vertices_, no_place); // of each vertex among those that are used
      index.resize(elements.elements * points);
      for_strips({1, stop}, elements.elements, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin * points; i < end * points; ++i) {
          const std::uint32_t vertex = elements.index[next.set().order[i / points] * points + i % points];
          if (place[vertex] == no_place) {
            place[vertex] = static_cast<std::uint32_t>(used.size());
            used.push_back(vertex);
          }
          index[i] = place[vertex];
        }
      });
    }
    points_.resize(3 * used.size());
    used_ = std::move(used), index_ = std::move(index);
    spread_ = spread_of(next.set().boxes);
    spare_ = std::exchange(now_, std::move(next));
  });
}

void moving_set::require_alike(const view &moved) const {
  if (moved.elements != now_.elements() || (vertices_ > 0 && moved.vertices != vertices_))
    throw usage_error("a set that moves keeps its number of elements and of vertices");
  if (vertices_ == 0 && moved.index && moved.elements > 0)
    throw usage_error("a set that moves keeps its rows, and has no index now");
}

// Writes the points in their places; false: one is not finite.
bool moving_set::pose_points(const view &moved, const pose &at, magnitudes &most, const execution &on) {
  view points = moved;
  points.index = used_.data(), points.elements = used_.size();
  std::mutex lock;
  for_chunks(on, used_.size(), 1024, [&](int, std::size_t begin, std::size_t end) {
    float *const to = points_.data() + 3 * begin;
    fetch(points, point, at, begin, end, to);
    const magnitudes of_mine = magnitudes_of(point, to, end - begin);
    const std::scoped_lock hold(lock);
    most.add(of_mine);
  });
  return std::isfinite(most.reach);
}

prepared moving_set::refitted(const view &moved, const pose &at, const execution &on) {
  const kind_info &kind = now_.kind();
  prepared p;
  p.take(spare_, kind, now_.elements());
  status s = status::ok;
  if (index_.empty())
    s = refit(*p.set_, now_.set(), moved, at, nullptr, on);
  else if (magnitudes most; pose_points(moved, at, most, on)) {
    const view placed{points_.data(), used_.size(), 0, index_.data(), moved.elements};
    s = refit(*p.set_, now_.set(), placed, {}, &most, on);
    p.set_->grid = at.grid;
  } else
    s = status::bad_value;
  if (s != status::ok)
    refuse_least(moved, at);
  p.finish(now_.elements(), 0);
  return p;
}

// The vertices of each element, by slot.
std::vector<std::uint32_t> moving_set::index_by_slot() const {
  std::vector<std::uint32_t> out;
  out.reserve(index_.size());
  for (const std::uint32_t point : index_)
    out.push_back(used_[point]);
  return out;
}

// Throws the fault of the least element that is bad.
void moving_set::refuse_least(const view &moved, const pose &at) const {
  const kind_info &kind = now_.kind();
  const std::uint32_t *const order = now_.set().order;
  const std::vector<std::uint32_t> index = index_by_slot();
  view one = with_stride(moved, kind);
  one.elements = 1;
  const auto alone = [&](std::size_t slot) {
    view v = one;
    if (!index.empty())
      v.index = index.data() + slot * static_cast<std::size_t>(kind.points);
    else // a stride may be odd
      v.data = reinterpret_cast<const float *>(reinterpret_cast<const char *>(v.data) + order[slot] * v.stride_bytes);
    return v;
  };
  std::vector<float> row(static_cast<std::size_t>(kind.fields));
  std::size_t least = now_.elements();
  for (std::size_t slot = 0; slot < now_.elements(); ++slot)
    if ((least == now_.elements() || order[slot] < order[least]) &&
        gather(alone(slot), kind, at, 0, 1, row.data()) != status::ok)
      least = slot;
  refuse(alone(least), order[least], kind, at);
}

void moving_set::update(const view &moved, const pose &at, int threads, const std::stop_token &stop) {
  under_standard_word([&] {
    require_alike(moved);
    const kind_info &kind = now_.kind();
    view given = moved;
    given.index = index_.empty() ? nullptr : index_.data();
    if (const char *const wrong = wrong_with(given, kind)) {
      fault f;
      f.kind = fault_kind::view, f.rule = wrong;
      throw input_error(f, kind);
    }
    if (const status s = movable(kind, at); s != status::ok)
      throw usage_error(text(s));
    prepared next = refitted(given, at, execution_on(threads, stop));
    spare_ = std::exchange(now_, std::move(next));
  });
}

void moving_set::reorder(const view &moved, const pose &at, int threads, const std::stop_token &stop) {
  require_alike(moved);
  const kind_info &kind = now_.kind();
  const std::vector<std::uint32_t> by_slot = index_by_slot();
  std::vector<std::uint32_t> index(by_slot.size());
  const auto points = static_cast<std::size_t>(kind.points);
  for (std::size_t slot = 0; slot < now_.elements() && !index.empty(); ++slot)
    std::copy_n(&by_slot[slot * points], points, &index[now_.set().order[slot] * points]);
  view v = moved;
  v.index = index.empty() ? nullptr : index.data();
  put_in_order(v, kind, at, threads, stop);
}

double moving_set::looseness() const {
  return under_standard_word([&] {
    const double now = spread_of(now_.set().boxes);
    return now == spread_ ? 1 : now / spread_; // both may be 0
  });
}

} // namespace meetc
