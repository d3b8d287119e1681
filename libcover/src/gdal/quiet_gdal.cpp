// Tested by tests/unit/gdal/read_gdal_test.cpp.
#include "gdal/quiet_gdal.hpp"

#include <cpl_error.h>

namespace cover {
namespace {

void CPL_STDCALL keep_message(CPLErr kind, CPLErrorNum, const char* message) {
  auto* quiet = static_cast<QuietGdal*>(CPLGetErrorHandlerUserData());
  if (quiet != nullptr && kind >= CE_Failure) quiet->add_failure(message);
}

}  // namespace

QuietGdal::QuietGdal() { CPLPushErrorHandlerEx(&keep_message, this); }
QuietGdal::~QuietGdal() { CPLPopErrorHandler(); }

}  // namespace cover
