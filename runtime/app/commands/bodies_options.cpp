#include "meet/app/commands/bodies_options.hpp"

#include "meet/app/input/failure.hpp"
#include "meet/io/text/number.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <span>

namespace meetc::app {

void add_bodies(CLI::App &c, bodies_arguments &to) {
  c.add_option("C", to.more, "Further bodies: the answer is then which bodies touch")->type_name("FILE");
  c.add_flag("--bodies", to.bodies, "Take two files for bodies as well, and tell whether one lies inside the other")
      ->disable_flag_override();
  c.add_option(
       "--world", to.world,
       "Collide the bodies that a file lists, with their poses and the pairs that may touch: {\"bodies\": [{\"name\", "
       "\"file\", \"pose\"}], \"allow\": [[\"arm\", \"tool\"]]}")
      ->type_name("cell.json");
  c.add_option(
       "--poses", to.poses,
       "Move the bodies frame by frame: rows of frame,body and a 3x4 matrix m00,..,m23, or x,y,z,qw,qx,qy,qz; or an "
       "array (frames, bodies, 4, 4) of NumPy")
      ->type_name("poses.csv|npy");
  c.add_option("--allow", to.allowed, "A pair of bodies that may touch, such as arm,tool or floor,*; may be repeated")
      ->allow_extra_args(false)
      ->type_name("NAME,NAME");
  c.add_option("--srdf", to.srdf, "The pairs of links that may touch, by disable_collisions of a robot's SRDF file")
      ->type_name("robot.srdf");
  c.add_option("--only", to.only, "Ask about this pair of bodies alone, such as arm,*")->type_name("NAME,NAME");
}

void require_fit(const CLI::App &c, const bodies_arguments &given) {
  const bool many = given.many();
  constexpr const char *of_many[] = {"--bodies", "--world", "--poses", "--allow", "--srdf", "--only"};
  constexpr const char *of_both[] = {
      "A",       "B",        "C",         "--mode",          "--precision",       "--any",
      "--pairs", "--json",   "--threads", "--fail-on-touch", "--instruction-set", "--device",
      "--image", "--camera", "--size",    "--report"};
  const auto among = [](std::span<const char *const> names, const std::string &name) {
    return std::ranges::any_of(names, [&name](const char *n) { return name == n; });
  };
  for (const CLI::Option *const o : c.get_options()) {
    const std::string name = o->get_name();
    if (o->count() == 0 || among(of_both, name) || among(of_many, name) == many)
      continue;
    const auto is_number = [&name](const std::filesystem::path &p) {
      double number = 0;
      return (name.starts_with("--translate") || name.starts_with("--matrix") || name.starts_with("--motor")) &&
             io::parse_decimal(p.string(), io::precision::float64, number) && !std::filesystem::exists(p);
    };
    const auto taken = std::ranges::find_if(given.more, is_number);
    throw failure(
        many ? fmt::format("{}: it is for two sets, and not for many bodies{}", name,
                           taken == given.more.end()
                               ? ""
                               : fmt::format("; {} is taken for a file, since commas separate numbers, as in "
                                             "1,2,3",
                                             taken->string()))
             : fmt::format("{}: it is for many bodies, as of --world, of --bodies or of three files and more", name));
  }
}

bodies_request bodies_named(const bodies_arguments &given, const std::filesystem::path &a,
                            const std::filesystem::path &b) {
  if (given.world && !a.empty())
    throw failure(fmt::format("{}: --world lists all bodies; name the file there", a.string()));
  if (!given.world && b.empty())
    throw failure("--bodies: name two files or more");
  bodies_request q;
  q.world = given.world, q.poses = given.poses, q.srdf = given.srdf;
  q.files = {a, b};
  q.files.insert(q.files.end(), given.more.begin(), given.more.end());
  for (const std::string &text : given.allowed)
    q.allowed.push_back(name_pair_of("--allow", text));
  if (given.only)
    q.only = name_pair_of("--only", *given.only);
  return q;
}

} // namespace meetc::app
