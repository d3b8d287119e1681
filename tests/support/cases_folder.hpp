// Where geometry of others lies on this machine, for tests that read it when it is there.
#pragma once

#include <filesystem>

namespace cover {

/// The folder of further cases; it need not exist. A function and not a definition for every unit,
/// so that a compiler cache knows the same test in another checkout again.
std::filesystem::path cases_folder();

}  // namespace cover
