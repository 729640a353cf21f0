// The page of a report, read back.
#include "decode.hpp"
#include "tests/catch.hpp"

#include "meet/bodies/meshes.hpp"
#include "meet/report/write.hpp"

#include <algorithm>
#include <cmath>

using namespace meetc;
using decoded::json;

namespace {

// Two bodies of which some faces are said to touch.
struct two_meshes {
  bodies::mesh a, b;
  std::vector<std::uint8_t> hit_a, hit_b;
  std::vector<index_pair> pairs;

  two_meshes(bodies::mesh first, bodies::mesh second, std::uint32_t n)
      : a(std::move(first)), b(std::move(second)), hit_a(a.index.size() / 3), hit_b(b.index.size() / 3) {
    for (std::uint32_t i = 0; i < n; ++i) {
      pairs.push_back({i, 3 * i % static_cast<std::uint32_t>(hit_b.size())});
      hit_a[pairs.back().a] = hit_b[pairs.back().b] = 1;
    }
  }
  report::scene scene() const {
    report::scene s;
    s.title = "two";
    for (const auto &[mesh, hit] : {std::pair{&a, &hit_a}, {&b, &hit_b}}) {
      report::shape one;
      one.drawn.rows = mesh->xyz;
      one.drawn.index = mesh->index;
      one.drawn.hit = *hit;
      one.items = hit->size();
      s.shapes.push_back(one);
    }
    s.bodies = {{"A", 0}, {"B", 1}};
    s.pairs = pairs;
    return s;
  }
};

using triangle = std::array<std::array<int, 3>, 3>;

// Compares a shape of the page with the mesh, and returns how many faces it shows with positions of 16 bits.
std::size_t check_shape(const decoded::page &page, std::size_t number, const bodies::mesh &mesh,
                        const std::vector<std::uint8_t> &hit) {
  const json &shape = page.header["shapes"][number];
  const json &detail = shape["detail"], &surface = shape["surface"];
  const std::array<double, 3> centre = shape["centre"];
  const double unit = page.header["unit"];

  const decoded::numbers items = page.differences(detail["items"]), corners = page.corners(detail["index"]);
  const std::vector<float> points = page.floats(detail["numbers"]);
  const std::vector<std::uint8_t> hits = page.bytes(detail["hit"]);
  std::vector<std::uint8_t> shown(hit.size());
  std::size_t different = 0;
  REQUIRE(corners.size() == 3 * items.size());
  for (std::size_t i = 0; i < items.size(); ++i) {
    shown[items[i]] = 1;
    different += hits[i] != hit[items[i]];
    for (std::size_t k = 0; k < 9; ++k) {
      const float of_mesh = mesh.xyz[3 * mesh.index[3 * items[i] + k / 3] + k % 3];
      different += points[3 * corners[3 * i + k / 3] + k % 3] != static_cast<float>((of_mesh - centre[k % 3]) / unit);
    }
  }
  CHECK(different == 0);

  const std::array<double, 3> lo = surface["lo"], step = surface["step"];
  std::vector<triangle> wanted, found;
  std::size_t far = 0, hits_left = 0;
  for (std::size_t f = 0; f < hit.size(); ++f) {
    if (shown[f])
      continue;
    hits_left += hit[f];
    triangle t;
    for (std::size_t k = 0; k < 9; ++k) {
      const double x = mesh.xyz[3 * mesh.index[3 * f + k / 3] + k % 3];
      const long q = std::lround((x - lo[k % 3]) / step[k % 3]);
      far += std::abs(lo[k % 3] + step[k % 3] * static_cast<double>(q) - x) > 0.5000001 * step[k % 3];
      t[k / 3][k % 3] = static_cast<int>(q);
    }
    wanted.push_back(t);
  }
  CHECK(far == 0);
  CHECK(surface["hits"] == hits_left);
  const auto grid = page.points(surface["points"], surface["count"]);
  const decoded::numbers index = page.corners(surface["index"]);
  for (std::size_t i = 0; i < index.size(); i += 3)
    found.push_back({grid[index[i]], grid[index[i + 1]], grid[index[i + 2]]});
  std::sort(wanted.begin(), wanted.end());
  std::sort(found.begin(), found.end());
  CHECK(wanted == found);
  return found.size();
}

std::vector<index_pair> pairs_in(const decoded::page &page) {
  const decoded::numbers a = page.differences(page.header["pairs"]["a"]),
                         b = page.differences(page.header["pairs"]["b"]);
  REQUIRE(a.size() == b.size());
  std::vector<index_pair> out;
  for (std::size_t i = 0; i < a.size(); ++i)
    out.push_back({a[i], b[i]});
  return out;
}

bool same(const std::vector<index_pair> &x, const std::vector<index_pair> &y) {
  return std::equal(x.begin(), x.end(), y.begin(), y.end(),
                    [](index_pair p, index_pair q) { return p.a == q.a && p.b == q.b; });
}

} // namespace

TEST_CASE("a page holds every face once, those of pairs exactly and the others within half a step") {
  const two_meshes m(bodies::blob(24), bodies::figure(20), 40);
  const std::string html = report::as_html(m.scene());
  const decoded::page page(html);
  CHECK(same(pairs_in(page), m.pairs));
  CHECK(page.header["notes"].empty());
  for (const std::size_t i : {0u, 1u}) {
    const std::size_t rounded = check_shape(page, i, i ? m.b : m.a, i ? m.hit_b : m.hit_a);
    CHECK(rounded > 0);
    CHECK(rounded < (i ? m.hit_b : m.hit_a).size() - 40);
    CHECK(page.header["shapes"][i]["surface"]["hits"] == 0);
  }
  CHECK(report::as_html(m.scene()) == html);
}

TEST_CASE("a page that cannot list all pairs says how many it leaves out, and shows their faces as hit") {
  const two_meshes m(bodies::blob(24), bodies::figure(20), 300);
  report::limits few;
  few.pairs = 30;
  const decoded::page page(report::as_html(m.scene(), few));
  CHECK(same(pairs_in(page), {m.pairs.begin(), m.pairs.begin() + 30}));
  CHECK(page.header["all_pairs"] == 300);
  REQUIRE(page.header["notes"].size() == 1);
  CHECK(page.header["notes"][0].get<std::string>().find("the first 30 of 300 pairs") != std::string::npos);
  check_shape(page, 0, m.a, m.hit_a);
  check_shape(page, 1, m.b, m.hit_b);
  CHECK(page.header["shapes"][0]["surface"]["hits"] > 100);
  few.pairs = 1000, few.items = 12;
  CHECK(pairs_in(decoded::page(report::as_html(m.scene(), few))).size() == 12);
}

TEST_CASE("contacts keep their places, and their numbers of points") {
  two_meshes m(bodies::blob(12), bodies::figure(12), 5);
  report::scene s = m.scene();
  s.contacts = {{1e6, 2, 3, 4, 5.5, 6, -7, 8, 9, 0, 0, 0}, {0, 1, 1, 2}, {2, 1, 0}, {3}};
  const decoded::page page(report::as_html(s));
  const json &c = page.header["contacts"];
  const std::array<double, 3> centre = page.header["centre"];
  const double unit = page.header["unit"];
  const std::vector<float> points = page.floats(c["points"]);
  REQUIRE(points.size() == 12);
  for (std::size_t i = 0; i < 12; ++i)
    CHECK(points[i] == static_cast<float>((s.contacts.points[i] - centre[i % 3]) / unit));
  CHECK(page.differences(c["pieces"]) == decoded::numbers{0, 1, 1, 2});
  CHECK(page.differences(c["triangles"]) == decoded::numbers{2, 1, 0});
  CHECK(page.differences(c["single"]) == decoded::numbers{3});
}

TEST_CASE("numbers near the ends of float32 stay finite in a page") {
  two_meshes m(bodies::blob(12), bodies::figure(12), 5);
  const float huge = GENERATE(1e-40f, 1e38f);
  for (float &x : m.a.xyz)
    x *= huge;
  for (float &x : m.b.xyz)
    x *= huge;
  const decoded::page page(report::as_html(m.scene()));
  for (const std::size_t i : {0u, 1u})
    for (const float x : page.floats(page.header["shapes"][i]["detail"]["numbers"]))
      REQUIRE(std::abs(x) < 4);
}

TEST_CASE("no text of a user ends an element of the page, and bytes that are no UTF-8 are replaced") {
  two_meshes m(bodies::blob(12), bodies::figure(12), 5);
  report::scene s = m.scene();
  s.title = "</script><b>\xff";
  s.facts = {{"A", "<!--<script>"}};
  const std::string html = report::as_html(s);
  CHECK(html.find("</script><b>") == std::string::npos);
  CHECK(html.find("<!--<script>") == std::string::npos);
  CHECK(decoded::page(html).header["title"] == "</script><b>\xef\xbf\xbd");
}

TEST_CASE("a set of spheres or segments keeps all its numbers") {
  const std::vector<float> balls = {0, 0, 0, 1, 2, 2, 2, 0.5f},
                           rods = {0, 0, 0, 1, 1, 1, 2, 2, 2, 3, 3, 3, 4, 4, 4, 5, 5, 5};
  const std::vector<std::uint32_t> owner = {0, 0, 1}; // a polyline of two segments
  report::scene s;
  s.shapes.resize(2);
  s.shapes[0].drawn.what = picture::form::spheres;
  s.shapes[0].drawn.rows = balls;
  s.shapes[0].items = 2;
  s.shapes[1].drawn.what = picture::form::segments;
  s.shapes[1].drawn.rows = rods;
  s.shapes[1].owner = owner;
  s.shapes[1].items = 2;
  s.bodies = {{"A", 0}, {"B", 1}};
  const std::vector<index_pair> pairs = {{0, 0}, {1, 1}};
  s.pairs = pairs;
  const decoded::page page(report::as_html(s));
  const std::array<double, 3> centre = page.header["centre"];
  const double unit = page.header["unit"];
  const std::vector<float> a = page.floats(page.header["shapes"][0]["detail"]["numbers"]);
  REQUIRE(a.size() == balls.size());
  for (std::size_t i = 0; i < a.size(); ++i)
    CHECK(a[i] * unit + (i % 4 < 3 ? centre[i % 4] : 0) == balls[i]);
  CHECK(page.differences(page.header["shapes"][1]["detail"]["items"]) == owner);
}

TEST_CASE("two meshes of 345,000 faces make a page of at most 6 MB") {
  bodies::mesh one = bodies::blob(200);
  REQUIRE(one.index.size() / 3 >= 345'000);
  bodies::mesh other = one;
  for (float &x : other.xyz)
    x = x * 0.9f + 0.1f;
  const two_meshes m(std::move(one), std::move(other), 5'000);
  const std::string html = report::as_html(m.scene());
  CAPTURE(html.size());
  CHECK(html.size() <= 6'000'000);
}
