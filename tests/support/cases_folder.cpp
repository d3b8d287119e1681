#include "support/cases_folder.hpp"

namespace cover {

std::filesystem::path cases_folder() { return COVER_CASES_DIR; }

}  // namespace cover
