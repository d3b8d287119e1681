// From the coordinates of a map's layer to those of a plane.
#pragma once

#include <optional>
#include <string>

#include <cover/result.hpp>

#include "gdal/gdal_library.hpp"

namespace cover {

/// What the coordinates of a layer are, and what becomes of them.
struct MapProjection {
  /// nullptr: they are taken as they are
  GdalHandle<&GdalLibrary::OCTDestroyCoordinateTransformation> transform;
  bool from_degrees = false;  ///< whether what is transformed is longitudes and latitudes
  bool degrees = false;       ///< whether the result is
  std::string unit;           ///< "m" where the result is said to be metres
  std::string system;         ///< that of the result, as Input::system has it
};

/// `system` is the layer's and may be nullptr; `wanted` as "EPSG:25832", empty: none. Files and
/// places of a network, which GDAL would read a system from, are not known.
/// REQUIRES: an open GDAL
///
/// Errors: bad_option, where PROJ does not know `wanted`, it is not of a plane, or the layer does
/// not say what it has
Result<MapProjection> projection_of(OGRSpatialReferenceH system, const std::string& wanted);

/// The same of a system that is known by its name alone, coordinates taken as they are; nothing
/// where PROJ does not know it.
/// REQUIRES: an open GDAL
std::optional<MapProjection> projection_of(const std::string& name);

}  // namespace cover
