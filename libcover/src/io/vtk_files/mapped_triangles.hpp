// Triangles of a file that need not fit into memory.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include <cover/point.hpp>

#include "io/files/mapped_file.hpp"
#include "io/vtk_files/arrays/number_array.hpp"

namespace cover {

/// The arrays of a .vtu or .vtkhdf as they lie in the file.
struct MappedTriangles {
  MappedFile file;
  std::size_t points = 0, triangles = 0;
  NumberView<double> places{nullptr, 0};         ///< three coordinates each
  NumberView<std::int64_t> corners{nullptr, 0};  ///< three for each triangle; may be any number
  NumberView<std::int32_t> region{nullptr, 0};   ///< RegionId, by triangle
  NumberView<std::int32_t> material{nullptr, 0};

  /// REQUIRES: p < points
  [[nodiscard]] Point place(std::size_t p) const { return {places[3 * p], places[3 * p + 1]}; }
};

/// The triangles of a file as cover writes it: of first order, in one piece, with arrays of plain
/// numbers, RegionId and material among them. Nothing where it is otherwise, or broken: then
/// read_mesh() tells.
///
/// Cost: O(n); memory for names alone
std::optional<MappedTriangles> map_triangles(const std::string& path);

}  // namespace cover
