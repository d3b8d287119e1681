// Puts a MeshFile together from the cells of a file.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include <cover/read_mesh.hpp>

namespace cover {

/// Nodes that share a name.
struct NodeSet {
  std::string name;
  std::vector<std::uint32_t> nodes;
};

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

  /// Points of sets without two that an edge joins, as those of lines are, are called by their
  /// names. Of points in several sets the first counts; a set without a name is left out.
  /// REQUIRES: indices of nodes in range; all triangles are there
  void name_points_apart(std::span<const NodeSet> sets);

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
