#include "app/cli.hpp"

#include "app/choose.hpp"
#include "app/collide_command.hpp"
#include "app/demo_command.hpp"
#include "app/failure.hpp"
#include "app/inspect_command.hpp"
#include "app/option_values.hpp"
#include "bench/options.hpp"
#include "io/number.hpp"
#include "io/text.hpp"

#include <cga/cga_runtime.hpp>
#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <fcntl.h>
#include <unistd.h>

namespace meetc::app {

namespace {

// Whether a comma lacks a number on one side.
bool has_hole(std::string_view text) {
  bool number = false, comma = false;
  for (const char c : text) {
    if (c == ',' && !number)
      return true;
    comma = comma || c == ',';
    number = c != ',' && (number || (c != ' ' && c != '\t'));
  }
  return comma && !number;
}

// Numbers apart by commas or blanks.
template <std::size_t N> std::array<double, N> numbers(const char *option, std::string text) {
  std::array<double, N> out{};
  std::size_t n = 0;
  if (has_hole(text))
    throw failure(fmt::format("{}: {} lacks a number beside a comma", option, io::quote(text)));
  std::replace(text.begin(), text.end(), ',', ' ');
  std::string_view rest = text;
  for (std::string_view word; !(word = io::take_word(rest)).empty(); ++n) {
    double value = 0;
    if (!io::parse_decimal(word, io::precision::float64, value))
      throw failure(fmt::format("{}: {} is not a number", option, io::quote(word)));
    if (n < N)
      out[n] = value;
  }
  if (n != N)
    throw failure(fmt::format("{}: {} number{} expected{}, {} given", option, N, N == 1 ? "" : "s",
                              N == 1 ? "" : ", with commas between them", n));
  return out;
}

// What CLI11 fills; strings where its own conversion says less than ours.
struct arguments {
  collide_request collide;
  inspect_request inspect;
  std::filesystem::path demo_folder = "meet-demo";
  bench_arguments bench;
  std::string precision = "certified", device = "auto";
  std::optional<std::string> translate, scale, matrix, threads;
  CLI::App *collide_command = nullptr, *inspect_command = nullptr, *demo_command = nullptr;
};

constexpr const char *files_help = "A mesh (.ply, .obj, .stl), or a .csv whose first line names a kind's numbers: "
                                   "x,y,z,r spheres; x0,y0,z0,x1,y1,z1 segments; x,y,z points";

void add_collide(CLI::App &app, arguments &to) {
  CLI::App &c = *app.add_subcommand("collide", "Find all touching pairs of the elements of two files");
  to.collide_command = &c;
  collide_request &q = to.collide;
  c.add_option("A", q.a, files_help)->required()->type_name("FILE");
  c.add_option("B", q.b, "The other set; the same file gives every ordered pair (i, j), i = j included")
      ->required()
      ->type_name("FILE");
  c.add_option("--predicate", q.predicate, "Which predicate decides, where several fit (meet inspect lists them)")
      ->type_name("NAME");
  c.add_option("--mode", q.mode, "What a sphere is; solid is the default")->type_name("solid|surface");
  c.add_option("--precision", to.precision,
               "certified, the default, is never wrong: fp32 with proved bounds first, and what that leaves unsure "
               "goes on to fp64, fp64x2 and exact; exact is never wrong either; fp32, fp64 and fp64x2 take the sign "
               "of what rounding leaves")
      ->type_name("fp32|fp64|fp64x2|exact|certified");
  c.add_option("--device", to.device, "Where pairs are decided; auto, the default, is the CPU")
      ->type_name("auto|cpu|cuda");
  c.add_option(io::scale_option, to.scale, "Multiply B by s first: coordinates and radii")->type_name("s");
  c.add_option(io::matrix_option, to.matrix,
               "Then move B by m00,m01,..,m23: 12 numbers, row-major 3x4; for spheres a similarity")
      ->type_name("NUMBERS");
  c.add_option(io::translate_option, to.translate, "Then move B by x,y,z")->type_name("x,y,z");
  c.add_flag("--any", q.any,
             "Only whether anything touches: stops at the first pair found, so that pairs is 0 or 1; "
             "which pair is not told")
      ->disable_flag_override();
  c.add_option("--pairs", q.pairs, "Write all pairs, sorted; indices from 0 in file order")->type_name("out.csv");
  c.add_option("--color,--colour", q.colour,
               "Write a.ply and b.ply with touched faces in bright colours into this folder")
      ->type_name("DIR");
  c.add_option("--image", q.image, "Write a picture in which what touches stands out")->type_name("out.png");
  c.add_flag("--json", q.json, "Print one JSON object instead of the summary")->disable_flag_override();
  c.add_option("--threads", to.threads, "Threads; 0, the default, is all cores")->type_name("N");
}

void add_inspect(CLI::App &app, arguments &to) {
  CLI::App &c = *app.add_subcommand("inspect", "Say what two files hold, what is degenerate, and which predicates fit");
  to.inspect_command = &c;
  c.add_option("A", to.inspect.a, files_help)->required()->type_name("FILE");
  c.add_option("B", to.inspect.b, "The other set")->required()->type_name("FILE");
  c.add_option("--scene", to.inspect.scene, "Write the scene file that these files require, for meetc")
      ->type_name("out.toml");
  c.add_option("--algebra", to.inspect.algebra, "The algebra that the scene file names (the shipped cga3.toml)")
      ->type_name("PATH");
}

void add_demo(CLI::App &app, arguments &to) {
  CLI::App &c = *app.add_subcommand("demo", "Collide built-in bodies; write coloured meshes and pictures");
  to.demo_command = &c;
  c.add_option("-o", to.demo_folder, "The folder to write to (./meet-demo)")->type_name("DIR");
}

std::string obey(arguments &args) {
  const catalogue &all = cga::catalogue();
  if (args.inspect_command->parsed())
    return inspect(all, args.inspect);
  if (args.demo_command->parsed())
    return demo(all, args.demo_folder, 0);
  if (args.bench.command->parsed())
    return bench(all, args.bench);
  collide_request &q = args.collide;
  q.where = place_named(args.device);
  q.precision = precision_named(args.precision);
  if (args.threads)
    q.threads = threads_named(*args.threads);
  if (args.scale)
    q.move_b.scale = numbers<1>(io::scale_option, *args.scale)[0];
  if (args.matrix)
    q.move_b.matrix = numbers<12>(io::matrix_option, *args.matrix);
  if (args.translate)
    q.move_b.translate = numbers<3>(io::translate_option, *args.translate);
  q.move_b.check();
  return collide(all, q);
}

int complain(const std::string &what, int code) {
  std::fprintf(stderr, "meet: %s\n", what.c_str());
  return code;
}

// A reader that has gone (head) is no fault; a full disk is.
int print(const std::string &text) {
  errno = 0;
  const bool written = std::fwrite(text.data(), 1, text.size(), stdout) == text.size();
  if ((written && std::fflush(stdout) == 0) || errno == EPIPE)
    return done;
  return complain(fmt::format("standard output: {}", std::generic_category().message(errno)), bad_input);
}

// A program started without them would get its next files under their numbers. For reading only: what is
// printed to a closed stream is lost, and writing must say so.
void open_standard_streams() {
  for (int fd = 0; fd < 3; ++fd)
    if (::fcntl(fd, F_GETFD) == -1)
      static_cast<void>(::open("/dev/null", O_RDONLY));
}

bool contains(const std::string &text, const char *part) {
  return text.find(part) != std::string::npos;
}

// CLI11's words, or better ones, in one line.
std::string in_one_line(const CLI::Error &e, const arguments &args, int argc, char **argv) {
  const CLI::App *command = nullptr;
  for (const CLI::App *c : {args.collide_command, args.inspect_command, args.demo_command, args.bench.command})
    if (argc > 1 && c->get_name() == argv[1])
      command = c;
  std::string name = command ? command->get_name() + " " : "";
  const CLI::App *part = nullptr;
  for (const CLI::App *c : {args.bench.paper_command, args.bench.gpu_command})
    if (command == args.bench.command && argc > 2 && c->get_name() == argv[2])
      part = c;
  if (part)
    name += part->get_name() + " ";
  else if (command == args.bench.command)
    return fmt::format("meet bench: {}; known: paper, gpu (meet bench --help says more)",
                       argc < 3 ? "what to measure is needed" : "unknown " + io::quote(argv[2]));
  const std::string more = fmt::format("meet {}--help says more", name);
  if (!command && (argc < 2 || argv[1][0] == '-'))
    return fmt::format("a command is needed first: collide, inspect, demo or bench ({})", more);
  if (!command)
    return fmt::format("unknown command {}; known: collide, inspect, demo, bench ({})", io::quote(argv[1]), more);
  std::string what = e.what();
  const std::string option = what.substr(0, what.find(':'));
  if (contains(what, "At Most 1 required"))
    what = option + ": given more than once";
  else if (contains(what, "1 required") && contains(what, "missing"))
    what = option + ": its value is missing";
  else if (contains(what, "not expected"))
    what = "not expected:" + what.substr(what.find(':') + 1);
  return fmt::format("{} ({})", io::error(what).what(), more);
}

} // namespace

int run(int argc, char **argv) {
  std::signal(SIGPIPE, SIG_IGN);
  open_standard_streams();
  try {
    CLI::App app("Which elements of two sets touch: meshes, segments and spheres, exactly.", "meet");
    app.set_version_flag("--version", "meet " MEETC_VERSION);
    app.require_subcommand(1);
    arguments args;
    add_collide(app, args);
    add_inspect(app, args);
    add_demo(app, args);
    add_bench(app, args.bench);
    try {
      app.parse(argc, argv);
    } catch (const CLI::CallForHelp &) {
      return print(app.help());
    } catch (const CLI::CallForVersion &) {
      return print("meet " MEETC_VERSION "\n");
    } catch (const CLI::Error &e) {
      return complain(in_one_line(e, args, argc, argv), bad_input);
    }
    return print(obey(args));
  } catch (const failure &e) {
    return complain(e.what(), e.code());
  } catch (const std::bad_alloc &) {
    return complain("not enough memory", bad_input);
  } catch (const std::length_error &) {
    return complain("not enough memory", bad_input);
  } catch (const std::exception &e) {
    return complain(e.what(), bad_input);
  }
}

} // namespace meetc::app
