#include "meet/io/write.hpp"

#include "meet/core/views/nouns.hpp"
#include "meet/io/files/atomic_file.hpp"
#include "meet/io/files/endian.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <numeric>
#include <string>
#include <vector>

namespace meetc::io {

namespace {

// Collects small pieces, so that the file is written in large ones.
class buffered {
public:
  explicit buffered(const std::filesystem::path &path) : file_(path) { buffer_.reserve(size + 64); }

  void text(std::string_view piece) {
    buffer_.append(piece);
    if (buffer_.size() >= size)
      flush();
  }
  template <class T> void binary(T value) {
    const auto bytes = store(value, std::endian::little);
    text({bytes.data(), bytes.size()});
  }
  void decimal(std::uint32_t value) {
    char digits[10];
    const auto [end, code] = std::to_chars(digits, digits + sizeof digits, value);
    text({digits, static_cast<std::size_t>(end - digits)});
  }
  void commit() {
    flush();
    file_.commit();
  }

private:
  void flush() {
    file_.write(buffer_);
    buffer_.clear();
  }
  static constexpr std::size_t size = 1 << 16;
  atomic_file file_;
  std::string buffer_;
};

// Faces as polygons. The corners of face i are corners[start[i]] up to corners[start[i + 1]].
struct polygons {
  std::vector<std::size_t> start{0};
  std::vector<std::uint32_t> corners;
};

polygons triangles(std::span<const std::uint32_t> index) {
  polygons out;
  out.corners.assign(index.begin(), index.end());
  for (std::size_t i = 3; i <= index.size(); i += 3)
    out.start.push_back(i);
  return out;
}

// The faces of a mesh as they were before they were cut.
polygons faces_of(const element_set &mesh) {
  if (mesh.polygons.lists == 0 || mesh.owner.empty())
    return triangles(mesh.index);
  polygons out;
  out.corners = mesh.polygons.vertices;
  for (std::size_t i = 0; i < mesh.polygons.lists; ++i)
    out.start.push_back(out.start.back() + mesh.polygons.count(i));
  return out;
}

void write_polygons(const std::filesystem::path &path, std::span<const float> xyz, const polygons &faces,
                    std::span<const rgb> colours) {
  const std::size_t count = faces.start.size() - 1, vertices = xyz.size() / 3;
  if (!colours.empty() && colours.size() != count)
    throw error(fmt::format("{}: {} colours for {} faces", path.string(), colours.size(), count));
  if (vertices > 0xffffffff || count > 0xffffffff)
    throw error(fmt::format("{}: more than {} vertices or faces", path.string(), 0xffffffff));
  std::size_t most = 0;
  for (std::size_t i = 0; i < count; ++i)
    most = std::max(most, faces.start[i + 1] - faces.start[i]);
  // The usual types, which every reader knows, unless they are too small.
  const bool small = most <= 255;
  buffered out(path);
  out.text(fmt::format("ply\nformat binary_little_endian 1.0\nelement vertex {}\n"
                       "property float x\nproperty float y\nproperty float z\n"
                       "element face {}\nproperty list {} {} vertex_indices\n",
                       vertices, count, small ? "uchar" : "uint", vertices <= 0x80000000 ? "int" : "uint"));
  if (!colours.empty())
    out.text("property uchar red\nproperty uchar green\nproperty uchar blue\n");
  out.text("end_header\n");
  for (const float c : xyz)
    out.binary(c);
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t corners = faces.start[i + 1] - faces.start[i];
    if (small)
      out.binary(static_cast<std::uint8_t>(corners));
    else
      out.binary(static_cast<std::uint32_t>(corners));
    for (std::size_t k = faces.start[i]; k < faces.start[i + 1]; ++k)
      out.binary(faces.corners[k]);
    if (!colours.empty())
      for (const std::uint8_t channel : colours[i])
        out.binary(channel);
  }
  out.commit();
}

void write_mesh(const std::filesystem::path &path, const element_set &mesh, std::span<const rgb> colours) {
  if (mesh.kind->points != 3 || mesh.kind->fields != 9)
    throw error(fmt::format("{}: only triangles make a PLY mesh, not {}", path.string(), plural_of(mesh.kind->name)));
  if (!mesh.index.empty() || mesh.elements == 0)
    return write_polygons(path, mesh.data, faces_of(mesh), colours);
  std::vector<std::uint32_t> index(3 * mesh.elements);
  std::iota(index.begin(), index.end(), 0U);
  write_polygons(path, mesh.data, triangles(index), colours);
}

} // namespace

void write_pairs_csv(const std::filesystem::path &path, std::span<const index_pair> pairs) {
  write_pairs_csv(path, pairs, "", [](std::size_t, std::string &) {});
}

void write_pairs_csv(const std::filesystem::path &path, std::span<const index_pair> pairs, std::string_view names,
                     const std::function<void(std::size_t i, std::string &line)> &append) {
  under_standard_word([&] {
    buffered out(path);
    out.text("a,b");
    out.text(names);
    out.text("\n");
    std::string line;
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      out.decimal(pairs[i].a);
      out.text(",");
      out.decimal(pairs[i].b);
      line.clear();
      append(i, line);
      line += '\n';
      out.text(line);
    }
    out.commit();
  });
}

void write_ply(const std::filesystem::path &path, std::span<const float> xyz, std::span<const std::uint32_t> index,
               std::span<const rgb> colours) {
  under_standard_word([&] { write_polygons(path, xyz, triangles(index), colours); });
}

void write_ply(const std::filesystem::path &path, const element_set &mesh, std::span<const rgb> colours) {
  under_standard_word([&] { write_mesh(path, mesh, colours); });
}

} // namespace meetc::io
