// Tested by tests/unit/gdal/read_gdal_test.cpp.
#include "gdal/gdal_library.hpp"

#include <dlfcn.h>

#include <string>

#include <fmt/core.h>

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

struct Opened {
  GdalLibrary functions;
  std::string failure;  ///< empty: open
};

Opened open_library() {
  Opened opened;
  // By its name first, so that whoever has opened it before shares it.
  void* library = dlopen(COVER_GDAL_SONAME, RTLD_NOW | RTLD_LOCAL);
  if (library == nullptr) {
    opened.failure = dlerror();
    library = dlopen(COVER_GDAL_FILE, RTLD_NOW | RTLD_LOCAL);
  }
  if (library == nullptr) return opened;
  opened.failure.clear();
  const auto find = [&](const char* name) {
    void* symbol = dlsym(library, name);
    if (symbol == nullptr && opened.failure.empty())
      opened.failure = fmt::format("{} has no {}", COVER_GDAL_SONAME, name);
    return symbol;
  };
#define COVER_GDAL_FIND(name) \
  opened.functions.name = reinterpret_cast<decltype(&::name)>(find(#name));
  COVER_GDAL_FUNCTIONS(COVER_GDAL_FIND)
#undef COVER_GDAL_FIND
  for (const char* name : kRegistrations) {
    auto* const enroll = reinterpret_cast<void (*)()>(find(name));
    if (opened.failure.empty()) enroll();
  }
  return opened;
}

const Opened& opened_once() {
  static const Opened opened = open_library();
  return opened;
}

}  // namespace

Result<const GdalLibrary*> gdal_library() {
  const Opened& opened = opened_once();
  if (!opened.failure.empty()) return not_there(opened.failure);
  return &opened.functions;
}

const GdalLibrary& opened_gdal() { return opened_once().functions; }

}  // namespace cover
