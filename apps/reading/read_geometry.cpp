#include "read_geometry.hpp"

#include <algorithm>
#include <utility>

#ifdef COVER_WITH_DXF
#include <cover/read_dxf.hpp>
#endif
#ifdef COVER_WITH_GDAL
#include <cover/read_gdal.hpp>
#endif
#ifdef COVER_WITH_GMSH
#include <cover/read_geo.hpp>
#endif
#include <cover/files.hpp>
#include <cover/read_input.hpp>
#include <cover/text.hpp>
#include <cover/units.hpp>

#include "read_oasis.hpp"

namespace cover::reading {
namespace {

std::string format_in(const std::string& path, const ReadOptions& options) {
  return options.format.empty() ? extension_of(path) : options.format;
}

/// What is read here, of pipes too, and not by the library's own readers.
std::vector<std::string> formats_of_pipes_elsewhere() {
#ifdef COVER_WITH_DXF
  return {".dxf"};
#else
  return {};
#endif
}

std::vector<std::string> formats_elsewhere() {
  std::vector<std::string> formats{".oas"};
#ifdef COVER_WITH_GMSH
  formats.emplace_back(".geo");
#endif
  for (const std::string& format : formats_of_pipes_elsewhere()) formats.push_back(format);
#ifdef COVER_WITH_GDAL
  for (const char* const format : {".shp", ".gpkg", ".fgb", ".gml", ".kml"})
    formats.emplace_back(format);
#endif
  return formats;
}

bool is_among(const std::string& format, const std::vector<std::string>& formats) {
  return std::find(formats.begin(), formats.end(), format) != formats.end();
}

/// The error for a format that is read here, but from files alone.
Error not_from_pipes(const std::string& format, const std::string& source) {
  std::vector<std::string> known = input_formats();
  for (const std::string& other : formats_of_pipes_elsewhere()) known.push_back(other);
  std::string message = source + ": " + format +
                        " is read from a file and not from a pipe; read from pipes are " +
                        listed(known);
  return {ErrorCode::unsupported_format, std::move(message), {}, {}};
}

/// The library knows of no format but its own; here are more.
Result<Input> with_all_formats(Result<Input> input, const std::string& format,
                               const std::string& source, const std::vector<std::string>& others) {
  if (input || input.error().code != ErrorCode::unsupported_format) return input;
  if (is_among(format, input_formats())) return input;
  return unknown_input_format(format, source, others);
}

}  // namespace

std::string known_formats() {
  std::string text = "Triangle's .poly, our .json, .geojson, gmsh's .msh";
#ifdef COVER_WITH_GMSH
  text += " and .geo";
#endif
  text +=
      ", VTK's .vtu, .vtp, .vti, .vtk, layouts in .gds and .oas, TCAD's .tif, .str, .cmd, pictures "
      "in "
      ".png, .bmp, .tif, .nrrd, .mha";
#ifdef COVER_WITH_DXF
  text += ", drawings in .dxf";
#endif
#ifdef COVER_WITH_GDAL
  text += ", maps in .shp, .gpkg, .fgb, .gml, .kml";
#endif
  return text;
}

Result<Input> read_geometry(const std::string& path, const ReadOptions& options,
                            const std::stop_token& stop) {
  const std::string format = format_in(path, options);
  if (is_oasis(format)) return read_oasis(path, options, stop);
#ifdef COVER_WITH_GMSH
  if (format == ".geo") {
    Result<Input> input = read_geo(path);
    if (!input) return input;
    if (Status status = apply_units(*input, options); !status) return std::move(status).error();
    return input;
  }
#endif
#ifdef COVER_WITH_DXF
  if (format == ".dxf") return read_dxf(path, options);
#endif
#ifdef COVER_WITH_GDAL
  // Of GeoJSON, what our own reader does not do.
  const bool is_chosen = !options.crs.empty() || !options.layers.empty();
  if (is_map(format) || (format == ".geojson" && is_chosen)) return read_gdal(path, options);
#endif
  Result<Input> input =
      with_all_formats(read_input(path, options), format, path, formats_elsewhere());
#ifdef COVER_WITH_GDAL
  if (input && format == ".geojson") describe_system(*input, options);
#endif
  return input;
}

Result<Input> parse_geometry(std::string_view text, const std::string& source,
                             const ReadOptions& options) {
#ifdef COVER_WITH_DXF
  if (options.format == ".dxf") return parse_dxf(text, source, options);
#endif
  // Of OASIS it is told how it becomes a format that pipes may hold.
  if (is_among(options.format, formats_elsewhere()) && !is_oasis(options.format))
    return not_from_pipes(options.format, source);
  return with_all_formats(parse_input(text, options.format, source, options), options.format,
                          source, formats_of_pipes_elsewhere());
}

}  // namespace cover::reading
