// Which reader a file wants is told by its extension.
// Tested by tests/unit/io/input/drawings/read_json_test.cpp and those beside it.
#include <cover/read_input.hpp>
#include <cover/text.hpp>
#include <cover/units.hpp>

#include <fmt/core.h>

#include <array>
#include <vector>

#include "base/faults/out_of_memory.hpp"
#include "io/images/raster.hpp"
#include "io/images/read_image.hpp"
#include "io/input/formats.hpp"
#include "io/layout/read_gds.hpp"
#include "io/text/text.hpp"
#include "io/vtk_files/read_data_set.hpp"

namespace cover {
namespace {

/// Formats that others turn into one that is read here, and how.
struct OtherFormat {
  std::string_view extension;
  std::string_view what;
};

constexpr std::string_view kOfMaps =
    "maps other than GeoJSON are read by GDAL, from files and in builds that have it: by the "
    "component cover::gdal, <cover/read_gdal.hpp>; "
    "'ogr2ogr -f GeoJSON OUT.geojson FILE' makes a file that can be read";

constexpr std::string_view kWantsGeoJson =
    "'ogr2ogr -f GeoJSON OUT.geojson FILE' makes a file of it that can be read";

constexpr std::string_view kOfMeshes =
    "a .vtm and a .vtkhdf are drawn, checked and converted, but not meshed again; "
    "'cover convert FILE -o FILE.msh' makes a file that can be read, with names and contacts";

constexpr std::array kOtherFormats{
    OtherFormat{".vtm", kOfMeshes},
    OtherFormat{".vtkhdf", kOfMeshes},
    OtherFormat{".shp", kOfMaps},
    OtherFormat{".gpkg", kOfMaps},
    OtherFormat{".fgb", kOfMaps},
    OtherFormat{".gml", kOfMaps},
    OtherFormat{".kml", kOfMaps},
    OtherFormat{".topojson", kWantsGeoJson},
    OtherFormat{".geojsonl", kWantsGeoJson},
    OtherFormat{".geojsons", kWantsGeoJson},
    OtherFormat{".tab", kWantsGeoJson},
    OtherFormat{".mif", kWantsGeoJson},
    OtherFormat{".gpx", kWantsGeoJson},
    OtherFormat{".kmz", kWantsGeoJson},
    OtherFormat{".sqlite", kWantsGeoJson},
    OtherFormat{".dgn", kWantsGeoJson},
    OtherFormat{".osm", kWantsGeoJson},
    OtherFormat{".csv",
                "a table is no geometry (one of sizes goes by --size-field); 'ogr2ogr -f GeoJSON "
                "-oo X_POSSIBLE_NAMES=x -oo Y_POSSIBLE_NAMES=y OUT.geojson FILE' makes a file of "
                "points that can be read, and without -oo one of the geometries in a column WKT"},
    OtherFormat{".wkt",
                "'ogr2ogr -f GeoJSON OUT.geojson FILE.csv' makes a file that can be read of a .csv "
                "whose first line is WKT and whose others are such texts in quotes"},
    OtherFormat{".geo",
                ".geo is read by gmsh's library, in builds that have it: by the component "
                "cover::gmsh, <cover/read_geo.hpp>; "
                "'gmsh -2 FILE.geo -o FILE.msh' makes a file that can be read"},
    OtherFormat{".oas",
                "OASIS is read from files, by programs that call KLayout for it; KLayout's "
                "'strm2gds FILE.oas FILE.gds' makes a file that can be read"},
    OtherFormat{".dxf",
                ".dxf is read by dxflib, in builds that have it: by the component cover::dxf, "
                "<cover/read_dxf.hpp>; "
                "'ogr2ogr -f GeoJSON FILE.geojson FILE.dxf' makes a file that can be read, "
                "with chords for arcs"},
};

/// What a file holds, and how messages call it.
struct Contents {
  std::string_view text;
  const std::string& extension;  ///< in lower case
  const std::string& source;
};

using Parse = Result<Input> (*)(const Contents& file, const ReadOptions& options);

/// A parser whom no options concern.
template <Result<Input> (*parse)(std::string_view text, const std::string& source)>
Result<Input> plain(const Contents& file, const ReadOptions& /*options*/) {
  return parse(file.text, file.source);
}

/// One whom they do.
template <Result<Input> (*parse)(std::string_view text, const std::string& source,
                                 const ReadOptions& options)>
Result<Input> with_options(const Contents& file, const ReadOptions& options) {
  return parse(file.text, file.source, options);
}

Result<ImageOptions> image_options(const ReadOptions& options) {
  ImageOptions image{static_cast<std::size_t>(options.speckle), options.smooth, {}, options.legend};
  if (!options.legend.empty()) {
    Result<std::string> legend = read_file(options.legend);
    if (!legend) return std::move(legend).error();
    image.legend = *std::move(legend);
  }
  return image;
}

Result<Input> picture(const Contents& file, const ReadOptions& options) {
  const Result<ImageOptions> image = image_options(options);
  return image ? parse_image(file.text, file.extension, file.source, *image)
               : Result<Input>(image.error());
}

/// TCAD's TIF has the extension of a picture.
Result<Input> tif(const Contents& file, const ReadOptions& options) {
  return is_tiff(file.text) ? picture(file, options) : parse_tif(file.text, file.source);
}

/// Without anything that concerns pictures, what read_vtk_input() makes of it.
Result<Input> vtk(const Contents& file, const ReadOptions& options) {
  if (!options.smooth && options.speckle == 0 && options.legend.empty())
    return parse_vtk_input(file.text, file.extension, file.source);
  const Result<ImageOptions> image = image_options(options);
  return image ? parse_vtk_input(file.text, file.extension, file.source, &*image)
               : Result<Input>(image.error());
}

/// Some choices are GDAL's alone.
Result<Input> geojson(const Contents& file, const ReadOptions& options) {
  if (!options.layers.empty() || !options.crs.empty())
    return Error{ErrorCode::bad_option,
                 fmt::format("{}: choosing layers or a projection takes GDAL, which "
                             "reads from files and in builds that have it",
                             file.source),
                 {},
                 {}};
  return parse_geojson(file.text, file.source, options);
}

struct Format {
  std::string_view extension;
  Parse parse;
};

/// All formats that are read from one text.
constexpr std::array kFormats{
    Format{".poly", with_options<parse_poly>},
    Format{".msh", plain<parse_msh>},
    Format{".tif", tif},
    Format{".str", plain<parse_suprem>},
    Format{".cmd", with_options<parse_sde>},
    Format{".scm", with_options<parse_sde>},
    Format{".json", with_options<parse_json>},
    Format{".geojson", geojson},
    Format{".gds", with_options<parse_gds>},
    Format{".gds2", with_options<parse_gds>},
    Format{".gdsii", with_options<parse_gds>},
    Format{".vtu", vtk},
    Format{".vtp", vtk},
    Format{".vti", vtk},
    Format{".vtk", vtk},
    Format{".png", picture},
    Format{".bmp", picture},
    Format{".tiff", picture},
    Format{".nrrd", picture},
    Format{".mha", picture},
};

/// nullptr if there is none.
const Format* find_format(std::string_view extension) {
  for (const Format& format : kFormats)
    if (format.extension == extension) return &format;
  return nullptr;
}

Result<Input> parse_format(const Contents& file, const ReadOptions& options) {
  const Format* const format = find_format(file.extension);
  return format != nullptr ? format->parse(file, options)
                           : unknown_input_format(file.extension, file.source);
}

}  // namespace

std::vector<std::string> input_formats() {
  std::vector<std::string> known;
  for (const Format& format : kFormats) known.emplace_back(format.extension);
  return known;
}

Error unknown_input_format(std::string_view extension, const std::string& source,
                           const std::vector<std::string>& others) {
  for (const OtherFormat& other : kOtherFormats) {
    if (other.extension != extension) continue;
    return {ErrorCode::unsupported_format, fmt::format("{}: {}", source, other.what), {}, {}};
  }
  std::vector<std::string> known = input_formats();
  known.insert(known.end(), others.begin(), others.end());
  return {ErrorCode::unsupported_format,
          fmt::format("{}: no reader for files named '*{}'; known: {}", source, extension,
                      listed(known)),
          {},
          {}};
}

Result<Input> parse_input(std::string_view text, std::string_view extension,
                          const std::string& source, const ReadOptions& options) {
  return memory_as_value(source, [&]() -> Result<Input> {
    if (const Status status = check_read_options(options); !status) return status.error();
    const std::string format = lower(options.format.empty() ? extension : options.format);
    Result<Input> input = parse_format({text, format, source}, options);
    if (!input && text.empty() && find_format(format) != nullptr &&
        input.error().code != ErrorCode::bad_option)
      return Error{input.error().code,
                   fmt::format("{}: nothing is in it: it is empty, or was cut off", source),
                   {},
                   {}};
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
