#include "bench/scenes/gpu_scenes.hpp"

#include "app/kinds.hpp"
#include "app/made_sets.hpp"
#include "bench/scenes/scene_sets.hpp"
#include "io/read.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

namespace meetc::bench {

namespace {

bodies::mesh finer(bodies::mesh m, std::size_t least) {
  while (m.triangles() < least)
    m = bodies::subdivide(m);
  return m;
}

bodies::mesh of_set(const io::element_set &s) {
  return {s.data, s.index};
}

// The meshes of the scenes, from files or built in.
struct scene_meshes {
  const catalogue &all;
  std::optional<std::filesystem::path> data;
  bool quick;

  io::element_set read(const char *file, const io::transform &move = {}) const {
    return io::read(*data / file, app::kinds_of(all), move);
  }
  io::element_set body() const {
    return data ? read(quick ? "bunny_5k.ply" : "bunny_69k.ply") : app::of_mesh(all, bodies::blob(quick ? 48 : 90));
  }
  // A larger body that it reaches into.
  io::element_set figure() const {
    io::transform near;
    if (data) {
      near.scale = 0.001;
      near.translate = {0, 0.1, 0};
      return read(quick ? "armadillo_5k.ply" : "armadillo_345k.ply", near);
    }
    near.translate = {0.4, 0, 0};
    return app::of_mesh(all, bodies::figure(quick ? 48 : 220), near);
  }
  io::element_set finer_body(std::size_t least) const { return app::of_mesh(all, finer(of_set(body()), least)); }
  io::element_set finer_figure(std::size_t least) const { return app::of_mesh(all, finer(of_set(figure()), least)); }
  const char *name_of_body() const { return data ? "Bunny" : "animal (built in)"; }
  const char *name_of_figure() const { return data ? "Armadillo" : "figure (built in)"; }
};

} // namespace

std::vector<gpu_scene> gpu_scenes(const catalogue &all, const std::optional<std::filesystem::path> &data, bool quick) {
  const std::size_t balls = quick ? 4096 : 262144, triangles = quick ? 20'000 : 4'000'000,
                    segments = quick ? 500 : 10'000;
  std::vector<gpu_scene> out;
  out.push_back({fmt::format("balls, {0} x {0}", balls), "ball_ball", [&all, balls] {
                   // Hits are a fixed share of all pairs for any n: about four in a million.
                   constexpr double radius = 0.0098;
                   return std::pair(ball_cloud(all, balls, 1, radius), ball_cloud(all, balls, 2, radius));
                 }});
  const scene_meshes meshes{all, data, quick};
  const std::string body = meshes.name_of_body(), figure = meshes.name_of_figure();
  out.push_back({fmt::format("{} x {}", body, figure), "triangle_triangle",
                 [meshes] { return std::pair(meshes.body(), meshes.figure()); }});
  out.push_back({fmt::format("{} cut finer x {}", body, figure), "triangle_triangle",
                 [meshes, triangles] { return std::pair(meshes.finer_body(triangles), meshes.figure()); }});
  const auto lines = [&all, meshes, triangles](std::size_t n, double share) {
    return [&all, meshes, triangles, n, share] {
      io::element_set mesh = meshes.finer_body(triangles);
      io::element_set s = segments_in(all, mesh, n, share);
      return std::pair(std::move(s), std::move(mesh));
    };
  };
  out.push_back(
      {fmt::format("{} segments, 1 % of the box, x mesh", segments), "segment_triangle", lines(segments, 0.01)});
  out.push_back({"1 segment, 1 % of the box, x mesh", "segment_triangle", lines(1, 0.01)});
  out.push_back({"100 rays as long as the box x mesh", "segment_triangle", lines(100, 1)});
  return out;
}

namespace {

// 2^power balls against as many, of which one touches 1.1 others on average.
gpu_scene growing_balls(const catalogue &all, int power) {
  const std::size_t n = std::size_t{1} << power;
  return {fmt::format("balls, {0} x {0}", n), "ball_ball", [&all, n] {
            const double radius = std::cbrt(1.1 * 3 / (4 * std::numbers::pi * static_cast<double>(n)));
            return std::pair(ball_cloud(all, n, 1, radius), ball_cloud(all, n, 2, radius));
          }};
}

} // namespace

std::vector<gpu_scene> growth_scenes(const catalogue &all, const std::optional<std::filesystem::path> &data,
                                     bool quick) {
  std::vector<gpu_scene> out;
  for (int power = 10; power <= (quick ? 14 : 24); power += 2)
    out.push_back(growing_balls(all, power));
  const scene_meshes meshes{all, data, quick};
  const std::string body = meshes.name_of_body(), figure = meshes.name_of_figure();
  const std::size_t fine = quick ? 20'000 : 4'000'000, finest = quick ? 20'000 : 20'000'000;
  out.push_back({fmt::format("{} x {}", body, figure), "triangle_triangle",
                 [meshes] { return std::pair(meshes.body(), meshes.figure()); }});
  out.push_back({fmt::format("{} with itself", figure), "triangle_triangle",
                 [meshes] { return std::pair(meshes.figure(), io::element_set{}); }, true});
  out.push_back({fmt::format("{} x {}, both cut finer", body, figure), "triangle_triangle",
                 [meshes, fine, finest] { return std::pair(meshes.finer_body(fine), meshes.finer_figure(finest)); }});
  for (const std::size_t n : {std::size_t{100}, quick ? std::size_t{500} : std::size_t{10'000}})
    out.push_back(
        {fmt::format("{} segments as long as the box x {}", n, body), "segment_triangle", [&all, meshes, fine, n] {
           io::element_set mesh = meshes.finer_body(fine);
           io::element_set segments = segments_in(all, mesh, n, 1);
           return std::pair(std::move(segments), std::move(mesh));
         }});
  const std::size_t boxes = quick ? 4096 : 100'000;
  out.push_back({fmt::format("{} boxes with themselves", boxes), "box_box",
                 [&all, boxes] { return std::pair(box_cloud(all, boxes, 1, 0.001), io::element_set{}); }, true});
  return out;
}

std::vector<gpu_scene> first_scenes(const catalogue &all, const std::optional<std::filesystem::path> &data,
                                    bool quick) {
  const scene_meshes meshes{all, data, quick};
  const std::string figure = meshes.name_of_figure();
  std::vector<gpu_scene> out;
  for (const std::size_t n :
       {std::size_t{100}, std::size_t{10'000}, quick ? std::size_t{20'000} : std::size_t{1'000'000}})
    out.push_back({fmt::format("{} segments x {}", n, figure), "segment_triangle", [&all, meshes, n] {
                     io::element_set mesh = meshes.figure();
                     io::element_set segments = segments_in(all, mesh, n, 1);
                     return std::pair(std::move(segments), std::move(mesh));
                   }});
  return out;
}

std::vector<gpu_scene> group_scenes(const catalogue &all, const std::optional<std::filesystem::path> &data,
                                    bool quick) {
  std::vector<gpu_scene> out;
  for (int power = quick ? 12 : 18; power <= (quick ? 14 : 24); power += 2)
    out.push_back(growing_balls(all, power));
  const scene_meshes meshes{all, data, quick};
  const std::string body = meshes.name_of_body(), figure = meshes.name_of_figure();
  const std::size_t fine = quick ? 20'000 : 4'000'000, finest = quick ? 20'000 : 20'000'000;
  out.push_back({fmt::format("{} with itself", figure), "triangle_triangle",
                 [meshes] { return std::pair(meshes.figure(), io::element_set{}); }, true});
  out.push_back({fmt::format("{} x {}, both cut finer", body, figure), "triangle_triangle",
                 [meshes, fine, finest] { return std::pair(meshes.finer_body(fine), meshes.finer_figure(finest)); }});
  out.push_back({fmt::format("{} x {}, both cut finer", figure, body), "triangle_triangle",
                 [meshes, fine, finest] { return std::pair(meshes.finer_figure(finest), meshes.finer_body(fine)); }});
  const std::size_t segments = quick ? 20'000 : 4'000'000;
  out.push_back({fmt::format("{} segments as long as the box x {}", segments, figure), "segment_triangle",
                 [&all, meshes, segments] {
                   io::element_set mesh = meshes.figure();
                   io::element_set of = segments_in(all, mesh, segments, 1);
                   return std::pair(std::move(of), std::move(mesh));
                 }});
  return out;
}

posed_meshes meshes_for_poses(const catalogue &all, const std::optional<std::filesystem::path> &data, bool quick) {
  const scene_meshes meshes{all, data, quick};
  return {meshes.figure(),
          data ? meshes.read(quick ? "bunny_1k.ply" : "bunny_5k.ply")
               : app::of_mesh(all, bodies::blob(quick ? 12 : 24)),
          quick ? std::size_t{60} : std::size_t{10'000}};
}

std::vector<std::function<tangent_scene()>> tangent_scenes(const catalogue &all, bool quick) {
  const int side = quick ? 12 : 64;
  std::vector<std::function<tangent_scene()>> out;
  // Balls of radius 1/2 on a lattice touch six neighbours and themselves. A share of them is slightly smaller and
  // touches only balls at the same place. With copies at each place every ball touches that many times as many.
  const auto lattice = [&all](int n, int copies, int smaller_of_64) {
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
  };
  const auto add = [&out, lattice](const std::string &name, int n, int copies, int smaller) {
    out.push_back([=] { return tangent_scene{name, lattice(n, copies, smaller), lattice(n, copies, smaller)}; });
  };
  add("none tangent", side, 1, 64);
  add("few tangent", side, 1, 22);
  add("each tangent to 6", side, 1, 0);
  add("each tangent to 258", quick ? 6 : 18, 43, 0);
  const std::size_t m = quick ? 1024 : 16384;
  out.push_back([&all, m] {
    std::vector<float> a, b;
    for (std::size_t i = 0; i < m; ++i)
      a.insert(a.end(), {0, 0, 0, 0.5F}), b.insert(b.end(), {1, 0, 0, 0.5F});
    return tangent_scene{"every pair tangent", app::of_rows(all, "sphere", std::move(a)),
                         app::of_rows(all, "sphere", std::move(b))};
  });
  return out;
}

} // namespace meetc::bench
