// Sets from what a program has: every form gives the view that a program would fill by hand.
#include "tests/catch.hpp"

#include <meet/meet.hpp>

#include <limits>
#include <list>
#if MEETC_WITH_EIGEN
#include <Eigen/Core>
#endif

namespace {

struct xyz {
  float x, y, z;
};
struct ball {
  xyz centre;
  float radius;
};
struct record {
  double weight;
  xyz at;
  float around[4];
  std::uint16_t flags;
};
struct face {
  std::uint32_t of[3];
};
// Three numbers and a fourth that is none: only a program can say so.
struct alignas(16) padded {
  xyz at;
};
// As glm's vectors are.
struct shader_vector {
  using value_type = float;
  static constexpr int length() { return 3; }
  shader_vector(float a, float b, float c) : x(a), y(b), z(c) {}
  float x, y, z;
};

template <class R> constexpr std::size_t width = meet::row_of<R>::count;
static_assert(width<float> == 1 && width<xyz> == 3 && width<ball> == 4 && width<face> == 3 && width<float[6]> == 6);
static_assert(width<std::array<xyz, 3>> == 9 && width<std::array<std::array<float, 2>, 2>> == 4);
static_assert(width<shader_vector> == 3 && std::same_as<meet::row_of<shader_vector>::number, float>);
static_assert(width<record> == 0 && width<std::string> == 0 && width<std::span<const float>> == 0);
static_assert(std::same_as<meet::row_of<face>::number, std::uint32_t>);
static_assert(std::same_as<meet::row_of<std::array<double, 3>>::number, double>);

const float flat[] = {0, 0, 0, 4, 0, 0, 0, 4, 0, 4, 4, 0};
const std::vector<xyz> points = {{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {4, 4, 0}};
const std::vector<std::array<std::uint32_t, 3>> faces = {{0, 1, 2}, {1, 3, 2}};

void same(const meet::elements &x, const char *kind, const void *data, std::size_t vertices, std::size_t stride,
          const void *index, std::size_t elements) {
  CHECK(std::string(x.kind->name) == kind);
  CHECK(static_cast<const void *>(x.view.data) == data);
  CHECK(x.view.vertices == vertices);
  CHECK(x.view.stride_bytes == stride);
  CHECK(static_cast<const void *>(x.view.index) == index);
  CHECK(x.view.elements == elements);
}

} // namespace

template <> struct meet::row_of<padded> {
  using number = float;
  static constexpr std::size_t count = 3;
};

TEST_CASE("front: points and faces") {
  same(meet::triangles(points, faces), "triangle", points.data(), 4, 12, faces.data(), 2);
  const std::vector<face> of_structs = {{{0, 1, 2}}};
  same(meet::triangles(points, of_structs), "triangle", points.data(), 4, 12, of_structs.data(), 1);
  const std::vector<int> signed_ones = {0, 1, 2, 1, 3, 2};
  same(meet::triangles(flat, signed_ones), "triangle", flat, 4, 12, signed_ones.data(), 2);
  const std::span<const xyz> some(points.data(), 3);
  same(meet::triangles(some, std::span(faces)), "triangle", points.data(), 3, 12, faces.data(), 2);
  const std::array<std::uint32_t, 2> edges[] = {{0, 1}, {2, 3}, {0, 2}};
  same(meet::segments(points, edges), "segment", points.data(), 4, 12, edges, 3);
}

TEST_CASE("front: rows of a kind's own numbers") {
  same(meet::triangles(std::span(flat).first(9)), "triangle", flat, 0, 36, nullptr, 1);
  same(meet::points(flat), "point", flat, 0, 12, nullptr, 4);
  const std::vector<std::array<xyz, 2>> ends(5);
  same(meet::segments(ends), "segment", ends.data(), 0, 24, nullptr, 5);
  const std::vector<ball> balls(7);
  same(meet::spheres(balls), "sphere", balls.data(), 0, 16, nullptr, 7);
  same(meet::boxes(std::span(flat)), "box", flat, 0, 24, nullptr, 2);
  const std::vector<shader_vector> glm = {{1, 2, 3}};
  same(meet::points(glm), "point", glm.data(), 0, 12, nullptr, 1);
  const std::vector<padded> apart(3);
  same(meet::points(apart), "point", apart.data(), 0, 16, nullptr, 3);
  const std::vector<xyz> none;
  CHECK(meet::prepare(meet::points(none)).elements() == 0);
}

TEST_CASE("front: members of records, and pointers with strides") {
  const std::vector<record> records(3);
  same(meet::triangles({records, &record::at}, faces), "triangle", &records[0].at, 3, sizeof(record), faces.data(), 2);
  same(meet::spheres({records, &record::around}), "sphere", &records[0].around, 0, sizeof(record), nullptr, 3);
  same(meet::points({flat, 2, 24}), "point", flat, 0, 24, nullptr, 2);
  same(meet::points({flat, 4}), "point", flat, 0, 12, nullptr, 4);
  same(meet::triangles({flat, 4}, {faces[0].data(), 2}), "triangle", flat, 4, 12, faces.data(), 2);
  const std::vector<record> none;
  CHECK(meet::prepare(meet::points({none, &record::at})).elements() == 0);
}

TEST_CASE("front: a kind of any catalogue") {
  const meetc::kind_info &sphere = meetc::find_kind(cga::catalogue(), "sphere");
  const std::vector<ball> balls(2);
  same(meet::elements_of(sphere, balls), "sphere", balls.data(), 0, 16, nullptr, 2);
  same(meet::elements_of(sphere, meet::rows<4>(std::span(flat).first(8))), "sphere", flat, 0, 16, nullptr, 2);
  CHECK_THROWS_AS(meet::elements_of(sphere, points), meet::usage_error);
  CHECK_THROWS_WITH(meet::elements_of(sphere, points), "sphere has the numbers x,y,z,r; a row here has 3");
  CHECK_THROWS_WITH(meetc::find_kind(cga::catalogue(), "ball"),
                    "no kind 'ball' in cga; there are: point, sphere, segment, triangle, box");
}

TEST_CASE("front: numbers that are no whole rows, or do not lie together, are misuse") {
  CHECK_THROWS_WITH(meet::points(std::span(flat).first(10)), "rows: 10 numbers are no multiple of the 3 of a row");
  const std::vector<std::uint32_t> five(5);
  CHECK_THROWS_AS(meet::triangles(points, five), meet::usage_error);
  const std::vector<padded> apart(3);
  CHECK_THROWS_WITH(meet::triangles(apart), "rows: numbers of one row do not lie together");
}

TEST_CASE("front: a bad element is named when the set is prepared") {
  const std::vector<std::array<int, 3>> beyond = {{0, 1, 2}, {0, -1, 2}};
  CHECK_THROWS_WITH(meet::prepare(meet::triangles(points, beyond)),
                    "element 1: index 4294967295 of point 1 lies beyond the vertices");
  const std::vector<ball> negative = {{{0, 0, 0}, -1}};
  CHECK_THROWS_AS(meet::prepare(meet::spheres(negative)), meet::input_error);
}

#if MEETC_WITH_EIGEN
TEST_CASE("front: matrices of Eigen") {
  Eigen::Matrix<float, 3, Eigen::Dynamic> columns(3, 4);
  same(meet::points(columns), "point", columns.data(), 0, 12, nullptr, 4);
  Eigen::Matrix<float, Eigen::Dynamic, 3, Eigen::RowMajor> by_rows(5, 3);
  Eigen::Matrix<int, Eigen::Dynamic, 3, Eigen::RowMajor> indices(6, 3);
  same(meet::triangles(by_rows, indices), "triangle", by_rows.data(), 5, 12, indices.data(), 6);
  std::vector<Eigen::Vector3f> vectors(2);
  same(meet::points(vectors), "point", vectors.data(), 0, 12, nullptr, 2);
  Eigen::VectorXf numbers(12);
  same(meet::points(numbers), "point", numbers.data(), 0, 12, nullptr, 4);
  const Eigen::Map<const Eigen::Matrix<float, 3, Eigen::Dynamic>, 0, Eigen::OuterStride<>> apart(
      flat, 3, 2, Eigen::OuterStride<>(6));
  same(meet::points(apart), "point", flat, 0, 24, nullptr, 2);
  const Eigen::Map<const Eigen::Matrix<float, 3, Eigen::Dynamic>, 0, Eigen::Stride<Eigen::Dynamic, Eigen::Dynamic>>
      torn(flat, 3, 2, {1, 2});
  CHECK_THROWS_AS(meet::points(torn), meet::usage_error);
  const Eigen::Matrix<double, 3, Eigen::Dynamic> doubles =
      Eigen::Matrix<double, 3, Eigen::Dynamic>::Constant(3, 4, 0.1);
  CHECK(meet::rounded(doubles).moved.numbers == 12);
  CHECK(meet::rounded(doubles).rows.size() == 4);
}
#endif

TEST_CASE("front: doubles are rounded on request, and what moves is told") {
  const std::vector<std::array<double, 3>> given = {{1, 2, 3}, {0.1, 16777217, -0.1}};
  const auto rounded = meet::rounded(given);
  CHECK(rounded.rows[0] == std::array<float, 3>{1, 2, 3});
  CHECK(rounded.rows[1] == std::array<float, 3>{0.1F, 16777216, -0.1F}); // of two the even one
  CHECK(rounded.moved.numbers == 3);
  CHECK(rounded.moved.largest == 1);
  same(meet::points(rounded.rows), "point", rounded.rows.data(), 0, 12, nullptr, 2);

  CHECK_THROWS_WITH(meet::unmoved(given), "row 1: number 0 is 0.1, which no float32 is; meet::rounded() rounds");
  try {
    meet::unmoved(given);
  } catch (const meet::input_error &e) {
    CHECK(e.where.element == 1);
    CHECK(e.where.field == 0);
    CHECK(e.where.value == 0.1F);
  }
  const std::vector<double> held = {0.5, 0x1p-149, -3};
  CHECK(meet::unmoved(held).rows.size() == 3);
  CHECK(meet::unmoved(held).moved.numbers == 0);
}

TEST_CASE("front: a double beyond float32 is refused, and what is not finite is left to prepare()") {
  const std::vector<std::array<double, 3>> beyond = {{0, 0, 1e39}};
  CHECK_THROWS_WITH(meet::rounded(beyond), "row 0: number 2 is 1e+39, beyond float32");
  const std::vector<std::array<double, 3>> bad = {{0, 0, 0}, {0, std::numeric_limits<double>::quiet_NaN(), 0}};
  const auto rounded = meet::rounded(bad);
  CHECK(rounded.moved.numbers == 0);
  CHECK_THROWS_WITH(meet::prepare(meet::points(rounded.rows)), "element 1: y is nan");
}
