// bench/harness/plot.hpp: pictures that gnuplot draws: a script of the folder plots, and the values that it reads.
//
// The scripts are part of the program. A script says at its top which variables, lists and data it reads; these are written
// before it, and so are the colours of all: paper, ink, line and thin_line. The same values always give the
// same script, and the same script the same file.
#ifndef MEETC_BENCH_HARNESS_PLOT_HPP
#define MEETC_BENCH_HARNESS_PLOT_HPP

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace meetc::bench {

// Throws app::failure, which says what is missing, where gnuplot cannot be run.
void need_gnuplot();

class plot {
public:
  explicit plot(std::string_view script); // plots/SCRIPT.gp
  plot &set(std::string_view variable, double value);
  plot &set(std::string_view variable, std::string_view text);
  plot &list(std::string_view variable, const std::vector<std::string> &texts);
  // Lines of numbers; sections, which a script takes by their index, are parted by two empty lines.
  plot &data(std::string_view block, const std::vector<std::string> &sections);

  const std::string &values() const { return values_; }
  // Throws app::failure where gnuplot is missing or fails. The user's own settings of gnuplot are not read.
  void draw(const std::filesystem::path &to) const;

private:
  std::string values_;
  std::string_view script_;
};

} // namespace meetc::bench

#endif
