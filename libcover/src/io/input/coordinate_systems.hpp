// Which coordinate systems maps are in, and whether two of them are one.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <cover/input.hpp>
#include <cover/result.hpp>

#include "geom/box.hpp"

namespace cover {

/// Longitudes and latitudes.
inline constexpr const char* kLongitudeLatitude = "EPSG:4326";

/// Before the number of a system that no registry has, in Input::system: nothing is projected from
/// it or to it.
inline constexpr const char* kUnknownSystem = "unknown system ";

/// What Input::system is for a system that a file calls `name`: "EPSG:25832" for
/// "urn:ogc:def:crs:EPSG::25832" and its like, "EPSG:4326" also for CRS84 of OGC, as the longitude
/// comes first in every file; other names stay.
std::string system_of_name(std::string_view name);

/// Whether two systems have numbers of EPSG's, and different ones. Names, and numbers of others,
/// tell nothing: one system has many.
bool surely_differ(std::string_view one, std::string_view other);

/// Whether a point may be a longitude, of some count of it, and a latitude.
bool is_on_globe(Point p);

/// Whether coordinates may be longitudes and latitudes. Of nothing, no.
bool could_be_degrees(const Box& box);

/// The box around all that is drawn.
Box box_of_input(const Input& input);

/// Are the inputs in one coordinate system, as far as they say? Appends a sentence to `warnings`
/// where they may not be.
///
/// Errors: bad_option, where they are not
Status check_systems(const std::vector<Input>& inputs, std::vector<std::string>& warnings);

}  // namespace cover
