// VTK's data sets from files, by extension.
#pragma once

#include <memory>
#include <string>
#include <string_view>

#include <cover/result.hpp>

#include "io/vtk_files/data_set.hpp"

namespace cover {

/// Whether files with this extension hold such a data set: .vtu, .vtp, .vti and .vtk, in lower
/// case.
bool is_data_set(std::string_view extension);

/// Reads a data set from memory; `text` must outlive it.
///
/// Errors: unsupported_format for any other extension; those of parse_vtk_xml()
Result<DataSet> parse_data_set(std::string_view text, std::string_view extension,
                               const std::string& source);

/// A data set with the text that its arrays point into.
struct DataSetFile {
  std::unique_ptr<const std::string> text;
  DataSet data;
};

/// Reads a file, or a pipe; its format follows from the extension, in whatever case.
///
/// Errors: cannot_open; those of parse_data_set()
Result<DataSetFile> read_data_set(const std::string& path);

}  // namespace cover
