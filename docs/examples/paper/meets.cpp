// In how many points do a million pairs of a sphere and a line meet? By the sign of B^2, on a device.
#include <cstdio>
#include <meet/core/device/evaluate.hpp>
#include <meets/meets_cuda.hpp>
#include <meets/meets_runtime.hpp>
#include <vector>

int main() try {
  std::vector<float> spheres, lines; // packed rows: centre and radius; two points
  std::vector<std::uint32_t> pairs;  // a sphere and a line each
  for (int i = 0; i < 1000; ++i) {
    const auto x = static_cast<float>(4 * (i % 10)), y = static_cast<float>(4 * (i / 10 % 10)),
               z = static_cast<float>(i / 100);
    spheres.insert(spheres.end(), {x, y, z, 1});
    lines.insert(lines.end(), {0, y + static_cast<float>(i % 10), z, 1, y + static_cast<float>(i % 10), z});
  }
  for (std::uint32_t sphere = 0; sphere < 1000; ++sphere)
    for (std::uint32_t line = 0; line < 1000; ++line)
      pairs.insert(pairs.end(), {sphere, line});

  meetc::column of_spheres[4], of_lines[6];
  meetc::columns_of(spheres.data(), of_spheres);
  meetc::columns_of(lines.data(), of_lines);
  const meetc::operand_columns operands[] = {{of_spheres, 1000}, {of_lines, 1000}};
  const meetc::formula_info &square = meetc::formula_named(meets::catalogue(), "norm2(meet(sphere, line))");
  const meetc::device gpu(meets::cuda::catalogue());
  const meetc::formula_values<float> found = meetc::evaluate<float>(gpu, square, operands, pairs);
  std::size_t two = 0, one = 0, none = 0;
  for (const float b2 : found.column(0))
    ++(b2 > 0 ? two : b2 == 0 ? one : none);
  std::printf("two points: %zu, one: %zu, none: %zu\n", two, one, none);
} catch (const meetc::device_error &e) {
  std::printf("device: %s\n", e.what());
  return 3;
}
