#include "meet/bench/tables/command/command.hpp"

#include "meet/app/input/failure.hpp"
#include "meet/app/input/option_values.hpp"
#include "meet/bench/tables/gpu/growth_chart.hpp"
#include "meet/bench/tables/tables.hpp"

#include <CLI/CLI.hpp>

#include <memory>
#include <utility>

namespace meetc::bench {

namespace {

// A command that runs `work` with what the options asked for.
template <class Work> app::command command_of(CLI::App &c, std::shared_ptr<request> q, Work work) {
  return {&c, [q = std::move(q), work] {
            q->read_numbers();
            return work(*q);
          }};
}

app::command add_paper(CLI::App &bench, const catalogue &all) {
  CLI::App &c = *bench.add_subcommand("paper", "The paper's tables and its figures 1 to 6 again");
  const auto q = std::make_shared<request>();
  q->threads = 0;
  add_folder(c, *q, "Also write paper.md and figure_1.png to figure_6.png into this folder");
  add_data(c, *q, "A folder with bunny_1k.ply and armadillo_*.ply; without it built-in bodies of the same sizes serve");
  add_device(c, *q, "Fills the columns of the GPU; auto, the default: where there is one");
  add_quick(c, *q, "The first rows only, in some seconds");
  add_json(c, *q);
  add_threads(c, *q,
              "Threads of the searches for pairs; 0, the default, is all cores; what is timed on the CPU "
              "runs on one");
  return command_of(c, q, [&all](const request &asked) { return paper(all, asked); });
}

app::command add_gpu(CLI::App &bench, const catalogue &all) {
  CLI::App &c = *bench.add_subcommand("gpu", "Kernels and queries on the CUDA device, beside the classic tests");
  const auto q = std::make_shared<request>();
  CLI::Option *const folder = add_folder(c, *q, "Also write gpu.md and gpu.json into this folder");
  add_data(c, *q,
           "A folder with bunny_69k.ply and armadillo_345k.ply (with --quick the 5k ones); without it built-in "
           "bodies of about the same sizes serve");
  add_only(c, *q,
           "Measure the scenes alone whose names hold this; growth, poses: one table; hard, lbvh, first, memory, "
           "group: tables that are not measured otherwise; growth:TEXT and others: of one table the "
           "scenes whose names hold TEXT");
  c.add_option("--draw", q->drawn,
               "Measure nothing: draw the growth in such a gpu.json as growth.png into the folder of -o")
      ->type_name("FILE")
      ->needs(folder);
  add_quick(c, *q, "Small sets, to see that it runs");
  add_json(c, *q);
  return command_of(c, q, [&all](const request &asked) {
    return asked.drawn ? draw_growth(*asked.drawn, *asked.folder) : gpu(all, asked);
  });
}

app::command add_cpu(CLI::App &bench, const app::kernel_library &kernels) {
  CLI::App &c = *bench.add_subcommand("cpu", "Kernels and queries on the CPU, beside other libraries");
  const auto q = std::make_shared<request>();
  add_folder(c, *q, "Also write cpu.md into this folder");
  add_data(
      c, *q,
      "A folder with bunny_69k.ply and armadillo_345k.ply (with --quick bunny_5k.ply and armadillo_5k.ply); without "
      "it built-in bodies of about the same sizes serve");
  add_only(c, *q,
           "Measure the families alone whose names hold this: precision, candidates, balls, bodies, refit, cancel, "
           "families");
  add_instruction_set(c, *q, "Measure one alone; auto, the default: each that runs here, and queries with the best");
  add_threads(c, *q, "Threads of queries; 0 is all cores, 1 the default");
  add_repetitions(c, *q, "How often the works of a table take turns, by default 21; fewer where they take long");
  add_quick(c, *q, "Small sets, to see that it runs");
  add_json(c, *q);
  return command_of(c, q, [kernels](const request &asked) { return cpu(kernels, asked); });
}

app::command add_read(CLI::App &bench, const catalogue &all) {
  CLI::App &c = *bench.add_subcommand("read", "The readers, beside the least that a file takes");
  const auto q = std::make_shared<request>();
  q->threads = 2;
  c.add_option("--mesh", q->a, "The mesh; without it a built-in body serves")->type_name("FILE");
  add_threads(c, *q, "Threads of the readers; 0 is all cores, 2 the default");
  add_repetitions(c, *q, "How often reader and least take turns, by default 21");
  add_json(c, *q, "table");
  return command_of(c, q, [&all](const request &asked) { return read(all, asked); });
}

app::command add_formulas(CLI::App &bench, const app::kernel_library &kernels) {
  CLI::App &c = *bench.add_subcommand("formulas", "Formulas on sets, beside the least that moving their numbers takes");
  const auto q = std::make_shared<request>();
  q->threads = 2;
  add_instruction_set(c, *q, "Measure this one; auto, the default: the best that runs here");
  add_threads(c, *q, "Threads; 0 is all cores, 2 the default");
  add_repetitions(c, *q, "How often the works take turns, by default 21");
  add_quick(c, *q, "Few values, to see that it runs");
  add_json(c, *q, "table");
  return command_of(c, q, [kernels](const request &asked) { return formulas(kernels, asked); });
}

} // namespace

app::command add_bench(CLI::App &program, const catalogue &all, const app::kernel_library &kernels) {
  CLI::App &c = *program.add_subcommand(
      "bench", "Measure: the paper's tables and figures again, the CUDA device, the CPU, the readers, and formulas");
  c.require_subcommand(1);
  app::command out{&c, {}};
  out.parts.push_back(add_paper(c, all));
  out.parts.push_back(add_gpu(c, all));
  out.parts.push_back(add_cpu(c, kernels));
  out.parts.push_back(add_read(c, all));
  out.parts.push_back(add_formulas(c, kernels));
  out.part_is_missing = "what to measure is needed";
  return out;
}

app::command add_trade(CLI::App &program, const app::kernel_library &kernels) {
  CLI::App &c =
      *program.add_subcommand("trade", "Measure what each precision costs, how often it is wrong, and how far");
  const auto q = std::make_shared<request>();
  c.add_option("a", q->a, app::files_help)->type_name("A");
  c.add_option("b", q->b, "The same. The pairs and the query of the two files are measured beside the built-in ones")
      ->type_name("B");
  add_folder(c, *q, "Also write trade.md, trade.csv, trade.png and a map for each predicate into this folder");
  add_instruction_set(c, *q, "Measure this one; auto, the default: the best that runs here");
  add_device(c, *q, "Also measure there; auto, the default: if there is one that this build can use");
  add_threads(c, *q, "Threads of whole queries; 0 is all cores, 1 the default");
  add_repetitions(c, *q, "How often the rungs take turns, by default 21; fewer where they take long");
  add_quick(c, *q, "Few pairs, to see that it runs");
  add_json(c, *q);
  return command_of(c, q, [kernels](const request &asked) {
    if (asked.a.has_value() != asked.b.has_value())
      throw app::failure("trade: a second set is needed beside the first");
    return trade(kernels, asked);
  });
}

} // namespace meetc::bench
