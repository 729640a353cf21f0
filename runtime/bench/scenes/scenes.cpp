#include "meet/bench/scenes/scenes.hpp"

#include "meet/app/input/made_sets.hpp"
#include "meet/bench/scenes/scene_sets.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

namespace meetc::bench {

namespace {

// 2^power balls against as many, of which one touches 1.1 others on average.
scene growing_balls(const catalogue &all, int power) {
  const std::size_t n = std::size_t{1} << power;
  return {fmt::format("balls, {0} x {0}", n), "ball_ball", [&all, n] {
            const double radius = std::cbrt(1.1 * 3 / (4 * std::numbers::pi * static_cast<double>(n)));
            return two_sets(ball_cloud(all, n, 1, radius), ball_cloud(all, n, 2, radius));
          }};
}

// n segments, of a share of the box's length, and a mesh.
template <class Mesh>
scene segments_and(const scene_source &from, std::string name, std::size_t n, double share, const Mesh &mesh) {
  return {std::move(name), "segment_triangle", [from, n, share, mesh] {
            io::element_set onto = mesh();
            io::element_set segments = segments_in(from.all, onto, n, share);
            return two_sets(std::move(segments), std::move(onto));
          }};
}

scene figure_with_itself(const scene_source &from) {
  return {fmt::format("{} with itself", from.name_of_figure()), "triangle_triangle",
          [from] { return two_sets(from.figure(), {}); }, true};
}

} // namespace

std::vector<scene> kernel_scenes(const scene_source &from) {
  const std::size_t balls = from.quick ? 4096 : 262144, triangles = from.quick ? 20'000 : 4'000'000,
                    segments = from.quick ? 500 : 10'000;
  const std::string body = from.name_of_body(), figure = from.name_of_figure();
  const auto fine = [from, triangles] { return from.finer_body(triangles); };
  // Hits of the balls are a fixed share of all pairs for any n: about four in a million.
  constexpr double radius = 0.0098;
  return {{fmt::format("balls, {0} x {0}", balls), "ball_ball",
           [from, balls] {
             return two_sets(ball_cloud(from.all, balls, 1, radius), ball_cloud(from.all, balls, 2, radius));
           }},
          {fmt::format("{} x {}", body, figure), "triangle_triangle",
           [from] { return two_sets(from.body(), from.figure()); }},
          {fmt::format("{} cut finer x {}", body, figure), "triangle_triangle",
           [from, fine] { return two_sets(fine(), from.figure()); }},
          segments_and(from, fmt::format("{} segments, 1 % of the box, x mesh", segments), segments, 0.01, fine),
          segments_and(from, "1 segment, 1 % of the box, x mesh", 1, 0.01, fine),
          segments_and(from, "100 rays as long as the box x mesh", 100, 1, fine)};
}

std::vector<scene> growth_scenes(const scene_source &from) {
  std::vector<scene> out;
  for (int power = 10; power <= (from.quick ? 14 : 24); power += 2)
    out.push_back(growing_balls(from.all, power));
  const std::string body = from.name_of_body(), figure = from.name_of_figure();
  const std::size_t fine = from.quick ? 20'000 : 4'000'000, finest = from.quick ? 20'000 : 20'000'000;
  out.push_back({fmt::format("{} x {}", body, figure), "triangle_triangle",
                 [from] { return two_sets(from.body(), from.figure()); }});
  out.push_back(figure_with_itself(from));
  out.push_back({fmt::format("{} x {}, both cut finer", body, figure), "triangle_triangle",
                 [from, fine, finest] { return two_sets(from.finer_body(fine), from.finer_figure(finest)); }});
  for (const std::size_t n : {std::size_t{100}, from.quick ? std::size_t{500} : std::size_t{10'000}})
    out.push_back(segments_and(from, fmt::format("{} segments as long as the box x {}", n, body), n, 1,
                               [from, fine] { return from.finer_body(fine); }));
  const std::size_t boxes = from.quick ? 4096 : 100'000;
  out.push_back({fmt::format("{} boxes with themselves", boxes), "box_box",
                 [from, boxes] { return two_sets(box_cloud(from.all, boxes, 1, 0.001), {}); }, true});
  return out;
}

std::vector<scene> first_scenes(const scene_source &from) {
  std::vector<scene> out;
  for (const std::size_t n : from.quick ? std::vector<std::size_t>{100, 10'000, 20'000}
                                        : std::vector<std::size_t>{100, 10'000, 100'000, 200'000, 400'000, 1'000'000})
    out.push_back(segments_and(from, fmt::format("{} segments x {}", n, from.name_of_figure()), n, 1,
                               [from] { return from.figure(); }));
  const std::size_t many = from.quick ? 20'000 : 1'000'000;
  for (const double share : {0.1, 0.01})
    out.push_back(
        segments_and(from, fmt::format("{} segments, {} % of the box, x {}", many, 100 * share, from.name_of_figure()),
                     many, share, [from] { return from.figure(); }));
  return out;
}

std::vector<scene> contact_scenes(const scene_source &from) {
  const std::string body = from.name_of_body(), figure = from.name_of_figure();
  const std::size_t fine = from.quick ? 20'000 : 4'000'000, segments = from.quick ? 500 : 100'000;
  return {{fmt::format("{} x {}", body, figure), "triangle_triangle",
           [from] { return two_sets(from.body(), from.figure()); }},
          {fmt::format("{} x {}, both cut finer", body, figure), "triangle_triangle",
           [from, fine] { return two_sets(from.finer_body(fine), from.finer_figure(fine)); }},
          segments_and(from, fmt::format("{} segments as long as the box x {}", segments, figure), segments, 1,
                       [from] { return from.figure(); })};
}

std::vector<scene> self_scenes(const scene_source &from) {
  const std::size_t fine = from.quick ? 20'000 : 4'000'000;
  return {figure_with_itself(from),
          {fmt::format("{} cut finer with itself", from.name_of_figure()), "triangle_triangle",
           [from, fine] { return two_sets(from.finer_figure(fine), {}); }, true}};
}

std::vector<scene> group_scenes(const scene_source &from) {
  std::vector<scene> out;
  for (int power = from.quick ? 12 : 18; power <= (from.quick ? 14 : 24); power += 2)
    out.push_back(growing_balls(from.all, power));
  const std::string body = from.name_of_body(), figure = from.name_of_figure();
  const std::size_t fine = from.quick ? 20'000 : 4'000'000, finest = from.quick ? 20'000 : 20'000'000;
  out.push_back(figure_with_itself(from));
  out.push_back({fmt::format("{} x {}, both cut finer", body, figure), "triangle_triangle",
                 [from, fine, finest] { return two_sets(from.finer_body(fine), from.finer_figure(finest)); }});
  out.push_back({fmt::format("{} x {}, both cut finer", figure, body), "triangle_triangle",
                 [from, fine, finest] { return two_sets(from.finer_figure(finest), from.finer_body(fine)); }});
  const std::size_t segments = from.quick ? 20'000 : 4'000'000;
  out.push_back(segments_and(from, fmt::format("{} segments as long as the box x {}", segments, figure), segments, 1,
                             [from] { return from.figure(); }));
  return out;
}

posed_meshes meshes_for_poses(const scene_source &from) {
  return {from.figure(),
          from.data ? from.read(from.quick ? "bunny_1k.ply" : "bunny_5k.ply")
                    : app::of_mesh(from.all, bodies::blob(from.quick ? 12 : 24)),
          from.quick ? std::size_t{60} : std::size_t{10'000}};
}

namespace {

// Balls of radius 1/2 on a lattice touch six neighbours and themselves. A share of them is slightly smaller and touches
// only balls at the same place. With copies at each place every ball touches that many times as many.
io::element_set lattice(const catalogue &all, int n, int copies, int smaller_of_64) {
  std::vector<float> rows;
  std::uint32_t state = 1;
  for (int i = 0; i < n * n * n; ++i) {
    state = state * 1664525U + 1013904223U;
    const bool smaller = static_cast<int>(state >> 26) < smaller_of_64;
    const int x = i % n, y = i / n % n, z = i / n / n;
    for (int c = 0; c < copies; ++c)
      rows.insert(rows.end(),
                  {static_cast<float>(x), static_cast<float>(y), static_cast<float>(z), smaller ? 0.4375F : 0.5F});
  }
  return app::of_rows(all, "sphere", std::move(rows));
}

// m copies of a ball of radius 1/2.
io::element_set copies_at(const catalogue &all, std::size_t m, float x) {
  std::vector<float> rows;
  for (std::size_t i = 0; i < m; ++i)
    rows.insert(rows.end(), {x, 0, 0, 0.5F});
  return app::of_rows(all, "sphere", std::move(rows));
}

} // namespace

std::vector<scene> tangent_scenes(const scene_source &from) {
  const int side = from.quick ? 12 : 64;
  const auto lattices = [&from](const char *name, int n, int copies, int smaller) -> scene {
    return {name, "ball_ball", [&all = from.all, n, copies, smaller] {
              return two_sets(lattice(all, n, copies, smaller), lattice(all, n, copies, smaller));
            }};
  };
  return {lattices("none tangent", side, 1, 64), lattices("few tangent", side, 1, 22),
          lattices("each tangent to 6", side, 1, 0), lattices("each tangent to 258", from.quick ? 6 : 18, 43, 0),
          scene{"every pair tangent", "ball_ball", [&all = from.all, m = std::size_t{from.quick ? 1024U : 16384U}] {
                  return two_sets(copies_at(all, m, 0), copies_at(all, m, 1));
                }}};
}

} // namespace meetc::bench
