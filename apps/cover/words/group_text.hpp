// Which number stands for what in the mesh files.
#pragma once

#include <string>
#include <vector>

#include <cover/output.hpp>
#include <cover/stream_mesh.hpp>
#include <cover/write_mesh.hpp>

namespace cover::app {

/// A table of the numbers that regions, lines and, where a file holds them, points have in mesh
/// files, as the manifest has them, and of their names in formats that do not bear them as they
/// are; empty unless one of `files` has such numbers or names. At most 20 rows of each kind, or
/// all.
std::string group_text(const StreamedOutput& output, const std::vector<std::string>& files,
                       const WriteOptions& options, bool all);

/// Of that, the names alone that formats bear in another form only.
std::string renamed_text(const Output& output, const std::vector<std::string>& files,
                         const WriteOptions& options, bool all);

}  // namespace cover::app
