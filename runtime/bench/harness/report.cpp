#include "meet/bench/harness/report.hpp"

#include "meet/app/input/failure.hpp"
#include "meet/bench/harness/plot.hpp"
#include "meet/io/files/atomic_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace meetc::bench {

namespace fs = std::filesystem;

std::string as_text(const report &r) {
  std::string out;
  for (const std::string &paragraph : r.about)
    out += paragraph + '\n';
  for (const table &t : r.tables)
    out += (out.empty() ? "" : "\n") + as_text(t);
  return out;
}

std::string as_markdown(const report &r) {
  std::string out = fmt::format("# {}\n\nWritten by `{}`.\n", r.title, r.command);
  for (const std::string &paragraph : r.about)
    out += '\n' + paragraph + '\n';
  for (const table &t : r.tables)
    out += '\n' + as_markdown(t);
  std::string figures;
  for (const output_file &f : r.files)
    if (!f.caption.empty())
      figures += fmt::format("\n![{0}]({1})\n\n{0}\n", f.caption, f.name);
  return figures.empty() ? out : out + "\n## Figures\n" + figures;
}

std::string as_json(const report &r) {
  app::json out = r.facts, tables = app::json::array();
  for (const table &t : r.tables)
    tables.push_back(as_json(t));
  out["tables"] = std::move(tables);
  return app::in_one_line(out) + '\n';
}

report_folder::report_folder(std::optional<fs::path> folder, const std::vector<std::string> &names,
                             std::vector<fs::path> inputs)
    : folder_(std::move(folder)), page_(names.front()), outputs_(std::move(inputs)) {
  if (!folder_)
    return;
  if (folder_->empty())
    throw app::failure("-o: the folder's name is empty");
  for (const std::string &name : names)
    outputs_.expect(*folder_ / name, true);
  if (std::any_of(names.begin(), names.end(), [](const std::string &name) { return name.ends_with(".png"); }))
    need_gnuplot();
}

std::string report_folder::write(const report &r, bool json) {
  std::string text = json ? as_json(r) : as_text(r), written;
  if (!folder_)
    return text;
  outputs_.make_folder(*folder_);
  const auto write = [&](const std::string &name, const app::output_files::writer &by) {
    outputs_.write(*folder_ / name, by);
    written += fmt::format("wrote {}\n", (*folder_ / name).string());
  };
  write(page_, [&r](const fs::path &to) { io::write_file(to, as_markdown(r)); });
  for (const output_file &f : r.files)
    write(f.name, f.write);
  outputs_.commit();
  return json ? text : text + '\n' + written;
}

} // namespace meetc::bench
