// GDAL, opened when it is first wanted: a program that is linked with it takes a tenth of a second
// longer to start, and reads a map once in a while.
#pragma once

#include <memory>

#include <cpl_error.h>
#include <cpl_string.h>
#include <cpl_vsi.h>
#include <gdal.h>
#include <ogr_api.h>
#include <ogr_srs_api.h>

#include <cover/result.hpp>

namespace cover {

// What is called of GDAL. Its C interface stays the same from version to version.
#define COVER_GDAL_FUNCTIONS(X)         \
  X(CPLPushErrorHandlerEx)              \
  X(CPLPopErrorHandler)                 \
  X(CPLGetErrorHandlerUserData)         \
  X(CPLIsUTF8)                          \
  X(GDALOpenEx)                         \
  X(GDALClose)                          \
  X(GDALDatasetGetLayerCount)           \
  X(GDALDatasetGetLayer)                \
  X(OGR_L_GetName)                      \
  X(OGR_L_GetGeomType)                  \
  X(OGR_L_GetLayerDefn)                 \
  X(OGR_L_GetSpatialRef)                \
  X(OGR_L_ResetReading)                 \
  X(OGR_L_GetNextFeature)               \
  X(OGR_FD_GetFieldCount)               \
  X(OGR_FD_GetFieldDefn)                \
  X(OGR_FD_GetFieldIndex)               \
  X(OGR_Fld_GetNameRef)                 \
  X(OGR_Fld_GetType)                    \
  X(OGR_F_Destroy)                      \
  X(OGR_F_GetFID)                       \
  X(OGR_F_GetFieldDefnRef)              \
  X(OGR_F_GetFieldAsDouble)             \
  X(OGR_F_GetFieldAsInteger64)          \
  X(OGR_F_GetFieldAsString)             \
  X(OGR_F_IsFieldSetAndNotNull)         \
  X(OGR_F_StealGeometry)                \
  X(OGR_G_DestroyGeometry)              \
  X(OGR_G_GetGeometryCount)             \
  X(OGR_G_GetGeometryRef)               \
  X(OGR_G_GetGeometryType)              \
  X(OGR_G_GetLinearGeometry)            \
  X(OGR_G_GetPointCount)                \
  X(OGR_G_GetPoints)                    \
  X(OGR_G_HasCurveGeometry)             \
  X(OGR_G_IsEmpty)                      \
  X(OGR_GT_Flatten)                     \
  X(OCTDestroyCoordinateTransformation) \
  X(OCTNewCoordinateTransformation)     \
  X(OCTTransform)                       \
  X(OSRClone)                           \
  X(OSRDemoteTo2D)                      \
  X(OSRDestroySpatialReference)         \
  X(OSRFindMatches)                     \
  X(OSRFreeSRSArray)                    \
  X(OSRGetAuthorityCode)                \
  X(OSRGetAuthorityName)                \
  X(OSRGetLinearUnits)                  \
  X(OSRGetName)                         \
  X(OSRIsGeographic)                    \
  X(OSRIsProjected)                     \
  X(OSRNewSpatialReference)             \
  X(OSRSetAxisMappingStrategy)          \
  X(OSRSetFromUserInput)                \
  X(VSIFree)

/// GDAL's functions by their names.
struct GdalLibrary {
// NOLINTNEXTLINE(bugprone-macro-parentheses): a name that is declared
#define COVER_GDAL_MEMBER(name) decltype(&::name) name = nullptr;
  COVER_GDAL_FUNCTIONS(COVER_GDAL_MEMBER)
#undef COVER_GDAL_MEMBER
};

/// Opens GDAL and registers the formats that are read, once for the whole process; it stays open.
/// May be called from several threads.
///
/// Errors: unsupported_format, where the library that this was built with is not there
Result<const GdalLibrary*> gdal_library();

/// The same where it is known to be open.
/// REQUIRES: gdal_library() has been a success
const GdalLibrary& opened_gdal();

/// Something of GDAL's that `Destroy`, a member of GdalLibrary, gives back.
template <auto Destroy>
struct GdalDeleter {
  void operator()(void* handle) const { (opened_gdal().*Destroy)(handle); }
};
template <auto Destroy>
using GdalHandle = std::unique_ptr<void, GdalDeleter<Destroy>>;

}  // namespace cover
