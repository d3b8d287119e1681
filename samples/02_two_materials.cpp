// Two materials from a file of our own making: regions, the interface between them, files for a
// solver. The interface stays as given, edge by edge.
#include <cover/cover_mesh.hpp>
#include <cover/read_input.hpp>
#include <cover/write_mesh.hpp>

#include <cstdio>

int main() {
  // Triangle's .poly: a square with a smaller one inside; silicon is 1, oxide 2.
  const char* text = R"(8 2 0 0
1 0 0
2 4 0
3 4 4
4 0 4
5 1 1
6 3 1
7 3 3
8 1 3
8 1
1 1 2 10
2 2 3 0
3 3 4 20
4 4 1 0
5 5 6 0
6 6 7 0
7 7 8 0
8 8 5 0
0
2
1 0.5 0.5 1
2 2 2 2
)";
  const auto input = cover::parse_input(text, ".poly", "two squares");
  if (!input) {
    std::fprintf(stderr, "%s\n", input.error().message.c_str());
    return 1;
  }
  const auto output = cover::cover_mesh(*input);
  if (!output) {
    std::fprintf(stderr, "%s\n", output.error().message.c_str());
    return 1;
  }
  for (const cover::Region& region : output->table.regions) {
    std::printf("region %u: material %d, area %g\n", region.id.value(), region.material,
                region.area);
  }
  for (const cover::Interface& line : output->table.interfaces) {
    std::printf("line %s: length %g, %zu segments\n", line.name.c_str(), line.length,
                line.segments.size());
  }

  // Faces and edges of the OpenMesh structure know where they belong.
  std::size_t on_interface = 0;
  for (const auto edge : output->mesh.tri().edges()) {
    const cover::InterfaceId id = output->mesh.interface(edge);
    if (id == cover::kNoInterface) continue;
    const cover::Interface& line = output->table.interface(id);
    if (line.kind == cover::InterfaceKind::interface) ++on_interface;
  }
  std::printf("edges on the interface: %zu\n", on_interface);

  const auto written = cover::write_vtu(*output, "two_materials.vtu");
  if (!written) std::fprintf(stderr, "%s\n", written.error().message.c_str());
  return written ? 0 : 1;
}
