// app/world/npy_file.hpp: an array of NumPy (.npy, versions 1 to 3 of the format) of float32 or float64.
#ifndef MEETC_APP_WORLD_NPY_FILE_HPP
#define MEETC_APP_WORLD_NPY_FILE_HPP

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace meetc::app {

// The numbers lie in the bytes of a file, in rows or columns first and in either order of bytes.
class npy_array {
public:
  // Throws io::error that begins with the file's name.
  npy_array(std::string_view bytes, const std::string &name);

  static bool is_one(std::string_view bytes);
  const std::vector<std::uint64_t> &shape() const { return shape_; }
  std::uint64_t size() const { return size_; }
  // The number at this place in the order in which the last index varies first.
  double operator[](std::uint64_t place) const;

private:
  std::vector<std::uint64_t> shape_;
  std::uint64_t size_ = 1;
  std::size_t width_ = 8; // bytes of a number
  bool big_endian_ = false, columns_first_ = false;
  std::string_view numbers_;
};

// "(2, 4, 4)", as Python writes it.
std::string in_words(const std::vector<std::uint64_t> &shape);

} // namespace meetc::app

#endif
