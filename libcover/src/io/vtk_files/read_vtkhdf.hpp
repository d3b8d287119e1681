// VTKHDF, read without VTK and without HDF5's library.
#pragma once

#include <memory>
#include <string>
#include <string_view>

#include <cover/result.hpp>

#include "io/hdf5/parse_hdf5.hpp"
#include "io/vtk_files/data_set.hpp"

namespace cover {

/// An unstructured grid with the file that its arrays point into.
struct VtkHdfFile {
  std::unique_ptr<const std::string> text;
  Hdf5Tree tree;
  DataSet data;  ///< of all pieces

  /// Field data of that name and kind; or nullptr.
  [[nodiscard]] const Hdf5Value* field(std::string_view name, Hdf5Value::Kind kind) const;
};

/// Reads a file of VTKHDF 1.x or 2.x without time steps.
///
/// Errors: cannot_open; those of parse_hdf5(); unsupported_format for other data sets and for what
///         is compressed or in chunks
Result<VtkHdfFile> read_vtkhdf(const std::string& path);

}  // namespace cover
