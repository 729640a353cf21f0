#include "meet/app/commands/demo_command.hpp"

#include "meet/app/commands/demo_scenes.hpp"
#include "meet/app/input/sets.hpp"
#include "meet/app/output/output_files.hpp"
#include "meet/app/output/paint.hpp"
#include "meet/app/output/report_page.hpp"
#include "meet/app/query/collide_sets.hpp"
#include "meet/app/text/words.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <memory>
#include <vector>

namespace meetc::app {

namespace fs = std::filesystem;

namespace {

fs::path mesh_path(const fs::path &folder, const std::string &name) {
  return folder / (name + ".ply");
}
fs::path picture_path(const fs::path &folder, const demo_scene &s) {
  return folder / (s.name + ".png");
}
fs::path page_path(const fs::path &folder, const demo_scene &s) {
  return folder / (s.name + ".html");
}

void write_scene(const fs::path &folder, const demo_scene &s, const query &asked, const answers &found,
                 output_files &outputs, std::vector<std::string> &written) {
  const painted a{s.a, found.a.hit, s.name_a, picture::palette::calm[0], picture::palette::yellow};
  const painted b{s.b, found.b.hit, s.name_b, picture::palette::calm[1], picture::palette::vermilion};
  for (const painted *const side : {&a, &b})
    if (is_mesh(side->set)) {
      const fs::path path = mesh_path(folder, side->name);
      outputs.write(path, [side](const fs::path &to) { write_coloured(to, *side); });
      written.push_back(path.string());
    }
  const auto write = [&](const fs::path &path, const output_files::writer &writer) {
    outputs.write(path, writer);
    written.push_back(path.string());
  };
  write(picture_path(folder, s), [&](const fs::path &to) { write_picture(to, {a, b}); });
  const collide_report report{s.name_a, s.name_b, s.a, s.b, asked, found, false, false, false, 0, "", {}, {}};
  write(page_path(folder, s), [&](const fs::path &to) { write_page(to, a, b, report); });
}

} // namespace

std::string demo(const catalogue &all, const fs::path &folder, int threads) {
  const std::vector<demo_scene> scenes = demo_scenes(all);
  output_files outputs;
  for (const demo_scene &s : scenes) {
    outputs.expect(picture_path(folder, s), true);
    outputs.expect(page_path(folder, s), true);
    for (const auto &[set, name] : {std::pair(&s.a, &s.name_a), std::pair(&s.b, &s.name_b)})
      if (is_mesh(*set))
        outputs.expect(mesh_path(folder, *name), true);
  }
  outputs.make_folder(folder);
  std::vector<std::string> written;
  constexpr const char *row = "{:<30}{:<30}{:<20}{:>8}{:>12}\n";
  std::string out = fmt::format(fmt::runtime(row), "A", "B", "predicate", "pairs", "time");
  for (const demo_scene &s : scenes) {
    query h;
    h.by = choose(all, *s.a.kind, *s.b.kind, {}, {});
    h.threads = threads;
    h.keep = true;
    h.elements = page_has_contacts(h);
    const answers found = collide_sets(s.a, s.b, h);
    const auto label = [](const std::string &name, const io::element_set &set) {
      return fmt::format("{}, {}", name, counted(set));
    };
    out += fmt::format(fmt::runtime(row), label(s.name_a, s.a), label(s.name_b, s.b), h.by.predicate->name,
                       grouped(found.pairs),
                       fmt::format("{:.1f} ms", 1000 * (found.prepare_seconds + found.collide_seconds)));
    write_scene(folder, s, h, found, outputs, written);
  }
  outputs.commit();
  out += "\nCertified answers, never wrong, on the CPU; a time covers preparing both sets and finding every pair.\n";
  for (const std::string &path : written)
    out += fmt::format("wrote {}\n", path);
  out += fmt::format("\nOpen {} in a browser: turn the scene, and click on a pair to fly there.\n",
                     page_path(folder, scenes.front()).string());
  return out;
}

command add_demo(CLI::App &program, const catalogue &all) {
  CLI::App &c = *program.add_subcommand(
      "demo", "Collide built-in bodies; write coloured meshes, pictures and pages for a browser");
  const auto folder = std::make_shared<fs::path>("meet-demo");
  c.add_option("-o", *folder, "The folder to write to (./meet-demo)")->type_name("DIR");
  return {&c, [&all, folder] { return demo(all, *folder, 0); }};
}

} // namespace meetc::app
