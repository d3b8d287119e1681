// gmsh's .msh as it stands in the file; what it means is said by who asks.
#pragma once

#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <cover/plane_field.hpp>
#include <cover/point.hpp>
#include <cover/result.hpp>

namespace cover {

/// A point, line, triangle or quadrangle, of whatever order.
struct MshElement {
  long id = 0;
  int dimension = 0;
  long physical = 0;           ///< number of the physical group; 0: none
  long entity = 0;             ///< number of the elementary entity
  std::size_t first_node = 0;  ///< index into MshFile::nodes
  std::uint32_t corners = 0;
  std::uint32_t nodes = 0;
};

/// Nodes, elements and physical groups.
struct MshFile {
  bool has_entities = false;  ///< elements have elementary entities of their own (version 2)
  std::vector<Point> points;
  std::vector<long> point_ids;
  std::vector<std::uint32_t> nodes;  ///< of all elements, corners first; indices into points
  std::vector<MshElement> elements;
  std::map<std::pair<long, long>, std::string> names;  ///< of groups, by dimension and number
  /// Numbers that stand at all nodes, or at all elements: by point, by element.
  std::vector<PlaneField::Array> point_arrays;
  std::vector<PlaneField::Array> element_arrays;
  bool has_periodic_points = false;
  std::size_t parts = 0;  ///< of a mesh, of which this is one; 0: it is whole, or binary
  std::size_t in_several_groups = 0;  ///< groups left out: entities have the first one they are in

  [[nodiscard]] std::span<const std::uint32_t> nodes_of(const MshElement& element) const {
    return std::span(nodes).subspan(element.first_node, element.nodes);
  }
};

/// Reads versions 2.x and 4.1, ASCII or binary. Elements are those of a plane mesh, in one plane.
///
/// Errors: syntax, truncated, id_out_of_range, non_finite_coordinate, unsupported_format, with line
/// Ref:    gmsh reference manual, chapter "MSH file format"
Result<MshFile> parse_msh_file(std::string_view text, const std::string& source);

}  // namespace cover
