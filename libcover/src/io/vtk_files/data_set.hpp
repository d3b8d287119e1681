// A data set of VTK's file formats: points, cells of any type, arrays of both.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <cover/result.hpp>

#include "io/vtk_files/arrays/number_array.hpp"

namespace cover {

/// VTK's numbers of the types of cells that are known here.
namespace cell_type {
inline constexpr int kEmpty = 0, kVertex = 1, kPolyVertex = 2, kLine = 3, kPolyLine = 4,
                     kTriangle = 5, kTriangleStrip = 6, kPolygon = 7, kPixel = 8, kQuad = 9,
                     kVoxel = 11, kHexahedron = 12, kQuadraticEdge = 21, kQuadraticTriangle = 22,
                     kQuadraticQuad = 23, kBiquadraticQuad = 28, kQuadraticLinearQuad = 30,
                     kBiquadraticTriangle = 34, kQuadraticPolygon = 36, kLagrangeTriangle = 69,
                     kLagrangeQuad = 70, kBezierTriangle = 76, kBezierQuad = 77;
}  // namespace cell_type

/// A data set whose cells have points that are there, and as many as their types need. Its arrays
/// may point into the file's text, and need not fit its points and cells.
class DataSet {
 public:
  using Coordinates = std::array<double, 3>;

  std::vector<NumberArray> point_arrays;
  std::vector<NumberArray> cell_arrays;
  std::size_t cut_vertices = 0;  ///< as MeshFile::cut_vertices

  /// A lattice of equal pixels: their number along x and y, and two opposite corners.
  struct Pixels {
    std::size_t width;
    std::size_t height;
    Coordinates first;
    Coordinates last;
  };

  [[nodiscard]] std::size_t point_count() const {
    return points_.empty() ? lattice_points() : points_.size();
  }
  [[nodiscard]] std::size_t cell_count() const { return types_.size() + lattice_cells_; }
  /// REQUIRES: p < point_count()
  [[nodiscard]] Coordinates point(std::size_t p) const {
    return points_.empty() ? lattice_point(p) : points_[p];
  }
  /// REQUIRES: c < cell_count()
  [[nodiscard]] int type(std::size_t c) const { return types_.empty() ? lattice_type_ : types_[c]; }
  /// The points of a cell; `room` is where those of a lattice are put.
  /// REQUIRES: c < cell_count()
  std::span<const std::uint32_t> nodes(std::size_t c, std::array<std::uint32_t, 8>& room) const {
    if (types_.empty()) return lattice_nodes(c, room);
    return {nodes_.data() + first_[c], first_[c + 1] - first_[c]};
  }

  /// An error where points differ in z; it names no file.
  [[nodiscard]] Status check_plane() const;

  /// The array of that name with one number per point, or per cell; or nullptr.
  [[nodiscard]] const NumberArray* array_of_points(std::string_view name) const;
  [[nodiscard]] const NumberArray* array_of_cells(std::string_view name) const;

  // How readers fill it. Errors name no file: the reader adds it.

  /// Adds points: three coordinates each.
  /// REQUIRES: coordinates.size() is divisible by 3
  Status add_points(const NumberArray& coordinates);
  /// Adds cells between the points from number `first_point` on: cell c has the nodes from
  /// offsets[c] up to offsets[c + 1] of `connectivity`, which are numbers from `first_point` on.
  /// REQUIRES: offsets begins with 0 and has one more than there are types
  Status add_cells(const NumberArray& connectivity, const std::vector<std::size_t>& offsets,
                   std::vector<std::uint8_t> types, std::size_t first_point);
  /// Makes it a lattice of these places on the axes; or, without axes, of `dimensions` points that
  /// add_points() has given.
  /// REQUIRES: check_lattice(dimensions); no cells; as many places or points as `dimensions` says
  void set_lattice(const std::array<std::size_t, 3>& dimensions,
                   std::array<std::vector<double>, 3> axes);
  /// Says that the places on each axis of the lattice are equally far from each other.
  void set_even() { is_even_ = true; }
  /// The cells as pixels, in the order of their rows, where the data set is an even lattice in a
  /// plane z = constant and nothing else.
  [[nodiscard]] std::optional<Pixels> pixels() const;

 private:
  [[nodiscard]] std::size_t lattice_points() const {
    return dimensions_[0] * dimensions_[1] * dimensions_[2];
  }
  [[nodiscard]] Coordinates lattice_point(std::size_t p) const;
  std::span<const std::uint32_t> lattice_nodes(std::size_t c,
                                               std::array<std::uint32_t, 8>& room) const;

  std::vector<Coordinates> points_;
  std::vector<std::size_t> first_{0};  ///< where in `nodes_` each cell begins, and one more
  std::vector<std::uint32_t> nodes_;
  std::vector<std::uint8_t> types_;
  std::array<std::size_t, 3> dimensions_{};  ///< of a lattice, in points
  std::array<std::vector<double>, 3> axes_;
  std::size_t lattice_cells_ = 0;
  int lattice_type_ = cell_type::kEmpty;
  bool is_even_ = false;
};

/// Whether a lattice has points, and no more than a file of so many bytes can have numbers for.
///
/// Errors: syntax, unsupported_format
Status check_lattice(const std::array<std::size_t, 3>& dimensions, std::size_t file_size);

/// Offsets as numbers that do not fall, from 0 on, with 0 in front if `add_zero`.
///
/// Errors: syntax
Result<std::vector<std::size_t>> as_offsets(const NumberArray& numbers, bool add_zero);

/// The numbers of cell types in bytes.
///
/// Errors: syntax
Result<std::vector<std::uint8_t>> as_cell_types(const NumberArray& numbers);

/// Kinds of cells that a surface keeps apart: what a file calls VERTICES, LINES, POLYGONS and
/// TRIANGLE_STRIPS, in the order in which cell arrays have them.
struct SurfaceCells {
  std::string_view keyword;  ///< of legacy files
  const char* element;       ///< of XML
  const char* count;
  std::size_t least;  ///< nodes of a cell
};
inline constexpr std::array kSurfaceCells{
    SurfaceCells{"VERTICES", "Verts", "NumberOfVerts", 1},
    SurfaceCells{"LINES", "Lines", "NumberOfLines", 2},
    SurfaceCells{"POLYGONS", "Polys", "NumberOfPolys", 3},
    SurfaceCells{"TRIANGLE_STRIPS", "Strips", "NumberOfStrips", 3},
};

/// The types of the cells of kSurfaceCells[kind], by their nodes.
///
/// Errors: syntax, where a cell has too few
Result<std::vector<std::uint8_t>> surface_types(std::size_t kind,
                                                const std::vector<std::size_t>& offsets);

/// The arrays that all pieces have, each piece's numbers behind those of the pieces before.
///
/// Cost: O(n log n) in the number of arrays, O(n) in their numbers
std::vector<NumberArray> join_pieces(std::vector<std::vector<NumberArray>> pieces);

}  // namespace cover
