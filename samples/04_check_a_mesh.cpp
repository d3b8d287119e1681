// The checker on its own: it takes plain arrays, so any mesh from any tool can be put to it.
#include <cover/cover_mesh.hpp>
#include <cover/verify.hpp>

#include <cstdio>

int main() {
  cover::Input input;
  input.points = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  for (std::uint32_t i = 0; i < 4; ++i) input.segments.push_back({.a = i, .b = (i + 1) % 4});
  const auto prepared = cover::prepare(input);
  if (!prepared) return 1;

  cover::TriangleSoup mesh;
  mesh.points = input.points;
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  mesh.region = {1, 1};
  const auto good = cover::verify_cover(prepared->pslg, prepared->table, mesh);
  std::printf("two triangles: %zu violations\n", good.violation_count);

  mesh.points.push_back({0.5, 0});  // a vertex on the lower side, which is thereby split
  mesh.triangles = {{0, 4, 3}, {4, 1, 2}, {4, 2, 3}};
  mesh.region = {1, 1, 1};
  const auto bad = cover::verify_cover(prepared->pslg, prepared->table, mesh);
  for (const cover::Violation& violation : bad.violations) {
    std::printf("promise %d: %s\n", violation.promise, violation.message.c_str());
  }
  return good.violation_count == 0 && bad.violation_count > 0 ? 0 : 1;
}
