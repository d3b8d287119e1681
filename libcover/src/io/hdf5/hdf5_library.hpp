// HDF5's library, opened when a file is first written by it: with it come libraries for files on
// the net, which nobody asked for, and 40 ms at every start of a program that is linked with it.
#pragma once

#include <hdf5.h>

#include <cover/result.hpp>

namespace cover {

// What is called of HDF5. Its C interface stays the same from version to version.
#define COVER_HDF5_FUNCTIONS(X) \
  X(H5Aclose)                   \
  X(H5Acreate2)                 \
  X(H5Awrite)                   \
  X(H5Dclose)                   \
  X(H5Dcreate2)                 \
  X(H5Dget_offset)              \
  X(H5Dwrite)                   \
  X(H5Eget_auto2)               \
  X(H5Eset_auto2)               \
  X(H5FDregister)               \
  X(H5FDunregister)             \
  X(H5Fclose)                   \
  X(H5Fcreate)                  \
  X(H5Gclose)                   \
  X(H5Gcreate2)                 \
  X(H5Gopen2)                   \
  X(H5Pclose)                   \
  X(H5Pcreate)                  \
  X(H5Pget_driver_info)         \
  X(H5Pset_alloc_time)          \
  X(H5Pset_driver)              \
  X(H5Pset_fill_time)           \
  X(H5Pset_layout)              \
  X(H5Pset_obj_track_times)     \
  X(H5Sclose)                   \
  X(H5Screate)                  \
  X(H5Screate_simple)           \
  X(H5Tclose)                   \
  X(H5Tcopy)                    \
  X(H5Tset_size)                \
  X(H5open)

// Kinds of numbers and of lists of properties. The header names them by macros that open the
// library they are linked with; these are the variables behind the macros.
#define COVER_HDF5_KINDS(X)      \
  X(H5P_CLS_DATASET_CREATE_ID_g) \
  X(H5P_CLS_FILE_ACCESS_ID_g)    \
  X(H5P_CLS_FILE_CREATE_ID_g)    \
  X(H5P_CLS_GROUP_CREATE_ID_g)   \
  X(H5T_C_S1_g)                  \
  X(H5T_NATIVE_DOUBLE_g)         \
  X(H5T_NATIVE_FLOAT_g)          \
  X(H5T_NATIVE_INT16_g)          \
  X(H5T_NATIVE_INT32_g)          \
  X(H5T_NATIVE_INT64_g)          \
  X(H5T_NATIVE_INT8_g)           \
  X(H5T_NATIVE_UINT16_g)         \
  X(H5T_NATIVE_UINT32_g)         \
  X(H5T_NATIVE_UINT64_g)         \
  X(H5T_NATIVE_UINT8_g)

/// HDF5's functions and kinds by their names.
struct Hdf5Library {
// NOLINTNEXTLINE(bugprone-macro-parentheses): a name that is declared
#define COVER_HDF5_FUNCTION(name) decltype(&::name) name = nullptr;
  COVER_HDF5_FUNCTIONS(COVER_HDF5_FUNCTION)
#undef COVER_HDF5_FUNCTION
// NOLINTNEXTLINE(bugprone-macro-parentheses): a name that is declared
#define COVER_HDF5_KIND(name) hid_t name = -1;
  COVER_HDF5_KINDS(COVER_HDF5_KIND)
#undef COVER_HDF5_KIND
};

/// Opens HDF5, once for the whole process; it stays open. May be called from several threads.
///
/// Errors: unsupported_format, where the library that this was built with is not there
Result<const Hdf5Library*> hdf5_library();

/// The same where it is known to be open.
/// REQUIRES: hdf5_library() has been a success
const Hdf5Library& opened_hdf5();

}  // namespace cover
