#include "meet/io/read.hpp"
#include "meet/python/arrays.hpp"
#include "meet/python/bindings.hpp"
#include <cga/cga_runtime.hpp>

namespace meetc::python {

namespace {

// The elements of a file, as arrays that own the reader's memory.
py::dict read_file(const std::filesystem::path &path, const std::string &kind, int threads) {
  const catalogue &all = cga::catalogue();
  std::vector<const kind_info *> kinds;
  for (int i = 0; i < all.kind_count; ++i)
    kinds.push_back(&all.kinds[i]);
  io::element_set set;
  {
    const py::gil_scoped_release others_run;
    io::read_options how;
    how.kind = kind;
    how.threads = threads;
    set = io::read(path, kinds, how);
  }
  py::dict out;
  out["kind"] = set.kind->name;
  const auto wide = static_cast<py::ssize_t>(set.index.empty() ? set.kind->fields : 3);
  const auto numbers = static_cast<py::ssize_t>(set.data.size());
  out["numbers"] = as_array<float>(std::move(set.data), {numbers / wide, wide});
  out["index"] = py::none();
  if (const auto indices = static_cast<py::ssize_t>(set.index.size()); indices > 0)
    out["index"] = as_array<std::uint32_t>(std::move(set.index), {indices / set.kind->points, set.kind->points});
  out["owner"] = py::none();
  if (!set.owner.empty())
    out["owner"] = as_array<std::uint32_t>(std::move(set.owner));
  out["items"] = set.items;
  out["moved"] = set.rounded.numbers;
  out["largest"] = set.rounded.largest;
  out["notes"] = set.notes;
  return out;
}

} // namespace

void bind_files(py::module_ &module) {
  module.def("read", [](const std::string &path, const std::string &kind, int threads) {
    return read_file(path, kind, threads);
  });
}

} // namespace meetc::python
