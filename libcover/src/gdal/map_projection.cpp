// Tested by tests/unit/gdal/read_gdal_test.cpp.
#include "gdal/map_projection.hpp"

#include <filesystem>
#include <system_error>

#include <fmt/core.h>

#include "base/faults/errors.hpp"
#include "io/input/coordinate_systems.hpp"

namespace cover {
namespace {

using Reference = GdalHandle<&GdalLibrary::OSRDestroySpatialReference>;

/// The number of a system, as "EPSG:25832"; empty if it has none.
std::string number_of(OGRSpatialReferenceH system) {
  const GdalLibrary& gdal = opened_gdal();
  const char* authority = gdal.OSRGetAuthorityName(system, nullptr);
  const char* code = gdal.OSRGetAuthorityCode(system, nullptr);
  if (authority == nullptr || code == nullptr) return {};
  return system_of_name(fmt::format("{}:{}", authority, code));
}

/// The number that EPSG has for the same system under another name, as files of ESRI's have them.
std::string number_of_match(OGRSpatialReferenceH system) {
  constexpr int kSame = 90;  // percent, by which GDAL itself takes one for the other
  const GdalLibrary& gdal = opened_gdal();
  int count = 0;
  int* confidence = nullptr;
  OGRSpatialReferenceH* matches = gdal.OSRFindMatches(system, nullptr, &count, &confidence);
  std::string number;
  for (int k = 0; k < count && number.empty(); ++k) {
    if (confidence[k] < kSame) continue;
    const std::string found = number_of(matches[k]);
    if (found.starts_with("EPSG:")) number = found;
  }
  gdal.OSRFreeSRSArray(matches);
  gdal.VSIFree(confidence);
  return number;
}

/// As Input::system has it. Heights, which are left out, make no other system.
std::string name_of(OGRSpatialReferenceH system) {
  const GdalLibrary& gdal = opened_gdal();
  const Reference plane(gdal.OSRClone(system));
  gdal.OSRDemoteTo2D(plane.get(), nullptr);
  std::string number = number_of(plane.get());
  if (!number.starts_with("EPSG:")) {
    std::string of_epsg = number_of_match(plane.get());
    if (!of_epsg.empty()) number = std::move(of_epsg);
  }
  if (!number.empty()) return number;
  const char* name = gdal.OSRGetName(plane.get());
  return name == nullptr ? std::string() : std::string(name);
}

void describe_result(OGRSpatialReferenceH system, MapProjection& projection) {
  const GdalLibrary& gdal = opened_gdal();
  projection.system = name_of(system);
  projection.degrees = gdal.OSRIsGeographic(system) != 0;
  if (gdal.OSRIsProjected(system) != 0 && gdal.OSRGetLinearUnits(system, nullptr) == 1)
    projection.unit = std::string(1, 'm');
}

/// Would GDAL look into a file or a network for it?
bool is_elsewhere(const std::string& wanted) {
  std::error_code ignored;
  return wanted.find("://") != std::string::npos || wanted.starts_with("/vsi") ||
         wanted.starts_with("DICT:") || std::filesystem::exists(wanted, ignored);
}

/// What PROJ knows under a name; nullptr: nothing.
Reference system_named(const std::string& name) {
  const GdalLibrary& gdal = opened_gdal();
  Reference system(gdal.OSRNewSpatialReference(nullptr));
  if (is_elsewhere(name) || gdal.OSRSetFromUserInput(system.get(), name.c_str()) != OGRERR_NONE)
    system.reset();
  return system;
}

}  // namespace

std::optional<MapProjection> projection_of(const std::string& name) {
  const Reference system = system_named(name);
  if (!system) return std::nullopt;
  MapProjection projection;
  describe_result(system.get(), projection);
  return projection;
}

Result<MapProjection> projection_of(OGRSpatialReferenceH system, const std::string& wanted) {
  const GdalLibrary& gdal = opened_gdal();
  MapProjection projection;
  if (wanted.empty()) {
    if (system != nullptr) describe_result(system, projection);
    return projection;
  }
  const Reference to = system_named(wanted);
  if (!to) return bad_option(fmt::format("crs: PROJ does not know '{}'; as EPSG:25832", wanted));
  if (gdal.OSRIsProjected(to.get()) == 0 && gdal.OSRIsGeographic(to.get()) == 0)
    return bad_option(fmt::format(
        "crs: '{}' is a system of heights, or in space, and no plane one; as EPSG:25832", wanted));
  if (system == nullptr)
    return bad_option("crs: the layer does not say in which system its coordinates are");
  const Reference from(gdal.OSRClone(system));
  // x is the longitude, as in files, whatever the authority says.
  gdal.OSRSetAxisMappingStrategy(from.get(), OAMS_TRADITIONAL_GIS_ORDER);
  gdal.OSRSetAxisMappingStrategy(to.get(), OAMS_TRADITIONAL_GIS_ORDER);
  projection.transform.reset(gdal.OCTNewCoordinateTransformation(from.get(), to.get()));
  if (!projection.transform)
    return bad_option(fmt::format("crs: there is no way from the layer's system to '{}'", wanted));
  projection.from_degrees = gdal.OSRIsGeographic(from.get()) != 0;
  describe_result(to.get(), projection);
  return projection;
}

}  // namespace cover
