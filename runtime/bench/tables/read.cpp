// How long the readers take.
#include "meet/io/read.hpp"
#include "meet/app/input/kinds.hpp"
#include "meet/app/input/made_sets.hpp"
#include "meet/bench/harness/method.hpp"
#include "meet/bench/harness/report.hpp"
#include "meet/bench/tables/tables.hpp"
#include "meet/bodies/meshes.hpp"
#include "meet/io/files/atomic_file.hpp"
#include "meet/io/files/endian.hpp"
#include "meet/io/files/file_bytes.hpp"
#include "meet/io/write.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cstring>
#include <malloc.h>
#include <sys/mman.h>
#include <unistd.h>

namespace meetc::bench {

namespace {

namespace fs = std::filesystem;

struct temporary_folder {
  fs::path path = fs::temp_directory_path() / fmt::format("meet-read-{}", ::getpid());
  temporary_folder() { fs::create_directories(path); }
  ~temporary_folder() {
    std::error_code ignored;
    fs::remove_all(path, ignored);
  }
};

// ---- the files ----

void write_text(const fs::path &folder, const io::element_set &m) {
  std::string obj, csv = std::string(m.kind->csv) + "\n", stl = "solid mesh\n";
  std::string ply =
      fmt::format("ply\nformat ascii 1.0\nelement vertex {}\nproperty float x\nproperty float y\n"
                  "property float z\nelement face {}\nproperty list uchar int vertex_indices\nend_header\n",
                  m.vertices, m.elements);
  const auto add = [](std::string &to, const char *how, const float *p) {
    fmt::format_to(std::back_inserter(to), fmt::runtime(how), p[0], p[1], p[2]);
  };
  for (std::size_t v = 0; v < m.vertices; ++v) {
    add(obj, "v {} {} {}\n", &m.data[3 * v]);
    add(ply, "{} {} {}\n", &m.data[3 * v]);
  }
  for (std::size_t i = 0; i < m.elements; ++i) {
    const std::uint32_t *const f = &m.index[3 * i];
    fmt::format_to(std::back_inserter(obj), "f {} {} {}\n", f[0] + 1, f[1] + 1, f[2] + 1);
    fmt::format_to(std::back_inserter(ply), "3 {} {} {}\n", f[0], f[1], f[2]);
    float row[9];
    m.row(i, row);
    stl += "facet normal 0 0 1\n outer loop\n";
    for (std::size_t k = 0; k < 9; k += 3) {
      add(csv, k == 0 ? "{},{},{}" : ",{},{},{}", row + k);
      add(stl, "  vertex {} {} {}\n", row + k);
    }
    csv += "\n";
    stl += " endloop\nendfacet\n";
  }
  stl += "endsolid mesh\n";
  for (const auto &[name, text] : {std::pair("mesh.obj", &obj), std::pair("ascii.ply", &ply),
                                   std::pair("rows.csv", &csv), std::pair("ascii.stl", &stl)})
    io::write_file(folder / name, *text);
}

void write_binary(const fs::path &folder, const io::element_set &m) {
  io::write_ply(folder / "binary.ply", m);
  std::string stl(80, ' ');
  const auto append = [&stl](auto value) {
    const auto bytes = io::store(value, std::endian::little);
    stl.append(bytes.data(), bytes.size());
  };
  append(static_cast<std::uint32_t>(m.elements));
  for (std::size_t i = 0; i < m.elements; ++i) {
    float row[12] = {};
    m.row(i, row + 3);
    for (const float x : row)
      append(x);
    append(std::uint16_t{0});
  }
  io::write_file(folder / "binary.stl", stl);
}

// ---- the least ----

struct numbers_of_text {
  std::vector<float> reals;
  std::vector<int> integers;
};

template <class T> const char *take(const char *at, const char *end, std::vector<T> &to) {
  T value{};
  at = std::from_chars(at, end, value).ptr;
  to.push_back(value);
  return at;
}

// One thread that passes the numbers of all lines to std::from_chars: real ones in the first `lines` lines, and then whole
// ones; 0 lines: as the first letter of each line says.
numbers_of_text plain_loop(const fs::path &path, std::size_t lines) {
  const io::file_bytes file = io::load_file(path);
  numbers_of_text out;
  const char *at = file.bytes.get(), *const end = at + file.size;
  if (const std::size_t header = file.text().find("end_header\n"); header != std::string_view::npos)
    at += header + 11;
  else if (path.extension() == ".csv")
    at += file.text().find('\n') + 1;
  for (std::size_t line = 0; at < end; ++line) {
    while (*at == ' ')
      ++at;
    const bool real = lines == 0 ? *at == 'v' : line < lines, whole = lines == 0 ? *at == 'f' && at[1] == ' ' : !real;
    while (at < end && *at >= 'a' && *at <= 'z')
      ++at;
    if (real || whole)
      while (at < end && *at != '\n') {
        if (*at == ' ' || *at == ',')
          ++at;
        else
          at = real ? take(at, end, out.reals) : take(at, end, out.integers);
      }
    at = static_cast<const char *>(std::memchr(at, '\n', static_cast<std::size_t>(end - at)));
    at = at ? at + 1 : end;
  }
  return out;
}

// A copy of the bytes, which are in memory, into pages that the system has just given. Returns how many.
std::size_t copy_to_fresh_memory(const std::vector<char> &bytes) {
  void *const to = ::mmap(nullptr, bytes.size(), PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
  std::memcpy(to, bytes.data(), bytes.size());
  ::munmap(to, bytes.size());
  return bytes.size();
}

struct row {
  std::string file;
  double megabytes, reader, least;
};

row time_of(const std::string &name, const fs::path &path, const io::element_set &mesh, const request &q,
            const std::vector<const kind_info *> &kinds) {
  const io::file_bytes file = io::load_file(path);
  const std::vector<char> bytes(file.bytes.get(), file.bytes.get() + file.size);
  const bool binary = name.starts_with("binary"), rows = path.extension() == ".csv";
  const std::size_t lines = rows ? ~std::size_t{0} : path.extension() == ".ply" ? mesh.vertices : 0;
  const bool of_vertices = name == "mesh.obj" || name == "ascii.ply"; // else each triangle has its corners
  const std::size_t reals = of_vertices ? 3 * mesh.vertices : 9 * mesh.elements;
  std::size_t faces = 0, taken = 0;
  host_clock clock(0);
  const measured_methods m =
      measure(name, clock,
              {{"the reader",
                true,
                {[&] { faces = io::read(path, kinds, {.threads = q.threads}).elements; }},
                [&] { return difference_of(faces, mesh.elements); }},
               {"the least",
                true,
                {[&] { taken = binary ? copy_to_fresh_memory(bytes) : plain_loop(path, lines).reals.size(); }},
                [&] { return difference_of(taken, binary ? bytes.size() : reals); }}},
              {q.repetitions, 600, 0});
  return {name, static_cast<double>(file.size) * 1e-6, m.of[0].seconds[0], m.of[1].seconds[0]};
}

} // namespace

std::string read(const catalogue &all, const request &q) {
  // Otherwise memory that was freed would be used again, and have its pages already.
  ::mallopt(M_MMAP_THRESHOLD, 1 << 17);
  ::mallopt(M_TRIM_THRESHOLD, 1 << 17);
  const std::vector<const kind_info *> kinds = app::kinds_of(all);
  const io::element_set mesh = q.a ? io::read(*q.a, kinds) : app::of_mesh(all, bodies::blob(192));
  if (mesh.index.size() != 3 * mesh.elements || mesh.kind->points != 3)
    throw io::error("bench read: the mesh must have triangles with common vertices");
  const temporary_folder folder;
  write_text(folder.path, mesh);
  write_binary(folder.path, mesh);
  std::vector<row> rows;
  for (const char *const name : {"mesh.obj", "rows.csv", "ascii.ply", "ascii.stl", "binary.ply", "binary.stl"})
    rows.push_back(time_of(name, folder.path / name, mesh, q, kinds));
  report r;
  r.tables = {
      table_of<row>("read", fmt::format("Reading {} faces on {} threads", mesh.elements, q.threads),
                    {{"file", "file", of_words, &row::file},
                     {"megabytes", "MB", of_ratio, &row::megabytes},
                     {"reader", "reader, ms", of_milliseconds, &row::reader},
                     {"least", "least, ms", of_milliseconds, &row::least},
                     {"ratio", "ratio", [](const row &m) { return of_ratio(m.reader / m.least); }}},
                    rows,
                    {fmt::format("Medians of {} interleaved runs, by the clock on the wall. Least: one thread over "
                                 "std::from_chars for text, a copy into fresh memory for binary files.",
                                 q.repetitions)})};
  return q.json ? as_json(r) : as_text(r);
}

} // namespace meetc::bench
