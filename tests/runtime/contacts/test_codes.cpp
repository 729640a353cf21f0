// Contact codes against the definition of labels in rational numbers.
#include "tests/catch.hpp"
#include "tests/runtime/contacts/definition.hpp"
#include "tests/runtime/contacts/families.hpp"

#include <algorithm>
#include <cga/side_triangle_point.hpp>
#include <cmath>
#include <meetc/contact/contact.hpp>

using namespace meetc::contacts_test;
using meetc::contact_code;

namespace {

using side = cga::side_triangle_point_sign;

// A planted mistake: the pair rounded to numbers of twelve bits.
pair_rows rounded(pair_rows p) {
  for (std::vector<float> *const row : {&p.a, &p.b})
    for (float &x : *row) {
      int exponent = 0;
      x = std::ldexp(std::round(std::ldexp(std::frexp(x, &exponent), 12)), exponent - 12);
    }
  return p;
}

template <class Sides> contact_code code_by(meetc::contact_signs<Sides> &signs, const pair_rows &p) {
  return p.a.size() == 9 ? meetc::contact_of_triangles(signs, p.a.data(), p.b.data())
                         : meetc::contact_of_segment(signs, p.a.data(), p.b.data());
}
contact_code code_of(const pair_rows &p) {
  meetc::contact_signs<meetc::exact_sides<side>> signs;
  return code_by(signs, p);
}

// Whether the code has the labels of the definition, in the order of code.hpp.
bool agrees(contact_code code, const pair_rows &p, const std::vector<exact_label> &labels) {
  if (code.labels() != static_cast<int>(labels.size()))
    return false;
  std::vector<const exact_label *> at;
  for (int i = 0; i < code.labels(); ++i) {
    const auto found = std::find_if(labels.begin(), labels.end(),
                                    [&](const exact_label &l) { return meetc::label_of(l.a, l.b) == code.label(i); });
    if (found == labels.end() || std::count(at.begin(), at.end(), &*found) != 0)
      return false;
    at.push_back(&*found);
  }
  const bool triangles = p.a.size() == 9;
  const exact_point na = triangles ? normal_of(p.a.data()) : exact_point(), nb = normal_of(p.b.data());
  const bool areas = triangles && !is_zero(na) && !is_zero(nb);
  const exact_point along = triangles ? cross(na, nb) : point_at(p.a.data() + 3) - point_at(p.a.data());
  const bool flat = areas && is_zero(along);
  if (code.in_one_plane() != (flat && !at.empty()) || code.normals_agree() != (flat && !at.empty() && dot(na, nb) > 0))
    return false;
  if (code.dimension() != std::clamp(static_cast<int>(at.size()) - 1, 0, 2))
    return false;
  if (at.size() == 2)
    return is_zero(along) ? at[0] == &labels[0] : dot(at[1]->at - at[0]->at, along) > 0;
  for (std::size_t i = 0; at.size() > 2 && i < at.size(); ++i) {
    const exact_point &x = at[i]->at, &y = at[(i + 1) % at.size()]->at, &z = at[(i + 2) % at.size()]->at;
    if (dot(cross(y - x, z - y), na) <= 0)
      return false;
  }
  return at.size() < 3 || at[0] == &labels[0];
}

struct tally {
  std::size_t wrong = 0, meeting = 0;
};
enum class mistake { none, rounds, closed };
tally compare(const family &f, int pairs, mistake planted = mistake::none) {
  std::mt19937 random(7);
  tally out;
  for (int i = 0; i < pairs; ++i) {
    const pair_rows p = f.pair(random);
    const auto labels =
        labels_by_definition(p.a.data(), static_cast<int>(p.a.size() / 3), p.b.data(), 3, planted == mistake::closed);
    out.meeting += !labels.empty();
    out.wrong += !agrees(code_of(planted == mistake::rounds ? rounded(p) : p), p, labels);
  }
  return out;
}

} // namespace

TEST_CASE("a contact code has the labels of the definition, in order") {
  for (const int corners : {3, 2})
    for (const family &f : families(corners)) {
      CAPTURE(f.name, corners);
      const tally t = compare(f, 400);
      CHECK(t.wrong == 0);
      CHECK(t.meeting >= 20); // the family says something
    }
}

TEST_CASE("floating-point numbers tell the same code or none") {
  for (const int corners : {3, 2})
    for (const family &f : families(corners)) {
      CAPTURE(f.name, corners);
      std::mt19937 random(11);
      int wrong = 0, none = 0;
      for (int i = 0; i < 2000; ++i) {
        const pair_rows p = f.pair(random);
        meetc::contact_signs<meetc::bounded_sides<side>> signs;
        const contact_code code = code_by(signs, p);
        none += !signs.known();
        wrong += signs.known() && code.bits() != code_of(p).bits();
      }
      CHECK(wrong == 0);
      // Lattices and general position leave nothing to integers. A turn of subnormal numbers is told beside a 1.
      const std::string name = f.name;
      CHECK((name == "of all sizes" || name.starts_with("planes") || name.starts_with("signed") || none == 0));
      CHECK(none < 2000);
    }
}

TEST_CASE("planted mistakes are noticed") {
  std::size_t by_rounding = 0, by_borders = 0;
  for (const int corners : {3, 2})
    for (const family &f : families(corners)) {
      by_rounding += compare(f, 60, mistake::rounds).wrong;
      by_borders += compare(f, 60, mistake::closed).wrong;
    }
  CHECK(by_rounding > 0);
  CHECK(by_borders > 0);
}

TEST_CASE("all shapes of a contact occur") {
  std::mt19937 random(3);
  std::array<int, 7> seen{};
  for (const family &f : families(3))
    for (int i = 0; i < 3000; ++i)
      ++seen[static_cast<std::size_t>(code_of(f.pair(random)).labels())];
  for (const int count : seen)
    CHECK(count > 0);
}
