#include "meet/bench/tables/gpu/growth_chart.hpp"

#include "meet/app/output/output_files.hpp"
#include "meet/io/files/error.hpp"
#include "meet/io/files/file_bytes.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace meetc::bench {

std::optional<chart> growth_chart(const app::json &results) {
  const app::json &tables = results.at("tables");
  const auto growth =
      std::find_if(tables.begin(), tables.end(), [](const app::json &t) { return t.at("name") == "growth"; });
  if (growth == tables.end())
    return {};
  const auto device = results.at("device").get<std::string>();
  chart c;
  c.title = "Balls, each with about 1.1 pairs: a certified query on new sets";
  c.x_label = "Balls in each set";
  c.y_label = fmt::format("Milliseconds, {}", device.substr(0, device.find(',')));
  const auto add = [&](const char *name, const char *key, picture::colour ink) {
    curve k{name, ink, {}};
    for (const app::json &row : growth->at("rows"))
      if (row.at("scene").get<std::string>().starts_with("balls,") && row.at(key).is_number())
        k.points.emplace_back(row.at("a").get<double>(), row.at(key).get<double>());
    std::sort(k.points.begin(), k.points.end());
    c.curves.push_back(std::move(k));
  };
  add("every pair", "every_first", curve_colours::red);
  add("hierarchy", "tree_first", curve_colours::gpu);
  return c;
}

std::string draw_growth(const std::filesystem::path &results, const std::filesystem::path &folder) {
  const io::file_bytes file = io::load_file(results);
  app::output_files outputs({results});
  const std::filesystem::path to = folder / "growth.png";
  outputs.expect(to, true);
  std::optional<chart> c;
  try {
    c = growth_chart(app::json::parse(file.text()));
  } catch (const app::json::exception &) {
    throw io::error(fmt::format("{}: not an object as `meet bench gpu --json` prints it", file.name));
  }
  if (!c)
    throw io::error(fmt::format("{}: it has no table of growth", file.name));
  outputs.make_folder(folder);
  outputs.write(to, [&c](const std::filesystem::path &at) { plot_of(*c, 800, 500).draw(at); });
  outputs.commit();
  return fmt::format("wrote {}\n", to.string());
}

} // namespace meetc::bench
