// The two bodies of a PLY file behind one interface, so that one template reads both:
//   begin(element)       checks that the rest of the file can hold this number of rows
//   begin_row(), end_row()
//   real(type), integer(type), skip(type, n)
//   fail(message)        throws with the place: file, line or byte, element and row
//   end()                refuses anything after the last element
#ifndef MEETC_IO_PLY_SOURCES_HPP
#define MEETC_IO_PLY_SOURCES_HPP

#include "io/endian.hpp"
#include "io/error.hpp"
#include "io/number.hpp"
#include "io/ply_header.hpp"
#include "io/text.hpp"

#include <fmt/format.h>

#include <limits>
#include <string_view>

namespace meetc::io {

template <std::endian Order> class ply_binary_source {
public:
  ply_binary_source(const file_bytes &file, const ply_header &header, precision)
      : name_(file.name), begin_(file.bytes.get()), at_(begin_ + header.body_offset), end_(begin_ + file.size) {}

  void begin(const ply_element &element) {
    element_ = &element;
    row_ = 0;
    std::size_t least = 0; // bytes in a row
    for (const ply_property &p : element.properties)
      least += size_of(p.list ? p.count_type : p.type);
    if (element.count > left() / least)
      throw error(fmt::format("{}: byte {}: {} rows of element {} take at least {} bytes each, but {} bytes are left",
                              name_, offset(), element.count, quote(element.name), least, left()));
  }
  void begin_row() {}
  void end_row() { ++row_; }

  double real(ply_type type) {
    switch (type) {
    case ply_type::float32:
      return static_cast<double>(take<float>());
    case ply_type::float64:
      return take<double>();
    default:
      return static_cast<double>(integer(type)); // exact, since it has at most 32 bits
    }
  }
  // `type` must be an integer type.
  std::int64_t integer(ply_type type) {
    switch (type) {
    case ply_type::int8:
      return take<std::int8_t>();
    case ply_type::uint8:
      return take<std::uint8_t>();
    case ply_type::int16:
      return take<std::int16_t>();
    case ply_type::uint16:
      return take<std::uint16_t>();
    case ply_type::int32:
      return take<std::int32_t>();
    default:
      return take<std::uint32_t>();
    }
  }
  // Checks that all values of a list are there before they are collected one by one.
  void need_values(ply_type type, std::uint64_t n) const { need(n * size_of(type)); }
  void skip(ply_type type, std::uint64_t n) {
    need_values(type, n);
    at_ += n * size_of(type);
  }

  [[noreturn]] void fail(std::string_view message) const {
    throw error(fmt::format("{}: {} {}: {}", name_, element_->name, row_, message));
  }
  void end() const {
    if (at_ != end_)
      throw error(fmt::format("{}: byte {}: {} bytes after the last element", name_, offset(), left()));
  }

private:
  template <class T> T take() {
    need(sizeof(T));
    const T value = load<T>(at_, Order);
    at_ += sizeof(T);
    return value;
  }
  void need(std::uint64_t bytes) const {
    if (bytes > left())
      throw error(fmt::format("{}: byte {}: the file ends inside {} {}", name_, end_ - begin_, element_->name, row_));
  }
  std::size_t left() const { return static_cast<std::size_t>(end_ - at_); }
  std::size_t offset() const { return static_cast<std::size_t>(at_ - begin_); }

  const std::string &name_;
  const char *begin_, *at_, *end_;
  const ply_element *element_ = nullptr;
  std::uint64_t row_ = 0;
};

// Each line is a row; blank lines are skipped.
class ply_ascii_source {
public:
  ply_ascii_source(const file_bytes &file, const ply_header &header, precision target)
      : lines_(file.text(), file.name, header.body_offset, header.body_line), size_(file.size), target_(target) {}

  void begin(const ply_element &element) {
    element_ = &element;
    row_ = 0;
    // This is enough to detect a false count: a row has a character and a line end, which the last line may lack.
    const std::size_t least = 2, left = size_ - lines_.offset() + 1;
    if (element.count > left / least)
      lines_.fail(fmt::format("{} rows of element {} take at least {} bytes each, but {} bytes are left", element.count,
                              quote(element.name), least, size_ - lines_.offset()));
  }
  void begin_row() {
    do {
      if (!lines_.next(line_))
        lines_.fail(fmt::format("the file ends after {} of {} rows of element {}", row_, element_->count,
                                quote(element_->name)));
    } while (trim(line_).empty());
  }
  void end_row() {
    if (const std::string_view rest = trim(line_); !rest.empty())
      fail(fmt::format("{} after the last value", quote(rest)));
    ++row_;
  }

  double real(ply_type type) {
    if (!is_real(type))
      return static_cast<double>(integer(type));
    const std::string_view word = need_word();
    double value = 0;
    if (!parse_decimal(word, target_, value))
      fail(fmt::format("{} is not a number", quote(word)));
    return value;
  }
  std::int64_t integer(ply_type type) {
    const std::string_view word = need_word();
    std::int64_t value = 0;
    if (!parse_integer(word, value))
      fail(fmt::format("{} is not an integer", quote(word)));
    const unsigned bits = static_cast<unsigned>(8 * size_of(type));
    const bool is_signed = type == ply_type::int8 || type == ply_type::int16 || type == ply_type::int32;
    const std::int64_t most = (std::int64_t{1} << (is_signed ? bits - 1 : bits)) - 1;
    if (value > most || value < (is_signed ? -most - 1 : 0))
      fail(fmt::format("{} does not fit the property's type", quote(word)));
    return value;
  }
  // need_word() reports the end of the line, and no memory is reserved by the count alone.
  void need_values(ply_type, std::uint64_t) const {}
  void skip(ply_type, std::uint64_t n) {
    for (std::uint64_t i = 0; i < n; ++i)
      need_word();
  }

  [[noreturn]] void fail(std::string_view message) const {
    lines_.fail(fmt::format("{} {}: {}", element_->name, row_, message));
  }
  void end() {
    while (lines_.next(line_))
      if (const std::string_view rest = trim(line_); !rest.empty())
        lines_.fail(fmt::format("{} after the last element", quote(rest)));
  }

private:
  std::string_view need_word() {
    const std::string_view word = take_word(line_);
    if (word.empty())
      fail("the line has too few values");
    return word;
  }

  line_reader lines_;
  std::size_t size_;
  precision target_;
  std::string_view line_;
  const ply_element *element_ = nullptr;
  std::uint64_t row_ = 0;
};

} // namespace meetc::io

#endif
