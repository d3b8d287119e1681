// Tested by tests/unit/vtk/write_vtk_test.cpp, where it is used.
#include "io/files/scratch_folder.hpp"

#include <fmt/core.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <system_error>
#include <utility>

namespace cover {

Result<ScratchFolder> ScratchFolder::beside(const std::string& target) {
  const std::filesystem::path path(target);
  std::string name = path.parent_path() / fmt::format(".{}.XXXXXX", path.filename().string());
  if (mkdtemp(name.data()) == nullptr) {
    return Error{ErrorCode::cannot_write,
                 fmt::format("cannot write {}: {}", target, std::strerror(errno)),
                 {},
                 {}};
  }
  return ScratchFolder(name);
}

ScratchFolder::ScratchFolder(ScratchFolder&& other) noexcept
    : path_(std::exchange(other.path_, {})) {}

ScratchFolder& ScratchFolder::operator=(ScratchFolder&& other) noexcept {
  std::swap(path_, other.path_);
  return *this;
}

ScratchFolder::~ScratchFolder() {
  std::error_code ignored;
  if (!path_.empty()) std::filesystem::remove_all(path_, ignored);
}

}  // namespace cover
