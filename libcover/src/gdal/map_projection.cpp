// Tested by tests/unit/gdal/read_gdal_test.cpp.
#include "gdal/map_projection.hpp"

#include <fmt/core.h>

namespace cover {
namespace {

Error bad_crs(std::string message) { return {ErrorCode::bad_option, std::move(message), {}, {}}; }

void describe_result(const OGRSpatialReference& system, MapProjection& projection) {
  projection.degrees = system.IsGeographic() != 0;
  if (system.IsProjected() != 0 && system.GetLinearUnits(nullptr) == 1) projection.unit = "m";
}

}  // namespace

Result<MapProjection> projection_of(const OGRSpatialReference* system, const std::string& wanted) {
  MapProjection projection;
  if (wanted.empty()) {
    if (system != nullptr) describe_result(*system, projection);
    return projection;
  }
  OGRSpatialReference to;
  if (to.SetFromUserInput(wanted.c_str(),
                          OGRSpatialReference::SET_FROM_USER_INPUT_LIMITATIONS_get()) !=
      OGRERR_NONE)
    return bad_crs(fmt::format("crs: PROJ does not know '{}'; as EPSG:25832", wanted));
  if (system == nullptr)
    return bad_crs("crs: the layer does not say in which system its coordinates are");
  OGRSpatialReference from(*system);
  // x is the longitude, as in files, whatever the authority says.
  from.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
  to.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
  projection.transform.reset(OGRCreateCoordinateTransformation(&from, &to));
  if (!projection.transform)
    return bad_crs(fmt::format("crs: there is no way from the layer's system to '{}'", wanted));
  describe_result(to, projection);
  return projection;
}

}  // namespace cover
