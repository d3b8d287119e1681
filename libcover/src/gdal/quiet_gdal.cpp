// Tested by tests/unit/gdal/read_gdal_test.cpp.
#include "gdal/quiet_gdal.hpp"

#include "gdal/gdal_library.hpp"

namespace cover {
namespace {

void CPL_STDCALL keep_message(CPLErr kind, CPLErrorNum, const char* message) {
  auto* quiet = static_cast<QuietGdal*>(opened_gdal().CPLGetErrorHandlerUserData());
  if (quiet != nullptr && kind >= CE_Failure) quiet->add_failure(message);
}

}  // namespace

QuietGdal::QuietGdal() { opened_gdal().CPLPushErrorHandlerEx(&keep_message, this); }
QuietGdal::~QuietGdal() { opened_gdal().CPLPopErrorHandler(); }

}  // namespace cover
