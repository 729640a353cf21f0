#include "bench/tables/paper/figures.hpp"

#include "app/paint.hpp"

#include <fmt/format.h>

namespace meetc::bench {

std::string figure_file(int number) {
  return fmt::format("figure_{}.png", number);
}

void draw_figure(const std::filesystem::path &to, const paper_figure &f, bool quick) {
  if (f.plot) {
    write_chart(to, *f.plot, quick ? 800 : 1000, quick ? 450 : 650);
    return;
  }
  const paper_scene &s = *f.scene;
  std::vector<app::painted> sides{{s.a, s.hit_a, s.name_a, s.base_a, s.hit_colour_a}};
  if (s.b.kind)
    sides.push_back({s.b, s.hit_b, s.name_b, s.base_b, s.hit_colour_b});
  app::write_picture(to, sides, {}, quick ? 800 : 1600, quick ? 450 : 900);
}

} // namespace meetc::bench
