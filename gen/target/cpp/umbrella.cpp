// Umbrella sources: a fixed number of numbered sources, each of which includes some of the predicates' own sources.
#include "gen/target/cpp/cpp.hpp"
#include "gen/target/cpp/names.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <map>

namespace meetc::target {
namespace {

// "cell/src/ball_ball.cu" is the source ".cu" of the kernel "ball_ball".
struct source {
  std::string kernel, suffix;
  std::size_t weight; // the length of all text emitted for the kernel, as an estimate of the time to compile it
};

std::vector<source> sources_in(const std::vector<file> &files, const std::string &space) {
  const std::string folder = space + "/src/", header = space + '/', detail = space + "/detail/";
  std::vector<source> out;
  for (const file &f : files)
    if (f.path.starts_with(folder)) {
      const std::size_t dot = f.path.rfind('.');
      out.push_back({f.path.substr(folder.size(), dot - folder.size()), f.path.substr(dot), f.text.size()});
    }
  for (source &s : out)
    for (const file &f : files)
      if (f.path == header + s.kernel + ".hpp" || f.path.starts_with(detail + s.kernel + '_'))
        s.weight += f.text.size();
  return out;
}

} // namespace

std::vector<file> umbrella_sources(const std::vector<file> &files, const lang::scene &s, int units) {
  const std::string space = identifier(s.space);
  std::vector<source> sources = sources_in(files, space);
  // Takes the longest first, and gives each to the unit with the least to compile so far.
  std::stable_sort(sources.begin(), sources.end(),
                   [](const source &x, const source &y) { return x.weight > y.weight; });
  std::vector<file> out;
  for (const char *suffix : {".cpp", ".cu"}) {
    if (suffix == std::string(".cu") &&
        std::none_of(sources.begin(), sources.end(), [](const source &x) { return x.suffix == ".cu"; }))
      continue;
    std::vector<std::vector<std::string>> kernels(static_cast<std::size_t>(units));
    std::vector<std::size_t> load(kernels.size(), 0);
    for (const source &x : sources)
      if (x.suffix == suffix) {
        const auto least = static_cast<std::size_t>(std::min_element(load.begin(), load.end()) - load.begin());
        load[least] += x.weight;
        kernels[least].push_back(x.kernel);
      }
    for (std::size_t i = 0; i < kernels.size(); ++i) {
      std::string text =
          banner(s, kernels[i].empty() ? "This unit has no sources." : "Sources that are compiled together.");
      for (const std::string &kernel : kernels[i])
        text += fmt::format("#include <{}/src/{}{}>\n", space, kernel, suffix);
      out.push_back({fmt::format("{}/units/unit_{}{}", space, i + 1, suffix), text});
    }
  }
  return out;
}

} // namespace meetc::target
