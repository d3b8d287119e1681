// What the tests of writers share: a mesh with everything that a format can get wrong, and the
// comparison of a mesh with what a parser took out of a file.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include <cover/cover_mesh.hpp>

namespace cover::testing {

/// Two squares that share a partly named border, a square beside them of the same name but another
/// material, one that touches only in a corner, a void, a slit, an isolated point, contacts over
/// one and two regions; coordinates that need 17 digits; names with slashes, quotes, blanks and
/// letters outside ASCII.
Output odd_device();

/// A structured mesh of 2 * columns * rows triangles, left half region 1 and right half region 2,
/// made without the mesher.
/// REQUIRES: columns is even
Output structured_mesh(int columns, int rows);

/// A cell of a file.
struct WrittenCell {
  std::vector<std::uint32_t> nodes;  ///< indices from 0: corners, then midpoints
  long number = 0;                   ///< physical group, material or number of the line
  long entity = 0;                   ///< elementary tag or RegionId; 0 if the format has none
};

/// A mesh as a test's own parser found it.
struct WrittenMesh {
  std::vector<Point> points;
  std::vector<WrittenCell> triangles;
  std::vector<WrittenCell> lines;
  std::map<long, std::string> region_names;  ///< by number; empty: the format has none
  std::map<long, std::string> line_names;    ///< by number; empty: the format has none
  bool names_are_utf8 = false;               ///< else letters that any program takes
};

/// What a WrittenMesh is compared with.
struct Expected {
  int order = 1;
  bool inner_lines = true;
  bool outer_lines = true;
};

/// Coordinates bit for bit and the nodes of all triangles, in order.
void expect_same_triangles(const Output& output, const WrittenMesh& file, int order = 1);

/// The same without an order: for formats that sort elements into sets.
void expect_same_triangles_unordered(const Output& output, const WrittenMesh& file, int order = 1);

/// Lines with their direction; one number for each name and pair of materials, and no number for
/// two.
void expect_same_lines(const Output& output, const WrittenMesh& file,
                       const Expected& expected = {});

/// Numbers of triangles are materials.
void expect_materials(const Output& output, const WrittenMesh& file);

/// Numbers of triangles tell regions apart by name and material; names are the safe forms of the
/// input's.
void expect_region_groups(const Output& output, const WrittenMesh& file);

}  // namespace cover::testing
