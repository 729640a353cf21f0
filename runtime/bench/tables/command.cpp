#include "bench/tables/command.hpp"

#include "app/failure.hpp"
#include "app/option_values.hpp"
#include "bench/harness/option_values.hpp"
#include "bench/tables/cpu/command.hpp"
#include "bench/tables/gpu/command.hpp"
#include "bench/tables/gpu/growth_chart.hpp"
#include "bench/tables/paper/command.hpp"
#include "bench/tables/read_command.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <filesystem>
#include <memory>
#include <optional>
#include <string>

namespace meetc::bench {

namespace {

app::command add_paper(CLI::App &bench, const catalogue &all) {
  CLI::App &c = *bench.add_subcommand("paper", "The paper's tables and its figures 1 to 6 again");
  const auto q = std::make_shared<paper_request>();
  const auto threads = std::make_shared<std::optional<std::string>>();
  c.add_option("-o", q->folder, "Also write paper.md and figure_1.png to figure_6.png into this folder")
      ->type_name("DIR");
  c.add_option("--data", q->data,
               "A folder with bunny_1k.ply and armadillo_*.ply; without it built-in bodies of the same sizes serve")
      ->type_name("DIR");
  c.add_option("--device", q->device, "Fills the columns of the GPU; auto, the default: where there is one")
      ->type_name("auto|cpu|cuda");
  c.add_flag("--quick", q->quick, "The first rows only, in some seconds")->disable_flag_override();
  c.add_flag("--json", q->json, "Print one JSON object instead of the tables")->disable_flag_override();
  c.add_option("--threads", *threads,
               "Threads of the searches for pairs; 0, the default, is all cores; what is timed on the CPU "
               "runs on one")
      ->type_name("N");
  return {&c, [&all, q, threads] {
            if (*threads)
              q->threads = app::threads_named(**threads);
            return paper(all, *q);
          }};
}

app::command add_gpu(CLI::App &bench, const catalogue &all) {
  CLI::App &c = *bench.add_subcommand("gpu", "Kernels and queries on the CUDA device, beside the classic tests");
  const auto q = std::make_shared<gpu_request>();
  const auto draw = std::make_shared<std::optional<std::filesystem::path>>();
  CLI::Option *const folder =
      c.add_option("-o", q->folder, "Also write gpu.md and gpu.json into this folder")->type_name("DIR");
  c.add_option("--data", q->data,
               "A folder with bunny_69k.ply and armadillo_345k.ply (with --quick the 5k ones); without it built-in "
               "bodies of about the same sizes serve")
      ->type_name("DIR");
  c.add_option("--only", q->only,
               "Measure the scenes alone whose names hold this; growth, poses: one table; hard, choice, lbvh, first, "
               "memory, group: tables that are not measured otherwise; growth:TEXT and others: of one table the "
               "scenes whose names hold TEXT")
      ->type_name("TEXT");
  c.add_option("--draw", *draw,
               "Measure nothing: draw the growth in such a gpu.json as growth.png into the folder of -o")
      ->type_name("FILE")
      ->needs(folder);
  c.add_flag("--quick", q->quick, "Small sets, to see that it runs")->disable_flag_override();
  c.add_flag("--json", q->json, "Print one JSON object instead of the tables")->disable_flag_override();
  return {&c, [&all, q, draw] { return *draw ? draw_growth(**draw, *q->folder) : gpu(all, *q); }};
}

app::command add_cpu(CLI::App &bench, const app::kernel_library &kernels) {
  CLI::App &c = *bench.add_subcommand("cpu", "Kernels and queries on the CPU, beside other libraries");
  const auto q = std::make_shared<cpu_request>();
  const auto threads = std::make_shared<std::optional<std::string>>(),
             repetitions = std::make_shared<std::optional<std::string>>();
  c.add_option("-o", q->folder, "Also write cpu.md into this folder")->type_name("DIR");
  c.add_option(
       "--data", q->data,
       "A folder with bunny_69k.ply and armadillo_345k.ply (with --quick bunny_5k.ply and armadillo_5k.ply); without "
       "it built-in bodies of about the same sizes serve")
      ->type_name("DIR");
  c.add_option("--only", q->only,
               "Measure the families alone whose names hold this: precision, candidates, balls, families")
      ->type_name("TEXT");
  c.add_option("--instruction-set", q->instruction_set,
               "Measure one alone; auto, the default: each that runs here, and queries with the best")
      ->type_name("auto|baseline|avx2|avx512");
  c.add_option("--threads", *threads, "Threads of queries; 0 is all cores, 1 the default")->type_name("N");
  c.add_option("--repetitions", *repetitions,
               "How often the works of a table take turns, by default 21; fewer where they take long")
      ->type_name("N");
  c.add_flag("--quick", q->quick, "Small sets, to see that it runs")->disable_flag_override();
  c.add_flag("--json", q->json, "Print one JSON object instead of the tables")->disable_flag_override();
  return {&c, [kernels, q, threads, repetitions] {
            if (*threads)
              q->threads = app::threads_named(**threads);
            if (*repetitions)
              q->repetitions = repetitions_named(**repetitions);
            return cpu(kernels, *q);
          }};
}

app::command add_read(CLI::App &bench, const catalogue &all) {
  CLI::App &c = *bench.add_subcommand("read", "The readers, beside the least that a file takes");
  const auto q = std::make_shared<read_request>();
  const auto threads = std::make_shared<std::optional<std::string>>(),
             repetitions = std::make_shared<std::optional<std::string>>();
  c.add_option("--mesh", q->mesh, "Of this mesh; without it a built-in body serves")->type_name("FILE");
  c.add_option("--threads", *threads, "Threads of the readers; 0 is all cores, 2 the default")->type_name("N");
  c.add_option("--repetitions", *repetitions, "How often reader and least take turns, by default 21")->type_name("N");
  c.add_flag("--json", q->json, "Print one JSON object instead of the table")->disable_flag_override();
  return {&c, [&all, q, threads, repetitions] {
            if (*threads)
              q->threads = app::threads_named(**threads);
            if (*repetitions)
              q->repetitions = repetitions_named(**repetitions);
            return read_times(all, *q);
          }};
}

} // namespace

app::command add_bench(CLI::App &program, const catalogue &all, const app::kernel_library &kernels) {
  CLI::App &c = *program.add_subcommand(
      "bench", "Measure: the paper's tables and figures again, the CUDA device, the CPU, and the readers");
  c.require_subcommand(1);
  app::command out{&c, {}};
  out.parts.push_back(add_paper(c, all));
  out.parts.push_back(add_gpu(c, all));
  out.parts.push_back(add_cpu(c, kernels));
  out.parts.push_back(add_read(c, all));
  out.part_is_missing = "what to measure is needed";
  return out;
}

} // namespace meetc::bench
