#include "meet/app/world/npy_file.hpp"

#include "meet/io/files/endian.hpp"
#include "meet/io/files/error.hpp"
#include "meet/io/text/text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <optional>

namespace meetc::app {

namespace {

constexpr std::string_view magic = "\x93NUMPY";

// The header, a Python dictionary such as {'descr': '<f8', 'fortran_order': False, 'shape': (2, 4, 4), }.
class header_reader {
public:
  header_reader(std::string_view text, const std::string &name) : text_(text), name_(name) {}

  std::optional<std::string> descr;
  std::optional<bool> columns_first;
  std::optional<std::vector<std::uint64_t>> shape;

  void read() {
    expect('{');
    while (!take('}')) {
      const std::string key = word();
      expect(':');
      if (key == "descr" && !descr)
        descr = peek() == '[' ? std::string(text_.substr(at_)) : word(); // a list describes records
      else if (key == "fortran_order" && !columns_first)
        columns_first = truth();
      else if (key == "shape" && !shape)
        shape = numbers();
      else
        fail();
      if (descr && descr->front() == '[')
        return;
      if (!take(',')) {
        expect('}');
        break;
      }
    }
    if (peek() != 0 || !descr || !columns_first || !shape)
      fail();
  }

private:
  [[noreturn]] void fail() const {
    throw io::error(fmt::format("{}: its header is no dictionary of 'descr', 'fortran_order' and 'shape': {}", name_,
                                io::quote(text_)));
  }
  // The next character that is no blank; 0: there is none.
  char peek() {
    while (at_ < text_.size() && (text_[at_] == ' ' || text_[at_] == '\n'))
      ++at_;
    return at_ < text_.size() ? text_[at_] : '\0';
  }
  bool take(char c) {
    const bool is = peek() == c;
    at_ += is ? 1 : 0;
    return is;
  }
  void expect(char c) {
    if (!take(c))
      fail();
  }
  std::string word() {
    const char quote = peek();
    if (quote != '\'' && quote != '"')
      fail();
    const std::size_t begin = at_ + 1, end = text_.find(quote, begin);
    if (end == std::string_view::npos || end == begin)
      fail();
    at_ = end + 1;
    return std::string(text_.substr(begin, end - begin));
  }
  bool truth() {
    peek();
    for (const bool value : {false, true})
      if (const std::string_view name = value ? "True" : "False"; text_.substr(at_, name.size()) == name) {
        at_ += name.size();
        return value;
      }
    fail();
  }
  std::vector<std::uint64_t> numbers() {
    std::vector<std::uint64_t> out;
    expect('(');
    while (!take(')')) {
      peek();
      std::uint64_t n = 0;
      const auto [end, wrong] = std::from_chars(text_.data() + at_, text_.data() + text_.size(), n);
      if (wrong != std::errc())
        fail();
      at_ = static_cast<std::size_t>(end - text_.data());
      out.push_back(n);
      if (!take(',')) {
        expect(')');
        break;
      }
    }
    return out;
  }

  std::string_view text_;
  const std::string &name_;
  std::size_t at_ = 0;
};

} // namespace

bool npy_array::is_one(std::string_view bytes) {
  return bytes.substr(0, magic.size()) == magic;
}

npy_array::npy_array(std::string_view bytes, const std::string &name) {
  const auto byte = [&](std::size_t at) { return std::size_t{static_cast<unsigned char>(bytes[at])}; };
  const std::size_t version = bytes.size() > magic.size() ? byte(magic.size()) : 0;
  const std::size_t lead = version == 1 ? 10 : 12;
  if (bytes.size() < lead)
    throw io::error(fmt::format("{}: the file ends within its header", name));
  if (version < 1 || version > 3)
    throw io::error(fmt::format("{}: version {} of the format; 1 to 3 are read", name, version));
  std::size_t length = 0;
  for (std::size_t at = lead; at-- > 8;)
    length = length * 256 + byte(at);
  if (bytes.size() - lead < length)
    throw io::error(fmt::format("{}: the file ends within its header", name));
  header_reader header(bytes.substr(lead, length), name);
  header.read();

  const std::string &type = *header.descr;
  if (type != "<f4" && type != "<f8" && type != ">f4" && type != ">f8")
    throw io::error(fmt::format("{}: its numbers are of type {}; float32 and float64 are read", name, io::quote(type)));
  big_endian_ = type[0] == '>', width_ = type[2] == '4' ? 4 : 8;
  columns_first_ = *header.columns_first, shape_ = *header.shape;
  numbers_ = bytes.substr(lead + length);
  const std::uint64_t room = numbers_.size() / width_;
  bool fits = true;
  for (const std::uint64_t n : shape_) {
    fits = fits && (n == 0 || size_ <= room / n);
    size_ = fits ? size_ * n : size_;
  }
  if (std::ranges::find(shape_, 0U) != shape_.end())
    fits = true, size_ = 0;
  if (!fits || numbers_.size() != size_ * width_)
    throw io::error(fmt::format("{}: {} bytes follow the header, which is not what an array of shape {} has", name,
                                numbers_.size(), in_words(shape_)));
}

double npy_array::operator[](std::uint64_t place) const {
  if (columns_first_) { // the place of the same indices where the first one varies first
    std::uint64_t other = 0, step = size_;
    for (std::size_t i = shape_.size(); i-- > 0; place /= shape_[i])
      step /= shape_[i], other += place % shape_[i] * step;
    place = other;
  }
  const std::endian order = big_endian_ ? std::endian::big : std::endian::little;
  const char *const at = numbers_.data() + place * width_;
  return width_ == 8 ? io::load<double>(at, order) : static_cast<double>(io::load<float>(at, order));
}

std::string in_words(const std::vector<std::uint64_t> &shape) {
  return fmt::format("({}{})", fmt::join(shape, ", "), shape.size() == 1 ? "," : "");
}

} // namespace meetc::app
