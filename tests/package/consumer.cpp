// What a user of the installed library writes: two materials in, a mesh and a file out.
#include <cstdio>
#include <fstream>

#include <cover/cover_mesh.hpp>
#ifdef WITH_dxf
#include <cover/read_dxf.hpp>
#endif
#ifdef WITH_gdal
#include <cover/read_gdal.hpp>
#endif
#include <cover/version.hpp>
#include <cover/write_mesh.hpp>

namespace {

/// Whether the readers that are there read.
bool readers_work() {
#ifdef WITH_dxf
  const char* const drawing =
      "0\nSECTION\n2\nENTITIES\n0\nCIRCLE\n8\niron\n10\n0\n20\n0\n40\n1\n0\nENDSEC\n0\nEOF\n";
  if (!cover::parse_dxf(drawing, "a.dxf")) return false;
#endif
#ifdef WITH_gdal
  std::ofstream("map.geojson")
      << R"({"type": "Polygon", "coordinates": [[[0, 0], [1, 0], [0, 1], [0, 0]]]})";
  const auto map = cover::read_gdal("map.geojson");
  if (!map) std::fprintf(stderr, "%s\n", map.error().message.c_str());
  if (!map || map->polygons.size() != 1) return false;
#endif
  return true;
}

}  // namespace

int main() {
  cover::Input input;
  input.points = {{0, 0}, {1, 0}, {2, 0}, {2, 1}, {1, 1}, {0, 1}};
  for (const auto [a, b] :
       {std::pair{0U, 1U}, {1U, 2U}, {2U, 3U}, {3U, 4U}, {4U, 5U}, {5U, 0U}, {1U, 4U}}) {
    input.segments.push_back({a, b, 0, 0, 0, ""});
  }
  const auto output = cover::cover_mesh(input);
  if (!output) {
    std::fprintf(stderr, "%s\n", output.error().message.c_str());
    return 1;
  }
  const bool written = cover::write_vtu(*output, "consumer.vtu").has_value();
  std::printf("cover %s: %zu regions\n", COVER_VERSION, output->table.regions.size());
  return written && readers_work() && output->table.regions.size() == 2 ? 0 : 1;
}
