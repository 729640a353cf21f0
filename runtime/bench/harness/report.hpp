// bench/harness/report.hpp: the results of a benchmark as text, as a page of Markdown, as JSON, and as files in a folder.
#ifndef MEETC_BENCH_HARNESS_REPORT_HPP
#define MEETC_BENCH_HARNESS_REPORT_HPP

#include "meet/app/output/output_files.hpp"
#include "meet/bench/harness/table.hpp"

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace meetc::bench {

// A file beside the page. A picture with a caption is shown on the page.
struct output_file {
  std::string name;
  std::function<void(const std::filesystem::path &to)> write;
  std::string caption = {};
};

struct report {
  std::string title, command;     // "Measured on a CPU", "meet bench cpu --quick -o DIR"
  std::vector<std::string> about; // paragraphs before the tables
  app::json facts;                // fields of the JSON object beside "tables"
  std::vector<table> tables;
  std::vector<output_file> files;
};

std::string as_text(const report &r);
std::string as_markdown(const report &r);
std::string as_json(const report &r); // one object and a newline

// The page and the other files of a report in a folder; without a folder nothing is written.
class report_folder {
public:
  // Checks that all can be written, before the work. `names`: the page, then the other files. Throws app::failure, also
  // where gnuplot is missing and one of them is a picture. No input may be one of them.
  report_folder(std::optional<std::filesystem::path> folder, const std::vector<std::string> &names,
                std::vector<std::filesystem::path> inputs = {});
  // Writes all of them or none. Returns the text for standard output: the report's, and what was written.
  std::string write(const report &r, bool json);

private:
  std::optional<std::filesystem::path> folder_;
  std::string page_;
  app::output_files outputs_;
};

} // namespace meetc::bench

#endif
