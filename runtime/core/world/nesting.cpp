#include "meet/core/world/nesting.hpp"

#include "meet/core/sets/element_set.hpp"
#include "meet/core/sets/posed_blocks.hpp"
#include "meet/core/sets/topology.hpp"

#include <bit>
#include <vector>

namespace meetc {
namespace {

// The elements of a body that a ray meets, found in the hierarchy of its own frame as posed_blocks are.
class ray_walk {
public:
  ray_walk(const standing_body &body, const float point[3])
      : body_(body), set_(body.shape.set()),
        point_(point), ray_{{point[0], point[1], point[2]}, {point[0], point[1], std::numeric_limits<float>::max()}},
        rows_(static_cast<std::size_t>(lanes * set_.kind->fields)) {}

  std::int64_t winding() {
    visit(set_.boxes.depth - 1, 0);
    return sum_;
  }

private:
  void visit(int at, std::size_t block) {
    const level &here = set_.boxes.levels[at];
    for (std::size_t i = 0; i < here.filled(block); ++i) {
      const std::size_t child = block * lanes + i;
      if (apart(posed_box(body_.at, here.get(child), set_.longest), ray_))
        continue;
      if (at == 1)
        add(child);
      else
        visit(at - 1, child);
    }
  }
  // A block of elements, posed as prepare() does.
  void add(std::size_t block) {
    const kind_info &kind = *set_.kind;
    const auto fields = static_cast<std::size_t>(kind.fields);
    const std::size_t filled = set_.boxes.levels[0].filled(block);
    std::copy_n(set_.rows + block * lanes * fields, filled * fields, rows_.data());
    move_rows(kind, body_.at, rows_.data(), filled);
    box_block boxes;
    box_rows(kind, rows_.data(), filled, &boxes);
    for (std::uint32_t mask = touching(boxes, ray_); mask != 0; mask &= mask - 1)
      sum_ += body_.winding(point_, rows_.data() + static_cast<std::size_t>(std::countr_zero(mask)) * fields, 1);
  }

  const standing_body &body_;
  const element_set &set_;
  const float *point_;
  box ray_;
  std::vector<float> rows_;
  std::int64_t sum_ = 0;
};

bool holds(const box &b, const float point[3]) {
  return !apart(b, {{point[0], point[1], point[2]}, {point[0], point[1], point[2]}});
}

// An element, or the item to which it belongs, in words.
std::string element_of(const standing_body &body, std::uint32_t element) {
  return "element " + std::to_string(body.owners.empty() ? element : body.owners[element]) + " of " + body.name;
}

// On which sides of a body the parts of another one lie.
struct sides {
  bool in = false, out = false;
  std::string undefined; // why it is not known
};

sides sides_of(const standing_body &inner, const standing_body &outer, const execution &on) {
  sides found;
  const element_set &of = inner.shape.set(), &around = outer.shape.set();
  const box bounds = posed_box(outer.at, around.around, around.longest);
  std::vector<float> row(static_cast<std::size_t>(of.kind->fields));
  for (const set_topology::corner &c : inner.shape.topology(on.stop).parts) {
    on.go_on();
    std::copy_n(of.rows + c.slot * row.size(), row.size(), row.data());
    move_rows(*of.kind, inner.at, row.data(), 1);
    float point[3];
    hull_point(*of.kind, row.data(), c.point, point);
    if (!outer.winding || !holds(bounds, point)) {
      found.out = true;
      continue;
    }
    if (const std::optional<std::uint32_t> open = outer.shape.topology(on.stop).open) {
      found.undefined = element_of(outer, *open) + " has an edge where the surface is open or not oriented";
      break;
    }
    const std::int64_t winding = ray_walk(outer, point).winding();
    if (winding != 0 && winding != 1) {
      found.undefined = outer.name + " goes around " + element_of(inner, of.order[c.slot]) + " " +
                        std::to_string(winding) +
                        (winding == -1 ? " times, so that its normals point inwards" : " times");
      break;
    }
    (winding == 1 ? found.in : found.out) = true;
  }
  return found;
}

} // namespace

// Both boundaries consist of pieces that lie inside or outside the other body, since none lies on it. The interiors of a and b
// have points in common iff some piece lies inside the other body; a has points that b lacks iff a piece of a lies outside or
// one of b inside; and b likewise.
std::optional<nesting_found> nesting_of(const standing_body &a, const standing_body &b, const execution &on) {
  const sides of_a = sides_of(a, b, on), of_b = sides_of(b, a, on);
  for (const sides *const s : {&of_a, &of_b})
    if (!s->undefined.empty())
      return nesting_found{nesting::unknown, s->undefined};
  if (!of_a.in && !of_b.in)
    return std::nullopt;
  if (!of_a.out && !of_b.in)
    return nesting_found{nesting::a_inside_b, {}};
  if (!of_b.out && !of_a.in)
    return nesting_found{nesting::b_inside_a, {}};
  return nesting_found{nesting::overlapping, {}};
}

} // namespace meetc
