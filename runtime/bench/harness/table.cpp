#include "meet/bench/harness/table.hpp"

#include "meet/app/text/words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace meetc::bench {

namespace {

std::vector<std::string> lines_of(const std::string &title) {
  std::vector<std::string> lines;
  for (std::size_t from = 0; from <= title.size();) {
    const std::size_t to = std::min(title.find('|', from), title.size());
    lines.push_back(title.substr(from, to - from));
    from = to + 1;
  }
  return lines;
}

// Counts code points, since names may have letters beyond ASCII.
std::size_t width(const std::string &text) {
  return static_cast<std::size_t>(std::count_if(text.begin(), text.end(), [](char c) { return (c & 0xc0) != 0x80; }));
}

std::string padded(const std::string &text, std::size_t to, bool left) {
  const std::string blanks(to - std::min(to, width(text)), ' ');
  return left ? text + blanks : blanks + text;
}

std::string without_end(std::string line) {
  line.erase(line.find_last_not_of(' ') + 1);
  return line + '\n';
}

} // namespace

cell of_count(std::uint64_t n) {
  return {app::grouped(n), n};
}

cell of_ratio(double x) {
  if (!std::isfinite(x))
    return {"-", nullptr};
  const double size = std::abs(x);
  return {size >= 1000  ? app::grouped(static_cast<std::uint64_t>(std::llround(size)))
          : size >= 100 ? fmt::format("{:.0f}", x)
          : size >= 10  ? fmt::format("{:.1f}", x)
          : size >= 0.1 ? fmt::format("{:.2f}", x)
                        : fmt::format("{:.2g}", x),
          app::with_digits(x, 6)};
}

cell of_milliseconds(double seconds) {
  return {fmt::format("{:.3g}", 1000 * seconds), app::with_digits(1000 * seconds, 6)};
}

cell of_nanoseconds(double seconds) {
  return {fmt::format("{:.3g}", 1e9 * seconds), app::with_digits(1e9 * seconds, 6)};
}

cell of_rate(double pairs_a_second) {
  return {fmt::format("{:.3g}", pairs_a_second / 1e12), app::with_digits(pairs_a_second / 1e12, 6)};
}

cell of_share(double x) {
  return {fmt::format("{:.1f} %", 100 * x), app::with_digits(x, 4)};
}

cell of_words(const std::string &words) {
  return {words, words};
}

cell missing(const std::string &why) {
  return {why, nullptr};
}

std::string as_text(const table &t) {
  std::vector<std::size_t> widths;
  std::size_t header = 0;
  for (std::size_t c = 0; c < t.columns.size(); ++c) {
    std::size_t w = 0;
    for (const std::string &line : lines_of(t.columns[c].title))
      w = std::max(w, width(line));
    for (const auto &row : t.rows)
      w = std::max(w, width(row[c].text));
    widths.push_back(w);
    header = std::max(header, lines_of(t.columns[c].title).size());
  }
  std::string out = t.title + "\n\n";
  for (std::size_t l = 0; l < header; ++l) {
    std::string line;
    for (std::size_t c = 0; c < t.columns.size(); ++c) {
      const std::vector<std::string> title = lines_of(t.columns[c].title);
      const std::size_t skip = header - title.size();
      line += std::string(c ? "  " : "") + padded(l < skip ? "" : title[l - skip], widths[c], c == 0);
    }
    out += without_end(line);
  }
  for (const auto &row : t.rows) {
    std::string line;
    for (std::size_t c = 0; c < row.size(); ++c)
      line += std::string(c ? "  " : "") + padded(row[c].text, widths[c], c == 0);
    out += without_end(line);
  }
  for (std::size_t i = 0; i < t.notes.size(); ++i)
    out += (i == 0 ? "\n" : "") + t.notes[i] + '\n';
  return out;
}

std::string as_markdown(const table &t) {
  std::string out = fmt::format("## {}\n\n|", t.title), rule = "|";
  for (std::size_t c = 0; c < t.columns.size(); ++c) {
    std::string title;
    for (const std::string &line : lines_of(t.columns[c].title))
      title += (title.empty() || line.empty() ? "" : " ") + line;
    out += fmt::format(" {} |", title);
    rule += c == 0 ? "---|" : "---:|";
  }
  out += "\n" + rule + "\n";
  for (const auto &row : t.rows) {
    out += "|";
    for (const cell &value : row)
      out += fmt::format(" {} |", value.text);
    out += "\n";
  }
  for (const std::string &note : t.notes)
    out += "\n" + note + "\n";
  return out;
}

app::json as_json(const table &t) {
  app::json rows = app::json::array();
  for (const auto &row : t.rows) {
    app::json values = app::json::object();
    for (std::size_t c = 0; c < row.size(); ++c)
      values[t.columns[c].key] = row[c].value;
    rows.push_back(std::move(values));
  }
  return {{"name", t.name}, {"rows", std::move(rows)}};
}

} // namespace meetc::bench
