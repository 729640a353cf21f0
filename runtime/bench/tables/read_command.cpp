#include "bench/tables/read_command.hpp"

#include "app/json.hpp"
#include "app/kinds.hpp"
#include "app/made_sets.hpp"
#include "bench/harness/measure.hpp"
#include "bench/harness/table.hpp"
#include "bodies/meshes.hpp"
#include "io/atomic_file.hpp"
#include "io/endian.hpp"
#include "io/file_bytes.hpp"
#include "io/read.hpp"
#include "io/write.hpp"

#include <fmt/format.h>

#include <charconv>
#include <chrono>
#include <cstring>
#include <functional>
#include <malloc.h>
#include <span>
#include <sys/mman.h>
#include <unistd.h>
#include <vector>

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

class text_writer {
public:
  text_writer &operator<<(std::string_view s) {
    out_ += s;
    return *this;
  }
  template <class T> text_writer &number(T value) {
    char text[32];
    const auto [end, code] = std::to_chars(text, text + sizeof text, value);
    out_.append(text, end);
    return *this;
  }
  text_writer &row(std::span<const float> row, char between) {
    for (std::size_t k = 0; k < row.size(); ++k) {
      number(row[k]);
      if (k + 1 < row.size())
        out_ += between;
    }
    return *this;
  }
  const std::string &text() const { return out_; }

private:
  std::string out_;
};

// ---- the files ----

void write_text(const fs::path &folder, const io::element_set &m) {
  text_writer obj, ply, csv, stl;
  ply << "ply\nformat ascii 1.0\nelement vertex ";
  ply.number(m.vertices) << "\nproperty float x\nproperty float y\nproperty float z\nelement face ";
  ply.number(m.elements) << "\nproperty list uchar int vertex_indices\nend_header\n";
  csv << m.kind->csv << "\n";
  stl << "solid mesh\n";
  for (std::size_t v = 0; v < m.vertices; ++v) {
    const std::span<const float> p(&m.data[3 * v], 3);
    (obj << "v ").row(p, ' ') << "\n";
    ply.row(p, ' ') << "\n";
  }
  for (std::size_t i = 0; i < m.elements; ++i) {
    obj << "f";
    ply << "3";
    for (std::size_t k = 0; k < 3; ++k) {
      (obj << " ").number(m.index[3 * i + k] + 1);
      (ply << " ").number(m.index[3 * i + k]);
    }
    obj << "\n";
    ply << "\n";
    float row[9];
    m.row(i, row);
    csv.row(row, ',') << "\n";
    stl << "facet normal 0 0 1\n outer loop\n";
    for (int k = 0; k < 3; ++k)
      (stl << "  vertex ").row({row + 3 * k, 3}, ' ') << "\n";
    stl << " endloop\nendfacet\n";
  }
  stl << "endsolid mesh\n";
  for (const auto &[name, w] : {std::pair("mesh.obj", &obj), std::pair("ascii.ply", &ply), std::pair("rows.csv", &csv),
                                std::pair("ascii.stl", &stl)})
    io::write_file(folder / name, w->text());
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

// A copy of the bytes, which are in memory, into pages that the system has just given.
void copy_to_fresh_memory(std::string_view bytes) {
  void *const to = ::mmap(nullptr, bytes.size(), PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
  std::memcpy(to, bytes.data(), bytes.size());
  ::munmap(to, bytes.size());
}

double seconds_of(const std::function<void()> &work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

} // namespace

std::string read_times(const catalogue &all, const read_request &q) {
  // Otherwise memory that was freed would be used again, and have its pages already.
  ::mallopt(M_MMAP_THRESHOLD, 1 << 17);
  ::mallopt(M_TRIM_THRESHOLD, 1 << 17);
  const std::vector<const kind_info *> kinds = app::kinds_of(all);
  const io::element_set mesh = q.mesh ? io::read(*q.mesh, kinds) : app::of_mesh(all, bodies::blob(192));
  if (mesh.index.size() != 3 * mesh.elements || mesh.kind->points != 3)
    throw io::error("bench read: the mesh must have triangles with common vertices");
  const temporary_folder folder;
  write_text(folder.path, mesh);
  write_binary(folder.path, mesh);
  table t{"read", fmt::format("Reading {} faces on {} threads", mesh.elements, q.threads), {}, {}, {}};
  t.columns = {
      {"file", "file"}, {"megabytes", "MB"}, {"reader", "reader, ms"}, {"least", "least, ms"}, {"ratio", "ratio"}};
  for (const char *const name : {"mesh.obj", "rows.csv", "ascii.ply", "ascii.stl", "binary.ply", "binary.stl"}) {
    const fs::path path = folder.path / name;
    const io::file_bytes file = io::load_file(path);
    const std::vector<char> bytes(file.bytes.get(), file.bytes.get() + file.size);
    const bool binary = std::string_view(name).starts_with("binary");
    const std::size_t lines = path.extension() == ".csv"   ? ~std::size_t{0}
                              : path.extension() == ".ply" ? mesh.vertices
                                                           : 0;
    std::size_t kept = 0; // what keeps the compiler from removing the work
    const std::function<void()> reader = [&] { kept += io::read(path, kinds, {.threads = q.threads}).elements; };
    const std::function<void()> least = [&] {
      if (binary)
        copy_to_fresh_memory({bytes.data(), bytes.size()});
      else
        kept += plain_loop(path, lines).reals.size();
    };
    std::vector<double> of_reader, of_least;
    for (int i = 0; i < q.repetitions; ++i) {
      of_reader.push_back(seconds_of(reader));
      of_least.push_back(seconds_of(least));
    }
    const double r = median(of_reader), l = median(of_least);
    t.rows.push_back({of_words(name), of_ratio(static_cast<double>(file.size) * 1e-6), of_milliseconds(r),
                      of_milliseconds(l), of_ratio(kept == 0 ? 0 : r / l)});
  }
  t.notes.push_back(
      fmt::format("Medians of {} interleaved runs, by the clock on the wall. Least: one thread over std::from_chars "
                  "for text, a copy into fresh memory for binary files.",
                  q.repetitions));
  if (!q.json)
    return as_text(t);
  app::json out = {{"tables", app::json::array({as_json(t)})}};
  return app::in_one_line(out) + '\n';
}

} // namespace meetc::bench
