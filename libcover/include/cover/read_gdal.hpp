// Reading maps through GDAL. In the component cover::gdal, which is there where GDAL is.
#pragma once

#include <string>
#include <string_view>

#include <cover/input.hpp>
#include <cover/read_options.hpp>
#include <cover/result.hpp>

namespace cover {

/// Whether read_gdal() reads files with this extension, in lower case: .shp, .gpkg, .fgb, .gml and
/// .kml.
bool is_map(std::string_view extension);

/// Completes what a map of another reader says of its coordinate system: Input::unit, where PROJ
/// knows the system and it is in metres, as apply_units() makes it of these with the `options` that
/// the map was read with; or a warning where PROJ does not know it. Nothing is done where GDAL
/// cannot be opened.
void describe_system(Input& input, const ReadOptions& options = {});

/// Reads polygons, lines and points of a map, with the meaning that read_input() gives to those of
/// GeoJSON (which is read too): polygons are painted, lines are contacts, points are vertices.
/// Attributes called material, name, priority and size count, in whatever case, unless the options
/// name others, which one layer at least has to have. Those of `options.keep_fields` become
/// Input::attributes. Layers have to be in one coordinate system, which becomes Input::system.
///
/// Of several layers those that `options.layers` names are read, in the order of the file. With
/// `options.crs`, coordinates are projected by PROJ; without, longitudes and latitudes are taken as
/// they are, which `Input::warnings` tells. Curves become chords as in drawings. Files are never
/// written, nor is anything fetched from a network.
/// Errors: cannot_open, syntax, unsupported_format, bad_option, non_finite_coordinate
/// Cost:   GDAL's
Result<Input> read_gdal(const std::string& path, const ReadOptions& options = {});

}  // namespace cover
