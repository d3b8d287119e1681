// Puts a MeshFile together from the cells of a file.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include <cover/read_mesh.hpp>

namespace cover {

/// Takes cells of first and second order, and keeps their corners.
class MeshCollector {
 public:
  MeshFile mesh;

  /// Three nodes, or six with the midpoints last.
  /// REQUIRES: at least three
  void add_triangle(std::span<const std::uint32_t> nodes) {
    mesh.soup.triangles.push_back({nodes[0], nodes[1], nodes[2]});
    midpoints_.insert(midpoints_.end(), nodes.begin() + 3, nodes.end());
    if (nodes.size() == 6) middles_.push_back({nodes[3], nodes[4], nodes[5]});
  }
  /// Two nodes, or three with the midpoint last.
  /// REQUIRES: at least two
  void add_line(std::span<const std::uint32_t> nodes, std::int64_t group, int marker = 0) {
    mesh.lines.push_back({nodes[0], nodes[1], group, marker});
    midpoints_.insert(midpoints_.end(), nodes.begin() + 2, nodes.end());
  }

  /// The mesh without the points that are midpoints alone.
  /// REQUIRES: indices of nodes in range
  MeshFile finish();

 private:
  /// After midpoints were left out, and names on them with these. `places`: of the points before.
  void rename_points(const std::vector<Point>& places,
                     const std::vector<std::uint32_t>& renumbered);

  std::vector<std::uint32_t> midpoints_;
  std::vector<std::array<std::uint32_t, 3>> middles_;  ///< of triangles with six nodes
};

}  // namespace cover
