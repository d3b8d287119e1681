// What is in a folder, and whether a name still means what was opened by it.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace cover {

/// The names in `folder` ("" is the current one), in no order; none where it cannot be read.
std::vector<std::string> names_in_folder(const std::filesystem::path& folder);

/// Whether `path` is a name of the open file `file`. A symbolic link is none, unless what it leads
/// to counts.
bool is_name_of(const std::filesystem::path& path, int file, bool through_links = false);

}  // namespace cover
