// Reading meshes back: triangles of any tool, and all that cover wrote.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include <cover/output.hpp>
#include <cover/periodic.hpp>
#include <cover/plane_field.hpp>
#include <cover/point.hpp>
#include <cover/pslg.hpp>
#include <cover/result.hpp>
#include <cover/triangle_soup.hpp>

namespace cover {

/// Values of one triangle each.
struct CellArray {
  std::string name;
  std::vector<double> values;
};

/// A line cell, as one edge.
struct MeshLine {
  std::uint32_t a = 0;  ///< index into TriangleSoup::points
  std::uint32_t b = 0;
  std::int64_t group = 0;  ///< number of its group, reference or marker in the file
  int marker = 0;          ///< boundary marker of the input
};

/// What a mesh file holds, as far as triangles and lines go.
struct MeshFile {
  TriangleSoup soup;                ///< without materials where the format has groups alone
  std::vector<CellArray> arrays;    ///< VTK, .msh, .xdmf: every cell array of one number each
  std::vector<MeshLine> lines;      ///< not of .vtu
  std::vector<std::int64_t> group;  ///< per triangle: its physical group or element set; else empty
  std::map<std::int64_t, std::string> region_names;  ///< of groups, or of materials
  std::map<std::int64_t, std::string> line_names;    ///< of groups of lines
  std::vector<NamedPoint> named_points;              ///< .msh, .vtm, .vtkhdf; numbers of `soup`
  bool second_order = false;  ///< triangles had six nodes; their corners were taken
  /// By triangle, where all have six nodes: the middle nodes, from that of the first edge on.
  std::vector<std::array<Point, 3>> middles{};
  /// Vertices that the run which wrote it put on segments of its input; 0 where that is not known:
  /// only a .vtu tells.
  std::size_t cut_vertices = 0;
  /// .msh: it is one of so many files of a mesh for several processes, and holds copies of
  /// triangles of others; else 0.
  std::size_t parts = 0;
  /// VTK, .msh: points are paired on periodic sides. Which sides these are, a .msh alone tells.
  bool has_periodic_points = false;
  std::vector<PeriodicNodes> periodic{};  ///< .msh: empty too where it is not as cover writes it
  /// VTK, .msh, .xdmf: numbers at points, as they are in `soup`; of a .vtm or .xdmf without those
  /// that every mesh of ours has.
  std::vector<PlaneField::Array> point_arrays{};
};

/// Reads the triangles of a mesh, and its lines: .vtu, .pvtu, cover's .vtm, legacy .vtk, .vtkhdf,
/// gmsh's .msh, .xdmf, Medit's .mesh, Abaqus' .inp, Triangle's .ele. Other cells are left out. Of
/// triangles with six nodes the corners are taken, and points that are nothing else are left out.
///
/// Of VTK's cell arrays region is RegionId, material the first of material, MaterialID, mat_id,
/// gmsh:physical, medit:ref, and the group of lines LineID.
/// Errors: cannot_open, syntax, truncated, id_out_of_range, non_finite_coordinate,
///         unsupported_format
Result<MeshFile> read_mesh(const std::string& path);

/// Reads a mesh that cover wrote, in any format of read_mesh(), as what cover_mesh() returned, as
/// far as files keep it; see rebuild(). A .vtkhdf holds all but arcs and periodic sides, which the
/// manifest (.json) beside it tells; one of another mesh is told in a note, as a .vtm of another
/// mesh is. Else names, interfaces and markers come from the manifest beside it, else from the .vtm
/// beside it, else from the file itself. So do attributes of regions and values at points, words of
/// attributes not from a lone .vtu, .msh or .xdmf. What is missing then is said in the report's
/// notes, and that nodes in the middle of edges, where some triangles have none, or pairs of
/// periodic sides that neither a manifest nor a .msh tells, were left out.
///
/// No file keeps the ids of points: Pslg::point_ids are places in the mesh, and -1 where the run
/// put a vertex on a segment, as far as the file or the manifest tells.
///
/// Errors: those of read_mesh(); syntax also where the manifest is of another mesh.
Result<Output> read_output(const std::string& path);

/// The extensions that read_mesh() knows, each with its dot.
std::vector<std::string> mesh_formats();

}  // namespace cover
