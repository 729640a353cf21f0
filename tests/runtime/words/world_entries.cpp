#include "entries.hpp"
#include "sets.hpp"

#include "meet/core/contacts/contacts.hpp"
#include "meet/core/query/find.hpp"
#include "meet/core/query/self_pairs.hpp"
#include "meet/core/world/world.hpp"

#include <neighbours/neighbours_runtime.hpp>

namespace words_test {
namespace {

using namespace meetc;

const rows &triangles(unsigned seed) {
  static const rows one = some_rows(*touching().a, 1), other = some_rows(*touching().a, 2);
  return seed == 1 ? one : other;
}
void call_fitting(caller &under) {
  const catalogue &all = cga::catalogue();
  for (int i = 0; i < all.kind_count; ++i)
    for (int k = 0; k < all.kind_count; ++k) {
      std::vector<choice> found;
      under([&] { found = fitting(all, all.kinds[i], all.kinds[k]); });
      under.add(found.size());
      std::optional<choice> first;
      under([&] { first = first_for(found, "solid"); });
      under.add(first ? first->predicate : nullptr);
    }
}

void call_turned(caller &under) {
  static const result of =
      collide(prepare(view_of(triangles(1), *touching().a), *touching().a),
              prepare(view_of(triangles(2), *touching().b), *touching().b), touching(), rung::certified);
  result r;
  under([&] { r = turned(of); });
  under.add_all(r.pairs);
}
void call_self_pairs(caller &under) {
  const view of = view_of(triangles(1), *touching().a);
  const prepared set = prepare(of, *touching().a);
  for (const bool merge : {true, false}) {
    self_options o;
    o.threads = 2;
    o.merge = merge;
    self_result r;
    under([&] {
      r = self_pairs(set, of,
                     {touching(), find_predicate(neighbours::catalogue(), "beyond_corner"),
                      find_predicate(neighbours::catalogue(), "beyond_edge")},
                     o);
    });
    under.add_all(r.pairs), under.add_all(r.degenerate), under.add(r.candidates), under.add_all(r.neighbours, 3);
    under.add_all(r.rungs.unsure, bounded_rungs);
  }
}

template <class Real> void call_contacts_in(caller &under) {
  const view a = view_of(triangles(1), *touching().a), b = view_of(triangles(2), *touching().b);
  for (const pose &at : {pose(), some_pose()}) {
    const result touch = collide(prepare(a, *touching().a, at), prepare(b, *touching().b), touching(), rung::exact);
    contact_options o;
    o.at_a = at;
    o.threads = 2;
    contact_set<Real> found;
    under([&] { found = contacts<Real>(a, b, touching(), touch.pairs, o); });
    under.add_all(found.codes), under.add_all(found.points), under.add_all(found.closed);
    under.add_all(found.corners.nodes), under.add_all(found.polylines.nodes), under.add_all(found.patches.nodes);
    under.add_all(found.single_nodes);
    std::size_t nodes = 0, lists = 0;
    under([&] { nodes = found.nodes(), lists = found.corners.size(); });
    under.add(nodes), under.add(lists);
    for (std::size_t i = 0; i < found.nodes(); ++i)
      under([&] {
        for (const decimal_fraction &f : found.exact(i))
          under.answer += f.numerator + "/" + f.denominator + " ";
      });
    node_lists more;
    under([&] { more.end_list(); });
    under.add_all(more.offsets);
  }
}
void call_contacts(caller &under) {
  call_contacts_in<float>(under);
  call_contacts_in<double>(under);
}

// All members of a world.
void call_world(caller &under) {
  std::vector<std::shared_ptr<const prepared>> shapes;
  std::vector<rows> all;
  const catalogue &c = cga::catalogue();
  for (const char *const name : {"triangle", "segment", "sphere"})
    for (int i = 0; i < c.kind_count; ++i)
      if (std::string_view(c.kinds[i].name) == name) {
        all.push_back(some_rows(c.kinds[i], 5));
        shapes.push_back(std::make_shared<prepared>(prepare(view_of(all.back(), c.kinds[i]), c.kinds[i])));
      }
  std::optional<world> w;
  under([&] { w.emplace(c); });
  for (std::size_t i = 0; i < shapes.size(); ++i)
    under([&] { w->add(std::string(1, static_cast<char>('a' + i)), shapes[i], i == 1 ? some_pose() : pose()); });
  under([&] { w->move(0, some_pose()); });
  under([&] { w->move(9, some_pose()); });
  for (const bool ignored : {false, true}) {
    under([&] { w->ignore(0, 1, ignored); });
    world_options o;
    o.want = answer_kind::pairs;
    o.threads = 2;
    o.nested = true;
    world_answer found;
    under([&] { found = w->touching(o); });
    under.add(found.near), under.add(found.candidates);
    for (const touching_bodies &t : found.touching)
      under.add(t.a), under.add(t.b), under.add_all(t.found.pairs);
    std::vector<near_bodies> near;
    under([&] { near = w->near(); });
    std::vector<nested_bodies> nested;
    under([&] { nested = w->nested(near, o); });
    under.add(nested.size());
    for (const near_bodies &n : near) {
      under.add(n.a), under.add(n.b), under.add(n.by.predicate);
      under([&] {
        result r;
        r.pairs = {{1, 2}};
        under.add(n.first()), under.add(n.second()), under.add_all(n.told(std::move(r)).found.pairs);
      });
    }
    for (const nested_bodies &n : found.nested)
      under.add(n.a), under.add(n.b), under.add(n.how);
  }
  under([&] {
    under.add(w->size()), under.add(w->find("b").value_or(7)), under.add(w->at(0).m[0]);
    under.answer += w->name(1);
    under.add(w->shape(1).elements()), under.add(w->owners(1).size());
  });
}

constexpr entry all[] = {
    {"fitting", call_fitting},
    {"first_for", call_fitting},
    {"turned", call_turned},
    {"self_pairs", call_self_pairs},
    {"contacts", call_contacts},
    {"contact_set::nodes", call_contacts},
    {"contact_set::exact", call_contacts},
    {"node_lists::size", call_contacts},
    {"node_lists::end_list", call_contacts},
    {"world::world", call_world},
    {"world::add", call_world},
    {"world::move", call_world},
    {"world::ignore", call_world},
    {"world::size", call_world},
    {"world::name", call_world},
    {"world::at", call_world},
    {"world::shape", call_world},
    {"world::find", call_world},
    {"world::touching", call_world},
    {"world::near", call_world},
    {"world::nested", call_world},
    {"world::owners", call_world},
    {"near_bodies::first", call_world},
    {"near_bodies::second", call_world},
    {"near_bodies::told", call_world},
};

} // namespace

std::span<const entry> world_entries() {
  return all;
}

} // namespace words_test
