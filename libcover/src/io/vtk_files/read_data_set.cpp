// Tested by tests/unit/io/vtk_files/read_data_set_test.cpp.
#include "io/vtk_files/read_data_set.hpp"

#include <utility>

#include <fmt/core.h>

#include "io/text/text.hpp"
#include "io/vtk_files/parse_data_set.hpp"

namespace cover {

bool is_data_set(std::string_view extension) {
  return extension == ".vtu" || extension == ".vtp" || extension == ".vti" || extension == ".vtk";
}

Result<DataSet> parse_data_set(std::string_view text, std::string_view extension,
                               const std::string& source) {
  if (extension == ".vtm")
    return Error{ErrorCode::unsupported_format,
                 fmt::format("{}: blocks are not read; 'cover convert FILE.vtm -o FILE.vtu' makes "
                             "one file of them",
                             source),
                 {},
                 {}};
  if (!is_data_set(extension))
    return Error{ErrorCode::unsupported_format,
                 fmt::format("{}: not named like a file of VTK: .vtu, .vtp, .vti or .vtk", source),
                 {},
                 {}};
  return extension == ".vtk" ? parse_legacy_vtk(text, source) : parse_vtk_xml(text, source);
}

Result<DataSetFile> read_data_set(const std::string& path) {
  const std::string extension = extension_of(path);
  if (!is_data_set(extension)) return parse_data_set({}, extension, path).error();
  Result<std::string> content = read_file(path);
  if (!content) return std::move(content).error();
  DataSetFile file{std::make_unique<const std::string>(std::move(*content)), {}};
  Result<DataSet> data = parse_data_set(*file.text, extension, path);
  if (!data) return std::move(data).error();
  file.data = std::move(*data);
  return file;
}

}  // namespace cover
