// Reading geometry files.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <cover/input.hpp>
#include <cover/read_options.hpp>
#include <cover/result.hpp>

namespace cover {

/// Reads a geometry file; the format follows from its extension:
/// - `.poly`, Triangle's; points may be in the `.node` beside it. A region's largest area A, above
///   zero, becomes RegionSeed::size, the edge sqrt(4 A / sqrt 3) of an equilateral triangle of this
///   area: triangles then have the area A on average, where Triangle makes it the largest;
/// - `.json`, our own form: points and segments, or painted polygons, with circles and arcs; its
///   schema is input.schema.json;
/// - `.geojson`: areas, lines and points with the properties material, name, priority and size;
///   those of `options.keep_fields` become Input::attributes;
/// - `.msh`, gmsh's 2.2 and 4.1, text or binary: the borders of the physical surfaces and the
///   physical curves;
/// - `.gds`, GDSII: a layout, flattened; see `cover/read_options.hpp` for what can be chosen of it;
/// - `.tif`, the meshes of TSUPREM-4 and MEDICI, and `.str`, those of SUPREM-IV: the borders of
///   their regions, electrodes of a .tif, and what they have at nodes as Input::field;
/// - `.cmd` and `.scm`, commands of the Sentaurus Structure Editor: regions, materials, contacts;
/// - `.png`, `.bmp`, `.tif`, `.tiff`, `.nrrd`, `.mha`, pictures of labels: a region for each set of
///   pixels of one label that hang together by their sides, with smooth borders;
/// - `.vtu`, `.vtp`, `.vti` and legacy `.vtk`: see read_vtk_input(); those that are images, pixels
///   with a material each, are pictures of labels.
///
/// Errors: cannot_open, syntax, truncated, id_out_of_range, non_finite_coordinate,
///         unsupported_format; messages name file and line, in JSON the path; those of
///         check_read_options() and apply_units().
Result<Input> read_input(const std::string& path, const ReadOptions& options = {});

/// Reads geometry from memory. `extension` names the format, as ".json", unless the options do;
/// `source` is what messages call the text.
///
/// Errors: as read_input; the .node of a .poly without points is looked for beside `source`.
Result<Input> parse_input(std::string_view text, std::string_view extension,
                          const std::string& source, const ReadOptions& options = {});

/// The extensions that parse_input() knows, each with its dot.
std::vector<std::string> input_formats();

/// The error for a format that parse_input() does not know; `others` are read by the caller.
Error unknown_input_format(std::string_view extension, const std::string& source,
                           const std::vector<std::string>& others = {});

}  // namespace cover
