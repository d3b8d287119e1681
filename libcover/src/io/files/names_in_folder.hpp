// What is in a folder.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace cover {

/// The names in `folder` ("" is the current one), in no order; none where it cannot be read.
std::vector<std::string> names_in_folder(const std::filesystem::path& folder);

}  // namespace cover
