// The options of `meet collide`.
#include "meet/app/commands/bodies_options.hpp"
#include "meet/app/commands/collide_command.hpp"
#include "meet/app/commands/self_command.hpp"
#include "meet/app/input/failure.hpp"
#include "meet/app/input/input_options.hpp"
#include "meet/app/input/option_values.hpp"
#include "meet/app/input/picture_options.hpp"
#include "meet/app/query/choose.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <memory>
#include <utility>

namespace meetc::app {

namespace {

// Filled by CLI11. Members are strings where CLI11's own conversion would give a poorer message.
struct arguments {
  collide_request request;
  std::string precision = "certified", device = "auto", instruction_set = "auto";
  std::optional<std::string> tolerance, threads, devices, camera, size;
  input_arguments a, b;
  bool separate = false; // --no-merge
  bodies_arguments bodies;
};

// Throws failure for an option that says nothing of a mesh with itself, or that says something of that alone.
void check_self(const arguments &args) {
  const collide_request &q = args.request;
  if (!q.self && args.separate)
    throw failure("--no-merge goes with --self, which finds where one mesh crosses itself");
  if (!q.self && q.b.empty())
    throw failure("B is required, the other set; to find where A crosses itself, write --self");
  if (!q.self)
    return;
  if (!q.b.empty())
    throw failure(fmt::format("--self is about A alone; leave out {}, or --self", q.b.string()));
  const input_arguments &b = args.b;
  const std::pair<const char *, bool> given[] = {
      {"--format-b", b.format.has_value()}, {"--kind-b", b.kind.has_value()},
      {"--scale-b", b.scale.has_value()},   {"--matrix-b", b.matrix.has_value()},
      {"--motor-b", b.motor.has_value()},   {"--translate-b", b.translate.has_value()}};
  for (const auto &[name, there] : given)
    if (there)
      throw failure(fmt::format("{}: with --self there is no B", name));
  const std::pair<const char *, bool> other[] = {{"--predicate", q.predicate.has_value()},
                                                 {"--mode", q.mode.has_value()},
                                                 {"--tolerance", args.tolerance.has_value()},
                                                 {"--any", q.any},
                                                 {"--first", q.first.has_value()},
                                                 {"--contacts", q.contacts.has_value()},
                                                 {"--evaluate", !q.evaluate.empty()}};
  for (const auto &[name, there] : other)
    if (there)
      throw failure(fmt::format("{} goes with two sets, and --self with one; leave one of them out", name));
  if (args.precision != "certified")
    throw failure(
        fmt::format("--precision {}: the answer of --self is certified; leave the option out", args.precision));
  if (args.devices)
    throw failure("--devices: one device answers --self; leave the option out");
}

void add_sets(CLI::App &c, arguments &to) {
  c.add_option("A", to.request.a, files_help)->type_name("FILE");
  c.add_option("B", to.request.b, "The other set; the same file gives every ordered pair (i, j), i = j included")
      ->type_name("FILE");
  c.add_flag(
       "--self", to.request.self,
       "Find where the mesh A crosses itself, in place of B: the pairs of its faces that meet beyond their common "
       "corners. Corners with equal coordinates are one")
      ->disable_flag_override();
  c.add_flag("--no-merge", to.separate,
             "With --self: corners are one only if they are one vertex of the file, so that sheets that lie on each "
             "other meet")
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
       "--contacts", q.contacts,
       "Write where the pairs of triangles, of segments and triangles, or of spheres and segments, meet: .csv, a row "
       "for each corner of a pair's contact; .obj or .ply, polylines and flat polygons; .json, all of it. Each "
       "coordinate "
       "is the exact one, rounded once to float32. Other pairs of spheres get a witness each, a point of both")
      ->type_name("out.csv|obj|ply|json");
  c.add_flag("--contacts-float64", q.contacts_float64, "Round the coordinates of --contacts to float64")
      ->disable_flag_override();
  c.add_flag("--contacts-embedded", q.contacts_embedded,
             "With --contacts of two meshes, also tell whether both are embedded: their faces meet in common vertices "
             "and edges alone, and all have area. Then no two nodes are one point")
      ->disable_flag_override();
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
  c.add_option("--image", q.image,
               "Write a picture in which touching elements stand out; of many bodies, that of the first frame in which "
               "some touch")
      ->type_name("out.png");
  c.add_option(
       "--camera", to.camera,
       "From where --image is seen: degrees about the upward axis y, from the front z, and above the horizon; a "
       "distance, 1 "
       "where the scene fills the picture; and z if that axis is upward and the front -y. Or the x,y,z of the eye, of "
       "the "
       "point that it looks at, and of the direction up (0,1,0), with a view 30 degrees high. 28,16 is the default")
      ->type_name("AZIMUTH,ELEVATION[,DISTANCE][,z]|EYE,TARGET[,UP]");
  c.add_option("--size", to.size, "The size of --image in pixels; 1600x900 is the default")->type_name("WIDTHxHEIGHT");
  c.add_option(
       "--report", q.page,
       "Write a page for a browser, one file that needs no network: the elements that touch and where they meet, in "
       "a scene to turn, with a list of the pairs")
      ->type_name("out.html");
  c.add_flag("--fail-on-touch", q.fail_on_touch,
             "Exit with 1 where something touches; of many bodies, where one lies inside another too")
      ->disable_flag_override();
  c.add_flag("--json", q.json, "Print one JSON object instead of the summary")->disable_flag_override();
  c.add_option("--threads", to.threads, "Threads; 0, the default, is all cores")->type_name("N");
}

void read_view(arguments &args) {
  collide_request &q = args.request;
  for (const auto &[name, given] : {std::pair("--camera", &args.camera), std::pair("--size", &args.size)})
    if (*given && !q.image)
      throw failure(fmt::format("{}: it is about a picture; write --image out.png as well", name));
  q.view = picture_view_named(args.camera, args.size);
}

const collide_request &read(arguments &args) {
  collide_request &q = args.request;
  check_self(args);
  read_view(args);
  q.merge = !args.separate;
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

printed collide_many(const kernel_library &all, arguments &args) {
  read_view(args);
  const collide_request &r = args.request;
  bodies_request q = bodies_named(args.bodies, r.a, r.b);
  q.mode = mode_named(r.mode);
  q.precision = precision_named(args.precision);
  q.on = processor_named(args.device);
  q.any = r.any, q.json = r.json, q.pairs = r.pairs, q.image = r.image, q.view = r.view, q.page = r.page;
  if (args.threads)
    q.threads = threads_named(*args.threads);
  bodies_report report = collide_bodies(kernels_named(all, args.instruction_set), q);
  return {std::move(report.text), r.fail_on_touch && report.touch ? check_failed : done};
}

} // namespace

command add_collide(CLI::App &program, const kernel_library &all, const kernel_library &neighbours) {
  CLI::App &c = *program.add_subcommand("collide", "Find all touching pairs of the elements of two files");
  const auto args = std::make_shared<arguments>();
  add_sets(c, *args);
  add_question(c, *args);
  add_answers(c, *args);
  add_bodies(c, args->bodies);
  return {&c, [all, neighbours, args, &c]() -> printed {
            require_fit(c, args->bodies);
            if (args->bodies.many())
              return collide_many(all, *args);
            if (args->request.a.empty())
              throw failure("A is required (meet collide --help says more)");
            const collide_request &q = read(*args);
            const catalogue &kernels = kernels_named(all, args->instruction_set);
            const catalogue &of_neighbours = kernels_named(neighbours, args->instruction_set);
            return q.self ? collide_self(kernels, of_neighbours, q) : collide(kernels, of_neighbours, q);
          }};
}

} // namespace meetc::app
