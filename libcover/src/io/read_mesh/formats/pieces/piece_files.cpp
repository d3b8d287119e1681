// Tested by tests/unit/io/read_mesh/read_mesh_test.cpp.
#include "io/read_mesh/formats/pieces/piece_files.hpp"

#include <system_error>
#include <utility>

#include <fmt/core.h>

#include "base/faults/errors.hpp"
#include "io/text/text.hpp"

namespace cover {

PieceFiles::PieceFiles(const std::string& path) : path_(path) {
  std::error_code failed;
  const std::filesystem::path canonical = std::filesystem::canonical(path, failed);
  folder_ = (failed ? std::filesystem::path(path) : canonical).parent_path();
}

Result<DataSetFile> PieceFiles::read(std::string_view piece) {
  const std::filesystem::path file = folder_ / piece;
  std::error_code failed;
  const std::filesystem::path canonical = std::filesystem::canonical(file, failed);
  if (failed || piece.empty() || !std::filesystem::is_regular_file(canonical, failed))
    return Error{ErrorCode::cannot_open,
                 fmt::format("{}: its piece '{}' is not there", path_, legible(piece)),
                 {},
                 {}};
  if (!seen_.insert(canonical).second)
    return wrong_file(path_, fmt::format("two pieces are the file '{}'", legible(piece)));
  Result<DataSetFile> data = read_data_set(file);
  if (!data) return data;
  if (Status plane = data->data.check_plane(); !plane)
    return in_file(file.string(), std::move(plane).error());
  return data;
}

}  // namespace cover
