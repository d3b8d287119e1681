// One function per mesh format that is read from text; read_mesh() chooses among them.
//
// All of them: `source` is the file's name for messages.
// Errors: syntax, truncated, id_out_of_range, non_finite_coordinate, unsupported_format, with line.
// Cost: O(n log n) in the length of the text, whatever numbers stand in it.
#pragma once

#include <string>
#include <string_view>

#include <cover/read_mesh.hpp>
#include <cover/result.hpp>

namespace cover {

/// gmsh's .msh 2.2 and 4.1, text or binary; of a binary one without numbers at nodes and elements
/// and without word of parts. Groups are physical groups. In version 2.2 regions are
/// elementary entities, as write_msh() has them.
Result<MeshFile> parse_msh_mesh(std::string_view text, const std::string& source);

/// Medit's .mesh. References are materials, and the groups of lines.
Result<MeshFile> parse_medit(std::string_view text, const std::string& source);

/// An Abaqus deck: nodes and triangles; each element set is a group, numbered as they come up.
/// Triangles come in the order of their numbers. Surfaces are groups of lines: sides S1 to S3 of
/// triangles. Node sets are not read: they do not tell edges.
Result<MeshFile> parse_inp(std::string_view text, const std::string& source);

/// XDMF with all numbers in the XML, as write_xdmf() has it: the grid `mesh` with its attributes
/// MaterialID, RegionId and GroupID, and the grid `lines` with LineID and Marker.
Result<MeshFile> parse_xdmf(std::string_view text, const std::string& source);

/// Triangle's .ele, with the .node and, if it is there, the .edge beside it. The first attribute is
/// the material, the second the region; of three the last is the material; boundary markers of
/// edges are the groups of lines.
Result<MeshFile> read_triangle(const std::string& path);

}  // namespace cover
