// Tested by tests/unit/gdal/read_gdal_test.cpp.
#include "gdal/gdal_library.hpp"

#include <string>

#include <fmt/core.h>

#include "base/opened_library.hpp"

namespace cover {
namespace {

constexpr const char* kRegistrations[] = {
    "RegisterOGRShape",  "RegisterOGRGeoPackage", "RegisterOGRFlatGeobuf", "RegisterOGRGML",
    "RegisterOGRLIBKML", "RegisterOGRKML",        "RegisterOGRGeoJSON"};

Error not_there(const std::string& why) {
  return {
      ErrorCode::unsupported_format,
      fmt::format("maps other than GeoJSON are read by GDAL, which cannot be opened ({}); 'ogr2ogr "
                  "-f GeoJSON OUT.geojson FILE' makes a file that can be read",
                  why),
      {},
      {}};
}

Opened<GdalLibrary> open_gdal() {
  OpenedLibrary library(COVER_GDAL_SONAME, COVER_GDAL_FILE);
  Opened<GdalLibrary> opened;
#define COVER_GDAL_FIND(name) library.find(#name, opened.members.name);
  COVER_GDAL_FUNCTIONS(COVER_GDAL_FIND)
#undef COVER_GDAL_FIND
  for (const char* name : kRegistrations) {
    void (*enroll)() = nullptr;
    library.find(name, enroll);
    if (library.failure().empty()) enroll();
  }
  opened.failure = library.failure();
  return opened;
}

}  // namespace

Result<const GdalLibrary*> gdal_library() {
  const Opened<GdalLibrary>& opened = opened_once<open_gdal>();
  if (!opened.failure.empty()) return not_there(opened.failure);
  return &opened.members;
}

const GdalLibrary& opened_gdal() { return opened_once<open_gdal>().members; }

}  // namespace cover
