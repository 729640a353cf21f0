#include "meet/bench/harness/options.hpp"

#include "meet/app/input/failure.hpp"
#include "meet/app/input/option_values.hpp"
#include "meet/io/text/number.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <cstdint>

namespace meetc::bench {

namespace {

int repetitions_named(const std::string &text) {
  constexpr int most = 1000;
  std::int64_t n = 0;
  if (!io::parse_integer(text, n) || n < 1 || n > most)
    throw app::failure(fmt::format("--repetitions: {} is not a number from 1 to {}", io::quote(text), most));
  return static_cast<int>(n);
}

} // namespace

void request::read_numbers() {
  if (threads_given)
    threads = app::threads_named(*threads_given);
  if (repetitions_given)
    repetitions = repetitions_named(*repetitions_given);
}

CLI::Option *add_folder(CLI::App &to, request &q, const std::string &help) {
  return to.add_option("-o", q.folder, help)->type_name("DIR");
}
CLI::Option *add_data(CLI::App &to, request &q, const std::string &help) {
  return to.add_option("--data", q.data, help)->type_name("DIR");
}
CLI::Option *add_only(CLI::App &to, request &q, const std::string &help) {
  return to.add_option("--only", q.only, help)->type_name("TEXT");
}
CLI::Option *add_device(CLI::App &to, request &q, const std::string &help) {
  return to.add_option("--device", q.device, help)->type_name("auto|cpu|cuda");
}
CLI::Option *add_instruction_set(CLI::App &to, request &q, const std::string &help) {
  return to.add_option("--instruction-set", q.instruction_set, help)->type_name("auto|baseline|avx2|avx512");
}
CLI::Option *add_threads(CLI::App &to, request &q, const std::string &help) {
  return to.add_option("--threads", q.threads_given, help)->type_name("N");
}
CLI::Option *add_repetitions(CLI::App &to, request &q, const std::string &help) {
  return to.add_option("--repetitions", q.repetitions_given, help)->type_name("N");
}
CLI::Option *add_quick(CLI::App &to, request &q, const std::string &help) {
  return to.add_flag("--quick", q.quick, help)->disable_flag_override();
}
CLI::Option *add_json(CLI::App &to, request &q, const std::string &what) {
  return to.add_flag("--json", q.json, fmt::format("Print one JSON object instead of the {}", what))
      ->disable_flag_override();
}

std::string in_words(const std::string &command, const request &q, const std::string &more) {
  return fmt::format("{}{}{}{}{} -o DIR", command, q.quick ? " --quick" : "", q.data ? " --data FOLDER" : "",
                     q.only ? " --only TEXT" : "", more);
}

} // namespace meetc::bench
