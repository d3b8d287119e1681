// VTK's data sets from files, by extension.
#pragma once

#include <string>

#include <vtkDataSet.h>
#include <vtkSmartPointer.h>

#include <cover/result.hpp>

namespace cover {

/// Reads .vtu, .vtp or legacy .vtk.
///
/// Errors: unsupported_format for any other extension, cannot_open, syntax
Result<vtkSmartPointer<vtkDataSet>> read_data_set(const std::string& path);

}  // namespace cover
