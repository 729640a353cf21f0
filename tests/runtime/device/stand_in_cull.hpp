// What a launcher of a kind does to cull two sets, on the host: see stand_in.cpp.
#pragma once
#include "tests/runtime/device/stand_in_rows.hpp"

#include <meetc/cull_grid.hpp>

namespace meetc::stand_in {

template <class Shape>
cudaError_t surround(const cuda::view &v, const cuda::pose_matrix &at, cuda::joined_box *around, cudaStream_t) {
  for (std::uint32_t i = 0; i < v.elements; ++i) {
    float row[Shape::fields];
    posed_element<Shape>(v, at, i, row);
    join(*around, cuda::box_of_row<Shape>(row));
  }
  return cudaSuccess;
}
// The last element is kept first.
template <class Shape> cudaError_t sift(const cuda::sift_job &job, cudaStream_t) {
  const cuda::cull_grid grid(job.around[0], job.around[1], job.bits);
  const cuda::cull_marks marked{job.marked, job.bits}, marks{job.marks, job.bits};
  const auto set = [](std::uint32_t *word, std::uint32_t mask) { *word |= mask; };
  for (std::uint32_t i = job.among ? *job.among_count : job.from.elements; i-- > 0;) {
    const std::uint32_t number = job.among ? job.among[i] : i;
    float row[Shape::fields];
    if (!posed_element<Shape>(job.from, job.at, number, row)) {
      *job.bad = std::max(*job.bad, ~(static_cast<unsigned long long>(number) << 32 | number));
      continue;
    }
    cuda::cell_range cells;
    bool meets = grid.range(cuda::box_of_row<Shape>(row), cells);
    if (job.from.index && Shape::pad < 0 && Shape::fields == 3 * Shape::hull) { // the same of the cells of its vertices
      std::uint32_t least[3] = {1023, 1023, 1023}, greatest[3] = {0, 0, 0};
      for (std::uint32_t p = 0; p < Shape::hull; ++p)
        for (int k = 0; k < 3; ++k) {
          const std::uint32_t vertex = job.from.index[number * std::size_t{Shape::hull} + p];
          const cuda::packed_cells of{vertex < job.from.vertices ? job.vertices[vertex] : cuda::no_cells};
          least[k] = std::min(least[k], of.at(k)), greatest[k] = std::max(greatest[k], of.at(k));
        }
      meets = grid.range(least, greatest, cells);
    }
    if (!meets)
      continue;
    const int level = cells.level();
    if (job.marked && level == 0 && !marked.meets(cells, *marked.levels()))
      continue;
    job.kept[(*job.count)++] = number;
    if (!job.marks)
      continue;
    bool by_line = false;
    if constexpr (Shape::hull == 2) {
      const cuda::cull_line line(grid, cuda::ends_of_line<Shape>(row));
      by_line = job.by_lines && level > 0 && line.is_thin();
      for (std::uint32_t s = line.first_slab(grid); by_line && s <= line.last_slab(grid); ++s)
        marks.mark(line.in_slab(grid, s), 0, set);
    }
    if (!by_line)
      marks.mark(cells, level, set);
  }
  if (job.at_end.there && job.from.elements > 0) { // as by the last block, where there is one
    std::copy_n(job.at_end.from, job.at_end.words, job.at_end.to);
    *job.at_end.there = 1;
  }
  return cudaSuccess;
}

} // namespace meetc::stand_in
