// Tested by tests/unit/io/read_mesh/read_mesh_test.cpp.
#include "io/read_mesh/second_order.hpp"

namespace cover {

std::vector<std::uint32_t> drop_midpoints(const std::vector<std::uint32_t>& midpoints,
                                          TriangleSoup& soup) {
  std::vector<std::uint8_t> dropped(soup.points.size());
  for (const std::uint32_t p : midpoints) dropped[p] = 1;
  for (const auto& triangle : soup.triangles) {
    for (const std::uint32_t p : triangle) dropped[p] = 0;
  }
  std::vector<std::uint32_t> renumbered(soup.points.size());
  std::uint32_t kept = 0;
  for (std::size_t p = 0; p < renumbered.size(); ++p) {
    renumbered[p] = kept;
    if (dropped[p] == 0) soup.points[kept++] = soup.points[p];
  }
  soup.points.resize(kept);
  for (auto& triangle : soup.triangles) {
    for (std::uint32_t& p : triangle) p = renumbered[p];
  }
  return renumbered;
}

void drop_values(const std::vector<std::uint32_t>& renumbered, std::size_t kept,
                 std::vector<double>& values) {
  // A point that is left out has the number of the next one that is kept, whose value comes later.
  for (std::size_t p = 0; p < values.size(); ++p) values[renumbered[p]] = values[p];
  values.resize(kept);
}

}  // namespace cover
