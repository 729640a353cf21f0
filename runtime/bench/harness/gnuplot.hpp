// bench/harness/gnuplot.hpp: runs the program gnuplot, which draws charts.
#ifndef MEETC_BENCH_HARNESS_GNUPLOT_HPP
#define MEETC_BENCH_HARNESS_GNUPLOT_HPP

#include <filesystem>
#include <string>

namespace meetc::bench {

// Throws app::failure, which says what is missing, where gnuplot cannot be run.
void need_gnuplot();

// A text as a string of a script: in single quotes, with those inside doubled, and on one line.
std::string gnuplot_string(const std::string &text);

// Runs a script whose terminal writes to standard output, and makes that output the file. The user's own settings of
// gnuplot are not read, so the same script always gives the same file. Throws app::failure where it fails.
void run_gnuplot(const std::string &script, const std::filesystem::path &to);

} // namespace meetc::bench

#endif
