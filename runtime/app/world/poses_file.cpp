#include "meet/app/world/poses_file.hpp"

#include "meet/app/input/failure.hpp"
#include "meet/app/text/nearest.hpp"
#include "meet/app/world/body_pose.hpp"
#include "meet/app/world/npy_file.hpp"
#include "meet/io/files/file_bytes.hpp"
#include "meet/io/text/number.hpp"
#include "meet/io/text/text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <set>

namespace meetc::app {

namespace {

constexpr std::string_view by_matrix = "frame,body,m00,m01,m02,m03,m10,m11,m12,m13,m20,m21,m22,m23",
                           by_quaternion = "frame,body,x,y,z,qw,qx,qy,qz";

std::vector<std::string> fields_of(std::string_view line) {
  std::vector<std::string> out;
  for (std::size_t at = 0; at <= line.size();) {
    const std::size_t comma = std::min(line.find(',', at), line.size());
    out.emplace_back(io::trim(line.substr(at, comma - at)));
    at = comma + 1;
  }
  return out;
}

// The next line that says something.
bool next(io::line_reader &lines, std::string_view &line) {
  while (lines.next(line))
    if (!io::trim(line).empty() && io::trim(line).front() != '#')
      return true;
  return false;
}

std::vector<frame> frames_of(const npy_array &array, const std::string &file, const std::vector<std::string> &names) {
  const std::vector<std::uint64_t> &shape = array.shape();
  const std::size_t lead = shape.size() == 4 ? 1 : 0;
  if (shape.size() != lead + 3 || shape[lead] != names.size() || shape[lead + 1] != 4 || shape[lead + 2] != 4)
    throw io::error(fmt::format("{0}: its shape is {1}; for {2} bodies it is (frames, {2}, 4, 4) or ({2}, 4, 4)", file,
                                in_words(shape), names.size()));
  if (array.size() == 0)
    throw io::error(fmt::format("{}: it has no frame", file));
  std::vector<frame> out;
  std::uint64_t place = 0;
  for (std::uint64_t f = 0; f < (lead == 1 ? shape[0] : 1); ++f) {
    out.push_back({lead == 1 ? fmt::format("{}", f) : "", {}});
    for (std::uint32_t body = 0; body < names.size(); ++body) {
      double numbers[16];
      for (double &x : numbers)
        x = array[place++];
      const std::string where =
          fmt::format("{}: {}body {}", file, lead == 1 ? fmt::format("frame {}, ", f) : "", names[body]);
      out.back().moved.emplace_back(body, pose_of(numbers, where));
    }
  }
  return out;
}

} // namespace

std::vector<frame> read_poses(const std::filesystem::path &path, const std::vector<std::string> &names) {
  const io::file_bytes bytes = io::load_file(path);
  if (npy_array::is_one(bytes.text()))
    return frames_of(npy_array(bytes.text(), bytes.name), bytes.name, names);
  io::line_reader lines(bytes.text(), bytes.name);
  std::string_view line;
  if (!next(lines, line))
    throw io::error(fmt::format("{}: no line; the first one is {} or {}", bytes.name, by_matrix, by_quaternion));
  const std::vector<std::string> header = fields_of(line);
  if (header != fields_of(by_matrix) && header != fields_of(by_quaternion))
    lines.fail(fmt::format("the first line is neither {} nor {}", by_matrix, by_quaternion));

  std::vector<frame> out;
  std::set<std::string> seen; // frames
  while (next(lines, line)) {
    const std::vector<std::string> fields = fields_of(line);
    if (fields.size() != header.size())
      lines.fail(fmt::format("{} fields, but the first line names {}", fields.size(), header.size()));
    if (out.empty() || out.back().name != fields[0]) {
      if (!seen.insert(fields[0]).second)
        lines.fail(fmt::format("frame {} begins a second time; the rows of one frame follow each other",
                               io::quote(fields[0])));
      out.push_back({fields[0], {}});
    }
    const auto body = std::ranges::find(names, fields[1]);
    if (body == names.end())
      lines.fail(fmt::format("no body is named {}{}", io::quote(fields[1]), nearest(fields[1], names)));
    const auto number = static_cast<std::uint32_t>(body - names.begin());
    if (std::ranges::any_of(out.back().moved, [number](const auto &m) { return m.first == number; }))
      lines.fail(fmt::format("frame {} has a pose of {} already", io::quote(fields[0]), io::quote(fields[1])));
    std::vector<double> numbers;
    for (std::size_t i = 2; i < fields.size(); ++i) {
      double value = 0;
      if (!io::parse_decimal(fields[i], io::precision::float64, value))
        lines.fail(fmt::format("{} is {}, not a number", header[i], io::quote(fields[i])));
      numbers.push_back(value);
    }
    out.back().moved.emplace_back(number, pose_of(numbers, fmt::format("{}:{}", bytes.name, lines.number())));
  }
  if (out.empty())
    throw io::error(fmt::format("{}: no row follows the first line", bytes.name));
  return out;
}

} // namespace meetc::app
