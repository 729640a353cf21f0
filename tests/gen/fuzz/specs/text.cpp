#include "tests/gen/fuzz/specs/text.hpp"

#include "gen/lang/spec.hpp"
#include "gen/target/target.hpp"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fmt/format.h>

namespace meetc::fuzz {
namespace {

// splitmix64: the same numbers everywhere.
class source {
public:
  source(std::uint64_t seed, std::uint64_t index) : state_(seed * 0x9e3779b97f4a7c15U ^ index * 0xd1342543de82ef95U) {}
  std::uint64_t next() {
    std::uint64_t z = state_ += 0x9e3779b97f4a7c15U;
    z = (z ^ (z >> 30U)) * 0xbf58476d1ce4e5b9U;
    z = (z ^ (z >> 27U)) * 0x94d049bb133111ebU;
    return z ^ (z >> 31U);
  }
  std::size_t below(std::size_t n) { return n == 0 ? 0 : static_cast<std::size_t>(next() % n); }
  template <class T> const T &of(const std::vector<T> &all) { return all[below(all.size())]; }

private:
  std::uint64_t state_;
};

std::string repeat(const std::string &text, std::size_t times) {
  std::string out;
  for (std::size_t i = 0; i < times; ++i)
    out += text;
  return out;
}

const std::vector<std::string> &words() {
  static const std::vector<std::string> all{
      "+",       "-",        "*",          "/",        "^",         "|",          "&",         "~",        "(",
      ")",       "[",        "]",          ",",        ".",         ":",          "=",         "==",       "<=",
      ">",       "!=",       "'",          "'''",      "\"",        "#",          "\n",        "0",        "1",
      "2",       "1/3",      "0.5",        "-1",       "4096",      "e1",         "e12",       "e0",       "I",
      "n",       "nb",       "grade",      "sign",     "zero",      "rev",        "dual",      "undual",   "rc",
      "lc",      "dot",      "commutator", "sandwich", "reflect",   "project",    "inverse",   "rnorm2",   "scalar",
      "conj",    "involute", "all",        "any",      "each",      "in",         "if",        "then",     "else",
      "and",     "or",       "not",        "exp",      "log",       "sqrt",       "pose",      "gives",    "norm",
      "real",    "store",    "blade",      "grades",   "where",     "hull",       "pad",       "position", "relations",
      "samples", "nearly",   "within",     "is",       "of",        "from",       "parts",     "let",      "reject",
      "hit",     "mode",     "orders",     "contacts", "vectors",   "squares",    "metric",    "null",     "import",
      "extends", "spec",     "algebra",    "kinds",    "functions", "predicates", "constants", "scene",    "kernels",
      "zero",    "rungs",    "backends",   "box",      "tolerance", "true",       "false",     "[[",       "]]",
      "{",       "}",        "meet",       "norm2"};
  return all;
}

const std::vector<std::string> &values() {
  static const std::vector<std::string> all{"''",
                                            "'1'",
                                            "0",
                                            "-1",
                                            "1e400",
                                            "nan",
                                            "inf",
                                            "true",
                                            "[]",
                                            "{}",
                                            "['']",
                                            "[[]]",
                                            "[0]",
                                            "[1, 1]",
                                            "['e1']",
                                            "'[e1]'",
                                            "'e1 ^ e2'",
                                            "18446744073709551616",
                                            "9223372036854775807",
                                            "'1/0'",
                                            "'99999999999999999999'",
                                            "'e1*e1*e1'",
                                            "1979-05-27",
                                            "'x: real'",
                                            "['x: real']",
                                            "\"e1\"",
                                            "'''\ne1'''"};
  return all;
}

// The parts of a text that are words or single signs, as [begin, end).
std::vector<std::pair<std::size_t, std::size_t>> tokens_of(const std::string &text) {
  std::vector<std::pair<std::size_t, std::size_t>> out;
  const auto part = [](char c) { return std::isalnum(static_cast<unsigned char>(c)) || c == '_'; };
  for (std::size_t i = 0; i < text.size();) {
    std::size_t end = i + 1;
    if (part(text[i]))
      while (end < text.size() && part(text[end]))
        ++end;
    if (!std::isspace(static_cast<unsigned char>(text[i])))
      out.emplace_back(i, end);
    i = end;
  }
  return out;
}

void change_bytes(std::string &text, source &r) {
  const std::size_t at = r.below(text.size());
  switch (r.below(3)) {
  case 0:
    text[at] = static_cast<char>(r.below(256));
    break;
  case 1:
    text.insert(at, 1, static_cast<char>(r.below(256)));
    break;
  default:
    text.erase(at, 1 + r.below(8));
  }
}

void change_tokens(std::string &text, source &r) {
  const auto all = tokens_of(text);
  if (all.empty())
    return;
  const auto [begin, end] = r.of(all);
  const auto [other, other_end] = r.of(all);
  const std::string word = text.substr(begin, end - begin), another = text.substr(other, other_end - other);
  switch (r.below(8)) {
  case 0:
    text.replace(begin, end - begin, r.of(words()));
    break;
  case 1: // by another one of its sort, which is most often read
  case 5:
  case 6:
  case 7:
    if (std::isalpha(static_cast<unsigned char>(word[0])) == std::isalpha(static_cast<unsigned char>(another[0])))
      text.replace(begin, end - begin, another);
    break;
  case 2:
    text.erase(begin, end - begin);
    break;
  case 3:
    text.insert(begin, r.of(words()) + ' ');
    break;
  default: { // around it: depth, and length
    const std::size_t times = std::size_t{1} << r.below(18);
    static const std::vector<std::pair<const char *, const char *>> pairs{
        {"(", ")"}, {"[", "]"}, {"-", ""}, {"~", ""}, {"", "*e1"}, {"", "+1"}, {"rev(", ")"}, {"", "[1]"}, {"9", ""}};
    const auto &[left, right] = r.of(pairs);
    text.replace(begin, end - begin, repeat(left, times) + word + repeat(right, times));
  }
  }
}

std::vector<std::string> lines_of(const std::string &text) {
  std::vector<std::string> out(1);
  for (const char c : text) {
    out.back() += c;
    if (c == '\n')
      out.emplace_back();
  }
  return out;
}

void change_lines(std::string &text, source &r) {
  std::vector<std::string> lines = lines_of(text);
  const std::size_t a = r.below(lines.size()), b = r.below(lines.size());
  switch (r.below(3)) {
  case 0:
    lines[a].clear();
    break;
  case 1:
    lines.insert(lines.begin() + static_cast<std::ptrdiff_t>(b), lines[a]);
    break;
  default:
    std::swap(lines[a], lines[b]);
  }
  text.clear();
  for (const std::string &l : lines)
    text += l;
}

void change_value(std::string &text, source &r) {
  std::vector<std::string> lines = lines_of(text);
  std::string &line = lines[r.below(lines.size())];
  if (const auto equals = line.find('='); equals != std::string::npos)
    line = line.substr(0, equals) + "= " + r.of(values()) + '\n';
  text.clear();
  for (const std::string &l : lines)
    text += l;
}

void mutate(std::string &text, source &r) {
  if (text.empty())
    return;
  switch (r.below(8)) {
  case 0:
    return change_bytes(text, r);
  case 1:
    return change_lines(text, r);
  case 2:
    return change_value(text, r);
  default:
    return change_tokens(text, r);
  }
}

} // namespace

std::vector<spec_seed> read_spec_seeds(const std::string &algebra_spec) {
  std::vector<spec_seed> out;
  // One scene for each algebra, with what it imports where the algebra is written elsewhere.
  for (const char *name :
       {"planar", "nulls", "flat", "planes", "motions2", "turns", "spacetime", "oriented", "screws", "spheres"}) {
    const std::string path = fmt::format("{}/scenes/{}.toml", algebra_spec, name);
    const lang::scene s = lang::load_scene(path, target::backends(), {});
    spec_seed seed{s.files.at(1)->text, {}};
    const std::string folder = std::filesystem::absolute(algebra_spec).generic_string() + '/';
    for (const char *imported : {"'primitives/", "'predicates/", "'cga3"})
      for (std::size_t at = 0; (at = seed.algebra.find(imported, at)) != std::string::npos; at += folder.size() + 1)
        seed.algebra.insert(at + 1, folder);
    for (const lang::kernel_request &k : s.kernels)
      seed.kernels.push_back(lang::print(*k.what));
    out.push_back(std::move(seed));
  }
  return out;
}

drawn_spec draw_spec(const std::vector<spec_seed> &seeds, std::uint64_t seed, std::uint64_t index) {
  source r(seed, index);
  const spec_seed &from = r.of(seeds);
  std::string kernels;
  for (std::size_t n = 1 + r.below(3); n-- > 0;)
    kernels += (kernels.empty() ? "'" : ", '") + r.of(from.kernels) + '\'';
  static const std::vector<std::string> ends{"",
                                             "rungs = ['fp32']\n",
                                             "rungs = ['exact']\n",
                                             "box = 1\n",
                                             "backends = ['cpp', 'c', 'cuda']\n",
                                             "box = 1\ntolerance = 1e-5\n"};
  drawn_spec out{from.algebra,
                 fmt::format("[scene]\nalgebra = 'a.toml'\nnamespace = 'x'\nkernels = [{}]\n{}", kernels, r.of(ends))};
  for (std::size_t n = r.below(2) == 0 ? 1 : 1 + r.below(4); n-- > 0;) // a single mutant gets furthest
    mutate(r.below(5) == 0 ? out.scene : out.algebra, r);
  return out;
}

} // namespace meetc::fuzz
