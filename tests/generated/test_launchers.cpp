// The launchers are in many sources: each that the header declares is defined once, and the catalogue holds every kind and
// every predicate that the CPU's has. Nothing is compiled for a device here.
#include "tests/catch.hpp"

#include <cga/cga_runtime.hpp>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>
#include <string>
#include <vector>

namespace {

const std::filesystem::path folder = std::filesystem::path(MEETC_GENERATED) / "cga";

std::string text_of(const std::filesystem::path &path) {
  std::ifstream file(path, std::ios::binary);
  REQUIRE(file);
  return {std::istreambuf_iterator<char>(file), {}};
}

// The matches of the expression's first group in the text, in order of the alphabet, each as often as it is there.
std::vector<std::string> all_in(const std::string &text, const char *expression) {
  std::vector<std::string> out;
  const std::regex wanted(expression);
  for (std::sregex_iterator i(text.begin(), text.end(), wanted), end; i != end; ++i)
    out.push_back((*i)[1]);
  std::sort(out.begin(), out.end());
  return out;
}

std::vector<std::string> launchers_in(const std::string &header) {
  std::vector<std::string> out;
  const std::regex structs("struct (\\w+) \\{([^}]*)\\};");
  for (std::sregex_iterator i(header.begin(), header.end(), structs), end; i != end; ++i)
    for (const std::string &name : all_in((*i)[2], "static cudaError_t (\\w+)\\("))
      out.push_back((*i)[1].str() + "::" + name);
  std::sort(out.begin(), out.end());
  return out;
}

} // namespace

TEST_CASE("launchers: each is defined in one source, and the catalogue has every kind and predicate") {
  const std::string header = text_of(folder / "cga_cuda.hpp"), catalogue = text_of(folder / "cga_cuda.cu");
  std::string sources = catalogue;
  for (const auto &entry : std::filesystem::directory_iterator(folder / "src"))
    if (entry.path().extension() == ".cu")
      sources += text_of(entry.path());

  const std::vector<std::string> launchers = launchers_in(header);
  CHECK(launchers.size() > 30);
  CHECK(launchers == all_in(sources, "\ncudaError_t (\\w+::\\w+)\\("));

  std::vector<std::string> kinds, predicates;
  const meetc::catalogue &here = cga::catalogue();
  for (int i = 0; i < here.kind_count; ++i)
    kinds.push_back(here.kinds[i].name);
  for (int i = 0; i < here.predicate_count; ++i)
    predicates.push_back(here.predicates[i].name);
  std::sort(kinds.begin(), kinds.end());
  std::sort(predicates.begin(), predicates.end());
  CHECK(all_in(header, "set_launchers (\\w+)\\(\\);") == kinds);
  CHECK(all_in(sources, "\nmeetc::cuda::set_launchers (\\w+)\\(\\) \\{") == kinds);
  CHECK(all_in(catalogue, "kinds::(\\w+)\\(\\),") == kinds);
  CHECK(all_in(catalogue, "\n  \\{\\.name = \"(\\w+)\",\n   \\.kind_a") == predicates);
}

TEST_CASE("launchers: the engine of every pair has the kinds of the other catalogue, each in its place") {
  const auto in_order = [](const std::string &text, const char *expression) {
    std::vector<std::string> out;
    const std::regex wanted(expression);
    for (std::sregex_iterator i(text.begin(), text.end(), wanted), end; i != end; ++i)
      out.push_back((*i)[1]);
    return out;
  };
  const std::vector<std::string> kinds = in_order(text_of(folder / "cga_cuda.cu"), "kinds::(\\w+)\\(\\),");
  CHECK(kinds.size() == static_cast<std::size_t>(cga::catalogue().kind_count));
  CHECK(in_order(text_of(folder / "cga_every_pair.cu"), "\\{\\.name = \"(\\w+)\",\\s+\\.enclose") == kinds);
}
