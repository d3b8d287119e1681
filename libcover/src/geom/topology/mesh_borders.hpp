// From a mesh with materials to the lines between them: how a mesh of another tool is remeshed.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <cover/input.hpp>
#include <cover/point.hpp>

namespace cover {

/// A plane mesh as a file gives it: cells are polygons with any number of corners.
struct CellMesh {
  /// A side of cells, or any other pair of points, that must stay.
  struct Line {
    std::uint32_t a = 0;  ///< index into points
    std::uint32_t b = 0;
    std::string name;  ///< empty if none
    int marker = 0;
    long id = 0;
  };

  std::string source;  ///< file name for messages
  std::vector<Point> points;
  std::vector<long> point_ids;         ///< as the file numbers them
  std::vector<std::uint32_t> corners;  ///< of all cells, one after the other
  std::vector<std::size_t> first{0};   ///< where in `corners` each cell begins; one more than cells
  std::vector<std::uint32_t> material;  ///< by cell, index into `materials`
  std::vector<std::string> materials;
  std::vector<Line> lines;
  std::vector<std::uint32_t> kept;  ///< points that must stay, on lines or not
  std::vector<PointName> names;     ///< of kept points

  [[nodiscard]] std::size_t cells() const { return first.size() - 1; }
  void add_cell(const std::vector<std::uint32_t>& cell, std::uint32_t cell_material);
};

/// The PSLG of all sides between different materials or with a cell on one side only, and of the
/// mesh's lines; with a seed in each connected piece of one material. What no cell covers is void.
/// A mesh without cells gives its lines alone, and every face they enclose is meshed.
///
/// Points at the same place are one, cells with the same corners too (the first counts); the
/// input's warnings say so. All other points inside materials are left out.
/// REQUIRES: indices in range; coordinates finite
/// EXACT:    only identity of coordinates decides
/// Cost:     O(n log n)
Input borders_of(const CellMesh& mesh);

}  // namespace cover
