// Which faces of a mesh file touch a ball: read.cpp's argument is a .ply, .obj, .off or .stl.
#include <cga/cga_runtime.hpp>
#include <cstdio>
#include <meet/core/query/collide.hpp>
#include <meet/core/query/find.hpp>
#include <meet/io/read.hpp>
#include <vector>

int main(int argc, char **argv) try {
  if (argc != 2) {
    std::puts("the name of a file is needed");
    return 1;
  }
  const meetc::catalogue &all = cga::catalogue();
  std::vector<const meetc::kind_info *> kinds;
  for (int i = 0; i < all.kind_count; ++i)
    kinds.push_back(&all.kinds[i]);
  const meetc::io::element_set mesh = meetc::io::read(argv[1], kinds, {.kind = "triangle"});
  for (const std::string &note : mesh.notes)
    std::printf("%s\n", note.c_str());
  std::printf("%zu faces, %zu triangles; float32 moved %zu numbers\n", mesh.items, mesh.elements, mesh.rounded.numbers);

  const float ball[] = {2, 0.5F, 0, 0.25F};
  const meetc::predicate_info &touch = meetc::find_predicate(all, "ball_triangle");
  const meetc::prepared a = meetc::prepare({.data = ball, .stride_bytes = 16, .elements = 1}, *touch.a);
  const meetc::prepared b = meetc::prepare({.data = mesh.data.data(),
                                            .vertices = mesh.vertices,
                                            .stride_bytes = 12,
                                            .index = mesh.index.data(),
                                            .elements = mesh.elements},
                                           *touch.b);
  meetc::collide_options faces; // pairs of faces, not of the triangles into which they were cut
  faces.owner_b = mesh.owner;
  for (const meetc::index_pair &pair : meetc::collide(a, b, touch, meetc::rung::certified, faces).pairs)
    std::printf("the ball touches face %u\n", pair.b);
} catch (const meetc::io::error &e) {
  std::printf("%s\n", e.what());
  return 1;
}
