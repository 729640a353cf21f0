// Which faces of a mesh file touch a ball: read.cpp's argument is a .ply, .obj, .off or .stl.
#include <cstdio>
#include <meet/io/read.hpp>
#include <meet/meet.hpp>

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
  const meet::prepared a = meet::prepare(meet::spheres(ball)), b = meet::prepare(meet::elements_of(mesh));
  // With owners, pairs are of faces, not of the triangles into which they were cut.
  for (const meet::index_pair &pair : meet::pairs(a, b, {.with = {.owner_b = mesh.owner}}))
    std::printf("the ball touches face %u\n", pair.b);
} catch (const meetc::io::error &e) {
  std::printf("%s\n", e.what());
  return 1;
}
