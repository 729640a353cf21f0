// The binary body of a PLY, in either byte order.
//
// If all rows of an element take the same number of bytes, because no list is in them or because each face has as many
// corners as the first one, several threads read them. Otherwise the rows are read one after the other, which also finds
// the place of a fault.
#include "meet/io/files/endian.hpp"
#include "meet/io/files/error.hpp"
#include "meet/io/mesh/ply_rows.hpp"
#include "meet/io/text/number.hpp"

#include <fmt/format.h>

#include <atomic>
#include <cmath>
#include <limits>
#include <utility>

namespace meetc::io {

namespace {

constexpr std::size_t rows_at_once = 1 << 14;

template <std::endian Order> double load_real(const char *at, ply_type type) {
  switch (type) {
  case ply_type::int8:
    return load<std::int8_t>(at, Order);
  case ply_type::uint8:
    return load<std::uint8_t>(at, Order);
  case ply_type::int16:
    return load<std::int16_t>(at, Order);
  case ply_type::uint16:
    return load<std::uint16_t>(at, Order);
  case ply_type::int32:
    return load<std::int32_t>(at, Order);
  case ply_type::uint32:
    return load<std::uint32_t>(at, Order);
  case ply_type::float32:
    return static_cast<double>(load<float>(at, Order));
  default:
    return load<double>(at, Order);
  }
}

// `type` must be an integer type.
template <std::endian Order> std::int64_t load_integer(const char *at, ply_type type) {
  return static_cast<std::int64_t>(load_real<Order>(at, type)); // exact, since it has at most 32 bits
}

// One coordinate, rounded. A number that float32 does not hold has moved.
float round_counted(double value, rounded_numbers &moved) {
  const float f = to_float32(value);
  if (static_cast<double>(f) != value && std::isfinite(f))
    moved.add(std::abs(value - static_cast<double>(f)));
  return f;
}

template <std::endian Order> class body_reader {
public:
  body_reader(const file_bytes &file, const ply_layout &layout, const read_request &q)
      : layout_(layout), q_(q), begin_(file.bytes.get()), at_(begin_ + layout.header->body_offset),
        end_(begin_ + file.size) {}

  mesh_part read() {
    for (const ply_element &e : layout_.header->elements) {
      if (e.properties.empty()) // takes no bytes, whatever the count
        continue;
      element_ = &e;
      row_ = 0;
      check_size();
      if (&e == layout_.vertex)
        vertices();
      else if (&e == layout_.face)
        faces();
      else
        for (; row_ < e.count; ++row_)
          for (const ply_property &p : e.properties)
            pass_over(p);
    }
    if (at_ != end_)
      throw error(fmt::format("{}: byte {}: {} bytes after the last element", layout_.file, offset(), left()));
    return std::move(part_);
  }

private:
  std::size_t left() const { return static_cast<std::size_t>(end_ - at_); }
  std::size_t offset() const { return static_cast<std::size_t>(at_ - begin_); }
  [[noreturn]] void fail(std::string_view message) const {
    throw error(fmt::format("{}: {} {}: {}", layout_.file, element_->name, row_, message));
  }
  void need(std::uint64_t bytes) const {
    if (bytes > left())
      throw error(
          fmt::format("{}: byte {}: the file ends inside {} {}", layout_.file, end_ - begin_, element_->name, row_));
  }

  // Checks that the rest of the file can hold this number of rows.
  void check_size() const {
    std::size_t least = 0;
    for (const ply_property &p : element_->properties)
      least += p.list ? size_of(p.count_type) : size_of(p.type);
    if (element_->count > left() / least)
      throw error(fmt::format("{}: byte {}: {} rows of element {} take at least {} bytes each, but {} bytes are left",
                              layout_.file, offset(), element_->count, quote(element_->name), least, left()));
  }

  std::uint64_t list_count(const ply_property &p) {
    need(size_of(p.count_type));
    const std::int64_t n = load_integer<Order>(at_, p.count_type);
    if (n < 0)
      fail(fmt::format("the count of list {} is {}", quote(p.name), n));
    at_ += size_of(p.count_type);
    return static_cast<std::uint64_t>(n);
  }
  void pass_over(const ply_property &p) {
    const std::uint64_t bytes = (p.list ? list_count(p) : 1) * size_of(p.type);
    need(bytes);
    at_ += bytes;
  }

  // ---- vertices ----

  void vertices() {
    part_.xyz.resize(3 * element_->count);
    if (!vertices_in_parallel())
      for (; row_ < element_->count; ++row_)
        vertex();
    if (q_.fault) {
      row_ = q_.fault->row;
      fail(q_.fault->what);
    }
  }

  bool vertices_in_parallel() {
    std::size_t stride = 0, offset[3] = {};
    ply_type type[3] = {};
    for (std::size_t k = 0; k < layout_.slots.size(); ++k) {
      const ply_property &p = element_->properties[k];
      if (p.list)
        return false;
      if (const int slot = layout_.slots[k]; slot >= 0) {
        offset[slot] = stride;
        type[slot] = p.type;
      }
      stride += size_of(p.type);
    }
    const bool plain = type[0] == ply_type::float32 && type[1] == ply_type::float32 && type[2] == ply_type::float32;
    std::vector<rounded_numbers> moved(element_->count / rows_at_once + 1);
    std::atomic<bool> finite = true;
    for_chunks(q_.by.threads, element_->count, rows_at_once, [&](int, std::size_t begin, std::size_t end) {
      float *out = &part_.xyz[3 * begin];
      const char *row = at_ + begin * stride;
      float sum = 0; // of 0 times each number, which is not 0 if one is not finite
      for (std::size_t i = begin; i < end; ++i, row += stride, out += 3)
        for (int c = 0; c < 3; ++c) {
          out[c] = plain ? load<float>(row + offset[c], Order)
                         : round_counted(load_real<Order>(row + offset[c], type[c]), moved[begin / rows_at_once]);
          sum += out[c] * 0;
        }
      if (!(sum == 0))
        finite = false;
    });
    if (!finite)
      return false;
    at_ += stride * element_->count;
    for (const rounded_numbers &m : moved)
      part_.rounded.add(m);
    return true;
  }

  void vertex() {
    for (std::size_t k = 0; k < layout_.slots.size(); ++k) {
      const ply_property &p = element_->properties[k];
      const int slot = layout_.slots[k];
      if (slot < 0) {
        pass_over(p);
        continue;
      }
      need(size_of(p.type));
      const double read = load_real<Order>(at_, p.type);
      at_ += size_of(p.type);
      const float f = round_counted(read, part_.rounded);
      if (!std::isfinite(f))
        unfit_[slot] = {true, read};
      part_.xyz[3 * row_ + static_cast<std::size_t>(slot)] = f;
    }
    for (int c = 0; c < 3; ++c)
      if (unfit_[c].first)
        fail(describe_non_finite(std::string_view("xyz").substr(static_cast<std::size_t>(c), 1), unfit_[c].second,
                                 to_float32(unfit_[c].second)));
  }

  // ---- faces ----

  void faces() {
    if (faces_in_parallel())
      return;
    for (; row_ < element_->count; ++row_)
      for (std::size_t k = 0; k < element_->properties.size(); ++k)
        if (k == layout_.corners)
          corners(element_->properties[k]);
        else
          pass_over(element_->properties[k]);
  }

  void corners(const ply_property &list) {
    const std::uint64_t n = list_count(list);
    if (n < 3)
      fail(fmt::format("{} corners; a face has at least 3", n));
    need(n * size_of(list.type)); // before they are collected
    for (std::uint64_t i = 0; i < n; ++i, at_ += size_of(list.type)) {
      const std::int64_t index = load_integer<Order>(at_, list.type);
      if (index < 0 || static_cast<std::uint64_t>(index) >= layout_.vertices())
        fail(describe_missing_vertex(index, layout_.vertices()));
      part_.faces.vertices.push_back(static_cast<std::uint32_t>(index));
    }
    part_.faces.end_list(n);
  }

  // Reads the faces on several threads if their only list is that of the corners and all have the length of the first.
  bool faces_in_parallel() {
    const ply_property &list = element_->properties[layout_.corners];
    std::size_t before = 0, stride = 0;
    for (std::size_t k = 0; k < element_->properties.size(); ++k) {
      if (k == layout_.corners) {
        before = stride;
        continue;
      }
      if (element_->properties[k].list)
        return false;
      stride += size_of(element_->properties[k].type);
    }
    const std::size_t count_size = size_of(list.count_type), size = size_of(list.type);
    if (left() < before + count_size)
      return false;
    const std::int64_t n = load_integer<Order>(at_ + before, list.count_type);
    if (n < 3 || static_cast<std::size_t>(n) > left() / size)
      return false;
    const auto corners = static_cast<std::size_t>(n);
    stride += count_size + corners * size;
    if (element_->count > left() / stride)
      return false;
    std::vector<std::uint32_t> &out = part_.faces.vertices;
    out.resize(corners * element_->count);
    std::atomic<bool> good = true;
    const bool wide = size == 4;
    for_chunks(q_.by.threads, element_->count, rows_at_once, [&](int, std::size_t begin, std::size_t end) {
      std::uint32_t *to = &out[corners * begin];
      const char *row = at_ + begin * stride + before;
      bool fine = true;
      for (std::size_t i = begin; i < end; ++i, row += stride) {
        fine = fine && (count_size == 1 ? static_cast<std::int64_t>(*reinterpret_cast<const unsigned char *>(row)) == n
                                        : load_integer<Order>(row, list.count_type) == n);
        const char *from = row + count_size;
        for (std::size_t k = 0; k < corners; ++k, from += size) {
          // As an unsigned number, a negative index is too large.
          const std::uint32_t index = wide ? load<std::uint32_t>(from, Order)
                                           : static_cast<std::uint32_t>(load_integer<Order>(from, list.type));
          fine = fine && index < layout_.vertices();
          *to++ = index;
        }
      }
      if (!fine)
        good = false;
    });
    if (!good) {
      out.clear();
      return false;
    }
    part_.faces.lists = element_->count;
    if (corners != part_.faces.common)
      part_.faces.counts.assign(element_->count, static_cast<std::uint32_t>(corners));
    at_ += stride * element_->count;
    return true;
  }

  const ply_layout &layout_;
  const read_request &q_;
  const char *begin_, *at_, *end_;
  const ply_element *element_ = nullptr;
  std::uint64_t row_ = 0;
  std::pair<bool, double> unfit_[3] = {};
  mesh_part part_;
};

} // namespace

mesh_part read_ply_binary(const file_bytes &file, const ply_layout &layout, const read_request &q) {
  if (layout.header->format == ply_format::little_endian)
    return body_reader<std::endian::little>(file, layout, q).read();
  return body_reader<std::endian::big>(file, layout, q).read();
}

} // namespace meetc::io
