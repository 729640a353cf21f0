// meetc: compiles the meet. Exit codes: 0 done, 1 a check failed, 2 bad usage or input.
#include "gen/driver.hpp"
#include "gen/support/limits.hpp"
#include "gen/support/output.hpp"
#include "gen/support/source.hpp"

#include <cerrno>
#include <cfenv>
#include <CLI/CLI.hpp>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <fmt/format.h>

namespace {

// CLI11's message, or which command or option may have been meant by one that is not known.
std::string usage_error(const CLI::App &app, const CLI::ParseError &e) {
  const std::vector<CLI::App *> given = app.get_subcommands();
  const CLI::App &of = given.empty() ? app : *given.front();
  for (const std::string &left : of.remaining()) {
    const bool option = left.size() > 1 && left.front() == '-';
    if (!option && !given.empty())
      continue;
    std::vector<std::string> known;
    if (option)
      for (const CLI::Option *const o : of.get_options())
        for (const std::string &name : o->get_lnames())
          known.push_back("--" + name);
    else
      for (const CLI::App *const command : app.get_subcommands([](const CLI::App *) { return true; }))
        known.push_back(command->get_name());
    return fmt::format("unknown {} '{}'{}", option ? "option" : "command", left,
                       meetc::nearest(left.substr(0, left.find('=')), known));
  }
  return e.what();
}

} // namespace

int main(int argc, char **argv) {
  using namespace meetc;
  std::fesetenv(FE_DFL_ENV);     // a library that is loaded first may have unmasked exceptions
  std::signal(SIGPIPE, SIG_IGN); // finish_output() knows what a reader that has gone means
  CLI::App app("meetc generates geometric-algebra kernels from a scene.", "meetc");
  app.set_version_flag("--version", "meetc " MEETC_VERSION);
  app.require_subcommand(1);

  generate_options g;
  CLI::App *generate_command = app.add_subcommand("generate", "Write the C++ and CUDA source that a scene asks for");
  generate_command->add_option("scene", g.scene, "Scene file (.toml)")->required();
  generate_command->add_option("-o,--out", g.out, "Folder that holds what is emitted, and nothing else")
      ->required()
      ->check([](const std::string &folder) { return folder.empty() ? "its name is empty" : ""; });
  generate_command->add_flag("--check", g.check,
                             "Write nothing; exit 1 if a byte would change or if there is a stray file");
  generate_command->add_option("--namespace", g.space, "Namespace instead of the scene's");
  generate_command->add_option("--require-backend", g.required_backends, "Fail unless the scene emits this backend")
      ->allow_extra_args(false)
      ->check(CLI::IsMember(target::backends().known));
  generate_command->add_option("--depfile", g.depfile, "Write the files that were read, for a build system");
  generate_command->add_option("--stamp", g.stamp, "Touch this file when done");
  generate_command->add_flag(
      "--kernel-headers,!--no-kernel-headers", g.kernel_headers,
      "Write the headers in meetc/ that emitted code includes, unless the build has them elsewhere");
  generate_command
      ->add_option(
          "--units", g.units,
          "Also write this number of sources for each language, which include those of the predicates, for a build\n"
          "that has to know the names of its sources before the scene is read")
      ->check(CLI::Range(0, 64));
  generate_command->add_flag("-q,--quiet", g.quiet, "Say nothing when all is well");

  verify_options v;
  CLI::App *verify_command = app.add_subcommand(
      "verify", "Check every kernel of a scene: formulas against the dense product, predicates against exact geometry");
  verify_command->add_option("scene", v.scene, "Scene file (.toml)")->required();
  verify_command->add_option("--cases", v.cases, "Cases for each predicate")
      ->capture_default_str()
      ->check(CLI::Range(1L, 100000000L));
  verify_command->add_option("--seed", v.seed, "Seed of the cases")->capture_default_str();
  verify_command->add_flag("--allow-unchecked", v.allow_unchecked,
                           "Exit 0 also where nothing of a kernel could be compared, which is named in any case");

  plan_options p;
  CLI::App *plan_command = app.add_subcommand(
      "plan", "Print which arithmetic keeps the tolerance of a scene, kernel by kernel, and what is proved of it");
  plan_command->add_option("scene", p.scene, "Scene file (.toml)")->required();

  show_options s;
  CLI::App *show_command = app.add_subcommand("show", "Print one kernel at any stage of the compiler");
  show_command->add_option("scene", s.scene, "Scene file (.toml)")->required();
  show_command->add_option(
      "what", s.words,
      "A predicate, or a function and its kinds: meet sphere line. Without it, the kernels of the scene are\n"
      "listed, and with --emit=separate or --emit=counts a table of them is printed");
  show_command->add_option("-e,--expression", s.expression,
                           "An expression in place of a kernel; --with names its operands");
  show_command->add_option("--with", s.with, "Operands of the expression: 'S: sphere, L: line'");
  show_command->add_option("--emit", s.emit, "Stage to print: cpp where nothing is said")
      ->check(CLI::IsMember(stages()));

  CLI::App *targets_command = app.add_subcommand("targets", "Print what each target, a scene's backend, carries");

  eval_options ev;
  CLI::App *eval_command =
      app.add_subcommand("eval", "Print the exact value of an expression for operands that are given as numbers");
  eval_command->add_option("scene", ev.scene, "Scene file (.toml)")->required();
  eval_command->add_option("-e,--expression", ev.expression, "The expression, as in 'norm2(meet(S, T))'")->required();
  eval_command->add_option("--with", ev.with,
                           "Its operands by what they store: 'S: sphere = 0,0,0,1; T: sphere = 1/2,0,0,2'");

  std::string first;
  CLI::App *new_command =
      app.add_subcommand("new", "Write a first algebra, a scene and a CMake project with a program into a new folder");
  new_command->add_option("folder", first, "The folder, which is new or empty")->required();

  compare_options m;
  CLI::App *compare_command = app.add_subcommand(
      "compare",
      "Print what the code of scenes costs: its size, operations and stored values, and perhaps its compilation");
  compare_command->add_option("scenes", m.scenes, "Scene files (.toml)")->required();
  compare_command->add_option("--compile", m.cxx,
                              "Also compile the C++ with this compiler, for objects, seconds and the time of a pair");
  compare_command->add_flag("--formulas", m.formulas, "Also print what each formula costs");
  compare_command->add_option("--beside", m.beside, "A file (.toml) of counts that other generators publish")
      ->needs("--formulas");
  compare_command->add_flag(
      "--kernels", m.kernels,
      "Also print the operations, sign atoms and bounds of each kernel, scene beside scene: the same\n"
      "kernel in two algebras");
  compare_command->add_option("--nvcc", m.nvcc, "Also compile the CUDA with this nvcc, for registers on sm_90");

  for (const auto &[command, path] :
       {std::pair(generate_command, &g.algebra_path), std::pair(verify_command, &v.algebra_path),
        std::pair(plan_command, &p.algebra_path), std::pair(show_command, &s.algebra_path),
        std::pair(compare_command, &m.algebra_path), std::pair(eval_command, &ev.algebra_path)})
    command
        ->add_option("--algebra-path", *path, "A folder in which algebras are looked for as well; may be given again")
        ->allow_extra_args(false);
  limits most;
  for (CLI::App *const command :
       {generate_command, verify_command, plan_command, show_command, compare_command, eval_command}) {
    command
        ->add_option("--limit-seconds", most.seconds,
                     "The most time that this may take, for a spec that is not trusted")
        ->check(CLI::Range(0.01, 1e6))
        ->check([](const std::string &text) {
          return std::isfinite(std::strtod(text.c_str(), nullptr)) ? "" : "it must be finite";
        });
    command->add_option("--limit-megabytes", most.megabytes, "The most memory that this may take")
        ->check(CLI::Range(1L, 100000000L));
  }

  try {
    app.parse(argc, argv);
  } catch (const CLI::Success &e) {
    const int rc = app.exit(e);
    const bool written = std::cout.good() && std::fflush(stdout) == 0 && std::ferror(stdout) == 0;
    if (written || errno == EPIPE)
      return rc;
    fmt::print(stderr, "meetc: standard output cannot be written\n");
    return 2;
  } catch (const CLI::ParseError &e) {
    fmt::print(stderr, "meetc: {} (see meetc --help)\n", usage_error(app, e));
    return 2;
  }
  watch_limits(most);
  try {
    const int rc = generate_command->parsed()  ? generate(g)
                   : verify_command->parsed()  ? verify_scene(v)
                   : plan_command->parsed()    ? plan_scene(p)
                   : compare_command->parsed() ? compare_scenes(m)
                   : eval_command->parsed()    ? eval(ev)
                   : new_command->parsed()     ? new_project(first)
                   : targets_command->parsed() ? list_targets()
                                               : show(s);
    finish_output();
    return rc;
  } catch (const spec_error &e) {
    fmt::print(stderr, "{}", e.render());
  } catch (const std::bad_alloc &) {
    fmt::print(stderr, "error: out of memory\n");
  } catch (const std::exception &e) {
    fmt::print(stderr, "error: internal: {}\n", e.what());
  }
  return 2;
}
