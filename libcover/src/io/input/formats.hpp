// One function per geometry format that is read from text; `read_input` chooses among them.
//
// All of them: `source` is the file's name for messages.
// Errors: syntax, truncated, id_out_of_range, non_finite_coordinate, unsupported_format, with line
//         or path.
// Cost: O(n log n) in the length of the text, whatever numbers stand in it.
#pragma once

#include <string>
#include <string_view>

#include <cover/input.hpp>
#include <cover/read_options.hpp>
#include <cover/result.hpp>

namespace cover {

struct ImageOptions;

/// Triangle's .poly; where it has no points they are in the .node beside `source`.
Result<Input> parse_poly(std::string_view text, const std::string& source,
                         const ReadOptions& options = {});

/// Our own JSON: points and segments, or painted polygons, with curves. See input.schema.json.
/// GeoJSON is known by what stands in it; of `options`, only that looks at fields.
Result<Input> parse_json(std::string_view text, const std::string& source,
                         const ReadOptions& options = {});

/// GeoJSON: areas, lines as contacts, and points; properties material, name and priority, or those
/// that `options` name.
Result<Input> parse_geojson(std::string_view text, const std::string& source,
                            const ReadOptions& options = {});

/// gmsh's .msh 2.2 and 4.1, ASCII or binary: the borders of physical surfaces, and physical curves.
Result<Input> parse_msh(std::string_view text, const std::string& source);

/// TIF, the mesh of TSUPREM-4 and MEDICI, with its electrodes and values.
/// Units: micrometres.
Result<Input> parse_tif(std::string_view text, const std::string& source);

/// SUPREM-IV's structure files, the same.
/// Units: micrometres.
Result<Input> parse_suprem(std::string_view text, const std::string& source);

/// Commands of the Sentaurus Structure Editor: regions, materials and contacts of plane drawings.
/// Circles become chords by `options`. What is not understood is named in the warnings.
/// Units: micrometres.
Result<Input> parse_sde(std::string_view text, const std::string& source,
                        const ReadOptions& options = {});

/// A plane mesh in a file of VTK's, named by its extension: see read_vtk_input().
Result<Input> parse_vtk_input(std::string_view text, std::string_view extension,
                              const std::string& source, const ImageOptions* image = nullptr);

}  // namespace cover
