// Writing results. Every file is written to a temporary name in its folder, brought to the disk and
// renamed: whatever happens, a name stands for the whole old file or the whole new one. Symbolic
// links stay, and a file that is replaced hands its permissions on. What a killed run has left
// behind is removed when its file is written again.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <cover/output.hpp>
#include <cover/result.hpp>
#include <cover/write_options.hpp>

namespace cover {

/// Writes `output` in the format that the extension of `path` names. See write_formats().
///
/// Errors: those of can_write(); cannot_write, also where `output` has no triangles (those of a
///         streamed mesh stand on the disk, see write_streamed_mesh(), and those of an output that
///         was moved from elsewhere) unless the format is .poly and it has input; cancelled
Status write_mesh(const Output& output, const std::string& path, const WriteOptions& options = {});

/// Tells before the work whether write_mesh() knows the format and the format has what is asked
/// for.
///
/// Errors: unsupported_format, bad_option
Status can_write(const std::string& path, const WriteOptions& options = {});

/// The same of a mesh with periodic sides, where can_write() is right: they have no place in the
/// parts of a .msh.
///
/// Errors: bad_option
Status can_write_periodic(const std::string& path, const WriteOptions& options = {});

/// Whether write_mesh() makes more than one file of it: .vtm, .pvtu and .ele, .xdmf with HDF5 and
/// whatever has parts. Such a mesh cannot go into a pipe.
bool is_several_files(const std::string& path, const WriteOptions& options = {});

/// The extensions that write_mesh() knows, each with its dot.
std::vector<std::string> write_formats();

/// Those of write_formats() that hold RegionTable::attributes.
std::vector<std::string> attribute_formats();

/// Those of these that hold the words of text; others number them.
std::vector<std::string> word_formats();

/// Those of write_formats() that hold Output::fields.
std::vector<std::string> value_formats();

/// Those of write_formats() that hold Output::periodic.
std::vector<std::string> periodic_formats();

/// Those of write_formats() that hold Pslg::named_points, by name or as numbers of groups: .msh not
/// in parts.
std::vector<std::string> point_formats(const WriteOptions& options = {});

/// The different ones of `names`, the first ten and how many more there are.
std::vector<std::string> first_of_all(const std::vector<std::string>& names);

/// "names of points (a, b) are not in x.msh: formats that hold them are .vtu, .vtm", of what each
/// of `files` lacks; empty where there are no names or no files.
std::string not_held(std::string_view what, const std::vector<std::string>& names,
                     const std::vector<std::string>& files,
                     const std::vector<std::string>& formats);

/// Those of write_formats() in which solvers find regions and lines by the numbers of groups.
std::vector<std::string> number_formats();

/// The other files, or folders, that a mesh written to `path` always brings: .node and .edge of an
/// .ele, the folder of a .vtm or .pvtu.
std::vector<std::string> companions_of(const std::string& path);

/// What write_mesh() says of a name by whose extension it knows no format, where `known` are those
/// that the caller writes.
Error unknown_output_format(const std::string& path, std::span<const std::string> known);

// The writers of single formats ask what can_write() asks of theirs, whatever the extension of
// `path` is: that is their bad_option. As write_mesh(), they cannot write without triangles.

/// Writes VTK's XML unstructured grid: triangles only, float64 points, raw appended data; cell
/// arrays material (first, for MFEM), MaterialID, mat_id, RegionId (Int32), max_angle and min_angle
/// in degrees; then RegionTable::attributes by their names, numbers as Float64, text as Int32,
/// whose meaning stands in the manifest; Output::fields are point arrays. A name that is taken gets
/// a number behind it. Where the run put vertices on segments, field data CutVertices is their
/// number.
///
/// Errors: bad_option, cannot_write, cancelled
Status write_vtu(const Output& output, const std::string& path, const WriteOptions& options = {});

/// Writes VTK's format in HDF5 (VTKHDF 1.0, an unstructured grid of one piece): the triangles and
/// cell arrays of write_vtu(), and as field data the names of regions, materials and lines, the
/// edges of all lines, named points, the words of attributes X as X_names, and where the mesh comes
/// from. So one file holds all that read_output() wants, but for arcs and periodic sides, which the
/// manifest tells.
///
/// Errors: bad_option, cannot_write, cancelled
Status write_vtkhdf(const Output& output, const std::string& path,
                    const WriteOptions& options = {});

/// Writes a grid in WriteOptions::parts parts, each for a process that is to start with it: the
/// arrays of write_vtu(), and of points and triangles ids in the whole mesh (GlobalNodeId,
/// GlobalCellId), the part that owns them (Owner) and vtkGhostType, 1 for those of other parts.
/// Behind its own triangles a part has one layer of ghosts: those that share a vertex with them.
/// Regions stay in one part where they have not too many triangles. The pieces of X.pvtu are
/// X.parts/X.parts_K_HASH.vtu, and are replaced as those of write_vtm().
///
/// Errors: bad_option, cannot_write, cancelled
Status write_pvtu(const Output& output, const std::string& path, const WriteOptions& options = {});

/// Writes a multi-block file with a named .vtu per group of regions and per group of lines beside
/// it: the groups are those of the physical groups of .msh, so one name is one block. Where more
/// than a hundred groups of lines are, those between regions are one block, `lines`. Lines between
/// two triangles are always there. Names of materials and of lines, words of attributes, and where
/// the mesh comes from, stand in the .vtm behind the blocks. The pieces of X.vtm are
/// X/X_K_HASH.vtu, with the hash of their content; those of an X.vtm that is replaced are removed.
///
/// Errors: bad_option, cannot_write, cancelled
Status write_vtm(const Output& output, const std::string& path, const WriteOptions& options = {});

/// Writes the clean PSLG as Triangle's .poly, 17 digits, with region and hole seeds. Segments of
/// named lines that have no marker get a number that is no marker, one for each name; comments tell
/// names.
///
/// Errors: cannot_write, cancelled
Status write_poly(const Pslg& pslg, const RegionTable& table, const std::string& path,
                  const WriteOptions& options = {});

/// The report as JSON text.
std::string report_json(const Output& output);

/// What is known before there is a mesh.
std::string report_json(const Prepared& prepared);

/// Writes the report as JSON.
///
/// Errors: cannot_write
Status write_report_json(const Output& output, const std::string& path);

// Formats in text. Doubles are written so that they read back bit for bit. Numbers of lines and, in
// .msh and with WriteOptions::ids, of regions are those of the physical groups in the manifest.
// Names in .msh and .xdmf are in UTF-8, with `_` for control characters and double quotes; in .vtk,
// .inp and .obj everything but ASCII letters, digits and `_ . -` is replaced by `_`. All names of a
// kind are different; the manifest has both, and those as they were.

/// Writes VTK's legacy format, version 3.0: cell arrays MaterialID, material, mat_id, RegionId.
/// With options.lines: triangles, then lines; MaterialID (on inner lines -1), ManifoldID (the
/// number of an inner line, else -1), LineID, RegionId. With options.ids, these are in MaterialID
/// and mat_id, and there is always a `material`. Fields are data of points.
///
/// Errors: bad_option, cannot_write, cancelled
Status write_vtk(const Output& output, const std::string& path, const WriteOptions& options = {});

/// Writes gmsh's format. Physical groups: regions by name, interfaces by the regions on both sides
/// with the lower one on the left, contacts and named points by name. Elementary tags in version
/// 2.2: RegionId and InterfaceId, or a further number where an interface lies in several groups; in
/// 4.1 those of the groups. Attributes and fields are data of elements and nodes, as the arrays of
/// write_vtu(). With options.parts, X_1.msh, X_2.msh, ... of version 4.1 have a part each, as
/// write_pvtu() divides the mesh, in entities of its own ($PartitionedEntities), with ghosts
/// ($GhostElements); nodes and elements have the numbers that they have in the file of the whole
/// mesh, and lines between parts are in both; named points are in none. All files are on the disk
/// before the first of them appears.
///
/// Errors: bad_option, also for periodic sides in parts; cannot_write, cancelled
Status write_msh(const Output& output, const std::string& path, const WriteOptions& options = {});

/// Writes XDMF: grids `mesh` (MaterialID, RegionId, GroupID, attributes and fields as write_vtu())
/// and `lines` (LineID, Marker), with all numbers in the XML, or with options.xdmf `hdf5` in X.h5
/// beside X.xdmf, for large meshes. With options.ids, GroupID comes first: dolfinx takes that.
///
/// Errors: bad_option, cannot_write, cancelled
Status write_xdmf(const Output& output, const std::string& path, const WriteOptions& options = {});

/// Writes Medit's format; references are materials, or with options.ids these, and the numbers of
/// lines and of named points, for a point with several names the last one.
///
/// Errors: bad_option, cannot_write, cancelled
Status write_medit(const Output& output, const std::string& path, const WriteOptions& options = {});

/// Writes an Abaqus input deck: an ELSET per region group, an NSET per group of lines or named
/// points. Coordinates have at most 20 characters, as Abaqus and CalculiX want it; those that need
/// more are rounded.
///
/// Errors: bad_option; cannot_write, with places, also where that flattens triangles or turns them
///         over; cancelled
Status write_inp(const Output& output, const std::string& path, const WriteOptions& options = {});

/// How many points write_inp() moves by that; midpoints of second-order edges count.
///
/// Cost: linear
std::size_t points_rounded_by_inp(const Output& output, const WriteOptions& options = {});
/// How many points lie on the wrong side of the axis, x = 0, if elements are axisymmetric (CAX):
/// solvers refuse these.
///
/// Cost: linear
std::size_t points_beyond_axis(const Output& output, const WriteOptions& options);
/// What readers of an .inp of write_inp() see of a point.
Point rounded_by_inp(Point p);

/// Writes Triangle's files `path` with the extensions .node (with the markers of the input's points
/// if it has any), .ele (attributes material and RegionId; with options.ids these, RegionId,
/// material) and .edge (lines with the boundary markers of the input; with the numbers of lines if
/// it has none).
///
/// Errors: bad_option, cannot_write, cancelled
Status write_triangle(const Output& output, const std::string& path,
                      const WriteOptions& options = {});

/// Writes Wavefront's .obj with a group per region group, lines as elements of their own.
///
/// Errors: bad_option, cannot_write, cancelled
Status write_obj(const Output& output, const std::string& path, const WriteOptions& options = {});

/// Writes Geomview's .off.
///
/// Errors: bad_option, cannot_write, cancelled
Status write_off(const Output& output, const std::string& path, const WriteOptions& options = {});

/// Writes Stanford's .ply, in text, with face properties material and region.
///
/// Errors: bad_option, cannot_write, cancelled
Status write_ply(const Output& output, const std::string& path, const WriteOptions& options = {});

/// Writes the manifest: what the mesh files cannot hold. Names as the input has them and as the
/// files have them, numbers of groups, the edges of every line, counts, quality.
///
/// Errors: bad_option, cannot_write, cancelled
Status write_manifest(const Output& output, const std::string& path,
                      const WriteOptions& options = {});

}  // namespace cover
