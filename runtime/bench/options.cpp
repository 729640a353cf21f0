#include "bench/options.hpp"

#include "app/option_values.hpp"

#include <CLI/CLI.hpp>

namespace meetc::app {

namespace {

void add_paper(CLI::App &bench, bench_arguments &to) {
  CLI::App &c = *bench.add_subcommand("paper", "The paper's tables and its figures 1 to 6 again");
  to.paper_command = &c;
  c.add_option("-o", to.paper.folder, "Also write paper.md and figure_1.png to figure_6.png into this folder")
      ->type_name("DIR");
  c.add_option("--data", to.paper.data,
               "A folder with bunny_1k.ply and armadillo_*.ply; without it built-in bodies of the same sizes serve")
      ->type_name("DIR");
  c.add_option("--device", to.paper.device, "Fills the columns of the GPU; auto, the default: where there is one")
      ->type_name("auto|cpu|cuda");
  c.add_flag("--quick", to.paper.quick, "The first rows only, in some seconds")->disable_flag_override();
  c.add_flag("--json", to.paper.json, "Print one JSON object instead of the tables")->disable_flag_override();
  c.add_option("--threads", to.threads,
               "Threads of the searches for pairs; 0, the default, is all cores; what is timed on the CPU "
               "runs on one")
      ->type_name("N");
}

void add_gpu(CLI::App &bench, bench_arguments &to) {
  CLI::App &c = *bench.add_subcommand("gpu", "Kernels and queries on the CUDA device, beside the classic tests");
  to.gpu_command = &c;
  c.add_option("-o", to.gpu.folder, "Also write gpu.md into this folder")->type_name("DIR");
  c.add_option("--data", to.gpu.data,
               "A folder with bunny_69k.ply and armadillo_345k.ply (with --quick the 5k ones); without it built-in "
               "bodies of about the same sizes serve")
      ->type_name("DIR");
  c.add_option("--only", to.gpu.only, "Measure the scenes alone whose names hold this")->type_name("TEXT");
  c.add_flag("--quick", to.gpu.quick, "Small sets, to see that it runs")->disable_flag_override();
  c.add_flag("--json", to.gpu.json, "Print one JSON object instead of the tables")->disable_flag_override();
}

} // namespace

void add_bench(CLI::App &app, bench_arguments &to) {
  to.command = app.add_subcommand("bench", "Measure: the paper's tables and figures again, and the CUDA device");
  to.command->require_subcommand(1);
  add_paper(*to.command, to);
  add_gpu(*to.command, to);
}

std::string bench(const catalogue &all, bench_arguments &args) {
  if (args.gpu_command->parsed())
    return gpu(all, args.gpu);
  if (args.threads)
    args.paper.threads = threads_named(*args.threads);
  return paper(all, args.paper);
}

} // namespace meetc::app
