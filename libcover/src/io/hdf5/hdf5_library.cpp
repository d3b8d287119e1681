// Tested by tests/unit/io/write_mesh/vtk_formats/write_vtkhdf_test.cpp.
#include "io/hdf5/hdf5_library.hpp"

#include <string>

#include <fmt/core.h>

#include "base/opened_library.hpp"

namespace cover {
namespace {

Opened<Hdf5Library> open_hdf5() {
  OpenedLibrary library(COVER_HDF5_SONAME, COVER_HDF5_FILE);
  Opened<Hdf5Library> opened;
#define COVER_HDF5_FIND(name) library.find(#name, opened.members.name);
  COVER_HDF5_FUNCTIONS(COVER_HDF5_FIND)
#undef COVER_HDF5_FIND
  // Kinds have no value before this.
  if (library.failure().empty()) opened.members.H5open();
  const auto value_of = [&library](const char* name) {
    const hid_t* kind = nullptr;
    library.find(name, kind);
    return kind != nullptr ? *kind : hid_t{-1};
  };
#define COVER_HDF5_FIND(name) opened.members.name = value_of(#name);
  COVER_HDF5_KINDS(COVER_HDF5_FIND)
#undef COVER_HDF5_FIND
  opened.failure = library.failure();
  return opened;
}

}  // namespace

Result<const Hdf5Library*> hdf5_library() {
  const Opened<Hdf5Library>& opened = opened_once<open_hdf5>();
  if (opened.failure.empty()) return &opened.members;
  return Error{ErrorCode::unsupported_format,
               fmt::format("HDF5 is written by its library, which cannot be opened ({}); .vtu and "
                           ".xdmf without HDF5 need none",
                           opened.failure),
               {},
               {}};
}

const Hdf5Library& opened_hdf5() { return opened_once<open_hdf5>().members; }

}  // namespace cover
