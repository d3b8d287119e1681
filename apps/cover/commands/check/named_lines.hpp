// Contacts of the input, compared with the lines of a mesh that have their names.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include <cover/point.hpp>

#include "commands/check/cut_input.hpp"
#include "files/mesh_file.hpp"

namespace cover::app {

/// A named line whose edges in the mesh are not those of the input.
struct WrongLine {
  std::string name;
  std::size_t edges = 0;                          ///< of the input, as the mesh cuts it
  std::size_t missing = 0;                        ///< of these, not there under the name
  std::size_t foreign = 0;                        ///< there under the name, but not of the line
  std::vector<Point> missing_at{}, foreign_at{};  ///< the ends of the first one
};

/// What is found on the lines that the input names.
struct NamedLines {
  std::vector<WrongLine> wrong;        ///< in the order of the input's names
  std::vector<std::string> unchecked;  ///< what the mesh cannot tell
};

/// Whether the input names lines that the mesh should have.
bool has_named_lines(const Pslg& pslg, const RegionTable& table);

/// What there is to say of a mesh whose lines are not looked at.
NamedLines lines_not_checked(const Pslg& pslg, const RegionTable& table);

/// Compares named lines with the edges that have their names in the mesh, where it names lines at
/// all. If it has no lines between triangles, for which --no-inner-lines may be the reason, only
/// those on the outside are looked at.
///
/// REQUIRES: `cut` is the input as the mesh cuts it
/// Cost:     O(n log n)
NamedLines check_named_lines(const CutInput& cut, const MeshTriangles& mesh);

}  // namespace cover::app
