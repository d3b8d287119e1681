// The files of which a mesh in pieces is made.
#pragma once

#include <filesystem>
#include <set>
#include <string>
#include <string_view>

#include <cover/result.hpp>

#include "io/vtk_files/read_data_set.hpp"

namespace cover {

/// Reads the pieces that a file names: data sets in the plane, beside the file or below.
class PieceFiles {
 public:
  /// Pieces are beside what `path` leads to, where it is a link.
  explicit PieceFiles(const std::string& path);

  /// Errors: syntax, where it was read before: else a small file could name a large one a thousand
  ///         times; cannot_open; those of read_data_set()
  Result<DataSetFile> read(std::string_view piece);

 private:
  std::string path_;
  std::filesystem::path folder_;
  std::set<std::filesystem::path> seen_;
};

}  // namespace cover
