// The options of `meet collide`.
#include "meet/app/commands/collide_command.hpp"
#include "meet/app/input/failure.hpp"
#include "meet/app/input/input_options.hpp"
#include "meet/app/input/option_values.hpp"
#include "meet/app/query/choose.hpp"
#include "meet/app/world/collide_bodies.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <span>

namespace meetc::app {

namespace {

// Filled by CLI11. Members are strings where CLI11's own conversion would give a poorer message.
struct arguments {
  collide_request request;
  std::string precision = "certified", device = "auto", instruction_set = "auto";
  std::optional<std::string> tolerance, threads, devices;
  input_arguments a, b;
  bodies_request bodies; // of --world, or of more than two files
  std::vector<std::filesystem::path> more;
  std::vector<std::string> allowed;
  std::optional<std::string> only;

  bool many() const { return bodies.world || !more.empty(); }
};

void add_sets(CLI::App &c, arguments &to) {
  c.add_option("A", to.request.a, files_help)->type_name("FILE");
  c.add_option("B", to.request.b, "The other set; the same file gives every ordered pair (i, j), i = j included")
      ->type_name("FILE");
  c.add_option("C", to.more, "Further bodies: the answer is then which bodies touch")->type_name("FILE");
}

void add_bodies(CLI::App &c, arguments &to) {
  c.add_option(
       "--world", to.bodies.world,
       "Collide the bodies that a file lists, with their poses and the pairs that may touch: {\"bodies\": [{\"name\", "
       "\"file\", \"pose\"}], \"allow\": [[\"arm\", \"tool\"]]}")
      ->type_name("cell.json");
  c.add_option("--poses", to.bodies.poses,
               "Move the bodies frame by frame: rows of frame,body and a 3x4 matrix m00,..,m23, or x,y,z,qw,qx,qy,qz")
      ->type_name("poses.csv");
  c.add_option("--allow", to.allowed, "A pair of bodies that may touch, such as arm,tool or floor,*; may be repeated")
      ->allow_extra_args(false)
      ->type_name("NAME,NAME");
  c.add_option("--only", to.only, "Ask about this pair of bodies alone, such as arm,*")->type_name("NAME,NAME");
  c.add_flag("--fail-on-touch", to.request.fail_on_touch, "Exit with 1 where something touches")
      ->disable_flag_override();
}

void add_question(CLI::App &c, arguments &to) {
  collide_request &q = to.request;
  c.add_option("--predicate", q.predicate, "The predicate that decides, if several fit (meet inspect lists them)")
      ->type_name("NAME");
  c.add_option("--mode", q.mode, "Take spheres as solid balls, the default, or as surfaces")
      ->type_name("solid|surface");
  c.add_option("--precision", to.precision,
               "certified, the default, is never wrong: fp32 with proved bounds comes first, and pairs that it leaves "
               "unsure go on to fp64, fp64x2 and exact; exact is never wrong either; fp32, fp64 and fp64x2 take the "
               "sign of the rounded result")
      ->type_name("fp32|fp64|fp64x2|exact|certified");
  c.add_option("--tolerance", to.tolerance,
               "A length. An answer may then be wrong, but only where moving one element by at most this changes it: "
               "numbers are rounded to a power of two, and certified answers are about these. 0, the default, is exact")
      ->type_name("LENGTH");
  c.add_option(
       "--device", to.device,
       "The processor that decides pairs; auto, the default, takes the one that is expected to answer first, the start "
       "of a device included")
      ->type_name("auto|cpu|cuda");
  c.add_option("--devices", to.devices,
               "The number of CUDA devices that share the query; 1 is the default. The answer is the same")
      ->type_name("N");
  c.add_option(
       "--instruction-set", to.instruction_set,
       "The instruction set of the code that decides pairs on the CPU; auto, the default, is the best that this "
       "processor runs. Certified and exact answers do not depend on it")
      ->type_name("auto|baseline|avx2|avx512");
  for (const char side : {'a', 'b'})
    add_reading(c, side, side == 'a' ? to.a : to.b);
  for (const char side : {'a', 'b'})
    add_moving(c, side, side == 'a' ? to.a : to.b);
}

void add_answers(CLI::App &c, arguments &to) {
  collide_request &q = to.request;
  c.add_flag("--any", q.any,
             "Tell only whether anything touches: stop at the first pair found, so that pairs is 0 or 1, and do not "
             "name it")
      ->disable_flag_override();
  c.add_option(
       "--pairs", q.pairs,
       "Write all pairs, sorted; indices from 0 in file order. For many bodies a folder, with a file for each two")
      ->type_name("out.csv");
  c.add_option(
       "--first", q.first,
       "Write for each segment that touches a triangle the pair that it meets first on its way from its first "
       "point to its second (of several at one point, the one with the least index), sorted like --pairs. The order "
       "is exact, among the triangles that the precision finds")
      ->type_name("out.csv");
  c.add_option(
       "--evaluate", q.evaluate,
       "Write the value of a formula of the scene, such as 'norm2(meet(sphere, sphere))', for each pair, sorted "
       "like --pairs: in float64, or in float32 with --precision fp32, within the error that the formula's "
       "header states")
      ->option_text("FORMULA out.csv")
      ->expected(1, 2);
  c.add_option("--color,--colour", q.colour,
               "Write a.ply and b.ply with touched faces in bright colours into this folder")
      ->type_name("DIR");
  c.add_option("--image", q.image, "Write a picture in which touching elements stand out")->type_name("out.png");
  c.add_flag("--json", q.json, "Print one JSON object instead of the summary")->disable_flag_override();
  c.add_option("--threads", to.threads, "Threads; 0, the default, is all cores")->type_name("N");
}

const collide_request &read(arguments &args) {
  collide_request &q = args.request;
  q.on = processor_named(args.device);
  if (q.on == processor::best && args.instruction_set != "auto") // the option concerns the CPU alone
    q.on = processor::cpu;
  q.precision = precision_named(args.precision);
  if (args.tolerance)
    q.tolerance = length_named("--tolerance", *args.tolerance);
  if (args.threads)
    q.threads = threads_named(*args.threads);
  if (args.devices)
    q.devices = devices_named(*args.devices);
  if (q.devices > 1 && q.on != processor::cuda)
    throw failure(fmt::format("--devices {}: needs --device cuda", q.devices));
  if (q.evaluate.size() == 1)
    throw failure(fmt::format("--evaluate '{}': the file for the values is missing", q.evaluate[0]));
  q.read_a = input_named('a', args.a);
  q.read_b = input_named('b', args.b);
  q.read_a.threads = q.read_b.threads = q.threads;
  return q;
}

// Throws failure for an option that was given and that is for another number of bodies.
void require_fit(const CLI::App &c, bool many) {
  constexpr const char *of_many[] = {"--world", "--poses", "--allow", "--only"};
  constexpr const char *of_both[] = {"A",       "B",      "C",         "--mode",          "--precision",      "--any",
                                     "--pairs", "--json", "--threads", "--fail-on-touch", "--instruction-set"};
  const auto among = [](std::span<const char *const> names, const std::string &name) {
    return std::ranges::any_of(names, [&name](const char *n) { return name == n; });
  };
  for (const CLI::Option *const o : c.get_options()) {
    const std::string name = o->get_name();
    if (o->count() == 0 || among(of_both, name) || among(of_many, name) == many)
      continue;
    throw failure(many ? fmt::format("{}: it is for two sets, and not for many bodies", name)
                       : fmt::format("{}: it is for many bodies, as of --world or of three files and more", name));
  }
}

printed collide_many(const kernel_library &all, arguments &args) {
  bodies_request &q = args.bodies;
  const collide_request &r = args.request;
  if (q.world && !r.a.empty())
    throw failure(fmt::format("{}: --world lists all bodies; name the file there", r.a.string()));
  q.files = {r.a, r.b};
  q.files.insert(q.files.end(), args.more.begin(), args.more.end());
  if (r.mode)
    q.mode = *r.mode;
  if (q.mode != "solid" && q.mode != "surface")
    throw failure(fmt::format("--mode {}: unknown; known: solid, surface", io::quote(q.mode)));
  q.precision = precision_named(args.precision);
  q.any = r.any, q.json = r.json, q.pairs = r.pairs;
  if (args.threads)
    q.threads = threads_named(*args.threads);
  for (const std::string &text : args.allowed)
    q.allowed.push_back(name_pair_of("--allow", text));
  if (args.only)
    q.only = name_pair_of("--only", *args.only);
  bodies_report report = collide_bodies(kernels_named(all, args.instruction_set), q);
  return {std::move(report.text), r.fail_on_touch && report.touch ? check_failed : done};
}

} // namespace

command add_collide(CLI::App &program, const kernel_library &all) {
  CLI::App &c = *program.add_subcommand("collide", "Find all touching pairs of the elements of two files");
  const auto args = std::make_shared<arguments>();
  add_sets(c, *args);
  add_question(c, *args);
  add_answers(c, *args);
  add_bodies(c, *args);
  return {&c, [all, args, &c] {
            require_fit(c, args->many());
            if (args->many())
              return collide_many(all, *args);
            if (args->request.a.empty() || args->request.b.empty())
              throw failure(
                  fmt::format("{} is required (meet collide --help says more)", args->request.a.empty() ? "A" : "B"));
            return collide(kernels_named(all, args->instruction_set), read(*args));
          }};
}

} // namespace meetc::app
