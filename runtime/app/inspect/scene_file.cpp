#include "meet/app/inspect/scene_file.hpp"

#include <fmt/format.h>

#include <string_view>
#include <system_error>

namespace meetc::app {

namespace fs = std::filesystem;

namespace {

// A TOML string, in its literal form where possible.
std::string toml_string(std::string_view text) {
  if (text.find('\'') == std::string_view::npos)
    return fmt::format("'{}'", text);
  std::string out = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\')
      out += '\\';
    out += c;
  }
  return out + '"';
}

bool is_letter(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}

// Keywords of C++ are left to the generator, which renames them.
std::string space_named(const std::string &stem) {
  std::string out;
  for (const char c : stem)
    if (is_letter(c) || (c >= '0' && c <= '9'))
      out += c;
    else if (!out.empty() && out.back() != '_')
      out += '_';
  if (out.empty() || !is_letter(out.front()))
    out = "scene_" + out;
  while (out.back() == '_')
    out.pop_back();
  return out == "meetc" ? "meetc_scene" : out; // the namespace of the kernel headers
}

} // namespace

std::string scene_text(const fs::path &at, const fs::path &algebra, const std::vector<std::string> &predicates,
                       double box, double tolerance, const std::string &comment) {
  std::error_code code;
  const fs::path folder = fs::weakly_canonical(fs::absolute(at).parent_path(), code);
  const fs::path real = fs::weakly_canonical(fs::absolute(algebra), code);
  const fs::path relative = real.lexically_relative(folder);
  std::string kernels;
  for (const std::string &p : predicates)
    kernels += fmt::format("{}'{}'", kernels.empty() ? "" : ", ", p);
  return fmt::format(
      "# {}\n\n[scene]\nalgebra   = {}\nnamespace = '{}'\n{}backends  = ['cpp', 'cuda']\n{}kernels   = [{}]\n", comment,
      toml_string((relative.empty() ? real : relative).generic_string()), space_named(at.stem().string()),
      tolerance > 0 ? fmt::format("tolerance = {}\n", tolerance) : "rungs     = ['certified']\n",
      box > 0 ? fmt::format("box       = {}\n", box) : "", kernels);
}

} // namespace meetc::app
