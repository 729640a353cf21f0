// bench/harness/options.hpp: a user's request to a benchmark, and the options that state it.
#ifndef MEETC_BENCH_HARNESS_OPTIONS_HPP
#define MEETC_BENCH_HARNESS_OPTIONS_HPP

#include <filesystem>
#include <optional>
#include <string>

namespace CLI {
class App;
class Option;
} // namespace CLI

namespace meetc::bench {

// Each benchmark has some of them.
struct request {
  std::optional<std::filesystem::path> a, b;   // the user's own sets: both or none
  std::optional<std::filesystem::path> folder; // pages and pictures are written there
  std::optional<std::filesystem::path> data;   // has meshes; without it procedural bodies are used
  std::optional<std::filesystem::path> drawn;  // results to be drawn again
  std::optional<std::string> only;             // part of the names of what is measured
  std::string device = "auto", instruction_set = "auto";
  int threads = 1, repetitions = 21;
  bool json = false, quick = false;
  std::optional<std::string> threads_given = {}, repetitions_given = {}; // as they were written

  // Throws app::failure where --threads or --repetitions, from 1 to 1000, is no such number.
  void read_numbers();
};

// Each adds one option with its help. The request must outlive the parser.
CLI::Option *add_folder(CLI::App &to, request &q, const std::string &help);
CLI::Option *add_data(CLI::App &to, request &q, const std::string &help);
CLI::Option *add_only(CLI::App &to, request &q, const std::string &help);
CLI::Option *add_device(CLI::App &to, request &q, const std::string &help);
CLI::Option *add_instruction_set(CLI::App &to, request &q, const std::string &help);
CLI::Option *add_threads(CLI::App &to, request &q, const std::string &help);
CLI::Option *add_repetitions(CLI::App &to, request &q, const std::string &help);
CLI::Option *add_quick(CLI::App &to, request &q, const std::string &help);
CLI::Option *add_json(CLI::App &to, request &q, const std::string &what = "tables"); // printed in their place

// "meet bench cpu --quick --data FOLDER --only TEXT -o DIR", where these were asked for; `more` stands before -o.
std::string in_words(const std::string &command, const request &q, const std::string &more = "");

} // namespace meetc::bench

#endif
