// A mesh as the text formats want it: points, triangles, lines, and groups with names and tags.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include <cover/angle.hpp>
#include <cover/output.hpp>
#include <cover/pslg.hpp>
#include <cover/write_mesh.hpp>

namespace cover {

/// Cells with the same number of nodes.
struct Cells {
  std::size_t nodes_each = 0;
  std::vector<std::uint32_t> nodes;  ///< indices into MeshView::points

  [[nodiscard]] std::size_t size() const { return nodes.size() / nodes_each; }
  /// Corners; then, in second-order cells, the middle node of each edge, from that of the first two
  /// corners on: see curved_mesh().
  [[nodiscard]] std::span<const std::uint32_t> operator[](std::size_t k) const {
    return std::span(nodes).subspan(k * nodes_each, nodes_each);
  }
};

/// A named set of regions, of lines or of points: a physical group, an element set, ...
struct Group {
  std::string name;      ///< safe form of the original, unique among sets of its sort
  std::string label;     ///< legible form, likewise unique: for formats that bear UTF-8
  std::string original;  ///< as the input has it
  int tag = 0;           ///< positive, unique over regions, lines and points
  int material = 0;      ///< of all its regions; 0 for lines and points
  /// Lines that the input does not name, called after the regions beside them or "hull". Where such
  /// a name is also one that the input gives, it is this one that changes.
  bool is_made_up = false;
};

/// Lines that are images of each other by one rule.
struct PeriodicLines {
  Isometry map;
  /// Indices of a line and its image.
  std::vector<std::array<std::uint32_t, 2>> lines;
  /// By pair of lines: corners of the first and of the second one that are images of each other, in
  /// the order of the first one.
  std::vector<std::array<std::array<std::uint32_t, 2>, 2>> corners;
};

/// The mesh of a run, ready to be written.
///
/// Regions of equal name and material are one group; tags count from 1 in the order of region ids.
/// With WriteOptions::ids, each region is a group whose tag is its id, or each material is one
/// whose tag is its number. Line groups follow, with the tags that are left: contacts by name;
/// lines with a boundary marker by that, which is then their name; all others by the groups that
/// they separate. On the left of a line is its lower region that is not the void. Tags are the same
/// whichever lines are left out. Points that the input names come last, a group for each name.
struct MeshView {
  std::size_t corners = 0;       ///< points that are vertices of the mesh; the others are midpoints
  std::vector<Point> points;     ///< in the order of the mesh
  std::size_t cut_vertices = 0;  ///< that the run put on segments of the input, if that is known

  Cells triangles;                          ///< in the order of the mesh
  std::vector<RegionId> region;             ///< by triangle
  std::vector<int> material;                ///< by triangle
  std::vector<std::uint32_t> region_group;  ///< by RegionId - 1
  std::vector<Group> region_groups;
  bool has_ids = false;  ///< WriteOptions::ids is set

  Cells lines;                            ///< by group, then by interface
  std::vector<InterfaceId> interface;     ///< by line; kNoInterface: of the hull
  std::vector<std::uint32_t> line_group;  ///< by line
  std::vector<std::uint8_t> inner;        ///< by line: a triangle on both sides
  std::vector<int> marker;                ///< by line: boundary marker of the input
  std::vector<Group> line_groups;         ///< also those whose lines are all left out

  std::vector<std::uint32_t> named;        ///< points that the input names, by group
  std::vector<std::uint32_t> named_group;  ///< by these
  std::vector<Group> point_groups;

  std::vector<PeriodicLines> periodic;  ///< by rule, without lines that are left out
  /// By point: the smallest point that it is joined to by periodic sides; empty where there are
  /// none.
  std::vector<std::uint32_t> periodic_node;

  /// RegionTable::attributes, by RegionId - 1, and Output::fields, by point, in the middle of an
  /// edge the mean of its ends, also in each region. Names are legible, without '/', all different
  /// and none of ours.
  std::vector<Attribute> attributes;
  std::vector<PlaneField::Array> fields;
  RegionValues region_values;  ///< of `fields`, as Output::region_values

  [[nodiscard]] bool second_order() const { return triangles.nodes_each == 6; }
  [[nodiscard]] const Group& group_of_triangle(std::size_t t) const {
    return region_groups[region_group[place_of(region[t])]];
  }
  /// The number of a triangle for solvers that know one alone: its material, or with
  /// WriteOptions::ids the tag of its group.
  [[nodiscard]] int number_of_triangle(std::size_t t) const {
    return has_ids ? group_of_triangle(t).tag : material[t];
  }
  [[nodiscard]] const Group& group_of_line(std::size_t l) const {
    return line_groups[line_group[l]];
  }
};

/// The view of `output` that `options` ask for. Only the mesh, the table of regions and interfaces,
/// names of points and periodic sides are looked at.
///
/// Cost: O(n log n) in the number of lines, linear in all else.
MeshView view_of(const Output& output, const WriteOptions& options);

/// The points that the input names, with their numbers in the mesh instead of the PSLG: those that
/// are in it, in the order of the input.
std::vector<NamedPoint> named_points_of(const Output& output);

/// The same without lines and named points and their groups, for formats that hold none.
///
/// Cost: linear
MeshView view_of_triangles(const Output& output, const WriteOptions& options);

/// The angles of triangle t, by corner. Second-order triangles count as straight.
std::array<Angle, 3> angles_of(const MeshView& view, std::size_t t);

/// An edge of a mesh on an interface or on the hull.
struct LineEdge {
  std::uint64_t order = 0;  ///< in which a mesh has its edges
  std::uint32_t group = 0;  ///< set by view_of_lines()
  InterfaceId interface;    ///< kNoInterface: of the hull
  int marker = 0;
  std::uint32_t from = 0;  ///< with the region on its left that the interface names so
  std::uint32_t to = 0;
  bool is_inner = false;  ///< a triangle on both sides
};

/// A view of groups, lines and named points alone, for a mesh that is not in memory: no places and
/// no triangles. `named`: with the numbers of the points in the mesh.
///
/// REQUIRES: triangles of first order
/// Cost:     O(n log n) in the number of lines
MeshView view_of_lines(const RegionTable& table, std::vector<LineEdge> lines,
                       const WriteOptions& options, std::span<const NamedPoint> named = {});

/// The set of all nodes in an input deck of Abaqus.
inline constexpr const char* kAllNodes = "NALL";

/// What the groups of regions, or those of node_sets(), are called as sets of Abaqus: in capitals,
/// beginning with a letter, at most 80 characters, unique among the groups given, none of them
/// kAllNodes.
std::vector<std::string> abaqus_names(const std::vector<Group>& groups);

/// The groups of lines, then those of named points: both are sets of nodes there.
std::vector<Group> node_sets(const MeshView& view);

}  // namespace cover
