// Which number stands for what in the mesh files.
#pragma once

#include <string>
#include <vector>

#include <cover/output.hpp>

namespace cover::app {

/// A table of the numbers that regions and lines have in mesh files, as the manifest has them; empty
/// unless one of `files` has such numbers. At most 20 rows of each kind, or all.
std::string group_text(const Output& output, const std::vector<std::string>& files, bool all);

}  // namespace cover::app
