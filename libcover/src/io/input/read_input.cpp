// Which reader a file wants is told by its extension.
// Tested by tests/unit/io/input/drawings/read_json_test.cpp and those beside it.
#include <cover/read_input.hpp>
#include <cover/units.hpp>

#include <fmt/core.h>

#include <array>

#include "base/faults/out_of_memory.hpp"
#include "io/images/raster.hpp"
#include "io/images/read_image.hpp"
#include "io/input/formats.hpp"
#include "io/layout/read_gds.hpp"
#include "io/text/text.hpp"
#include "io/vtk_files/read_data_set.hpp"

namespace cover {
namespace {

/// A format that is read from one text.
struct Format {
  std::string_view extension;
  Result<Input> (*parse)(std::string_view text, const std::string& source);
};

constexpr std::array kFormats{
    Format{".poly", parse_poly},  Format{".msh", parse_msh}, Format{".tif", parse_tif},
    Format{".str", parse_suprem}, Format{".cmd", parse_sde}, Format{".scm", parse_sde},
};

/// Formats that others turn into one that is read here, and how.
struct OtherFormat {
  std::string_view extension;
  std::string_view what;
};

constexpr std::string_view kOfMaps =
    "maps other than GeoJSON are read by GDAL, from files and in builds that have it; "
    "'ogr2ogr -f GeoJSON OUT.geojson FILE' makes a file that can be read";

constexpr std::array kOtherFormats{
    OtherFormat{".shp", kOfMaps},
    OtherFormat{".gpkg", kOfMaps},
    OtherFormat{".fgb", kOfMaps},
    OtherFormat{".gml", kOfMaps},
    OtherFormat{".kml", kOfMaps},
    OtherFormat{".geo",
                ".geo is read by gmsh's library, without which this was built; "
                "'gmsh -2 FILE.geo -o FILE.msh' makes a file that can be read"},
    OtherFormat{".oas",
                "OASIS is read from files, by programs that call KLayout for it; KLayout's "
                "'strm2gds FILE.oas FILE.gds' makes a file that can be read"},
    OtherFormat{".dxf",
                ".dxf is read by dxflib, without which this was built; "
                "'ogr2ogr -f GeoJSON FILE.geojson FILE.dxf' makes a file that can be read, "
                "with chords for arcs"},
};

Error unknown_format(std::string_view extension, const std::string& source) {
  for (const OtherFormat& other : kOtherFormats) {
    if (other.extension != lower(extension)) continue;
    return {ErrorCode::unsupported_format, fmt::format("{}: {}", source, other.what), {}, {}};
  }
  std::string known;
  for (const Format& format : kFormats) known += fmt::format("{}, ", format.extension);
  return {ErrorCode::unsupported_format,
          fmt::format(
              "{}: no reader for files named '*{}'; known: {}.json, .geojson, .gds, .vtu, .vtp, "
              ".vti, .vtk, .png, "
              ".bmp, .tiff, .nrrd, .mha",
              source, extension, known),
          {},
          {}};
}

/// Whether something of a map is chosen that only GDAL does.
bool is_for_gdal(const ReadOptions& o) { return !o.layers.empty() || !o.crs.empty(); }

Result<ImageOptions> image_options(const ReadOptions& options) {
  ImageOptions image{options.smooth, {}, options.legend};
  if (!options.legend.empty()) {
    Result<std::string> legend = read_file(options.legend);
    if (!legend) return std::move(legend).error();
    image.legend = *std::move(legend);
  }
  return image;
}

Result<Input> parse_picture(std::string_view data, const std::string& extension,
                            const std::string& source, const ReadOptions& options) {
  const Result<ImageOptions> image = image_options(options);
  return image ? parse_image(data, extension, source, *image) : Result<Input>(image.error());
}

/// Without smoothing and a legend, what read_vtk_input() makes of it.
Result<Input> parse_vtk(std::string_view text, const std::string& extension,
                        const std::string& source, const ReadOptions& options) {
  if (!options.smooth && options.legend.empty()) return parse_vtk_input(text, extension, source);
  const Result<ImageOptions> image = image_options(options);
  return image ? parse_vtk_input(text, extension, source, &*image) : Result<Input>(image.error());
}

Result<Input> parse_format(std::string_view text, const std::string& extension,
                           const std::string& source, const ReadOptions& options) {
  if (extension == ".geojson" && is_for_gdal(options))
    return Error{ErrorCode::bad_option,
                 fmt::format("{}: choosing layers or a projection takes GDAL, which "
                             "reads from files and in builds that have it",
                             source),
                 {},
                 {}};
  // TCAD's TIF has the extension of a picture.
  if (is_image(extension) && (extension != ".tif" || is_tiff(text)))
    return parse_picture(text, extension, source, options);
  if (extension == ".json") return parse_json(text, source, options);
  if (extension == ".geojson") return parse_geojson(text, source, options);
  for (const Format& format : kFormats)
    if (format.extension == extension) return format.parse(text, source);
  if (is_data_set(extension)) return parse_vtk(text, extension, source, options);
  if (is_layout(extension)) return parse_gds(text, source, options);
  return unknown_format(extension, source);
}

}  // namespace

Result<Input> parse_input(std::string_view text, std::string_view extension,
                          const std::string& source, const ReadOptions& options) {
  return memory_as_value(source, [&]() -> Result<Input> {
    if (const Status status = check_read_options(options); !status) return status.error();
    const std::string format = lower(options.format.empty() ? extension : options.format);
    Result<Input> input = parse_format(text, format, source, options);
    if (!input) return input;
    if (Status status = apply_units(*input, options); !status) return std::move(status).error();
    return input;
  });
}

Result<Input> read_input(const std::string& path, const ReadOptions& options) {
  return memory_as_value(path, [&]() -> Result<Input> {
    Result<std::string> text = read_file(path);
    if (!text) return std::move(text).error();
    return parse_input(*text, extension_of(path), path, options);
  });
}

}  // namespace cover
